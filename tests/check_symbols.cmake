# SPDX-License-Identifier: MIT
# Fails when LIBRARY wants a GL, EGL or OSMesa symbol of the linker: all are found at run time.
#   cmake -D NM=nm -D LIBRARY=libcrevice_backends.a -P check_symbols.cmake
execute_process(COMMAND ${NM} -u ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} cannot read ${LIBRARY}")
endif()
string(REGEX MATCHALL "[^\n]* _?(gl|egl|OSMesa)[A-Z][^\n]*" linked "${symbols}")
if(linked)
  message(FATAL_ERROR "${LIBRARY} links\n${linked}")
endif()
