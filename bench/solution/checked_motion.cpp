#include "bench/solution/checked_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "bench/data/coordinates.hpp"
#include "bench/solution/certify_events.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// Two solutions part where their states differ by this part of the system's sizes [-]: a thousand
/// times less than what would send a cable another way, and far more than what grows no further.
constexpr double parted = 1e-4;

/// Bounces are completed at an instant of each solution's own. What the numbers change from there
/// to the limit of the impacts, times this, is what they may be off by at another such instant [-].
constexpr double other_completion = 2.0;

/// The error of completed accumulations in more digits, below that of doubles [-]: it may have cost
/// a few of them.
double completion_of(int digits) {
  constexpr int spare = 6;
  constexpr double most = 1e-18;
  return std::min(most, std::pow(10.0, spare - digits));
}

/// The name of body `index` in tables.
template <int D>
std::string name_of(const BasicSystem<double, D>& system, std::size_t index) {
  const std::string& name = system.bodies[index].name;
  if (system.bodies.size() == 1) {
    return "";
  }
  return name.empty() ? fmt::format("body {} ", index) : name + " ";
}

/// The numbers of a sample in the order of `names`.
template <class Real, int D>
std::vector<Real> numbers_of(const BasicSystem<Real, D>& system,
                             const BasicSystemState<Real, D>& state, CableSet taut,
                             const BasicCableVector<Real>& tensions) {
  std::vector<Real> result;
  for (const auto& body : state.bodies) {
    for (const auto& one : coordinates(body)) {
      result.push_back(one.value);
    }
  }
  for (std::size_t i = 0; i < system.cables.size(); ++i) {
    const auto& cable = system.cables[i];
    result.push_back(taut.contains(i) ? Real(0) : gap(cable, state));
    result.push_back(taut.contains(i) ? Real(0) : gap_rate(cable, state));
    result.push_back(tensions[static_cast<Eigen::Index>(i)]);
  }
  result.push_back(energy(system, state));
  return result;
}

/// The tension of all cables, none of them taut.
template <class Real, int D>
BasicCableVector<Real> no_tensions(const BasicSystem<Real, D>& system) {
  return BasicCableVector<Real>::Zero(static_cast<Eigen::Index>(system.cables.size()));
}

template <class Real, int D>
std::vector<Real> numbers_at(const BasicSystem<Real, D>& system,
                             const BasicSolution<BasicSystem<Real, D>>& solution,
                             const Real& time) {
  return numbers_of(system, solution.at(time), taut_at(solution, time), solution.tensions(time));
}

/// They on one side of event `index`.
template <class Real, int D>
std::vector<Real> numbers_at(const BasicSystem<Real, D>& system,
                             const BasicSolution<BasicSystem<Real, D>>& solution, std::size_t index,
                             Side side) {
  const auto& event = solution.events()[index];
  const auto& arcs = solution.arcs();
  if (side == Side::after) {
    return numbers_of(system, event.after, taut_at(solution, event.time),
                      solution.tensions(event.time));
  }
  const auto next =
      std::lower_bound(arcs.begin(), arcs.end(), event.time,
                       [](const auto& arc, const Real& time) { return arc.start < time; });
  if (next == arcs.begin()) {
    return numbers_of(system, event.before, CableSet(), no_tensions(system));
  }
  const auto& last = *std::prev(next);
  return numbers_of(system, event.before, last.taut,
                    solution.tensions(last, Real(last.end - last.start)));
}

/// The length of the longest cable [m].
template <int D>
double size_of(const BasicSystem<double, D>& system, const BasicSystemState<double, D>& state) {
  double length = 0.0;
  for (const auto& cable : system.cables) {
    length = std::max(length, cable.length.at(state.time)[0]);
  }
  for (const auto& body : state.bodies) {
    length = length > 0.0 ? length : body.position.norm();
  }
  return length;
}

/// The speed of the fastest body, or of its turn [m/s].
template <int D>
double speed_of(const BasicSystem<double, D>& system, const BasicSystemState<double, D>& state) {
  const double length = size_of(system, state);
  double speed = 0.0;
  for (const auto& body : state.bodies) {
    speed = std::max({speed, body.velocity.norm(), spin_size(body) * length});
  }
  return speed;
}

