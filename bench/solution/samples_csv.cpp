#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bench/data/coordinates.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/samples.hpp"
#include "bench/solution/system_text.hpp"

namespace tautline::bench {
namespace {

constexpr int digits_of_double = 17;

/// A row of numbers at an instant, in the order of the columns.
struct Row {
  Bounded time;
  std::vector<Bounded> numbers;
};

/// The rows of a case.
class CaseRows {
 public:
  CaseRows(const Case& the_case, const Solution& solution, const Uncertainty& uncertainty)
      : case_(the_case), solution_(solution), uncertainty_(uncertainty) {}

  [[nodiscard]] const auto& events() const { return solution_.events(); }
  [[nodiscard]] std::size_t cables() const { return case_.cables.size(); }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& one : coordinates(case_.initial)) {
      result.emplace_back(one.name);
    }
    return result;
  }
  [[nodiscard]] Row at(double time) const {
    return row(sample_at(case_, solution_, uncertainty_, time));
  }
  [[nodiscard]] Row at_event(std::size_t index, Side side) const {
    return row(sample_at_event(case_, solution_, uncertainty_, index, side));
  }
  [[nodiscard]] std::vector<Bounded> impulses(std::size_t index) const {
    const Event& event = solution_.events()[index];
    const auto& errors = uncertainty_.events()[index];
    std::vector<Bounded> result;
    for (Eigen::Index place = 0; place < event.impulses.size(); ++place) {
      result.push_back({event.impulses[place], errors ? errors->impulses[place] : -1.0});
    }
    return result;
  }

 private:
  static Row row(const MotionSample& sample) {
    Row result{sample.time, bounded(sample.state, sample.errors)};
    result.numbers.push_back(sample.energy);
    for (const Bounded CableSample::*member :
         {&CableSample::gap, &CableSample::gap_rate, &CableSample::tension}) {
      for (const CableSample& cable : sample.cables) {
        result.numbers.push_back(cable.*member);
      }
    }
    return result;
  }

  const Case& case_;
  const Solution& solution_;
  const Uncertainty& uncertainty_;
};

/// The rows of a system.
template <int D>
class SystemRows {
 public:
  explicit SystemRows(const BasicCheckedMotion<D>& motion) : motion_(motion) {}

  [[nodiscard]] const auto& events() const { return motion_.solution().events(); }
  [[nodiscard]] std::size_t cables() const { return motion_.system().cables.size(); }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const SampleName& one : motion_.names()) {
      if (one.is_of_a_body) {
        result.push_back(one.name);
        std::replace(result.back().begin(), result.back().end(), ' ', '_');
      }
    }
    return result;
  }
  [[nodiscard]] Row at(double time) const { return row({time, 0.0}, motion_.at(time)); }
  [[nodiscard]] Row at_event(std::size_t index, Side side) const {
    return row(motion_.time(index), motion_.at_event(index, side));
  }
  [[nodiscard]] std::vector<Bounded> impulses(std::size_t index) const {
    return motion_.impulses(index);
  }

 private:
  /// `numbers` in the order of the columns.
  [[nodiscard]] Row row(const Bounded& time, const std::vector<Bounded>& numbers) const {
    constexpr std::size_t of_cable = 3;  // gap, its rate, tension
    const std::size_t first = numbers.size() - 1 - of_cable * cables();
    Row result{time, {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(first)}};
    result.numbers.push_back(numbers.back());
    for (std::size_t which = 0; which < of_cable; ++which) {
      for (std::size_t cable = 0; cable < cables(); ++cable) {
        result.numbers.push_back(numbers[first + of_cable * cable + which]);
      }
    }
    return result;
  }

  const BasicCheckedMotion<D>& motion_;
};

template <class Rows>
class Csv {
 public:
  explicit Csv(const Rows& rows) : rows_(rows) {}

  std::string text(std::span<const double> times) {
    head();
    std::vector<double> sorted(times.begin(), times.end());
    std::sort(sorted.begin(), sorted.end());
    const auto& events = rows_.events();
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
          if (jumps(event)) {
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
        row(rows_.at(time), "", nullptr);
      }
    }
    return std::move(out_);
  }

 private:
  /// An impact, and the completion of an accumulation of impacts.
  [[nodiscard]] bool jumps(std::size_t index) const {
    const auto& event = rows_.events()[index];
    return event.kind == EventKind::impact || !event.impulses.isZero(0.0);
  }

  void head() {
    out_ = "time,event";
    for (const std::string& name : rows_.names()) {
      out_ += "," + name;
    }
    out_ += ",energy";
    for (const char* name : {"gap", "gap_rate", "tension", "impulse"}) {
      for (std::size_t index = 0; index < rows_.cables(); ++index) {
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
    row(rows_.at_event(first, Side::before), "before impact", nullptr);
    std::vector<Bounded> impulses(rows_.cables(), Bounded{0.0, 0.0});
    for (std::size_t index = first; index <= last; ++index) {
      if (jumps(index)) {
        add_impulses(index, impulses);
      }
    }
    row(rows_.at_event(last, Side::after), "after impact", &impulses);
  }

  void add_impulses(std::size_t index, std::vector<Bounded>& impulses) const {
    const std::vector<Bounded> more = rows_.impulses(index);
    std::size_t place = 0;
    for (const std::size_t cable : rows_.events()[index].cables) {
      Bounded& sum = impulses[cable];
      sum.value += std::max(0.0, more[place].value);
      // an error below 0 is not known
      sum.error =
          more[place].error >= 0.0 && sum.error >= 0.0 ? sum.error + more[place].error : -1.0;
      ++place;
    }
  }

  void row(const Row& sample, const char* event, const std::vector<Bounded>* impulses) {
    const std::string time = right_general(sample.time.value, sample.time.error, digits_of_double);
    out_ += (sample.time.error == 0.0 ? shortest(sample.time.value) : time == dash ? "" : time);
    out_ += ",";
    out_ += event;
    for (const Bounded& one : sample.numbers) {
      number(one);
    }
    for (std::size_t index = 0; index < rows_.cables(); ++index) {
      if (impulses == nullptr) {
        out_ += ",";
      } else {
        number((*impulses)[index]);
      }
    }
    out_ += "\n";
  }

  const Rows& rows_;
  std::string out_;
};

}  // namespace

std::string samples_csv(const Case& the_case, const Solution& solution,
                        const Uncertainty& uncertainty, std::span<const double> times) {
  return Csv(CaseRows(the_case, solution, uncertainty)).text(times);
}

template <int D>
std::string samples_csv(const BasicCheckedMotion<D>& motion, std::span<const double> times) {
  return Csv(SystemRows<D>(motion)).text(times);
}
template std::string samples_csv(const BasicCheckedMotion<2>&, std::span<const double>);
template std::string samples_csv(const BasicCheckedMotion<3>&, std::span<const double>);

}  // namespace tautline::bench
