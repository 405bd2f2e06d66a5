#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bench/data/coordinates.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/samples.hpp"

namespace tautline::bench {
namespace {

constexpr int digits_of_double = 17;

class Csv {
 public:
  Csv(const Case& the_case, const Solution& solution, const Uncertainty& uncertainty)
      : case_(the_case), solution_(solution), uncertainty_(uncertainty) {}

  std::string text(std::span<const double> times) {
    head();
    std::vector<double> sorted(times.begin(), times.end());
    std::sort(sorted.begin(), sorted.end());
    const auto& events = solution_.events();
    std::size_t event = 0;
    while (!sorted.empty() && event < events.size() && events[event].time < sorted.front()) {
      ++event;
    }
    for (const double time : sorted) {
      bool told = false;  // by the two rows of an impact
      while (event < events.size() && events[event].time <= time) {
        const double instant = events[event].time;
        std::optional<std::size_t> first;
        std::size_t last = event;
        for (; event < events.size() && events[event].time == instant; ++event) {
          if (jumps(events[event])) {
            first = first.value_or(event);
            last = event;
          }
        }
        if (first) {
          impacts(*first, last);
          told = told || instant == time;
        }
      }
      if (!told) {
        row(sample_at(case_, solution_, uncertainty_, time), "", nullptr);
      }
    }
    return std::move(out_);
  }

 private:
  /// An impact, and the completion of an accumulation of impacts.
  static bool jumps(const Event& event) {
    return event.kind == EventKind::impact || !event.impulses.isZero(0.0);
  }

  void head() {
    out_ = "time,event";
    for (const auto& one : coordinates(case_.initial)) {
      out_ += fmt::format(",{}", one.name);
    }
    out_ += ",energy";
    for (const char* name : {"gap", "gap_rate", "tension", "impulse"}) {
      for (std::size_t index = 0; index < case_.cables.size(); ++index) {
        out_ += fmt::format(",{}_{}", name, index);
      }
    }
    out_ += "\n";
  }

  void number(const Bounded& one) {
    const std::string text = right_general(one.value, one.error, digits_of_double);
    out_ += text == dash ? "," : "," + text;
  }

  /// The impacts of one instant, events `first` to `last`: one state before them and one after.
  void impacts(std::size_t first, std::size_t last) {
    row(sample_at_event(case_, solution_, uncertainty_, first, Side::before), "before impact",
        nullptr);
    std::vector<Bounded> impulses(case_.cables.size(), Bounded{0.0, 0.0});
    for (std::size_t index = first; index <= last; ++index) {
      if (jumps(solution_.events()[index])) {
        add_impulses(index, impulses);
      }
    }
    row(sample_at_event(case_, solution_, uncertainty_, last, Side::after), "after impact",
        &impulses);
  }

  void add_impulses(std::size_t index, std::vector<Bounded>& impulses) const {
    const Event& event = solution_.events()[index];
    const auto& errors = uncertainty_.events()[index];
    Eigen::Index place = 0;
    for (const std::size_t cable : event.cables) {
      Bounded& sum = impulses[cable];
      sum.value += std::max(0.0, event.impulses[place]);
      // an error below 0 is not known
      sum.error = errors && sum.error >= 0.0 ? sum.error + errors->impulses[place] : -1.0;
      ++place;
    }
  }

  void row(const MotionSample& sample, const char* event, const std::vector<Bounded>* impulses) {
    const std::string time = right_general(sample.time.value, sample.time.error, digits_of_double);
    out_ += (sample.time.error == 0.0 ? shortest(sample.time.value) : time == dash ? "" : time);
    out_ += ",";
    out_ += event;
    for (const Bounded& one : bounded(sample.state, sample.errors)) {
      number(one);
    }
    number(sample.energy);
    for (const Bounded CableSample::*member :
         {&CableSample::gap, &CableSample::gap_rate, &CableSample::tension}) {
      for (const CableSample& cable : sample.cables) {
        number(cable.*member);
      }
    }
    for (std::size_t index = 0; index < case_.cables.size(); ++index) {
      if (impulses == nullptr) {
        out_ += ",";
      } else {
        number((*impulses)[index]);
      }
    }
    out_ += "\n";
  }

  const Case& case_;
  const Solution& solution_;
  const Uncertainty& uncertainty_;
  std::string out_;
};

}  // namespace

std::string samples_csv(const Case& the_case, const Solution& solution,
                        const Uncertainty& uncertainty, std::span<const double> times) {
  return Csv(the_case, solution, uncertainty).text(times);
}

}  // namespace tautline::bench
