// First the whole box of parameters is divided (DIRECT), then the best is refined (Subplex):
// NLopt's, with numbers of evaluations and no chance in them.

#include "bench/run/calibration/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "bench/base/process.hpp"
#include "bench/run/calibration/minimise.hpp"
#include "bench/run/calibration/reach.hpp"
#include "bench/run/workplace.hpp"

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

/// What a point of the unit box stands for, and what is fixed.
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
  for (std::size_t index = 0; index < strikes.size(); ++index) {
    result.held_out.push_back({strikes[index], reply.restitutions[index]});
    const double error = error_of(reply.restitutions[index], request.restitution);
    result.worst = std::max(result.worst, error);
    result.mean += error / static_cast<double>(strikes.size());
  }
}

}  // namespace

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
                     : search.failure.empty() ? "no strike rebounds, whatever the setting"
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
