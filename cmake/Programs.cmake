# fur_program(<target> SOURCES <folder globs>... LINK <targets>...): made when there are sources and all
# that it links exists.
function(fur_program target)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  list(TRANSFORM arg_SOURCES PREPEND "${CMAKE_SOURCE_DIR}/")
  file(GLOB sources CONFIGURE_DEPENDS ${arg_SOURCES})
  if(NOT sources)
    return()
  endif()
  foreach(linked ${arg_LINK})
    if(NOT TARGET ${linked})
      message(STATUS "wet-fur: ${target} is left out: no ${linked}")
      return()
    endif()
  endforeach()
  add_executable(${target} ${sources})
  target_include_directories(${target} PRIVATE "${CMAKE_SOURCE_DIR}")
  target_link_libraries(${target} PRIVATE ${arg_LINK} fur_options)
  fur_precompile(${target})
  if(TARGET fur_arrows)
    add_dependencies(${target} fur_arrows)
  endif()
endfunction()

# A wasm program for Node. Two manners of Emscripten 3.1.6: it cannot make an ES module for Node, so it is
# CommonJS in a folder whose package.json says so (the tree's says otherwise); and compiling
# asynchronously it hands a path to fetch().
function(fur_node_program target)
  if(TARGET ${target})
    set(folder "${CMAKE_BINARY_DIR}/node")
    file(WRITE "${folder}/package.json" "{ \"type\": \"commonjs\" }\n")
    target_compile_options(${target} PRIVATE ${FUR_EXCEPTIONS})
    set_target_properties(${target} PROPERTIES SUFFIX ".js" RUNTIME_OUTPUT_DIRECTORY "${folder}")
    target_link_options(${target} PRIVATE -sENVIRONMENT=node -sWASM_ASYNC_COMPILATION=0
      -sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=1MB -sEXIT_RUNTIME=1 ${ARGN})
  endif()
endfunction()

# The wasm programs: modules for the browser that can also be imported, and with a given wasmBinary
# instantiated, in Node; no eval, no file system. SMALLEST: what any page waits for.
function(fur_web_program target)
  cmake_parse_arguments(arg "SMALLEST" "" "" ${ARGN})
  fur_program(${target} ${arg_UNPARSED_ARGUMENTS})
  if(NOT TARGET ${target})
    return()
  endif()
  # The bindings run once a call of a person's or a page's; the download counts more.
  target_compile_options(${target} PRIVATE ${FUR_EXCEPTIONS} $<$<CONFIG:Release>:-Os>)
  set_target_properties(${target} PROPERTIES SUFFIX ".mjs" RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/web")
  target_link_options(${target} PRIVATE
    -sMODULARIZE=1 -sEXPORT_ES6=1 -sENVIRONMENT=web -sFILESYSTEM=0 -sDYNAMIC_EXECUTION=0
    -sALLOW_MEMORY_GROWTH=1 -sMEMORY_GROWTH_LINEAR_STEP=1MB -sTOTAL_STACK=1MB -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
    -sMALLOC=emmalloc -sEXPORTED_FUNCTIONS=_malloc,_free
    -sEXPORTED_RUNTIME_METHODS=GL -sINCOMING_MODULE_JS_API=instantiateWasm,onAbort,print,printErr
    -sGL_SUPPORT_AUTOMATIC_ENABLE_EXTENSIONS=0 -sTEXTDECODER=2
    # The page makes the contexts, and the browser tells of errors.
    -sGL_WORKAROUND_SAFARI_GETCONTEXT_BUG=0 -sGL_TRACK_ERRORS=0 -sSUPPORT_ERRNO=0
    $<$<CONFIG:Debug>:-sASSERTIONS=1>
    # After the compiler's own -O3, wasm-opt's adds size but no speed that we could measure.
    $<$<CONFIG:Release>:-Oz> --no-entry)
  if(NOT CMAKE_BUILD_TYPE STREQUAL "Release")
    return()
  endif()
  # Another round of wasm-opt after what emcc does last inlines what is shorter than a call with it.
  set(wasm "$<TARGET_FILE_DIR:${target}>/${target}.wasm")
  find_program(FUR_WASM_OPT wasm-opt HINTS "${EMSCRIPTEN_ROOT_PATH}/../bin" NO_CMAKE_FIND_ROOT_PATH)
  if(FUR_WASM_OPT)
    set(round -Oz --always-inline-max-function-size=5)
    if(arg_SMALLEST)
      # The linker inlines only what one other alone calls, as each module has inlined what its speed needs, and emcc nothing: apart,
      # more functions are alike. (Long hair would move 4 % slower.) Twice, as the first pass leaves the second 0.6 KB, gzipped.
      target_link_options(${target} PRIVATE -Wl,-mllvm,-inline-threshold=-100
        -sBINARYEN_EXTRA_PASSES=--always-inline-max-function-size=0,--one-caller-inline-max-function-size=0)
      list(APPEND round -Oz --one-caller-inline-max-function-size=20)
    endif()
    add_custom_command(TARGET ${target} POST_BUILD COMMAND ${FUR_WASM_OPT} ${round} --enable-bulk-memory --enable-sign-ext
      --enable-nontrapping-float-to-int --enable-exception-handling --enable-simd --enable-mutable-globals ${wasm} -o ${wasm} VERBATIM)
  endif()
  # And functions that are alike come next to each other.
  if(FUR_NODE)
    set(order "${CMAKE_SOURCE_DIR}/tools/order-functions.mjs")
    add_custom_command(TARGET ${target} POST_BUILD COMMAND "${FUR_NODE}" "${order}" ${wasm} VERBATIM)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${order}")
  endif()
endfunction()

# Makes the models that are shipped. Built for both targets, so that the web app alone needs no native compiler.
fur_program(wet-fur-make-assets SOURCES assets/*.cpp LINK fur_stages)
if(EMSCRIPTEN)
  # It runs once a build: linking it well takes longer than it runs.
  fur_node_program(wet-fur-make-assets -sNODERAWFS=1 "$<$<CONFIG:Release>:-O1;-Wl,--lto-O1>")
  fur_web_program(wet-fur SMALLEST SOURCES web/*.cpp LINK fur_app)
  # The same with long hair, for models that have some.
  fur_web_program(wet-fur-hair SOURCES web/*.cpp web/hair/*.cpp LINK fur_app)
  fur_web_program(wet-fur-editor SOURCES web/*.cpp web/hair/*.cpp web/editor/*.cpp LINK fur_app_editor)
  # What a visitor of the viewer need not download, and those who draw nothing need not take with the rest.
  fur_web_program(wet-fur-core SOURCES web/Boundary.cpp web/SettingsBindings.cpp web/core/*.cpp LINK fur_scene fur_hair)
  target_link_options(wet-fur-core PRIVATE -sEXPORTED_RUNTIME_METHODS=HEAPU8)
else()
  fur_program(wet-fur-render SOURCES native/*.cpp native/headless/*.cpp LINK fur_app third_party_egl)
  fur_program(wet-fur-compare SOURCES native/*.cpp native/compare/*.cpp native/headless/EglContext.cpp
    LINK fur_app fur_truth third_party_egl)
  fur_program(wet-fur SOURCES native/*.cpp native/window/*.cpp LINK fur_app_editor third_party_glfw)
endif()
