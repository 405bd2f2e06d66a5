#include "bench/measure/metric_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tautline::bench {
namespace {

using Value = std::optional<double>;

/// A deviation over a window; none where the run has no sample in it.
template <Window window, double Deviation::*number>
Value deviation_over(const Metrics& metrics) {
  const Deviation& found = metrics.deviation_in(window);
  return found.covered > 0.0 ? Value(found.*number) : std::nullopt;
}

template <Window window>
Value worst_time_error(const Metrics& metrics) {
  return metrics.impacts_in(window).worst_time_error;
}

Value first_time_error(const Metrics& metrics) {
  return metrics.impacts_in(Window::horizon).first_time_error;
}

Value missed_share(const Metrics& metrics) {
  const ImpactMatch& impacts = metrics.impacts_in(Window::horizon);
  return impacts.exact > 0 ? Value(static_cast<double>(impacts.exact - impacts.matched) /
                                   static_cast<double>(impacts.exact))
                           : std::nullopt;
}

Value last_impact_error(const Metrics& metrics) {
  if (metrics.last_impacts.empty()) {
    return std::nullopt;
  }
  const LastImpactMatch& last = metrics.last_impacts.front();
  return last.exact && last.found ? Value(std::abs(*last.found - *last.exact)) : std::nullopt;
}

Value restitution_error(const Metrics& metrics) {
  return metrics.restitution ? Value(metrics.restitution->worst) : std::nullopt;
}

template <auto number>
Value always(const Metrics& metrics) {
  return static_cast<double>(metrics.*number);
}

template <Value Metrics::*number>
Value optional_number(const Metrics& metrics) {
  return metrics.*number;
}

/// How far a number of the run is off the exact one.
template <std::optional<ExactAndFound> Metrics::*number>
Value distance_of(const Metrics& metrics) {
  const std::optional<ExactAndFound>& both = metrics.*number;
  return both ? Value(std::abs(both->found - both->exact)) : std::nullopt;
}

constexpr std::string_view position = "position error";
constexpr std::string_view angle = "angle error";
constexpr std::string_view velocity = "velocity error";
constexpr std::string_view off_by = "impacts off by";

constexpr std::array list = {
    Metric{"early_position_error", "early", position, "early", "m",
           "Largest distance from the exact position up to the first few impacts.",
           deviation_over<Window::early, &Deviation::position>, as_error, Aggregate::typical,
           NoiseKind::early, Shown::by_run_and_over_cases},
    Metric{"horizon_position_error", "to the horizon", position, "horizon", "m",
           "Largest distance from the exact position up to the predictability horizon.",
           deviation_over<Window::horizon, &Deviation::position>, as_error, Aggregate::typical,
           NoiseKind::horizon, Shown::by_run_and_over_cases, 3},
    Metric{"whole_position_error", "whole", position, "", "m",
           "Largest distance from the exact position up to the end of the exact motion or the run.",
           deviation_over<Window::whole, &Deviation::position>, as_error, Aggregate::none,
           NoiseKind::any, Shown::nowhere},
    Metric{"early_angle_error", "early", angle, "", "rad",
           "Largest distance from the exact angle up to the first few impacts.",
           deviation_over<Window::early, &Deviation::angle>, as_error, Aggregate::none,
           NoiseKind::early, Shown::nowhere},
    Metric{"horizon_angle_error", "to the horizon", angle, "", "rad",
           "Largest distance from the exact angle up to the predictability horizon.",
           deviation_over<Window::horizon, &Deviation::angle>, as_error, Aggregate::none,
           NoiseKind::any, Shown::by_run},
    Metric{"whole_angle_error", "whole", angle, "", "rad",
           "Largest distance from the exact angle up to the end of the exact motion or the run.",
           deviation_over<Window::whole, &Deviation::angle>, as_error, Aggregate::none,
           NoiseKind::any, Shown::nowhere},
    Metric{"early_velocity_error", "early", velocity, "", "m/s",
           "Mean over time of the distance from the exact velocity up to the first few impacts.",
           deviation_over<Window::early, &Deviation::velocity>, as_error, Aggregate::none,
           NoiseKind::any, Shown::nowhere},
    Metric{"horizon_velocity_error", "to the horizon", velocity, "", "m/s",
           "Mean over time of the distance from the exact velocity up to the horizon.",
           deviation_over<Window::horizon, &Deviation::velocity>, as_error, Aggregate::none,
           NoiseKind::any, Shown::nowhere},
    Metric{"whole_velocity_error", "whole", velocity, "", "m/s",
           "Mean over time of the distance from the exact velocity up to the end.",
           deviation_over<Window::whole, &Deviation::velocity>, as_error, Aggregate::none,
           NoiseKind::any, Shown::nowhere},
    Metric{"first_impact_error", "first", off_by, "", "s",
           "How far the first impact is off in time.", first_time_error, as_error, Aggregate::none,
           NoiseKind::early, Shown::by_run},
    Metric{"early_impact_error", "worst early", off_by, "", "s",
           "How far the worst matched impact is off in time, of the first few.",
           worst_time_error<Window::early>, as_error, Aggregate::none, NoiseKind::any,
           Shown::nowhere},
    Metric{"horizon_impact_error", "worst to the horizon", off_by, "", "s",
           "How far the worst matched impact is off in time, up to the predictability horizon.",
           worst_time_error<Window::horizon>, as_error, Aggregate::none, NoiseKind::any,
           Shown::by_run},
    Metric{"whole_impact_error", "worst of all", off_by, "", "s",
           "How far the worst matched impact is off in time, of the whole run.",
           worst_time_error<Window::whole>, as_error, Aggregate::none, NoiseKind::any,
           Shown::nowhere},
    Metric{"missed_impacts", "missed", "impacts to the horizon", "", "1",
           "Share of the exact impacts up to the horizon that the run has no match for.",
           missed_share, as_error, Aggregate::none, NoiseKind::share, Shown::nowhere},
    Metric{
        "last_impact_error", "off by", "last impact", "", "s",
        "How far the last impact faster than the first threshold of settling is off in time, where "
        "the exact motion locks before its horizon.",
        last_impact_error, as_error, Aggregate::typical, NoiseKind::any,
        Shown::by_run_and_over_cases},
    Metric{"later_impacts", "later impacts", "", "", "1",
           "Counted impacts of the run after the exact lock.", always<&Metrics::later_impacts>,
           as_count, Aggregate::none, NoiseKind::any, Shown::by_run},
    Metric{"long_impacts", "long impacts", "", "", "1",
           "Counted impacts, up to the exact lock, that take several steps.",
           always<&Metrics::long_impacts>, as_count, Aggregate::none, NoiseKind::any,
           Shown::nowhere},
    Metric{"restitution_error", "e error", "", "e error", "1",
           "Largest distance of a measured restitution from the cable's own.", restitution_error,
           as_error, Aggregate::extreme, NoiseKind::extreme, Shown::by_run_and_over_cases, 2},
    Metric{"impulse_error", "impulse", "impacts off by", "", "%",
           "How far an impulse is off, of the exact impulse: the worst matched impact of one cable "
           "alone up to the horizon.",
           optional_number<&Metrics::impulse_error>, as_error, Aggregate::typical, NoiseKind::any,
           Shown::by_run_and_over_cases},
    Metric{"energy_loss_error", "energy loss", "impacts off by", "", "J",
           "How far the energy is off that an impact loses: the worst matched impact of one cable "
           "alone, in one step, up to the horizon.",
           optional_number<&Metrics::energy_loss_error>, as_error, Aggregate::typical,
           NoiseKind::any, Shown::by_run_and_over_cases},
    Metric{"first_impulse_error", "first impulse", "impacts off by", "", "N s",
           "How far the impulse of the first impact is off, where one cable alone is hit.",
           distance_of<&Metrics::first_impulse>, as_error, Aggregate::none, NoiseKind::any,
           Shown::by_run},
    Metric{
        "rest_tension_error", "at rest", "tension off by", "", "N",
        "How far the tension of a cable is off at worst, where the exact motion ends at rest and "
        "the engine tells its tensions.",
        distance_of<&Metrics::rest_tension>, as_error, Aggregate::none, NoiseKind::any,
        Shown::by_run},
    Metric{"largest_tension_error", "largest", "tension off by", "", "N",
           "How far the largest tension of a taut phase is off, up to the predictability horizon, "
           "where the engine tells its tensions.",
           distance_of<&Metrics::largest_tension>, as_error, Aggregate::none, NoiseKind::any,
           Shown::by_run},
    Metric{"overstretch", "overstretch", "", "stretch", "m",
           "Largest length of an inextensible cable beyond its own.", always<&Metrics::overstretch>,
           as_error, Aggregate::extreme, NoiseKind::extreme, Shown::by_run_and_over_cases, 5},
    Metric{"energy_gain", "energy gain", "", "gain", "J",
           "Largest rise of the energy above the start.", always<&Metrics::energy_gain>, as_error,
           Aggregate::extreme, NoiseKind::extreme, Shown::by_run_and_over_cases, 4},
    Metric{"energy_error", "energy error", "", "", "J",
           "Distance from the exact energy at the end of the exact motion or the run.",
           always<&Metrics::energy_error>, as_error, Aggregate::none, NoiseKind::any,
           Shown::nowhere},
};

}  // namespace

std::span<const Metric> metric_list() { return list; }

std::optional<std::size_t> place_of(std::string_view name) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const Metric& metric) { return metric.name == name; });
  return found != list.end() ? std::optional<std::size_t>(found - list.begin()) : std::nullopt;
}

MetricValues values_of(const Metrics& metrics) {
  MetricValues values;
  for (const Metric& metric : list) {
    const Value value = metric.of(metrics);
    // what is not finite says that something could not be measured
    values.push_back(value && std::isfinite(*value) ? value : std::nullopt);
  }
  return values;
}

}  // namespace tautline::bench
