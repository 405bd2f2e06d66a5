# Run when a test program has been linked: writes LIST, a file of CTest's, with one test for each suite
# of PROGRAM, all of whose tests then run in one process. See tautline_test.
#
#   cmake -DPROGRAM=... -DLIST=... -DPREFIX=... -DTIMEOUT=... -DWITHOUT=<patterns of GoogleTest> -P suites.cmake

execute_process(COMMAND "${PROGRAM}" --gtest_list_tests --gtest_filter=*-${WITHOUT}
  OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
# a suite stands at the start of a line and ends with a dot; "Some/" of a parametrised one may be many.
# Its tests follow, each on a line that begins with blanks.
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")  # what a parameter is
string(REPLACE "\n" ";" lines "${listed}")
set(suites "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([^. ]*/)?([A-Za-z0-9_]+)\\.$")
    set(suite "${CMAKE_MATCH_2}")
    if(suite MATCHES "^[0-9]+$")
      message(FATAL_ERROR "${line} is a typed suite: its number alone would name it")
    endif()
    list(APPEND suites "${suite}")
  elseif(line MATCHES "^  ")
    math(EXPR tests_of_${suite} "0${tests_of_${suite}} + 1")
  endif()
endforeach()
list(REMOVE_DUPLICATES suites)
if(suites STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()

# Left out is a suite whose every test skips itself. "0 tests passed" alone would hide one whose every test fails.
set(skipped "\\[  PASSED  \\] 0 tests\\.\n(\\[  SKIPPED \\] [^\n]*\n?)+$")
# the largest begin first, so that none is left over for one core at the end
set(text "")
foreach(suite IN LISTS suites)
  string(APPEND text
    "add_test([=[${PREFIX}${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*:*/${suite}.*-${WITHOUT}]=])\n"
    "set_tests_properties([=[${PREFIX}${suite}]=] PROPERTIES TIMEOUT ${TIMEOUT} COST ${tests_of_${suite}}\n"
    "  SKIP_REGULAR_EXPRESSION [=[${skipped}]=])\n")
endforeach()
file(WRITE "${LIST}" "${text}")
