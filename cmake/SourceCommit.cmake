# Writes OUTPUT, the C++ source that names the commit that SOURCE is at, if it says anything new. Called at
# each build by bench/CMakeLists.txt.
set(commit "unknown")
find_program(git git)
if(git)
  # whoever owns the checkout; and not the repository that a copy without one may lie in
  execute_process(
    COMMAND "${git}" -c "safe.directory=*" -C "${SOURCE}" rev-parse --show-toplevel
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(
    COMMAND "${git}" -c "safe.directory=*" -C "${SOURCE}" describe --always --dirty --abbrev=40 --exclude=*
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  get_filename_component(source "${SOURCE}" REALPATH)
  if(described AND top STREQUAL source)
    set(commit "${described}")
  endif()
endif()
set(text "// Written by cmake/SourceCommit.cmake.
#include \"bench/store/source_commit.hpp\"

namespace tautline::bench {

std::string_view source_commit() { return \"${commit}\"; }

}  // namespace tautline::bench
")
set(old "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" old)
endif()
if(NOT text STREQUAL old)
  file(WRITE "${OUTPUT}" "${text}")
endif()