/// How far the states of two solutions are apart [-], whose largest speed is `speed` [m/s]: at rest
/// they have none of their own.
template <int D>
double distance(const BasicSystem<double, D>& system, const BasicSystemState<double, D>& one,
                const BasicSystemState<Multi, D>& other, double speed) {
  const double length = size_of(system, one);
  double result = 0.0;
  for (std::size_t i = 0; i < one.bodies.size(); ++i) {
    const auto mine = coordinates(one.bodies[i]);
    const auto theirs = coordinates(other.bodies[i]);
    for (std::size_t k = 0; k < mine.size(); ++k) {
      const bool is_length = std::string_view(mine[k].unit).starts_with("m");
      const double scale = mine[k].is_rate ? (is_length ? speed : speed / length)
                           : is_length     ? length
                                           : 1.0;
      const Multi off = abs(Multi(mine[k].value - theirs[k].value));
      result = std::max(result, static_cast<double>(off) / std::max(scale, 1e-300));
    }
  }
  return result;
}

/// The difference of two numbers, with room for what rounding takes of `one` less and plus it.
double off_by(double one, const Multi& other) {
  if (!std::isfinite(one)) {
    return -1.0;
  }
  const Multi difference = abs(Multi(one - other));
  if (!(difference > 0)) {
    return 0.0;
  }
  const double size = std::abs(one);
  const double room = std::nextafter(size, HUGE_VAL) - size;
  return std::nextafter(static_cast<double>(difference) + room, HUGE_VAL);
}

double off_by(const std::optional<double>& one, const std::optional<Multi>& other) {
  return one && other ? off_by(*one, *other) : one || other ? -1.0 : 0.0;
}

/// Numbers with how far they agree with `others`; none of them does without.
std::vector<Bounded> agreeing(const std::vector<double>& numbers,
                              const std::vector<Multi>& others) {
  std::vector<Bounded> result;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    result.push_back({numbers[i], others.empty() ? -1.0 : off_by(numbers[i], others[i])});
  }
  return result;
}

}  // namespace

template <int D>
struct BasicCheckedMotion<D>::InDigits {
  BasicSystem<Multi, D> system;
  BasicSolution<BasicSystem<Multi, D>> solution;
  BasicSystemSettling<Multi> settling;
  BasicSystemLedger<Multi> ledger;
};

template <int D>
BasicCheckedMotion<D>::BasicCheckedMotion(System system, const SolveOptions& options, int digits)
    : system_(std::move(system)),
      solution_(solve(system_, options)),
      settling_(tautline::settling(system_, solution_)),
      ledger_(energy_ledger(system_, solution_)),
      digits_(digits) {
  if (digits == 0) {
    horizon_ = 0.0;
    return;
  }
  const tautline::Digits precision(static_cast<unsigned>(digits_));
  SolveOptions sharper = options;
  sharper.completion = {.error = completion_of(digits), .speed = std::nullopt};
  auto many = converted<Multi>(system_);
  auto solution = solve(many, sharper);
  auto settled = tautline::settling(many, solution);
  auto ledger = energy_ledger(many, solution);
  in_digits_.reset(
      new InDigits{std::move(many), std::move(solution), std::move(settled), std::move(ledger)});
  align();
}

template <int D>
BasicCheckedMotion<D>::~BasicCheckedMotion() = default;

template <int D>
void BasicCheckedMotion<D>::align() {
  const Alignment alignment(solution_, in_digits_->solution);
  same_.resize(solution_.events().size());
  const auto& others = in_digits_->solution.events();
  double speed = speed_of(system_, system_.initial);
  for (const auto& event : solution_.events()) {
    speed = std::max({speed, speed_of(system_, event.before), speed_of(system_, event.after)});
  }
  double last = 0.0;
  for (const auto& [mine, other] : alignment.places()) {
    if (mine == 0) {
      continue;
    }
    const auto& event = solution_.events()[mine - 1];
    const auto& same = others[other - 1];
    if (off_by(event.time, same.time) > parted * std::max(event.time, 1e-300) ||
        distance(system_, event.after, same.after, speed) > parted) {
      horizon_ = last;
      return;
    }
    same_[mine - 1] = other - 1;
    last = event.time;
  }
  if (!alignment.match().all || !end_alike(speed)) {
    horizon_ = last;
  }
}

/// Drag brings a motion to rest in double first: it is the same motion.
template <int D>
bool BasicCheckedMotion<D>::end_alike(double speed) const {
  const auto& other = in_digits_->solution;
  const auto whole = [](Ending ending) {
    return ending == Ending::rest || ending == Ending::reached_duration;
  };
  return solution_.ending() == other.ending() ||
         (whole(solution_.ending()) && whole(other.ending()) &&
          distance(system_, solution_.at(solution_.end_time()), other.at(other.end_time()),
                   speed) <= parted);
}

template <int D>
std::optional<std::size_t> BasicCheckedMotion<D>::same_event(std::size_t index) const {
  return index < same_.size() ? same_[index] : std::nullopt;
}

