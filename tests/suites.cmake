# Run when a test program has been linked: writes LIST, a file of CTest's, with one test for each suite
# of PROGRAM, all of whose tests then run in one process. See tautline_test(SUITES).
#
#   cmake -DPROGRAM=... -DLIST=... -DTIMEOUT=... -DWITHOUT=<patterns of GoogleTest> -P suites.cmake

execute_process(COMMAND "${PROGRAM}" --gtest_list_tests --gtest_filter=*-${WITHOUT}
  OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
# a suite stands at the start of a line and ends with a dot; "Some/" of a parametrised one may be many
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\.[^\n]*" lines "${listed}")
set(suites "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^\n?([^.]*/)?([A-Za-z0-9_]+)\\..*" "\\2" suite "${line}")
  list(APPEND suites "${suite}")
endforeach()
list(REMOVE_DUPLICATES suites)
if(suites STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()

set(text "")
foreach(suite IN LISTS suites)
  string(APPEND text
    "add_test([=[${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*:*/${suite}.*-${WITHOUT}]=])\n"
    "set_tests_properties([=[${suite}]=] PROPERTIES TIMEOUT ${TIMEOUT})\n")
endforeach()
file(WRITE "${LIST}" "${text}")
