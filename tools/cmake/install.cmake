# SPDX-License-Identifier: MIT
# `cmake --install`: the three libraries with their headers, so that find_package(crevice) gives
# crevice::core, crevice::backends and crevice::effects; and the command, where it is built.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/crevice)

install(TARGETS crevice_core crevice_backends crevice_effects EXPORT creviceTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

# Only what a host may include; the other headers are the libraries' own.
set(public_headers
  backends/context.h
  backends/gl_device.h
  backends/gl_loader.h
  backends/recording_device.h
  core/codes.h
  core/description.h
  core/device.h
  core/diagnostic.h
  core/document.h
  core/format.h
  core/frame.h
  core/frame_times.h
  core/generators.h
  core/glsl.h
  core/image.h
  core/lazy.h
  core/load.h
  core/merge.h
  core/plan.h
  core/rules.h
  core/renderer.h
  core/result.h
  core/source.h
  core/values.h
  effects/catalog.h
)
foreach(header IN LISTS public_headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/crevice/${folder})
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
