# SPDX-License-Identifier: MIT
# `cmake --install`: the three libraries with their headers, so that find_package(crevice) gives
# crevice::core, crevice::backends and crevice::effects; and the command, where it is built.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/crevice)

install(TARGETS crevice_core crevice_backends crevice_effects EXPORT creviceTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

# Only what a host may include, as <crevice/...>; all other headers are the libraries' own.
foreach(library core backends effects)
  install(DIRECTORY ${library}/include/crevice DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()
install(EXPORT creviceTargets NAMESPACE crevice:: DESTINATION ${config_dir})

# Before 1.0 a minor version may break what the last one had.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/creviceConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
configure_package_config_file(tools/cmake/creviceConfig.cmake.in creviceConfig.cmake
  INSTALL_DESTINATION ${config_dir})
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/creviceConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/creviceConfigVersion.cmake
  DESTINATION ${config_dir})

if(TARGET crevice)
  install(TARGETS crevice RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
