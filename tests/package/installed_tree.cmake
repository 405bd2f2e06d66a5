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

# so do the programs on the page about cables, each in the place of an example's
set(page "${prefix}/${EXAMPLE_DIR}/../cables.md")
if(NOT EXISTS "${prefix}/${EXAMPLE_DIR}/../cables.svg")
  message(FATAL_ERROR "the picture of cables.md is not installed")
endif()
file(READ "${page}" page)
foreach(example IN LISTS EXAMPLES)
  string(REPLACE "_crane" "" engine ${example})
  set(mark "<!-- program of: ${engine} -->\n```cpp\n")
  string(FIND "${page}" "${mark}" start)
  if(start EQUAL -1)
    message(FATAL_ERROR "cables.md has no program of ${engine}")
  endif()
  string(LENGTH "${mark}" skipped)
  math(EXPR start "${start} + ${skipped}")
  string(SUBSTRING "${page}" ${start} -1 program)
  string(FIND "${program}" "```" length)
  string(SUBSTRING "${program}" 0 ${length} program)
  file(COPY "${prefix}/${EXAMPLE_DIR}/${example}/" DESTINATION "${WORK_DIR}/page_${engine}")
  file(WRITE "${WORK_DIR}/page_${engine}/main.cpp" "${program}")
  build_project("${WORK_DIR}/page_${engine}" "${WORK_DIR}/page_${engine}/build"
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON)
  run("${WORK_DIR}/page_${engine}/build/${example}")
endforeach()

if(NOT PROGRAM)
  return()
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
find_program(python python3)
if(python)
  run("${CMAKE_COMMAND}" -E env "CXXFLAGS=${FLAGS}" "Eigen3_DIR=${EIGEN_DIR}"
    "${SOURCE_DIR}/scripts/test-tutorials" "${prefix}")
endif()

# the workflow that docs/ci-recipe.md gives to the maintainer of an engine
run("${CMAKE_COMMAND}" -E env "CXXFLAGS=${FLAGS}" "Eigen3_DIR=${EIGEN_DIR}"
  "${SOURCE_DIR}/scripts/test-recipe" "${prefix}")
