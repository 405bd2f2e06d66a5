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

run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/consumer" -B "${WORK_DIR}/build"
  -G "${GENERATOR}"
  "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_CXX_FLAGS=${FLAGS}"
  "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DEigen3_DIR=${EIGEN_DIR}"
  "-DWANTED_VERSION=${VERSION}")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --config "${CONFIG}")
run("${CMAKE_CTEST_COMMAND}" --test-dir "${WORK_DIR}/build" -C "${CONFIG}" --output-on-failure
  --no-tests=error)

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
