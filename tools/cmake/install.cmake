# SPDX-License-Identifier: MIT
# `cmake --install`: the three libraries with their headers, so that find_package(crevice) gives
# crevice::core, crevice::backends and crevice::effects; and the command, where it is built.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/crevice)

install(TARGETS crevice_core crevice_backends crevice_effects EXPORT creviceTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

# Only what a host may include; the other headers are the libraries' own.
set(public_headers
  backends/context/context.h
  backends/gl/device.h
  backends/gl/loader.h
  backends/recording/device.h
  core/base/codes.h
  core/config/description.h
  core/gpu/device.h
  core/base/diagnostic.h
  core/json/document.h
  core/gpu/format.h
  core/frame/frame.h
  core/frame/frame_times.h
  core/sampling/generators.h
  core/glsl/stage.h
  core/base/image.h
  core/frame/imports.h
  core/json/lazy.h
  core/config/load.h
  core/json/merge.h
  core/plan/plan.h
  core/plan/optimizations.h
  core/renderer/renderer.h
  core/base/result.h
  core/base/source.h
  core/gpu/state.h
  core/config/values.h
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
