# Run by CTest with cmake -P; see CMakeLists.txt for the variables.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGV}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "exit code ${result} from: ${command}\n${output}")
  endif()
endfunction()

# install to one place and use from another: the tree must not remember where it was put
set(prefix "${WORK_DIR}/prefix")
file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${WORK_DIR}/first")
file(RENAME "${WORK_DIR}/first" "${prefix}")

# a path of the build machine in the package would break on any other
file(GLOB_RECURSE package_files "${prefix}/*/cmake/tautline/*.cmake")
if(NOT package_files)
  message(FATAL_ERROR "no package files were installed under ${prefix}")
endif()
foreach(file IN LISTS package_files)
  file(READ "${file}" text)
  string(FIND "${text}" "${SOURCE_DIR}" found)
  if(NOT found EQUAL -1)
    message(FATAL_ERROR "${file} names a path of this checkout")
  endif()
endforeach()

# build_project(<source> <build> [-D...]): as a stranger would, whose build need not be of the libraries' kind
function(build_project source build)
  run("${CMAKE_COMMAND}" -S "${source}" -B "${build}"
    -G "${GENERATOR}"
    "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}"
    "-DCMAKE_CXX_FLAGS=${FLAGS}"
    -DCMAKE_BUILD_TYPE=Debug
    "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DEigen3_DIR=${EIGEN_DIR}"
    ${ARGN})
  run("${CMAKE_COMMAND}" --build "${build}")
endfunction()

build_project("${CMAKE_CURRENT_LIST_DIR}/consumer" "${WORK_DIR}/build"
  "-DWANTED_VERSION=${VERSION}")
run("${CMAKE_CTEST_COMMAND}" --test-dir "${WORK_DIR}/build" --output-on-failure
  --no-tests=error)

