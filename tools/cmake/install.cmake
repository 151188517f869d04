# SPDX-License-Identifier: MIT
# `cmake --install`: libcrevice, which is the C API, and the three C++ libraries, with their headers, so that
# find_package(crevice) gives crevice::crevice, crevice::runtime, and crevice::core, crevice::backends and
# crevice::effects, and crevice_bake; crevice.pc;
# and the command, where it is built. A component is a Debian package (tools/cmake/packages.cmake).
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/crevice)

install(TARGETS crevice_c EXPORT creviceTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(TARGETS crevice_core crevice_backends crevice_effects crevice_runtime EXPORT creviceTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)

# Only what a host may include, as <crevice/...>; all other headers are the libraries' own.
foreach(library core backends effects effects/api/c)
  install(DIRECTORY ${library}/include/crevice DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endforeach()
install(EXPORT creviceTargets NAMESPACE crevice:: DESTINATION ${config_dir} COMPONENT development)

# Before 1.0 a minor version may break what the last one had.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/creviceConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
configure_package_config_file(tools/cmake/creviceConfig.cmake.in creviceConfig.cmake
  INSTALL_DESTINATION ${config_dir})
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/creviceConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/creviceConfigVersion.cmake
  tools/cmake/crevice_bake.cmake
  DESTINATION ${config_dir} COMPONENT development)

# The prefix is where the file is found, so that an installed tree may be moved.
set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH PC_PREFIX /prefix/${pc_dir} /prefix)
if(NOT BUILD_SHARED_LIBS)
  set(PC_PRIVATE "-lcrevice_effects -lcrevice_backends -lcrevice_core -lstdc++ -lm -ldl")
endif()
configure_file(effects/api/c/crevice.pc.in crevice.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/crevice.pc DESTINATION ${pc_dir} COMPONENT development)

# The manual and the examples, laid out as here, so that links between them hold.
set(manual ${CMAKE_INSTALL_DATADIR}/doc/libcrevice-dev)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE SECURITY.md DESTINATION ${manual} COMPONENT development)
install(FILES tools/scripts/packages.txt DESTINATION ${manual}/tools/scripts COMPONENT development)
install(DIRECTORY tests/installed DESTINATION ${manual}/tests COMPONENT development)
install(DIRECTORY docs/ DESTINATION ${manual}/docs COMPONENT development
  FILES_MATCHING REGEX "[.](md|png|json)$" PATTERN bench EXCLUDE)
install(DIRECTORY tools/examples/ DESTINATION ${manual}/tools/examples COMPONENT development)
foreach(folder configs effects)
  install(FILES ${folder}/README.md DESTINATION ${manual}/${folder} COMPONENT development)
endforeach()

if(TARGET crevice)
  install(TARGETS crevice RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  # The page of `crevice view`, where tools/page.sh has built it.
  install(DIRECTORY out/page/ DESTINATION ${CMAKE_INSTALL_DATADIR}/crevice/page COMPONENT tools OPTIONAL)
endif()
include(tools/cmake/packages.cmake)
