#include <array>
#include <string_view>

#include "handles.hpp"
#include "tautline/impact.hpp"

namespace {

#define TAUTLINE_TEXT_OF(value) #value
#define TAUTLINE_VERSION_TEXT(major, minor, patch) \
  TAUTLINE_TEXT_OF(major) "." TAUTLINE_TEXT_OF(minor) "." TAUTLINE_TEXT_OF(patch)

constexpr std::array status_texts = {
    "all is well",
    "an argument must not be null",
    "the member `size` of a struct is not right, or members that this version does not know are "
    "not 0",
    "the case has problems, which tautline_problems names",
    "an option is refused, tautline_option_problems says why",
    "a time is not a number in the range of the motion",
    "the rows asked for are not all there",
    "no number of the case has this name",
    "the number of threads must be 0 or above",
    "memory is missing",
    "the library has a mistake: please report it",
};
static_assert(status_texts.size() == TAUTLINE_BROKEN + 1);

// the constants of the header are the enumerators of the library, in the same order
static_assert(static_cast<int>(tautline::ImpactLaw::energetic) == TAUTLINE_ENERGETIC);
static_assert(static_cast<int>(tautline::EventKind::impact) == TAUTLINE_IMPACT);
static_assert(static_cast<int>(tautline::EventKind::slack) == TAUTLINE_SLACK);
static_assert(static_cast<int>(tautline::Ending::locked) == TAUTLINE_LOCKED);
static_assert(static_cast<int>(tautline::Ending::overflow) == TAUTLINE_OVERFLOW);

/// The name of an enumerator up to `last`; null beyond. The library's names end in a zero byte.
template <class Enum>
const char* name_of(std::int32_t value, Enum last) {
  const bool known = value >= 0 && value <= static_cast<std::int32_t>(last);
  return known ? to_string(static_cast<Enum>(value)).data() : nullptr;
}

}  // namespace

const char* tautline_version(void) {
  return TAUTLINE_VERSION_TEXT(TAUTLINE_VERSION_MAJOR, TAUTLINE_VERSION_MINOR,
                               TAUTLINE_VERSION_PATCH);
}

int32_t tautline_version_number(void) { return TAUTLINE_VERSION_NUMBER; }

const char* tautline_status_text(int32_t status) {
  const bool known = status >= 0 && status <= TAUTLINE_BROKEN;
  return known ? status_texts.at(static_cast<std::size_t>(status)) : nullptr;
}

const char* tautline_law_name(int32_t law) { return name_of(law, tautline::ImpactLaw::energetic); }

const char* tautline_event_kind_name(int32_t kind) {
  return name_of(kind, tautline::EventKind::slack);
}

const char* tautline_ending_name(int32_t ending) {
  return name_of(ending, tautline::Ending::overflow);
}
