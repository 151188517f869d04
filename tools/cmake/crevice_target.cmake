# SPDX-License-Identifier: MIT
# What all targets share: warnings, sanitizers, hardening, and the rules for libraries.
include(CheckCXXCompilerFlag)
include(CheckLinkerFlag)
include(CheckPIESupported)

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

# crevice_find(NAME PACKAGE ARGUMENTS...): find_package. What is found must be no older than tools/scripts/packages.txt
# says of the Debian package.
file(STRINGS ${PROJECT_SOURCE_DIR}/tools/scripts/packages.txt packages REGEX " >= ")
foreach(each IN LISTS packages)
  string(REGEX MATCH "^([^ ]+) >= ([0-9.]+)$" each "${each}")
  set(CREVICE_LEAST_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
endforeach()
if(NOT CMAKE_MINIMUM_REQUIRED_VERSION VERSION_EQUAL CREVICE_LEAST_cmake)
  message(FATAL_ERROR "CMakeLists.txt and tools/scripts/packages.txt differ in the least version of CMake")
endif()
macro(crevice_find name package)
  find_package(${name} ${ARGN})
  if(${name}_VERSION AND ${name}_VERSION VERSION_LESS CREVICE_LEAST_${package})
    message(FATAL_ERROR "${name} is version ${${name}_VERSION}, and crevice needs ${CREVICE_LEAST_${package}}")
  endif()
endmacro()

# crevice_hardened(TARGET): what makes a slip of memory hard to use, where the compiler has it. For the command, the
# shared library, and what both are linked from; a host's own link options are its own.
if(NOT EMSCRIPTEN)
  check_pie_supported()
  check_cxx_compiler_flag(-fstack-protector-strong CREVICE_HAS_STACK_PROTECTOR)
  check_cxx_compiler_flag(-fcf-protection CREVICE_HAS_CF_PROTECTION)
  check_linker_flag(CXX LINKER:-z,relro,-z,now CREVICE_HAS_RELRO)
endif()
set(CREVICE_HARDENING $<$<BOOL:${CREVICE_HAS_STACK_PROTECTOR}>:-fstack-protector-strong>
  $<$<BOOL:${CREVICE_HAS_CF_PROTECTION}>:-fcf-protection>)
if(NOT CREVICE_SANITIZE)  # which brings checks of its own; glibc has them in code that is optimised
  set(optimised $<CONFIG:Release,RelWithDebInfo,MinSizeRel>)
  list(APPEND CREVICE_HARDENING $<${optimised}:-U_FORTIFY_SOURCE> $<${optimised}:-D_FORTIFY_SOURCE=2>)
endif()
function(crevice_hardened target)
  target_compile_options(${target} PRIVATE ${CREVICE_HARDENING})
  target_link_options(${target} PRIVATE $<$<BOOL:${CREVICE_HAS_RELRO}>:LINKER:-z,relro,-z,now>)
endfunction()

# crevice_small(TARGET): in MinSizeRel the linker sees all of the code at once. A host then links by the same compiler.
include(CheckIPOSupported)
check_ipo_supported(RESULT CREVICE_HAS_IPO OUTPUT ignored LANGUAGES CXX)
function(crevice_small target)
  if(CREVICE_IPO AND CREVICE_HAS_IPO AND NOT EMSCRIPTEN)
    set_target_properties(${target} PROPERTIES INTERPROCEDURAL_OPTIMIZATION_MINSIZEREL ON)
  endif()
endfunction()

# crevice_library(NAME SOURCES... ) makes crevice_NAME, exported as crevice::NAME. Host applications
# link it, so it neither throws nor uses run-time types. Public headers are
# <crevice/file.h>, in NAME/include; the others are the library's own, "NAME/layer/file.h".
function(crevice_library name)
  add_library(crevice_${name} STATIC ${ARGN})
  add_library(crevice::${name} ALIAS crevice_${name})
  set_target_properties(crevice_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(crevice_${name} PUBLIC cxx_std_17)
  target_compile_options(crevice_${name} PRIVATE -fno-exceptions -fno-rtti)
  crevice_hardened(crevice_${name})
  crevice_small(crevice_${name})
  # A host's own shared object that links it exports none of it.
  set_target_properties(crevice_${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_libraries(crevice_${name} PRIVATE $<BUILD_INTERFACE:crevice_flags>)
  target_include_directories(crevice_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()
