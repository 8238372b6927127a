# One library per folder of src/, linked along the allowed arrows (tools/check-arrows.mjs holds the
# includes to the same table).

find_program(FUR_NODE node NO_CMAKE_FIND_ROOT_PATH)

add_library(fur_options INTERFACE)
target_include_directories(fur_options INTERFACE "${CMAKE_SOURCE_DIR}/src")
target_compile_options(fur_options INTERFACE -Wall -Wextra -Wpedantic "$<$<NOT:$<CONFIG:Debug>>:-Werror>")
target_link_libraries(fur_options INTERFACE third_party_headers)

# What most files include, compiled once (cmake/Precompiled.h); not under a compiler cache, which it would miss.
# Natively one serves all modules; as wasm their options differ, so that each has its own, which does not pay where
# several files are compiled together.
function(fur_precompile target)
  if(CMAKE_CXX_COMPILER_LAUNCHER OR (EMSCRIPTEN AND CMAKE_UNITY_BUILD))
    return()
  endif()
  if(EMSCRIPTEN OR target STREQUAL "fur_precompiled")
    target_precompile_headers(${target} PRIVATE "${CMAKE_SOURCE_DIR}/cmake/Precompiled.h")
  else()
    target_precompile_headers(${target} REUSE_FROM fur_precompiled)
  endif()
