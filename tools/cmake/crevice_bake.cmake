# SPDX-License-Identifier: MIT
# crevice_bake(TARGET CONFIG... [NAME name] [OPTIONS --output ao ...]): bakes configs as TARGET is built, into NAME.h,
# which TARGET may include: `static const unsigned char NAME[]` and `NAME_size`. NAME is `baked` by default. A
# change of a .json file that is named here bakes again. Built for another machine, the command is this machine's:
# -D CREVICE_COMMAND=/path/of/crevice.
function(crevice_bake target)
  cmake_parse_arguments(arg "" "NAME" "OPTIONS" ${ARGN})
  if(NOT arg_NAME)
    set(arg_NAME baked)
  endif()
  if(NOT CREVICE_COMMAND AND TARGET crevice AND NOT CMAKE_CROSSCOMPILING)
    set(command crevice)
  else()
    find_program(CREVICE_COMMAND crevice HINTS "${CREVICE_COMMAND_HINT}")
    if(NOT CREVICE_COMMAND)
      message(FATAL_ERROR "crevice_bake needs the command crevice: set CREVICE_COMMAND to this machine's")
    endif()
    set(command "${CREVICE_COMMAND}")
    set(depends "${command}")
  endif()
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/${target}_baked")
  set(files ${arg_UNPARSED_ARGUMENTS} ${arg_OPTIONS})
  list(FILTER files INCLUDE REGEX "[.]json$")
  if(TARGET "${command}")
    set(depends "${command}")
    set(command "$<TARGET_FILE:${command}>")
  endif()
  add_custom_command(
    OUTPUT "${folder}/${arg_NAME}.h"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
    COMMAND "${command}" bake ${arg_UNPARSED_ARGUMENTS} ${arg_OPTIONS} --header "${folder}/${arg_NAME}.h"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    DEPENDS ${files} ${depends}
    COMMENT "Baking ${arg_NAME}.h"
    VERBATIM)
  target_sources(${target} PRIVATE "${folder}/${arg_NAME}.h")
  target_include_directories(${target} PRIVATE "${folder}")
endfunction()