template <int D>
SystemLedger BasicCheckedMotion<D>::ledger_errors() const {
  SystemLedger errors{-1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0};
  if (in_digits_ && !horizon_) {
    for (const auto& [member, same] :
         {std::pair(&SystemLedger::start, &BasicSystemLedger<Multi>::start),
          std::pair(&SystemLedger::work, &BasicSystemLedger<Multi>::work),
          std::pair(&SystemLedger::impacts, &BasicSystemLedger<Multi>::impacts),
          std::pair(&SystemLedger::completions, &BasicSystemLedger<Multi>::completions),
          std::pair(&SystemLedger::end, &BasicSystemLedger<Multi>::end),
          std::pair(&SystemLedger::stored, &BasicSystemLedger<Multi>::stored),
          std::pair(&SystemLedger::dissipated, &BasicSystemLedger<Multi>::dissipated)}) {
      errors.*member = off_by(ledger_.*member, in_digits_->ledger.*same);
    }
  }
  return errors;
}

template <int D>
std::vector<SampleName> BasicCheckedMotion<D>::names() const {
  std::vector<SampleName> result;
  for (std::size_t i = 0; i < system_.bodies.size(); ++i) {
    for (const auto& one : coordinates(system_.initial.bodies[i])) {
      result.push_back({name_of(system_, i) + one.name, true});
    }
  }
  for (std::size_t i = 0; i < system_.cables.size(); ++i) {
    result.push_back({fmt::format("gap {}", i), false});
    result.push_back({fmt::format("gap rate {}", i), false});
    result.push_back({fmt::format("tension {}", i), false});
  }
  result.push_back({"energy", false});
  return result;
}

template <int D>
std::vector<Bounded> BasicCheckedMotion<D>::at(double time) const {
  const std::vector<double> mine = numbers_at(system_, solution_, time);
  const bool sure = in_digits_ && !(horizon_ && time >= *horizon_);
  if (!sure || Multi(time) > in_digits_->solution.end_time()) {
    return agreeing(mine, {});
  }
  const tautline::Digits precision(static_cast<unsigned>(digits_));
  return agreeing(mine, numbers_at(in_digits_->system, in_digits_->solution, Multi(time)));
}

template <int D>
std::vector<Bounded> BasicCheckedMotion<D>::at_event(std::size_t index, Side side) const {
  const std::vector<double> mine = numbers_at(system_, solution_, index, side);
  const auto same = same_event(index);
  if (!same) {
    return agreeing(mine, {});
  }
  const tautline::Digits precision(static_cast<unsigned>(digits_));
  auto result = agreeing(mine, numbers_at(in_digits_->system, in_digits_->solution, *same, side));
  if (const double late = completed_time(index); late > 0.0) {
    const double time = solution_.events()[index].time;
    const std::vector<double> later =
        numbers_at(system_, solution_, std::min(time + late, solution_.end_time()));
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i].error = other_completion * (result[i].error + std::abs(later[i] - result[i].value));
    }
  }
  return result;
}

template <int D>
double BasicCheckedMotion<D>::completed_time(std::size_t index) const {
  const Accumulation* const one = completed_by(solution_, solution_.events()[index]);
  return one != nullptr ? one->time - one->start + one->uncertainty : 0.0;
}

template <int D>
Bounded BasicCheckedMotion<D>::time(std::size_t index) const {
  const double mine = solution_.events()[index].time;
  const auto same = same_event(index);
  return {mine,
          same ? completed_time(index) + off_by(mine, in_digits_->solution.events()[*same].time)
               : -1.0};
}

template <int D>
std::vector<Bounded> BasicCheckedMotion<D>::impulses(std::size_t index) const {
  const CableVector& mine = solution_.events()[index].impulses;
  const auto same = same_event(index);
  // a cable goes taut by an impact, or without one: which may be a matter of rounding
  const auto* const other = same ? &in_digits_->solution.events()[*same].impulses : nullptr;
  std::vector<Bounded> result;
  for (Eigen::Index row = 0; row < mine.size(); ++row) {
    const double impulse = std::max(0.0, mine[row]);  // below are gravity's
    double error = -1.0;
    if (other != nullptr && other->size() == mine.size()) {
      error = off_by(impulse, max(Multi(0), (*other)[row]));
      if (completed_time(index) > 0.0) {  // those that come later may be less, or more
        error = max(error, impulse);
      }
    }
    result.push_back({impulse, error});
  }
  return result;
}

