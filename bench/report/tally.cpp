#include "bench/report/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "bench/report/words.hpp"

namespace tautline::bench {

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

}  // namespace tautline::bench
