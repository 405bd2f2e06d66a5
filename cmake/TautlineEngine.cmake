# Engines are optional modules. Each lives in engines/<name>/ with a CMakeLists.txt that either calls
# tautline_engine_module(<name> SOURCES ... LIBRARIES ...) or tautline_engine_missing(<name> <reason>).
# Two engines may share a folder, which is read for each, with its name in `name` and the folder's in
# `folder`; they share a package too.

# tautline_engine(<name> <default: ON|AUTO|OFF> <package that brings it> [<folder>])
function(tautline_engine name default package)
  set(folder ${name})
  if(ARGC GREATER 3)
    set(folder ${ARGV3})
  endif()
  string(TOUPPER "TAUTLINE_${name}" option)
  set(${option} ${default} CACHE STRING "Build the ${name} plug-in: ON (required), AUTO or OFF")
  set_property(CACHE ${option} PROPERTY STRINGS ON AUTO OFF)
  set_property(GLOBAL PROPERTY TAUTLINE_MISSING_${name} "")
  if(${option} STREQUAL "OFF")
    set_property(GLOBAL PROPERTY TAUTLINE_MISSING_${name} "switched off when tautline was built")
    set(package "")  # brings nothing here
  else()
    add_subdirectory(${folder} ${name})
    get_property(reason GLOBAL PROPERTY TAUTLINE_MISSING_${name})
    if(reason AND ${option} STREQUAL "ON")
      message(FATAL_ERROR "engine ${name}: ${reason}. Install ${package}, "
                          "or configure with -D${option}=OFF to build without it.")
    endif()
  endif()
  get_property(reason GLOBAL PROPERTY TAUTLINE_MISSING_${name})
  set_property(GLOBAL APPEND_STRING PROPERTY TAUTLINE_ENGINE_ROWS
    "    {\"${name}\", \"${package}\", \"${reason}\"},\n")
  if(reason)
    message(STATUS "engine ${name}: not built (${reason})")
  else()
    message(STATUS "engine ${name}: built")
  endif()
endfunction()

# Says that an engine cannot be built here, and why.
function(tautline_engine_missing name reason)
  set_property(GLOBAL PROPERTY TAUTLINE_MISSING_${name} "${reason}")
endfunction()

# tautline_engine_module(<name> SOURCES <files> [LIBRARIES <targets>])
function(tautline_engine_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  set(target tautline-engine-${name})
  add_library(${target} MODULE ${arg_SOURCES})
  tautline_target(${target})
  tautline_unity(${target} 16)
  set_target_properties(${target} PROPERTIES
    PREFIX ""
    LIBRARY_OUTPUT_DIRECTORY "${TAUTLINE_ENGINE_DIR}")
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/engines")
  target_link_libraries(${target} PRIVATE tautline::engine ${arg_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY TAUTLINE_ENGINE_MODULES ${target})
  # the exact engine is the control, without which the program has nothing to say
  set(component program)
  if(NOT name STREQUAL "exact")
    set(component engine_${folder})
    set_property(GLOBAL APPEND PROPERTY TAUTLINE_ENGINE_COMPONENTS ${component})
  endif()
  install(TARGETS ${target}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/tautline/engines COMPONENT ${component})
endfunction()

# Writes the list of known engines, so that the program can name the ones that are missing.
function(tautline_write_engine_list)
  get_property(rows GLOBAL PROPERTY TAUTLINE_ENGINE_ROWS)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/generated/known_engines.inc" CONTENT "${rows}" @ONLY)
endfunction()