template <int D>
std::vector<CheckedContact> BasicCheckedMotion<D>::contacts() const {
  using Mine = ElasticContact;
  using Other = BasicElasticContact<Multi>;
  std::optional<tautline::Digits> precision;
  std::vector<Other> others;
  if (in_digits_) {
    precision.emplace(static_cast<unsigned>(digits_));
    others = elastic_contacts(in_digits_->solution);
  }
  std::vector<CheckedContact> result;
  std::vector<std::size_t> next(system_.cables.size());  // of the other contacts of each cable
  for (const Mine& mine : elastic_contacts(solution_)) {
    // two cables may engage at one instant, in either order
    std::size_t& place = next[mine.cable];
    while (place < others.size() && others[place].cable != mine.cable) {
      ++place;
    }
    const Other* const same = place < others.size() ? &others[place++] : nullptr;
    Mine errors{.cable = mine.cable};
    const auto compare = [&](double until, const auto&... members) {
      const bool sure = same != nullptr && !(horizon_ && until > *horizon_);
      ((errors.*members.first = sure ? off_by(mine.*members.first, same->*members.second) : -1.0),
       ...);
    };
    compare(mine.entry, std::pair(&Mine::entry, &Other::entry),
            std::pair(&Mine::entry_speed, &Other::entry_speed));
    compare(mine.exit.value_or(solution_.end_time()), std::pair(&Mine::exit, &Other::exit),
            std::pair(&Mine::exit_speed, &Other::exit_speed), std::pair(&Mine::peak, &Other::peak),
            std::pair(&Mine::peak_time, &Other::peak_time),
            std::pair(&Mine::greatest_stretch, &Other::greatest_stretch),
            std::pair(&Mine::impulse, &Other::impulse));
    result.push_back({mine, errors});
  }
  return result;
}

template <int D>
double BasicCheckedMotion<D>::accumulation_error(std::size_t index) const {
  const Accumulation& mine = solution_.accumulations()[index];
  double nearest = -1.0;
  if (!in_digits_ || (horizon_ && mine.start >= *horizon_)) {
    return nearest;
  }
  for (const auto& other : in_digits_->solution.accumulations()) {
    const double off = off_by(mine.time, other.time);
    if (other.cables == mine.cables && (nearest < 0.0 || off < nearest)) {
      nearest = off;
    }
  }
  return nearest < 0.0 ? nearest : nearest + mine.uncertainty;
}

template <int D>
SystemSettlingErrors BasicCheckedMotion<D>::settling_errors() const {
  SystemSettlingErrors errors;
  const auto& mine = settling_;
  const std::size_t cables = mine.cables.size();
  const bool whole = in_digits_ && !horizon_;
  const auto same = [&](const auto& one, const auto& other) {
    return whole ? off_by(one, other) : -1.0;
  };
  for (std::size_t i = 0; i < mine.last_impacts.size(); ++i) {
    errors.last_impacts.push_back(
        whole ? off_by(mine.last_impacts[i].time, in_digits_->settling.last_impacts[i].time)
              : -1.0);
  }
  for (std::size_t i = 0; i < cables; ++i) {
    const auto* other = whole ? &in_digits_->settling.cables[i] : nullptr;
    errors.shares.push_back(other ? same(mine.cables[i].taut_share, other->taut_share) : -1.0);
    const auto value = [&](const std::optional<Peak>& a, const std::optional<BasicPeak<Multi>>& b) {
      return a && b ? off_by(a->value, b->value) : -1.0;
    };
    const auto when = [&](const std::optional<Peak>& a, const std::optional<BasicPeak<Multi>>& b) {
      return a && b ? off_by(a->time, b->time) : -1.0;
    };
    const std::optional<BasicPeak<Multi>> none;
    errors.tensions.push_back(value(mine.cables[i].tension, other ? other->tension : none));
    errors.tension_times.push_back(when(mine.cables[i].tension, other ? other->tension : none));
    errors.impulses.push_back(value(mine.cables[i].impulse, other ? other->impulse : none));
    errors.impulse_times.push_back(when(mine.cables[i].impulse, other ? other->impulse : none));
  }
  if (whole && mine.lock && in_digits_->settling.lock &&
      mine.lock->cables == in_digits_->settling.lock->cables) {
    const auto& other = *in_digits_->settling.lock;
    errors.lock = off_by(mine.lock->time, other.time) + mine.lock->uncertainty;
    if (mine.lock->residual_energy && other.residual_energy) {
      errors.residual_energy = off_by(*mine.lock->residual_energy, *other.residual_energy);
    }
    if (mine.lock->one_percent && other.one_percent) {
      errors.one_percent = off_by(*mine.lock->one_percent, *other.one_percent);
    }
    if (mine.lock->ring_down && other.ring_down) {
      errors.ring_down = off_by(*mine.lock->ring_down, *other.ring_down);
    }
  }
  return errors;
}

template class BasicCheckedMotion<2>;
template class BasicCheckedMotion<3>;

}  // namespace tautline::bench
