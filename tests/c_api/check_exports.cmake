# SPDX-License-Identifier: MIT
# What LIBRARY exports is what TEST calls: a function that is not called is not tested, and one that is no longer
# exported breaks programs.
#   cmake -D NM=nm -D LIBRARY=libcrevice.so -D TEST=api_test.c -P check_exports.cmake
cmake_minimum_required(VERSION 3.22)
execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} cannot read ${LIBRARY}")
endif()
string(REGEX REPLACE "[0-9a-f]* [A-Za-z] ([^\n]*)\n" "\\1;" exported "${symbols}")
file(READ ${TEST} test)
foreach(name IN LISTS exported)
  if(name AND NOT test MATCHES "${name}[(]")
    message(SEND_ERROR "${TEST} does not call ${name}")
  endif()
endforeach()
list(LENGTH exported count)
message("${count} symbols")
