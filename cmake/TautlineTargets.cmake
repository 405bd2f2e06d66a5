# What every target of the project shares. Targets and properties only, no global flags.

set(TAUTLINE_ENGINE_DIR "${PROJECT_BINARY_DIR}/engines/modules")
# the thread sanitizer cannot be combined with the others
set(TAUTLINE_SANITIZERS address,undefined)
if(TAUTLINE_TSAN)
  set(TAUTLINE_SANITIZERS thread)
endif()

# tautline_target(<target>): language level, warnings, sanitizers, reproducible floating point.
# A target with the property TAUTLINE_UNSANITIZED is compiled without sanitizers and linked with them:
# for what would take long to compile and checks nothing that others do not.
function(tautline_target target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON
    POSITION_INDEPENDENT_CODE ON)
  # A contracted multiply-add rounds once where the source rounds twice. Same input, same bits, on every
  # machine, needs it off (tests/analytic/benchmarks/same-bits).
  target_compile_options(${target} PRIVATE
    -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
    -Wnon-virtual-dtor -Woverloaded-virtual
    $<$<BOOL:${TAUTLINE_WARNINGS_AS_ERRORS}>:-Werror>)
  # the same package from wherever the source lies
  target_compile_options(${target} PRIVATE
    $<$<CONFIG:Release>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=>)
  # Clang has limits GCC has not: long literals, and names that another source of a unity build gave a function
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:Clang>:-Wno-overlength-strings>
    $<$<AND:$<CXX_COMPILER_ID:Clang>,$<BOOL:${TAUTLINE_UNITY}>>:-Wno-shadow>)
  # GCC looks for memory to give back when it has taken 128 MB. A source made of several takes more, and each
  # look costs: up to a sixth of the time to compile it.
  target_compile_options(${target} PRIVATE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${TAUTLINE_UNITY}>>:--param=ggc-min-heapsize=524288>)
  if(TAUTLINE_SANITIZE)
    # with sanitizers GCC warns of uninitialised members inside its own <regex> (GCC bug 105562)
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
      $<$<NOT:$<BOOL:$<TARGET_PROPERTY:TAUTLINE_UNSANITIZED>>>:-fsanitize=${TAUTLINE_SANITIZERS}$<SEMICOLON>-fno-sanitize-recover=all$<SEMICOLON>-fno-omit-frame-pointer>)
    # The checks make functions long, and GCC's usual colouring of registers takes up to a third of the time
    # to compile them; its simpler allocator checks the same.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fira-algorithm=priority>)
    # The solver, the program and the tests reach memory through containers and references alone. What these
    # three checks would find there ASan finds as a bad access, and they take a third of the time to compile.
    # The fuzzers leave them to the preset `asan` in all folders.
    cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}"
      OUTPUT_VARIABLE room)
    if((TAUTLINE_FUZZ AND NOT TAUTLINE_TESTS) OR room MATCHES "^(analytic|bench|tests)(/|$)")
      target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,object-size)
    endif()
    # A program at a fixed address has nothing to relocate when it starts: the table of checked globals is
    # megabytes of addresses, and the tests start the program some thousand times.
    target_link_options(${target} PRIVATE -fsanitize=${TAUTLINE_SANITIZERS}
      $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>)
    # A fuzzer needs to see which branches an input takes. `undefined` does not include the check of a double that
    # does not fit the integer it is converted to, a usual mistake in readers.
    if(TAUTLINE_FUZZ)
      target_compile_options(${target} PRIVATE
        $<$<NOT:$<BOOL:$<TARGET_PROPERTY:TAUTLINE_UNSANITIZED>>>:-fsanitize=fuzzer-no-link,float-cast-overflow>
        # the compared values, too, cost more than all else: not where the same code runs all tests
        $<$<BOOL:${TAUTLINE_TESTS}>:-fno-sanitize-coverage=trace-cmp,indirect-calls>)
    endif()
    # for tests that must be shorter, or cannot be, where what they call is sanitized
    target_compile_definitions(${target} PRIVATE TAUTLINE_SANITIZED=1)
    # Eigen would take another malloc under ASan, and free what an engine built without it allocated
    target_compile_definitions(${target} PRIVATE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  endif()
endfunction()

# tautline_unity(<target> <count>): compiles so many of its sources as one where TAUTLINE_UNITY is on.
# Headers are then parsed and templates instantiated once for all of them, most of what a source costs.
# Sources that stand together must not give two things of their unnamed namespaces one name.
function(tautline_unity target count)
  if(TAUTLINE_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
  endif()
endfunction()
