# What is not ours, as targets:
#   third_party_headers  glm, stb/ (header only)
#   third_party_test_headers  tiny_gltf.h and nlohmann/json.hpp, only with the tests
#   third_party_gles     OpenGL ES 3 (native: libGLESv2; wasm: Emscripten's own)
#   third_party_egl, third_party_glfw   native only
#   imgui, imgui_opengl3                Dear ImGui from FUR_IMGUI_DIR
# A target that cannot be made is left out; Modules and Programs then leave out what needs it.

# Header-only libraries by one of their headers each; `packages` are Debian's.
function(fur_header_libraries target packages)
  add_library(${target} INTERFACE)
  foreach(header ${ARGN})
    string(MAKE_C_IDENTIFIER "FUR_DIR_OF_${header}" variable)
    find_path(${variable} ${header} NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include /usr/local/include /opt/homebrew/include)
    if(NOT ${variable})
      message(FATAL_ERROR "${header} not found; on Debian: apt-get install ${packages}")
    endif()
    if(EMSCRIPTEN)
      # The folder that holds these also holds glibc's headers, so wasm gets links to just these.
      string(REGEX REPLACE "/.*" "" entry "${header}")
      file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/third_party_include")
      file(CREATE_LINK "${${variable}}/${entry}" "${CMAKE_BINARY_DIR}/third_party_include/${entry}" SYMBOLIC)
    elseif(NOT ${variable} STREQUAL "/usr/include")
      target_include_directories(${target} SYSTEM INTERFACE "${${variable}}")
    endif()
  endforeach()
  if(EMSCRIPTEN)
    target_include_directories(${target} SYSTEM INTERFACE "${CMAKE_BINARY_DIR}/third_party_include")
  endif()
endfunction()

fur_header_libraries(third_party_headers "libglm-dev libstb-dev" glm/glm.hpp stb/stb_rect_pack.h)
if(FUR_TESTS)
  fur_header_libraries(third_party_test_headers "libtinygltf-dev nlohmann-json3-dev" tiny_gltf.h nlohmann/json.hpp)
endif()

# One native library by its header and its file name; silently absent when the system lacks it.
function(fur_system_library target header library)
  string(MAKE_C_IDENTIFIER "FUR_${library}" prefix)
  find_path(${prefix}_INCLUDE ${header})
  find_library(${prefix}_LIBRARY ${library})
  if(${prefix}_INCLUDE AND ${prefix}_LIBRARY)
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE "${${prefix}_LIBRARY}")
  else()
    message(STATUS "wet-fur: ${library} (${header}) not found; what needs it is left out")
  endif()
endfunction()

if(FUR_GL)
  if(EMSCRIPTEN)
    add_library(third_party_gles INTERFACE)
  else()
    fur_system_library(third_party_gles GLES3/gl3.h GLESv2)
    fur_system_library(third_party_egl EGL/egl.h EGL)
    fur_system_library(third_party_glfw GLFW/glfw3.h glfw)
  endif()
endif()

if(FUR_GL AND EXISTS "${FUR_IMGUI_DIR}/imgui.h")
  add_library(imgui STATIC
    "${FUR_IMGUI_DIR}/imgui.cpp" "${FUR_IMGUI_DIR}/imgui_draw.cpp"
    "${FUR_IMGUI_DIR}/imgui_tables.cpp" "${FUR_IMGUI_DIR}/imgui_widgets.cpp")
  target_include_directories(imgui SYSTEM PUBLIC "${FUR_IMGUI_DIR}" "${FUR_IMGUI_DIR}/backends")
  target_compile_definitions(imgui PUBLIC IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_METRICS_WINDOW
    IMGUI_DISABLE_FILE_FUNCTIONS)
  target_compile_options(imgui PRIVATE -w)
  if(EMSCRIPTEN)
    # The panel is drawn a few times a second; its download counts more than its speed.
    target_compile_options(imgui PRIVATE $<$<CONFIG:Release>:-Os>)
  else()
    target_compile_options(imgui PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()

  if(TARGET third_party_gles)
    add_library(imgui_opengl3 STATIC "${FUR_IMGUI_DIR}/backends/imgui_impl_opengl3.cpp")
    target_compile_definitions(imgui_opengl3 PUBLIC IMGUI_IMPL_OPENGL_ES3)
    target_compile_options(imgui_opengl3 PRIVATE -w)
    target_link_libraries(imgui_opengl3 PUBLIC imgui third_party_gles)
  endif()
elseif(FUR_GL)
  message(STATUS "wet-fur: no Dear ImGui in ${FUR_IMGUI_DIR}; the editor is left out")
endif()
