# The editor's font as bytes in C++: fur_editor_font brings the include folder of editor/FontData.inc.
# Without a font file the panel falls back to Dear ImGui's own bitmap font.
find_file(FUR_EDITOR_FONT Karla-Regular.otf NO_CMAKE_FIND_ROOT_PATH
  PATHS /usr/share/fonts /usr/local/share/fonts PATH_SUFFIXES truetype/karla opentype/karla karla
  DOC "TrueType or OpenType font of the editor's panel (Debian: fonts-karla)")

add_library(fur_editor_font INTERFACE)
if(FUR_EDITOR_FONT)
  file(READ "${FUR_EDITOR_FONT}" bytes HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/generated/editor/FontData.inc" CONTENT "${bytes}\n" @ONLY)
  target_include_directories(fur_editor_font INTERFACE "${CMAKE_BINARY_DIR}/generated")
else()
  message(STATUS "wet-fur: Karla-Regular.otf not found (on Debian: fonts-karla); the panel uses a bitmap font")
endif()
