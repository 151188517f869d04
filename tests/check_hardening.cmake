# SPDX-License-Identifier: MIT
# Fails where BINARY lacks what crevice_hardened built it with, by the words of the list HARDENING:
#   now      its links to other libraries are made at the start, and read-only then
#   stack    functions with arrays notice when their frame is written past
#   fortify  glibc's functions check the bounds that the compiler knows
#   pie      it is loaded at a random address
#   cet      jumps land where they may: an object says so, a program only where those of the C library do too
#   cmake -D READELF=readelf -D BINARY=crevice -D HARDENING=now,stack -P check_hardening.cmake
cmake_minimum_required(VERSION 3.22)
execute_process(COMMAND ${READELF} -W -h -l -d -n -s ${BINARY} OUTPUT_VARIABLE said RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${READELF} cannot read ${BINARY}")
endif()
set(now "BIND_NOW|FLAGS[^\n]* NOW")
set(stack "__stack_chk_fail")
set(fortify "__[a-z]+_chk(@|\n)")
set(pie "Type: +DYN")
set(cet "IBT, SHSTK")
string(REPLACE "," ";" wanted "${HARDENING}")
foreach(each IN LISTS wanted)
  if(NOT said MATCHES "${${each}}" OR (each STREQUAL now AND NOT said MATCHES "GNU_RELRO"))
    message(SEND_ERROR "${BINARY} is not hardened by '${each}'")
  endif()
endforeach()
