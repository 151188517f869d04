# SPDX-License-Identifier: MIT
# Installs crevice, builds the project beside this file against the installed package alone, and runs it; builds a C
# program by pkg-config too, and looks whether the project could be built with crevice as a folder of its own.
#   cmake -D BUILD=<build folder> -D SOURCE=<folder of this file> -D WORK=<scratch folder>
#         -D CXX=<compiler> -D CC=<compiler> -D FLAGS=<compiler flags> -P test.cmake
file(REMOVE_RECURSE "${WORK}")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "failed (${code}): ${ARGN}")
  endif()
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
# The code of the README and of docs/host.md is compiled as it stands there.
file(READ "${SOURCE}/../../README.md" readme)
file(READ "${SOURCE}/../../docs/host.md" manual)
foreach(kind cpp c)
  string(REGEX MATCH "<!-- example[.]${kind} -->\n```${kind}\n(.*)" example "${readme}")
  string(REGEX REPLACE "\n```.*" "\n" example "${CMAKE_MATCH_1}")
  file(WRITE "${WORK}/example.${kind}" "${example}")
endforeach()
string(REGEX MATCH "\n```cpp\n(.*)" shown "${manual}")
string(REGEX REPLACE "\n```.*" "\n" shown "${CMAKE_MATCH_1}")
set(code "#include <crevice/effect.h>\n#include <crevice/gl_device.h>\nusing namespace crevice;
extern std::unique_ptr<Effect> effect;\nStatus show(Extent size)\n{\n${shown}}\n")
# Its loaders, as the headers that there are declare them.
set(header_eglGetProcAddress EGL/egl.h)
set(header_SDL_GL_GetProcAddress SDL2/SDL.h)
set(header_glfwGetProcAddress GLFW/glfw3.h)
string(REGEX MATCH "\n[|] loader [^\n]*" row "${manual}")
string(REGEX MATCHALL "[A-Za-z_]+GetProcAddress" loaders "${row}")
foreach(loader IN LISTS loaders)
  string(APPEND code "#if __has_include(<${header_${loader}}>)\n#include <${header_${loader}}>
GlLoader by_${loader} = ${loader};\nauto of_${loader} = makeGlDevice(${loader});\n#endif\n")
endforeach()
file(WRITE "${WORK}/manual.cpp" "${code}")

# A host may have headers of the same names.
foreach(name core/frame.h device.h frame.h plan.h text.h)
  file(WRITE "${WORK}/host/${name}" "#error \"crevice included a header of its host\"\n")
endforeach()

set(c_program "${SOURCE}/../c_api/api_test.c")
set(configure "${CMAKE_COMMAND}" -G Ninja -S "${SOURCE}" "-DEXAMPLE=${WORK}/example.cpp" "-DC_PROGRAM=${c_program}"
  "-DBAKED_PROGRAM=${SOURCE}/../platforms/size_host.c"
  "-DHOST_HEADERS=${WORK}/host"
  "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_C_COMPILER=${CC}" "-DCMAKE_C_FLAGS=${FLAGS}"
  -DCMAKE_BUILD_TYPE=Release)
run(${configure} -B "${WORK}/build" "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
set(strict -std=c++17 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Werror "-I${WORK}/prefix/include")
run("${CXX}" ${strict} "${WORK}/manual.cpp")

# The libraries are made by the tests already: here it is enough that all that they need is found.
foreach(shared ON OFF)
  run(${configure} -B "${WORK}/within_${shared}" "-DSUBDIRECTORY=${SOURCE}/../.." -DBUILD_SHARED_LIBS=${shared})
  run(ninja -C "${WORK}/within_${shared}" -n --quiet)
endforeach()

# A project of C alone, on a machine without GLM.
file(WRITE "${WORK}/c/CMakeLists.txt" "cmake_minimum_required(VERSION 3.22)
project(c LANGUAGES C)
find_package(crevice REQUIRED)
add_executable(c ${c_program})
target_link_libraries(c PRIVATE crevice::crevice)
")
run("${CMAKE_COMMAND}" -G Ninja -S "${WORK}/c" -B "${WORK}/c/build" "-DCMAKE_PREFIX_PATH=${WORK}/prefix"
  "-DCMAKE_C_COMPILER=${CC}" "-DCMAKE_C_FLAGS=${FLAGS}" -DCMAKE_DISABLE_FIND_PACKAGE_glm=ON)
run("${CMAKE_COMMAND}" --build "${WORK}/c/build")

# The manual's links lead to what is installed with it.
file(GLOB_RECURSE pages "${WORK}/prefix/share/doc/libcrevice-dev/README.md"
  "${WORK}/prefix/share/doc/libcrevice-dev/docs/host.md")
if(NOT pages)
  message(FATAL_ERROR "no manual is installed")
endif()
foreach(page IN LISTS pages)
  file(READ "${page}" text)
  get_filename_component(folder "${page}" DIRECTORY)
  string(REPLACE "](" "@(" text "${text}")  # brackets would join the entries of a list
  string(REGEX MATCHALL "@[(][A-Za-z0-9_./-]+[#)]" links "${text}")
  foreach(link IN LISTS links)
    string(REGEX REPLACE "^@.|.$" "" link "${link}")
    if(NOT EXISTS "${folder}/${link}")
      message(FATAL_ERROR "${page} links to ${link}, which is not installed")
    endif()
  endforeach()
endforeach()

# crevice.pc, of a tree that was moved.
find_program(pkg_config NAMES pkgconf pkg-config)
if(pkg_config)
  file(COPY "${WORK}/prefix/" DESTINATION "${WORK}/moved")
  file(GLOB_RECURSE pc "${WORK}/moved/*/crevice.pc")
  get_filename_component(pc_dir "${pc}" DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} "${pc_dir}")
  set(ENV{LD_LIBRARY_PATH} "${pc_dir}/..")
  execute_process(COMMAND "${pkg_config}" --static --cflags --libs crevice OUTPUT_VARIABLE flags RESULT_VARIABLE code)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run("${CC}" ${FLAGS} -std=c99 -pedantic -Wall -Wextra -Werror "${c_program}" "${WORK}/example.c" -o "${WORK}/by_pkg_config" ${flags})
else()
  message(STATUS "pkg-config is not here: crevice.pc is not tried")
endif()

# Every installed header must compile alone, so that none leans on one that stays behind; beside a host's
# headers of the same names; and as the strictest host builds.
file(WRITE "${WORK}/empty.cpp" "")
set(compile "${CXX}" ${strict} -fno-exceptions -fno-rtti "-I${WORK}/host" "${WORK}/empty.cpp")
file(GLOB_RECURSE headers RELATIVE "${WORK}/prefix/include" "${WORK}/prefix/include/*.h")
foreach(header IN LISTS headers)
  if(NOT header MATCHES "^crevice/[a-z_]+[.]h$")
    message(FATAL_ERROR "installed, and not <crevice/...>: ${header}")
  endif()
  run(${compile} -include "${header}")
endforeach()

# GLM types of another layout are refused, and the facade has none.
set(aligned -DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES -DGLM_FORCE_INTRINSICS)
run(${compile} ${aligned} -include crevice/effect.h)
execute_process(COMMAND ${compile} ${aligned} -include crevice/frame.h RESULT_VARIABLE code ERROR_VARIABLE said)
if(code EQUAL 0 OR NOT said MATCHES "GLM_FORCE_DEFAULT_ALIGNED_GENTYPES")
  message(FATAL_ERROR "aligned GLM types are not refused: ${said}")
endif()

execute_process(COMMAND "${WORK}/build/baked_application" RESULT_VARIABLE code ERROR_VARIABLE said)
if(NOT said MATCHES "CV6004")
  message(FATAL_ERROR "baked_application does not say that GL has no functions: ${said}")
endif()

foreach(program build/application build/c_application by_pkg_config)
  if(NOT EXISTS "${WORK}/${program}")
    continue()
  endif()
  execute_process(COMMAND "${WORK}/${program}" RESULT_VARIABLE code)
  if(code EQUAL 77 AND NOT "$ENV{CREVICE_REQUIRE_GL}")
    message("SKIPPED: there is no GL context on this machine")
  elseif(NOT code EQUAL 0)
    message(FATAL_ERROR "${program} failed (${code})")
  endif()
endforeach()
