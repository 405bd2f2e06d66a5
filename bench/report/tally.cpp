#include "bench/report/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// "is sound" of one run, "are sound" of several.
struct Predicate {
  const char* one;
  const char* several;
};

Predicate predicate_of(Word word) {
  switch (word) {
    case Word::sound:
      return {"is sound", "are sound"};
    case Word::listed_problem:
      return {"has a listed problem", "have a listed problem"};
    case Word::problem:
      return {"has a problem", "have a problem"};
    case Word::too_few:
      break;
  }
  return {"tells too little", "tell too little"};
}

}  // namespace

void Tally::add(const RunRow& run) {
  const Word word = run.verdict                ? run.verdict->word
                    : did_its_work(run.status) ? Word::too_few
                                               : Word::problem;
  ++counts_.at(static_cast<std::size_t>(word));
}

void Tally::add(const Tally& other) {
  std::transform(counts_.begin(), counts_.end(), other.counts_.begin(), counts_.begin(),
                 std::plus<>());
}

std::size_t Tally::runs() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
}

Word Tally::worst() const {
  const auto found = std::find_if(worst_first.begin(), worst_first.end(),
                                  [this](Word word) { return of(word) > 0; });
  return found != worst_first.end() ? *found : Word::too_few;
}

std::string tally_text(const Tally& tally) {
  const Word worst = tally.worst();
  const std::size_t count = tally.of(worst);
  return count == tally.runs()
             ? to_string(worst)
             : fmt::format("{} in {} of {}", to_string(worst), count, tally.runs());
}

std::string sentence_of(const Tally& tally) {
  std::vector<std::string> parts;
  for (const Word word : worst_first) {
    if (const std::size_t count = tally.of(word); count > 0) {
      const Predicate does = predicate_of(word);
      parts.push_back(fmt::format("{} {}", count, count == 1 ? does.one : does.several));
    }
  }
  return parts.empty()
             ? "no run."
             : fmt::format("of {}, {}.", counted(tally.runs(), "run"), joined(parts, "and"));
}

}  // namespace tautline::bench
