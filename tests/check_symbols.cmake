# SPDX-License-Identifier: MIT
# Fails when LIBRARY wants a GL, EGL or OSMesa symbol of the linker: all are found at run time. And where
# it has a number written by the locale, into a stream or by std::to_string of a float. The runtime has
# no streams, files and locales at all, and nothing that reads configs and GLSL.
#   cmake -D NM=nm -D LIBRARY=libcrevice_backends.a -P check_symbols.cmake
execute_process(COMMAND ${NM} ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} cannot read ${LIBRARY}")
endif()
string(REGEX MATCHALL "[^\n]* U _?(gl|egl|OSMesa)[A-Z][^\n]*" linked "${symbols}")
if(linked)
  message(FATAL_ERROR "${LIBRARY} links\n${linked}")
endif()
string(REGEX MATCHALL "[^\n]* (_ZNSolsE[a-z]|_ZNSo9_M_insertI|_ZN9__gnu_cxx12__to_xstring)[^\n]*"
       written "${symbols}")
if(written)
  message(FATAL_ERROR "${LIBRARY} writes numbers by the locale (use core/base/numbers.h)\n${written}")
endif()
if(LIBRARY MATCHES "runtime")
  string(REGEX MATCHALL "[^\n]* U [^\n]*(filesystem|ios_base|basic_[io]?f?stream|locale|fopen|parseDocument|loadConfig|assembleStage|7compileE)[^\n]*"
         more "${symbols}")
  if(more)
    message(FATAL_ERROR "${LIBRARY} wants more than what draws:\n${more}")
  endif()
endif()
