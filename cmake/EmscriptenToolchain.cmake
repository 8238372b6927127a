# Finds Emscripten and hands over to its own toolchain file: an active emsdk first (it is newer and was
# switched on by hand), then the emcc on PATH.
if(DEFINED ENV{EMSDK} AND EXISTS "$ENV{EMSDK}/upstream/emscripten/emcc")
  set(_fur_emscripten "$ENV{EMSDK}/upstream/emscripten")
else()
  find_program(FUR_EMCC emcc)
  if(NOT FUR_EMCC)
    message(FATAL_ERROR "Emscripten not found: install the package emscripten, or activate an emsdk.")
  endif()
  # Debian's /usr/bin/emcc is a link into the folder that holds cmake/Modules.
  file(REAL_PATH "${FUR_EMCC}" _fur_emcc)
  get_filename_component(_fur_emscripten "${_fur_emcc}" DIRECTORY)
endif()
include("${_fur_emscripten}/cmake/Modules/Platform/Emscripten.cmake")