endfunction()
if(NOT EMSCRIPTEN AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # gcc 12 then gives false alarms where it has inlined the copy of a std::string.
    target_compile_options(fur_options INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overread -Wno-stringop-overflow)
  endif()
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/generated/precompiled.cpp" CONTENT "")
  add_library(fur_precompiled OBJECT EXCLUDE_FROM_ALL "${CMAKE_BINARY_DIR}/generated/precompiled.cpp")
  target_link_libraries(fur_precompiled PRIVATE fur_options)
  fur_precompile(fur_precompiled)
endif()

# The presets that `npm test` builds compile 8 files of a target together, as wasm 16 (CMAKE_UNITY_BUILD), for little more than
# half the time. So names in unnamed namespaces must differ within a folder, of src/, tests/ and web/.
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # gcc takes a source that is included for a header.
  target_compile_options(fur_options INTERFACE -Wno-subobject-linkage)
endif()

# fur_library(<target> <sources of> <linked>...): every .cpp below a folder, as a static library; as
# an interface library while the folder has none. EXCEPT matches subfolders that belong to other targets.
function(fur_library target folder)
  cmake_parse_arguments(arg "" "EXCEPT" "" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/${folder}/*.cpp")
  if(arg_EXCEPT)
    list(FILTER sources EXCLUDE REGEX "/${folder}/${arg_EXCEPT}/")
  endif()
  if(sources)
    add_library(${target} STATIC ${sources})
    target_link_libraries(${target} PUBLIC fur_options ${arg_UNPARSED_ARGUMENTS})
    fur_precompile(${target})
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE fur_options ${arg_UNPARSED_ARGUMENTS})
  endif()
endfunction()

fur_library(fur_core src/core)
fur_library(fur_tools src/app/tools fur_core)
fur_library(fur_geometry src/geometry fur_core)
fur_library(fur_settings src/settings fur_core)
target_include_directories(fur_settings PRIVATE "${CMAKE_SOURCE_DIR}")  # assets/Presets.inc
set(FUR_FIELDS fur_geometry fur_settings)
fur_library(fur_furgen src/furgen ${FUR_FIELDS})
fur_library(fur_wet src/wet ${FUR_FIELDS})
# Constants that shaders have as well (shared/Wet.h).
target_include_directories(fur_wet PUBLIC "${CMAKE_SOURCE_DIR}/shaders/es3")
fur_library(fur_dynamics src/dynamics ${FUR_FIELDS})
fur_library(fur_groom src/groom ${FUR_FIELDS} fur_dynamics)
fur_library(fur_hair src/hair ${FUR_FIELDS} fur_groom fur_dynamics)
fur_library(fur_scene src/scene fur_furgen fur_groom fur_wet fur_dynamics fur_hair)
# Wiring without a context: what a person did, and the stages from input to what is drawn.
fur_library(fur_commands src/app/commands fur_tools fur_groom fur_wet)
fur_library(fur_stages src/app/stages fur_commands fur_scene)
set(FUR_PURE_MODULES fur_core fur_tools fur_geometry fur_settings fur_furgen fur_groom fur_wet fur_dynamics fur_hair fur_scene fur_commands
  fur_stages)

if(NOT EMSCRIPTEN)
  # The reference renderer: minutes of several threads, nothing for a web page.
  find_package(Threads REQUIRED)
  fur_library(fur_truth src/truth fur_furgen fur_wet fur_dynamics fur_hair Threads::Threads)
  target_include_directories(fur_truth PUBLIC "${CMAKE_SOURCE_DIR}/shaders/es3")
  list(APPEND FUR_PURE_MODULES fur_truth)
endif()

if(TARGET third_party_gles)
  file(GLOB_RECURSE FUR_SHADERS CONFIGURE_DEPENDS
    "${CMAKE_SOURCE_DIR}/shaders/es3/*.vert" "${CMAKE_SOURCE_DIR}/shaders/es3/*.frag"
    "${CMAKE_SOURCE_DIR}/shaders/es3/*.glsl" "${CMAKE_SOURCE_DIR}/shaders/es3/*.h")
  set(shader_header "${CMAKE_BINARY_DIR}/generated/render/ShaderSources.h")
  # What the browser downloads; debug builds and programs keep names that can be read.
  set(short_names "${CMAKE_SOURCE_DIR}/tools/short-names.mjs")
  set(shorten)
  if(EMSCRIPTEN AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    set(shorten COMMAND "${FUR_NODE}" "${short_names}" "${shader_header}")
  endif()
  add_custom_command(OUTPUT "${shader_header}"
    COMMAND "${CMAKE_COMMAND}" "-DSHADERS=${CMAKE_SOURCE_DIR}/shaders/es3" "-DOUTPUT=${shader_header}"
      -P "${CMAKE_SOURCE_DIR}/cmake/EmbedShaders.cmake"
    ${shorten}
    DEPENDS ${FUR_SHADERS} "${CMAKE_SOURCE_DIR}/cmake/EmbedShaders.cmake" "${short_names}"
    COMMENT "Embedding the shaders" VERBATIM)
  add_custom_target(fur_shaders DEPENDS "${shader_header}")
  add_library(fur_shader_sources INTERFACE)
  add_dependencies(fur_shader_sources fur_shaders)
  target_include_directories(fur_shader_sources INTERFACE
    "${CMAKE_BINARY_DIR}/generated" "${CMAKE_SOURCE_DIR}/shaders/es3")

  fur_library(fur_gl src/gl fur_core third_party_gles)
  fur_library(fur_render src/render fur_scene fur_gl fur_shader_sources)
  fur_library(fur_app src/app fur_stages fur_render EXCEPT "(editor|tools|commands|stages)")
  if(TARGET imgui)
    include(EditorFont)
    fur_library(fur_editor src/editor fur_tools fur_scene imgui fur_editor_font)
    fur_library(fur_app_editor src/app/editor fur_app fur_editor imgui_opengl3)
  endif()
endif()

# Options of single files: these cannot use what was precompiled without them.
function(fur_source_options sources)
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS "${ARGN}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# fur_part_options(<module> <options> <sources>...): the same for many files of a module, on top of the module's own. As a target
# of theirs, so that they too are compiled together.
function(fur_part_options module options)
  set(part ${module}_part)
  get_target_property(sources ${module} SOURCES)
  get_target_property(linked ${module} LINK_LIBRARIES)
  list(REMOVE_ITEM sources ${ARGN})
  set_property(TARGET ${module} PROPERTY SOURCES ${sources} $<TARGET_OBJECTS:${part}>)
  add_library(${part} OBJECT ${ARGN})
  target_link_libraries(${part} PRIVATE ${linked})
  target_compile_options(${part} PRIVATE $<TARGET_PROPERTY:${module},COMPILE_OPTIONS> ${options})
  fur_precompile(${part})
endfunction()

if(EMSCRIPTEN)
  file(GLOB importers CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/src/scene/import/*.cpp")
  fur_part_options(fur_scene "${FUR_EXCEPTIONS}" ${importers} "${CMAKE_SOURCE_DIR}/src/scene/export/ExportDocument.cpp")
  # Much code that runs once a model, once a file or once a frame: the download counts more than its speed. Without
  # -finline-functions Emscripten leaves small functions where they are, which makes a surface take four times as long,
  # and water three times.
  foreach(module furgen hair groom scene geometry wet)
    if(TARGET fur_${module})
      target_compile_options(fur_${module} PRIVATE "$<$<CONFIG:Release>:-Oz;-finline-functions>")
    endif()
  endforeach()
  # These have no loops over vertices or texels.
  foreach(module settings gl tools stages app commands render)
    if(TARGET fur_${module})
      target_compile_options(fur_${module} PRIVATE "$<$<CONFIG:Release>:-Oz>")
    endif()
  endforeach()
  foreach(source MovingVertices SurfaceBuffers WetCells passes/fin/FinEdges passes/fin/MovingEdges)
    fur_source_options("${CMAKE_SOURCE_DIR}/src/render/${source}.cpp" "$<$<CONFIG:Release>:-finline-functions>")
  endforeach()
  # Once a chart, once a hard edge, once a model.
  foreach(source AtlasOutlines AtlasUv ChartPacking ChartRelaxation Charts CoatThickness HardEdges SurfaceBytes)
    fur_source_options("${CMAKE_SOURCE_DIR}/src/geometry/${source}.cpp" "$<$<CONFIG:Release>:-fno-inline-functions>")
  endforeach()
  # Once a model; whiskers, at most 512, at each step of a brush as well.
  foreach(source Lie Whiskers)
    fur_source_options("${CMAKE_SOURCE_DIR}/src/groom/${source}.cpp" "$<$<CONFIG:Release>:-fno-inline-functions>")
  endforeach()
  foreach(source Json NumberText SharedThings)
    fur_source_options("${CMAKE_SOURCE_DIR}/src/core/${source}.cpp" "$<$<CONFIG:Release>:-Os>")
  endforeach()
  # Every wet place, every other step: four at a time.
  fur_source_options("${CMAKE_SOURCE_DIR}/src/wet/Flow.cpp" "$<$<CONFIG:Release>:-Os;-finline-functions>;-msimd128")
  # Every vertex, every frame: four at a time (dynamics/Lanes.h).
  target_compile_options(fur_dynamics PRIVATE "$<$<CONFIG:Release>:-Os;-finline-functions>" -msimd128)
  # Every guide, every step: four at a time. -O2 would be a third faster and 5 KB of download more.
  target_compile_options(fur_hair PRIVATE -msimd128)
  set(every_step AdaptiveDetail CascadeModel Colliders Crowding ForestModel HairWaterStep Lengths ShownNodes SimulationStep SpringModel)
  list(TRANSFORM every_step REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/src/hair/\\1.cpp")
  fur_part_options(fur_hair "$<$<CONFIG:Release>:-Os;-finline-functions>" ${every_step})
  foreach(source scene/Pose render/MovingVertices render/passes/fin/MovingEdges)
    fur_source_options("${CMAKE_SOURCE_DIR}/src/${source}.cpp" "-finline-functions;-msimd128")
  endforeach()
endif()

# The programs wait for this check, so a forbidden include fails the build of all of them.
if(FUR_NODE)
  file(GLOB_RECURSE checked CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/src/*" "${CMAKE_SOURCE_DIR}/web/*.cpp"
    "${CMAKE_SOURCE_DIR}/web/*.h" "${CMAKE_SOURCE_DIR}/native/*")
  set(arrows_stamp "${CMAKE_BINARY_DIR}/arrows.stamp")
  add_custom_command(OUTPUT "${arrows_stamp}"
    COMMAND "${FUR_NODE}" "${CMAKE_SOURCE_DIR}/tools/check-arrows.mjs" "${CMAKE_SOURCE_DIR}" --stamp "${arrows_stamp}"
    DEPENDS ${checked} "${CMAKE_SOURCE_DIR}/tools/check-arrows.mjs"
    COMMENT "Checking the arrows between modules" VERBATIM)
  add_custom_target(fur_arrows DEPENDS "${arrows_stamp}")
else()
  message(STATUS "wet-fur: no Node.js; the arrows between modules are not checked")
endif()
