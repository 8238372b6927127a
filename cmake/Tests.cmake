# wet-fur-tests     the pure modules, on the CPU; native, and as wasm under Node
# wet-fur-gl-tests  what needs a context (EGL without a window), and the modules that link GL; native

set(FUR_PURE_TEST_FOLDERS core settings geometry furgen groom wet dynamics hair scene app/tools app/commands app/stages)
if(TARGET fur_truth)
  list(APPEND FUR_PURE_TEST_FOLDERS truth)
endif()

set(pure_globs ${FUR_PURE_TEST_FOLDERS})
list(TRANSFORM pure_globs PREPEND "${CMAKE_SOURCE_DIR}/tests/")
list(TRANSFORM pure_globs APPEND "/*Test.cpp")
file(GLOB_RECURSE FUR_CPU_TESTS CONFIGURE_DEPENDS ${pure_globs})
list(FILTER FUR_CPU_TESTS EXCLUDE REGEX "GLTest\\.cpp$")
file(GLOB_RECURSE FUR_GL_TESTS CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/tests/*Test.cpp")
if(FUR_CPU_TESTS)
  list(REMOVE_ITEM FUR_GL_TESTS ${FUR_CPU_TESTS})
endif()

if(EMSCRIPTEN)
  # Debian's libgtest is native; its sources serve here.
  set(gtest_root "/usr/src/googletest/googletest" CACHE PATH "GoogleTest's sources, for the wasm tests")
  if(NOT EXISTS "${gtest_root}/src/gtest-all.cc")
    message(FATAL_ERROR "no GoogleTest in ${gtest_root}; on Debian: apt-get install googletest")
  endif()
  add_library(fur_gtest STATIC EXCLUDE_FROM_ALL "${gtest_root}/src/gtest-all.cc" "${gtest_root}/src/gtest_main.cc")
  target_include_directories(fur_gtest SYSTEM PUBLIC "${gtest_root}/include")
  target_include_directories(fur_gtest PRIVATE "${gtest_root}")
  target_compile_definitions(fur_gtest PUBLIC GTEST_HAS_PTHREAD=0)
  target_compile_options(fur_gtest PRIVATE -w ${FUR_EXCEPTIONS})
else()
  find_package(GTest QUIET)
  if(NOT GTest_FOUND)
    message(FATAL_ERROR "no GoogleTest; on Debian: apt-get install libgtest-dev")
  endif()
  add_library(fur_gtest INTERFACE)
  target_link_libraries(fur_gtest INTERFACE GTest::gtest GTest::gtest_main)
endif()

# `if (x) EXPECT_EQ(…)` is fine: GoogleTest's macros are written for it, gcc does not see that.
add_library(fur_test_options INTERFACE)
target_compile_options(fur_test_options INTERFACE -Wno-dangling-else)
# What they test is compiled as it ships; of the tests themselves compiling takes longer than running, and as wasm linking.
target_compile_options(fur_test_options INTERFACE "$<$<CONFIG:Release>:$<IF:$<BOOL:${EMSCRIPTEN}>,-O1,-O0>>")
if(FUR_SANITIZE)
  # Undefined behaviour is looked for in what they test. In the tests themselves that check takes a third of the build, and
  # making them fast more than it saves.
  target_compile_options(fur_test_options INTERFACE -fno-sanitize=undefined -g0 -O0)
  # What compares with readers of others compiles those.
  foreach(source core/JsonTest scene/DocumentTest scene/TinyGltfTest settings/PresetsTest)
    fur_source_options("${CMAKE_SOURCE_DIR}/tests/${source}.cpp" "-fno-sanitize=all;-O0")
  endforeach()
endif()
target_link_libraries(fur_test_options INTERFACE fur_options fur_gtest third_party_test_headers)

if(FUR_CPU_TESTS)
  add_executable(wet-fur-tests EXCLUDE_FROM_ALL ${FUR_CPU_TESTS} "${CMAKE_SOURCE_DIR}/tests/AllocatedBytes.cpp")
  target_include_directories(wet-fur-tests PRIVATE "${CMAKE_SOURCE_DIR}" "${CMAKE_SOURCE_DIR}/tests")
  target_link_libraries(wet-fur-tests PRIVATE ${FUR_PURE_MODULES} fur_test_options)
  target_precompile_headers(wet-fur-tests PRIVATE "${CMAKE_SOURCE_DIR}/tests/Precompiled.h")
  if(EMSCRIPTEN)
    # What the linker optimizes once more is mostly the tests: less of that halves its time.
    fur_node_program(wet-fur-tests "$<$<CONFIG:Release>:-O1;-Wl,--lto-O1>")
  endif()
endif()

# tests/bench/water.cpp and others; no tests, and not built with them.
foreach(bench water:wet hair:hair alive:stages)
  string(REPLACE ":" ";" bench "${bench}")
  list(GET bench 0 name)
  list(GET bench 1 module)
  add_executable(wet-fur-${name}-bench EXCLUDE_FROM_ALL "${CMAKE_SOURCE_DIR}/tests/bench/${name}.cpp")
  target_include_directories(wet-fur-${name}-bench PRIVATE "${CMAKE_SOURCE_DIR}" "${CMAKE_SOURCE_DIR}/tests")
  target_link_libraries(wet-fur-${name}-bench PRIVATE fur_${module})
  if(EMSCRIPTEN)
    fur_node_program(wet-fur-${name}-bench -sNODERAWFS=1)
  endif()
endforeach()

if(FUR_GL_TESTS AND NOT EMSCRIPTEN AND TARGET third_party_egl AND TARGET fur_app)
  # The tests draw through the context of the windowless program.
  list(APPEND FUR_GL_TESTS "${CMAKE_SOURCE_DIR}/native/headless/EglContext.cpp")
  add_executable(wet-fur-gl-tests EXCLUDE_FROM_ALL ${FUR_GL_TESTS})
  target_include_directories(wet-fur-gl-tests PRIVATE "${CMAKE_SOURCE_DIR}" "${CMAKE_SOURCE_DIR}/tests")
  target_link_libraries(wet-fur-gl-tests PRIVATE fur_app fur_truth third_party_egl fur_test_options)
  target_compile_definitions(wet-fur-gl-tests PRIVATE FUR_ASSETS="${CMAKE_SOURCE_DIR}/assets")
  target_precompile_headers(wet-fur-gl-tests PRIVATE "${CMAKE_SOURCE_DIR}/tests/Precompiled.h")
  if(TARGET fur_app_editor)
    target_link_libraries(wet-fur-gl-tests PRIVATE fur_app_editor)
    # What the window keeps on disk.
    target_sources(wet-fur-gl-tests PRIVATE "${CMAKE_SOURCE_DIR}/native/Files.cpp" "${CMAKE_SOURCE_DIR}/native/window/FileDialog.cpp"
      "${CMAKE_SOURCE_DIR}/native/window/OwnCoats.cpp" "${CMAKE_SOURCE_DIR}/native/window/Versions.cpp")
  else()
    list(FILTER FUR_GL_TESTS EXCLUDE REGEX "/tests/editor/")
    set_target_properties(wet-fur-gl-tests PROPERTIES SOURCES "${FUR_GL_TESTS}")
  endif()
endif()
