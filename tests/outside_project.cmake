# SPDX-License-Identifier: MIT
# Installs crevice, builds tests/outside against the installed tree alone, and runs it.
#   cmake -D BUILD=<build folder> -D SOURCE=<tests/outside> -D WORK=<scratch folder>
#         -D CXX=<compiler> -D FLAGS=<compiler flags> -P outside_project.cmake
file(REMOVE_RECURSE "${WORK}")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "failed (${code}): ${ARGN}")
  endif()
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
run("${CMAKE_COMMAND}" -G Ninja -S "${SOURCE}" -B "${WORK}/build"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
  -DCMAKE_BUILD_TYPE=Release)
run("${CMAKE_COMMAND}" --build "${WORK}/build")

# Every installed header must compile alone, so that none leans on one that stays behind; and as the
# strictest host builds.
file(WRITE "${WORK}/empty.cpp" "")
file(GLOB_RECURSE headers RELATIVE "${WORK}/prefix/include/crevice" "${WORK}/prefix/include/*.h")
foreach(header IN LISTS headers)
  run("${CXX}" -std=c++17 -fsyntax-only -fno-exceptions -fno-rtti -Wall -Wextra -Wpedantic -Wshadow
    -Werror "-I${WORK}/prefix/include/crevice" -include "${header}" "${WORK}/empty.cpp")
endforeach()

execute_process(COMMAND "${WORK}/build/outside" RESULT_VARIABLE code)
if(code EQUAL 77 AND NOT "$ENV{CREVICE_REQUIRE_GL}")
  message("SKIPPED: there is no GL context on this machine")
elseif(NOT code EQUAL 0)
  message(FATAL_ERROR "the outside project failed (${code})")
endif()
