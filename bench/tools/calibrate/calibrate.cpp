// First the whole box of parameters is divided where it looks best (DIRECT), then the best point is
// refined by simplices of few coordinates each (Subplex): NLopt's, with numbers of evaluations and
// no chance in them. Neither needs a derivative.

#include "bench/tools/calibrate/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>

#ifdef TAUTLINE_NLOPT
#include <nlopt.hpp>
#endif

#include "bench/base/process.hpp"
#include "bench/run/worker.hpp"

namespace tautline::bench {
namespace {

constexpr int settings_for_each = 64;  // parameter

/// The part of the settings that looks through the whole box, at most [-].
constexpr double part_of_box = 0.5;

/// The search ends where the errors are so small a part of the tolerance [-].
constexpr double good_enough = 0.1;

/// An error this large, or no rebound at all, is as bad as any other [-].
constexpr double largest_error = 1.0;

/// Who gives up a model of which no setting was measured at all.
constexpr int failures_in_a_row = 5;

/// A body that is struck, and how much of the speed its spin brings [-].
struct Struck {
  double arm;      // [m]
  double inertia;  // [kg m^2]
  double spin_part;
};

/// A central cable, and one off the centre of a light and a heavy rim, which feels half and nine
/// tenths of the mass; with spin that closes the cable and spin that opens it.
constexpr Struck searched[] = {
    {0.0, 0.01, 0.0}, {0.1, 0.01, 0.0}, {0.1, 0.01, 0.5}, {0.1, 0.1, -0.5}};

/// None of them but the central one: two thirds and nine tenths of the mass, less spin.
constexpr Struck unseen[] = {{0.0, 0.01, 0.0}, {0.07, 0.01, -0.3}, {0.05, 0.02, 0.3}};

/// Every body at the speeds at these parts of the range, by its logarithm.
std::vector<Strike> strikes_at(const CalibrationRequest& request, std::span<const Struck> bodies,
                               std::initializer_list<double> parts) {
  std::vector<Strike> result;
  for (const double part : parts) {
    const double speed = request.slowest * std::pow(request.fastest / request.slowest, part);
    for (const auto& [arm, inertia, spin_part] : bodies) {
      result.push_back({speed, arm, inertia, spin_part});
    }
  }
  return result;
}

/// Six significant digits, as they are printed.
double rounded(double value) { return std::stod(fmt::format("{:.6g}", value)); }

/// What a point of the unit box means, and what is fixed.
std::map<std::string, double> parameters_at(const CalibrationRequest& request,
                                            const std::vector<double>& point) {
  std::map<std::string, double> result = request.fixed;
  for (std::size_t index = 0; index < point.size(); ++index) {
    const Parameter& one = request.searched[index];
    const double at = one.logarithmic ? one.low * std::pow(one.high / one.low, point[index])
                                      : one.low + (one.high - one.low) * point[index];
    result[one.name] = rounded(at * std::pow(request.step, one.step_power));
  }
  return result;
}

double error_of(double found, double wanted) {
  const double error = std::abs(found - wanted);
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

/// The strikes on one side of which the restitution stays.
struct Beyond {
  double nearest = 0.0;        // [-], what all of them reach
  std::vector<double> speeds;  // [m/s]
  std::vector<double> arms;    // [m]
  std::vector<double> spins;   // [-], their parts of the speed

  void add(const Strike& strike, double reached, const std::function<bool(double, double)>& less) {
    nearest = speeds.empty() || less(reached, nearest) ? reached : nearest;
    speeds.push_back(strike.speed);
    arms.push_back(strike.arm);
    spins.push_back(strike.spin_part);
  }
};

/// " at arms of 0.1 m", " at closing speeds of 0.05 to 0.17 m/s"; "" where `some` are as wide as
/// `all`.
std::string where(const char* what, const char* unit, const std::vector<double>& some,
                  const std::vector<double>& all) {
  const auto [low, high] = std::minmax_element(some.begin(), some.end());
  const auto [lowest, highest] = std::minmax_element(all.begin(), all.end());
  if (*low == *lowest && *high == *highest) {
    return "";
  }
  return *low == *high ? fmt::format(" at {} of {:.2g}{}", what, *low, unit)
                       : fmt::format(" at {} of {:.2g} to {:.2g}{}", what, *low, *high, unit);
}

/// Where `wanted` lies further than `tolerance` beyond what any setting gave, in sentences.
std::vector<std::string> sentences_of(const std::vector<Strike>& strikes,
                                      const std::vector<Reach>& reach, double wanted,
                                      double tolerance) {
  Beyond above;
  Beyond below;
  Beyond all;
  for (std::size_t index = 0; index < strikes.size(); ++index) {
    all.add(strikes[index], 0.0, std::less());
    if (reach[index].highest < wanted - tolerance) {
      above.add(strikes[index], std::max(0.0, reach[index].highest), std::less());
    } else if (reach[index].lowest > wanted + tolerance) {
      below.add(strikes[index], reach[index].lowest, std::greater());
    }
  }
  std::vector<std::string> result;
  const auto tell = [&](const Beyond& side, const char* word) {
    if (!side.speeds.empty()) {
      result.push_back(fmt::format("e {} {:.3g} is not reached at this step{}{}{}", word,
                                   side.nearest,
                                   where("closing speeds", " m/s", side.speeds, all.speeds),
                                   where("arms", " m", side.arms, all.arms),
                                   where("spin's parts", "", side.spins, all.spins)));
    }
  };
  tell(above, "above");
  tell(below, "below");
  return result;
}

/// How a unit box is looked through: all of it, or around a point.
enum class Pass { whole_box, refinement };

using Objective = std::function<std::optional<double>(const std::vector<double>&)>;

#ifdef TAUTLINE_NLOPT

/// Where refinement first looks around itself, as a part of the box [-].
constexpr double first_stride = 0.05;

/// The objective and who asks it.
struct Question {
  nlopt::opt& optimiser;
  const Objective& objective;
};

double value_at(const std::vector<double>& point, std::vector<double>& /*gradient*/, void* data) {
  const auto& question = *static_cast<Question*>(data);
  const std::optional<double> value = question.objective(point);
  if (!value) {
    question.optimiser.force_stop();
  }
  return value.value_or(0.0);
}

/// Looks for a point of the unit box where `objective` is smallest, from `start`; the caller keeps
/// the best. Ends after so many `evaluations`, below `enough`, or where the objective is none.
/// The same objective is asked the same questions. Throws std::runtime_error in a program that was
/// built without NLopt.
void minimise(Pass pass, std::vector<double> start, int evaluations, double enough,
              const Objective& objective) {
  nlopt::opt optimiser(pass == Pass::whole_box ? nlopt::GN_DIRECT_L : nlopt::LN_SBPLX,
                       static_cast<unsigned>(start.size()));
  Question question{optimiser, objective};
  optimiser.set_lower_bounds(0.0);
  optimiser.set_upper_bounds(1.0);
  optimiser.set_initial_step(first_stride);
  optimiser.set_maxeval(evaluations);
  optimiser.set_stopval(enough);
  optimiser.set_min_objective(value_at, &question);
  double value = 0.0;
  try {
    optimiser.optimize(start, value);
  } catch (const nlopt::forced_stop&) {       // the objective was none
  } catch (const nlopt::roundoff_limited&) {  // as good as it gets
  }
}

#else

void minimise(Pass /*pass*/, std::vector<double> /*start*/, int /*evaluations*/, double /*enough*/,
              const Objective& /*objective*/) {
  throw std::runtime_error("this program was built without NLopt (Debian: libnlopt-cxx-dev)");
}

#endif

/// What the search has seen.
class Search {
 public:
  Search(const CalibrationRequest& request, const std::function<void()>& tried)
      : request_(request),
        tried_(tried),
        strikes_(strikes_at(request, searched, {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0})),
        reach_(strikes_.size()),
        best_point_(request.searched.size(), 0.5) {}

  void run(Pass pass, int most) {
    if (best_point_.empty()) {  // all are fixed
      evaluate(best_point_);
      return;
    }
    minimise(pass, best_point_, most, good_value(),
             [this](const std::vector<double>& point) { return evaluate(point); });
  }

  [[nodiscard]] bool done() const {
    return interrupted || hopeless() || best_point_.empty() || best_ <= good_value();
  }
  [[nodiscard]] StrikesReply strike(const std::vector<double>& point,
                                    const std::vector<Strike>& strikes) {
    RunSettings settings = request_.step;
    settings.parameters = parameters_at(request_, point);
    return strike_in_worker({request_.plugin, request_.model.name, settings, strikes,
                             request_.restitution, request_.limits},
                            workplace_);
  }
  [[nodiscard]] const std::vector<double>& best_point() const { return best_point_; }
  [[nodiscard]] std::vector<std::string> beyond_reach() const {
    return sentences_of(strikes_, reach_, request_.restitution, request_.tolerance);
  }

  int evaluations = 0;
  bool measured = false;     // at least one strike
  bool interrupted = false;  // the program was told to stop
  std::string failure;       // of the latest setting that failed

 private:
  [[nodiscard]] bool hopeless() const { return !measured && failures_ >= failures_in_a_row; }
  [[nodiscard]] double good_value() const { return std::pow(good_enough * request_.tolerance, 2); }

  /// The mean square of the errors; none if the search has to stop.
  std::optional<double> evaluate(const std::vector<double>& point) {
    const StrikesReply reply = strike(point, strikes_);
    if (reply.interrupted) {
      interrupted = true;
      return std::nullopt;
    }
    ++evaluations;
    tried_();
    if (reply.restitutions.size() != strikes_.size()) {
      failure = reply.failure;
      ++failures_;
      return hopeless() ? std::nullopt : std::optional(largest_error);
    }
    double sum = 0.0;
    for (std::size_t index = 0; index < strikes_.size(); ++index) {
      const double found = reply.restitutions[index];
      measured = measured || std::isfinite(found);
      reach_[index].include(found);
      sum += std::pow(std::min(largest_error, error_of(found, request_.restitution)), 2);
    }
    const double value = sum / static_cast<double>(strikes_.size());
    if (value < best_) {
      best_ = value;
      best_point_ = point;
    }
    return value;
  }

  const CalibrationRequest& request_;
  const std::function<void()>& tried_;
  Workplace workplace_;
  std::vector<Strike> strikes_;
  std::vector<Reach> reach_;
  std::vector<double> best_point_;
  double best_ = std::numeric_limits<double>::infinity();
  int failures_ = 0;  // settings with which the engine failed
};

std::string with_values(std::string code, const std::map<std::string, double>& parameters) {
  for (const auto& [name, value] : parameters) {
    const std::string mark = "{" + name + "}";
    for (std::size_t at = code.find(mark); at != code.npos; at = code.find(mark, at)) {
      code.replace(at, mark.size(), fmt::format("{:.6g}", value));
    }
  }
  return code;
}

/// Strikes at speeds, on bodies and with spins that the search did not have.
void hold_out(const CalibrationRequest& request, Search& search, Calibration& result) {
  const std::vector<Strike> strikes = strikes_at(request, unseen, {0.1, 0.3, 0.5, 0.7, 0.9});
  const StrikesReply reply = search.strike(search.best_point(), strikes);
  if (reply.restitutions.size() != strikes.size()) {
    result.failure = reply.interrupted ? "interrupted" : reply.failure;
    return;
  }
  result.law = reply.law;
  for (std::size_t index = 0; index < strikes.size(); ++index) {
    result.held_out.push_back({strikes[index], reply.restitutions[index]});
    const double error = error_of(reply.restitutions[index], request.restitution);
    result.worst = std::max(result.worst, error);
    result.mean += error / static_cast<double>(strikes.size());
  }
}

}  // namespace

void Reach::include(double restitution) {
  if (std::isfinite(restitution)) {
    lowest = std::min(lowest, restitution);
    highest = std::max(highest, restitution);
  }
}

double damping_ratio_of(const SoftRow& law) {
  return law.damping / (2.0 * std::sqrt(law.stiffness));
}

int most_settings(std::size_t searched) {
  return std::max(1, static_cast<int>(searched) * settings_for_each);
}

Calibration calibrate(const CalibrationRequest& request, const std::function<void()>& tried) {
  Search search(request, tried);
  const int in_box = static_cast<int>(std::ceil(part_of_box * request.settings));
  search.run(Pass::whole_box, in_box);
  if (!search.done() && search.evaluations < request.settings) {
    search.run(Pass::refinement, request.settings - search.evaluations);
  }
  Calibration result;
  result.evaluations = search.evaluations;
  result.interrupted = search.interrupted;
  if (!search.measured) {
    result.failure = search.interrupted       ? "interrupted before anything was found"
                     : search.failure.empty() ? "no strike rebounds, at any setting"
                                              : search.failure;
    return result;
  }
  interruption() = false;  // what was found so far is still judged
  result.parameters = parameters_at(request, search.best_point());
  result.code = with_values(request.model.code, result.parameters);
  hold_out(request, search, result);
  // half a search knows no reach
  if (!result.interrupted && !result.reached(request.tolerance)) {
    result.why = search.beyond_reach();
    if (result.why.empty()) {
      result.why = {"no one setting suits all closing speeds, arms, inertias and spins"};
    }
  }
  return result;
}

}  // namespace tautline::bench
