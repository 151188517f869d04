# SPDX-License-Identifier: MIT
# Toolchain file: WebAssembly and WebGL 2, by Emscripten. Libraries of headers alone are the host's, seen
# through links, since the compiler must see nothing else of the host's headers.
execute_process(COMMAND em-config EMSCRIPTEN_ROOT OUTPUT_VARIABLE emscripten_root
  OUTPUT_STRIP_TRAILING_WHITESPACE)
include(${emscripten_root}/cmake/Modules/Platform/Emscripten.cmake)

set(host_headers ${CMAKE_BINARY_DIR}/host_headers)
file(MAKE_DIRECTORY ${host_headers})
foreach(library glm nlohmann)
  file(CREATE_LINK /usr/include/${library} ${host_headers}/${library} SYMBOLIC)
endforeach()
set(CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES /usr/include)
set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${host_headers})
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