# the installed examples need the cables' headers and their engine, and no Eigen
foreach(example IN LISTS EXAMPLES)
  build_project("${prefix}/${EXAMPLE_DIR}/${example}" "${WORK_DIR}/${example}"
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
  run("${WORK_DIR}/${example}/${example}")
endforeach()

# block_of(<result> <page> <mark>): what a page shows in the block below the comment `mark`
function(block_of result page mark)
  file(READ "${page}" text)
  string(FIND "${text}" "<!-- ${mark} -->\n```" start)
  if(start EQUAL -1)
    message(FATAL_ERROR "${page} has no block of <!-- ${mark} -->")
  endif()
  string(SUBSTRING "${text}" ${start} -1 text)
  string(REGEX REPLACE "^[^\n]*\n```[a-z]*\n" "" text "${text}")
  string(FIND "${text}" "```" length)
  string(SUBSTRING "${text}" 0 ${length} text)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# so do the programs on the page about cables, each in the place of an example's
set(documents "${prefix}/${EXAMPLE_DIR}/..")
foreach(example IN LISTS EXAMPLES)
  string(REPLACE "_crane" "" engine ${example})
  block_of(program "${documents}/docs/guides/cables.md" "program of: ${engine}")
  file(COPY "${prefix}/${EXAMPLE_DIR}/${example}/" DESTINATION "${WORK_DIR}/page_${engine}")
  file(WRITE "${WORK_DIR}/page_${engine}/main.cpp" "${program}")
  build_project("${WORK_DIR}/page_${engine}" "${WORK_DIR}/page_${engine}/build"
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
  run("${WORK_DIR}/page_${engine}/build/${example}")
endforeach()

# the C interface serves a project of C by CMake and by pkg-config, and needs no Eigen
if(C_INTERFACE)
  set(impacts "impact at 1.000000000 s\nimpact at 2.000000000 s\n")
  set(ball "${WORK_DIR}/ball.toml")
  execute_process(COMMAND "${prefix}/${PROGRAM}" cases bouncing-ball OUTPUT_FILE "${ball}"
    COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE "${WORK_DIR}/c/CMakeLists.txt" "cmake_minimum_required(VERSION 3.22)
project(c LANGUAGES C)
find_package(tautline REQUIRED COMPONENTS c)
add_executable(c \"${SOURCE_DIR}/languages/c/example.c\")
target_link_libraries(c PRIVATE tautline::c)
")
  build_project("${WORK_DIR}/c" "${WORK_DIR}/c/build" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON
    "-DCMAKE_C_FLAGS=${FLAGS}")
  file(GLOB_RECURSE pc "${prefix}/*/tautline.pc")
  cmake_path(GET pc PARENT_PATH folder)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PKG_CONFIG_PATH=${folder}"
      pkg-config --cflags --libs tautline
    OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags} ${FLAGS}")
  cmake_path(GET folder PARENT_PATH libraries)
  run("${C_COMPILER}" "${SOURCE_DIR}/languages/c/example.c" -o "${WORK_DIR}/c/by_pkg_config" ${flags}
    "-Wl,-rpath,${libraries}")
  foreach(program IN ITEMS build/c by_pkg_config)
    execute_process(COMMAND "${WORK_DIR}/c/${program}" "${ball}"
      OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
    string(FIND "${said}" "${impacts}" found)
    if(NOT found EQUAL 0)
      message(FATAL_ERROR "the ball falls for 1 s and again for 1 s, ${program} says\n${said}")
    endif()
  endforeach()
endif()

# no link of a page or of the site is dead, and what the pages name is there
find_program(python python3)
if(python)
  run("${SOURCE_DIR}/scripts/check-links" "${documents}")
  foreach(file IN ITEMS README.md VALIDATION.md docs/error.svg docs/results/engines.md docs/results/findings/pull.toml
      docs/guides/ensembles/engines.toml docs/guides/recipes/floor.toml)
    if(NOT EXISTS "${documents}/${file}")
      message(FATAL_ERROR "${file} is not installed")
    endif()
  endforeach()
endif()

# an installed file names a schema that is there
file(GLOB_RECURSE files "${prefix}/*.toml")
foreach(file IN LISTS files)
  file(STRINGS "${file}" first LIMIT_COUNT 1)
  cmake_path(GET file PARENT_PATH folder)
  if(first MATCHES "^#:schema (.+)$")
    if(NOT EXISTS "${folder}/${CMAKE_MATCH_1}")
      message(FATAL_ERROR "${file} names ${CMAKE_MATCH_1}, which is not installed")
    endif()
  endif()
endforeach()

if(NOT PROGRAM)
  return()
endif()

# the project of docs/reference/api.md reads case files, says all that is wrong with one, and writes one
set(mine "${WORK_DIR}/mine")
foreach(file IN ITEMS CMakeLists.txt main.cpp)
  block_of(text "${SOURCE_DIR}/docs/reference/api.md" "file: ${file}")
  file(WRITE "${mine}/${file}" "${text}")
endforeach()
build_project("${mine}" "${mine}/build")
execute_process(COMMAND "${prefix}/${PROGRAM}" cases bouncing-ball OUTPUT_FILE "${mine}/ball.toml"
  COMMAND_ERROR_IS_FATAL ANY)
foreach(file IN ITEMS ball softer)  # what it has written is read as well
  execute_process(COMMAND "${mine}/build/mine" "${mine}/${file}.toml" "${mine}/softer.toml"
    OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  if(NOT said STREQUAL "first impact at 1.000000 s\n")
    message(FATAL_ERROR "the ball of ${file}.toml falls for 1 s, the project of docs/reference/api.md says\n${said}")
  endif()
endforeach()
file(WRITE "${mine}/wrong.toml" "name = 3\nduration = -1\n")
execute_process(COMMAND "${mine}/build/mine" "${mine}/wrong.toml" "${mine}/never.toml"
  RESULT_VARIABLE result OUTPUT_VARIABLE said)
if(NOT result EQUAL 2 OR EXISTS "${mine}/never.toml"
    OR NOT said MATCHES "wrong.toml:1: name = 3.*wrong.toml:2: duration = -1")
  message(FATAL_ERROR "a wrong file ends with exit code ${result} and\n${said}")
endif()

# the program finds the plug-ins it was installed with ...
run("${prefix}/${PROGRAM}" engines --json "${WORK_DIR}/engines.json")
file(READ "${WORK_DIR}/engines.json" engines)
file(GLOB modules RELATIVE "${prefix}" "${prefix}/${ENGINE_DIR}/*.so")
foreach(module IN LISTS modules)
  string(FIND "${engines}" "/${module}\"" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "the program does not list ${module} but\n${engines}")
  endif()
endforeach()

# ... and takes the consumer's
run("${prefix}/${PROGRAM}" run bouncing-ball --engine "${WORK_DIR}/build/still.so" --model still
  --step 0.01)

# the tutorials: an engine of one's own is built, checked and run on the bench; a crane; a case
if(python)
  run("${CMAKE_COMMAND}" -E env "CXXFLAGS=${FLAGS}" "Eigen3_DIR=${EIGEN_DIR}"
    "${SOURCE_DIR}/scripts/test-tutorials" "${prefix}")
endif()

# the workflow and the action that docs/guides/ci-recipe.md gives to the maintainer of an engine
run("${CMAKE_COMMAND}" -E env "CXXFLAGS=${FLAGS}" "Eigen3_DIR=${EIGEN_DIR}"
  "${SOURCE_DIR}/scripts/test-recipe" "${prefix}")
