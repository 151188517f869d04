# SPDX-License-Identifier: MIT
# What all targets share: warnings, sanitizers, and the rules for libraries.

add_library(crevice_flags INTERFACE)
target_include_directories(crevice_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(crevice_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow
  $<$<BOOL:${CREVICE_WERROR}>:-Werror>)
if(CREVICE_SANITIZE)
  # vptr asks for run-time types, which the libraries are built without. g++ takes the checks that
  # it adds itself for reads of what was never set, in the standard library and in Catch2.
  add_compile_options(-fsanitize=${CREVICE_SANITIZE} -fno-sanitize=vptr -fno-sanitize-recover=all
    -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(-fsanitize=${CREVICE_SANITIZE})
endif()
if(CREVICE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# crevice_library(NAME SOURCES... ) makes crevice_NAME, exported as crevice::NAME. Host applications
# link it, so it neither throws nor uses run-time types. Public headers are
# <crevice/file.h>, in NAME/include; the others are the library's own, "NAME/layer/file.h".
function(crevice_library name)
  add_library(crevice_${name} STATIC ${ARGN})
  add_library(crevice::${name} ALIAS crevice_${name})
  set_target_properties(crevice_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(crevice_${name} PUBLIC cxx_std_17)
  target_compile_options(crevice_${name} PRIVATE -fno-exceptions -fno-rtti)
  # A host's own shared object that links it exports none of it.
  set_target_properties(crevice_${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_libraries(crevice_${name} PRIVATE $<BUILD_INTERFACE:crevice_flags>)
  target_include_directories(crevice_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()
