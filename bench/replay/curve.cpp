// From each knot the curve goes on as far as one cubic can follow: it is fitted to what was
// recorded between its two ends, rounded as it will be read, and compared with all of it.

#include "bench/replay/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tautline/geometry.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// The last index of `first` .. `last` for which `fits(index)` holds, if those that fit are the
/// first ones; `first` is taken without asking. Asks where doubled strides lead, then halves the
/// stride that was too long: a long stretch costs few answers.
template <class Fits>
std::size_t farthest(std::size_t first, std::size_t last, const Fits& fits) {
  std::size_t good = first;
  std::size_t bad = last + 1;
  for (std::size_t stride = 1; good < last; stride *= 2) {
    const std::size_t next = std::min(last, good + stride);
    if (!fits(next)) {
      bad = next;
      break;
    }
    good = next;
  }
  while (bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (fits(middle) ? good : bad) = middle;
  }
  return good;
}

/// The grid is this part of the bound: the places of a curve are rounded, and so is where it bends.
constexpr double grid_part = 1.0 / 16.0;

/// No column has more grid widths than this: 2^28, which leaves room in 32 bits.
constexpr double most_widths = 268435456.0;

/// How many numbers of a pose are lengths; the others say how the body is turned.
template <int N>
constexpr int lengths = N == 3 ? 2 : 3;

/// The angle [rad] that a small change of the other numbers is: a quaternion has half of it.
template <int N>
constexpr double angle_of_turn = N == 3 ? 1.0 : 2.0;

/// How far a change of a pose moves the end of `lever`, at most [m].
template <int N>
double moves(const Eigen::Matrix<double, N, 1>& change, double lever) {
  const auto turn = change.template tail<N - lengths<N>>();
  return change.template head<lengths<N>>().norm() + angle_of_turn<N> * lever * turn.norm();
}

/// One cubic, as it is read back.
template <int N>
struct Piece {
  using Numbers = Eigen::Matrix<double, N, 1>;

  double start;  // [s]
  double end;    // [s]
  Numbers from;
  Numbers to;
  Numbers first_bend = Numbers::Zero();
  Numbers second_bend = Numbers::Zero();

  [[nodiscard]] double part(double time) const {
    return std::clamp((time - start) / (end - start), 0.0, 1.0);
  }
  [[nodiscard]] Numbers straight(double s) const { return from + s * (to - from); }
  [[nodiscard]] Numbers at(double s) const {
    return straight(s) + 3.0 * s * (1.0 - s) * ((1.0 - s) * first_bend + s * second_bend);
  }
};

/// The power of two below `grid`, whose multiples are exact.
double even(double grid) { return std::exp2(std::floor(std::log2(grid))); }

double rounded_to(double value, double start, double grid) {
  return start + grid * std::round((value - start) / grid);
}

template <int N>
class Curve {
 public:
  using Numbers = Eigen::Matrix<double, N, 1>;

  Curve(const std::vector<Sample<N>>& samples, double bound, const Nearness::Turn& turn)
      : samples_(samples), turn_(turn), bound_(bound) {
    choose_grids();
  }

  /// Draws it; none where that takes more than `most` pieces.
  [[nodiscard]] std::optional<CurveColumns<N>> draw(std::size_t most) const;

 private:
  void choose_grids();
  [[nodiscard]] double time_of(std::size_t index) const {
    return rounded_to(samples_[index].time, samples_[0].time, time_grid_);
  }
  [[nodiscard]] Numbers knot(std::size_t index) const;
  [[nodiscard]] Piece<N> fitted(std::size_t from, std::size_t to) const;
  [[nodiscard]] double error(const Piece<N>& piece, std::size_t from, std::size_t to, double lever,
                             double enough) const;
  [[nodiscard]] std::size_t end_of_piece(std::size_t from) const;

  const std::vector<Sample<N>>& samples_;
  const Nearness::Turn& turn_;
  double bound_;                    // [m]
  double time_grid_ = 0.0;          // [s]
  Numbers grid_ = Numbers::Ones();  // of each number
};

template <int N>
void Curve<N>::choose_grids() {
  const double duration = samples_.back().time - samples_.front().time;
  Eigen::Array<double, N, 1> least = samples_[0].pose;
  Eigen::Array<double, N, 1> largest = samples_[0].pose;
  double speed = 0.0;  // [m/s], of the centre and of the lever's end
  for (const Sample<N>& one : samples_) {
    least = least.min(one.pose.array());
    largest = largest.max(one.pose.array());
    speed = std::max(speed, moves<N>(one.leaving, turn_.lever));
  }
  const double grid = grid_part * bound_;
  Eigen::Array<double, N, 1> widths;
  widths.fill(grid);
  widths.template tail<N - lengths<N>>().setConstant(grid / (angle_of_turn<N> * turn_.lever));
  grid_ = widths.max((largest - least) / most_widths).unaryExpr(&even);
  constexpr double coarsest = 1e-6;  // [-] of the duration: a page tells events so near apart
  const double moved = speed > 0.0 ? grid / speed : duration;
  const double fine = std::max(std::min(moved, coarsest * duration), duration / most_widths);
  time_grid_ = duration > 0.0 ? even(fine) : 1.0;
}

template <int N>
typename Curve<N>::Numbers Curve<N>::knot(std::size_t index) const {
  Numbers result;
  for (int k = 0; k < N; ++k) {
    result[k] = rounded_to(samples_[index].pose[k], samples_[0].pose[k], grid_[k]);
  }
  return result;
}

/// The bends by least squares over what lies between. That may be too little to tell both: then,
/// with a weight that is nothing against one sample, those that the velocities at the ends give.
template <int N>
Piece<N> Curve<N>::fitted(std::size_t from, std::size_t to) const {
  constexpr double weight = 1e-7;   // [-]
  constexpr std::size_t most = 32;  // samples: more do not change a cubic
  Piece<N> piece{time_of(from), time_of(to), knot(from), knot(to)};
  const double length = piece.end - piece.start;
  const Numbers way = piece.to - piece.from;
  Eigen::Matrix2d matrix = weight * Eigen::Matrix2d::Identity();
  Eigen::Matrix<double, 2, N> right;
  right.row(0) = weight / 3.0 * (length * samples_[from].leaving - way).transpose();
  right.row(1) = weight / 3.0 * (way - length * samples_[to].arriving).transpose();
  const std::size_t stride = std::max<std::size_t>(1, (to - from) / most);
  for (std::size_t index = from + 1; index < to; index += stride) {
    const double s = piece.part(samples_[index].time);
    const Eigen::Vector2d shape = 3.0 * s * (1.0 - s) * Eigen::Vector2d(1.0 - s, s);
    matrix += shape * shape.transpose();
    right += shape * (samples_[index].pose - piece.straight(s)).transpose();
  }
  const Eigen::Matrix<double, 2, N> bends = matrix.inverse() * right;
  for (int k = 0; k < N; ++k) {
    const auto bend = [&](int row) {
      return std::clamp(rounded_to(bends(row, k), 0.0, grid_[k]), -most_widths * grid_[k],
                        most_widths * grid_[k]);
    };
    piece.first_bend[k] = bend(0);
    piece.second_bend[k] = bend(1);
  }
  return piece;
}

/// The largest distance of `piece` from samples `from` .. `to` [m], or one above `enough`.
template <int N>
double Curve<N>::error(const Piece<N>& piece, std::size_t from, std::size_t to, double lever,
                       double enough) const {
  double largest = 0.0;
  for (std::size_t index = from; index <= to && largest <= enough; ++index) {
    const Numbers off = piece.at(piece.part(samples_[index].time)) - samples_[index].pose;
    largest = std::max(largest, moves<N>(off, lever));
  }
  return largest;
}

template <int N>
std::size_t Curve<N>::end_of_piece(std::size_t from) const {
  const std::size_t last = samples_.size() - 1;
  std::size_t next = from + 1;
  while (next < last && time_of(next) <= time_of(from)) {
    ++next;  // too near to be two knots
  }
  return farthest(next, last, [&](std::size_t to) {
    return time_of(to) > time_of(from) &&
           error(fitted(from, to), from, to, turn_.lever, bound_) <= bound_;
  });
}

template <int N>
std::optional<CurveColumns<N>> Curve<N>::draw(std::size_t most) const {
  std::vector<double> time = {time_of(0)};
  ForEach<std::vector<double>, N> places;
  ForEach<std::vector<double>, N> bends;
  const auto add = [](ForEach<std::vector<double>, N>& columns, const Numbers& values) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      columns[k].push_back(values[static_cast<Eigen::Index>(k)]);
    }
  };
  add(places, knot(0));
  CurveColumns<N> result;
  for (std::size_t from = 0; from + 1 < samples_.size();) {
    if (time.size() > most) {
      return std::nullopt;
    }
    const std::size_t to = end_of_piece(from);
    if (!(time_of(to) > time_of(from))) {
      break;  // the last samples are of one instant
    }
    const Piece<N> piece = fitted(from, to);
    const double any = std::numeric_limits<double>::infinity();
    result.error = std::max(result.error, error(piece, from, to, turn_.reach, any));
    time.push_back(piece.end);
    add(places, piece.to);
    add(bends, piece.first_bend);
    add(bends, piece.second_bend);
    from = to;
  }
  result.time = on_grid(time, time_grid_);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double grid = grid_[static_cast<Eigen::Index>(k)];
    result.places[k] = on_grid(places[k], grid);
    result.bends[k] = on_grid(bends[k], grid);
  }
  return result;
}

/// The largest distance of the line from `from` to `to` from what lies between.
double line_error(const std::vector<Level>& levels, std::size_t from, std::size_t to) {
  const double length = levels[to].time - levels[from].time;
  double largest = 0.0;
  for (std::size_t index = from + 1; index < to; ++index) {
    const double s = length > 0.0 ? (levels[index].time - levels[from].time) / length : 0.0;
    const double line = levels[from].value + s * (levels[to].value - levels[from].value);
    largest = std::max(largest, std::abs(line - levels[index].value));
  }
  return largest;
}

/// The knots of a line that is off by no more than `bound`; none where they are too many.
std::optional<std::vector<std::size_t>> line_knots(const std::vector<Level>& levels, double bound,
                                                   std::size_t most) {
  std::vector<std::size_t> knots = {0};
  while (knots.back() + 1 < levels.size()) {
    if (knots.size() > most) {
      return std::nullopt;
    }
    const std::size_t from = knots.back();
    knots.push_back(farthest(from + 1, levels.size() - 1, [&](std::size_t to) {
      return line_error(levels, from, to) <= bound;
    }));
  }
  return knots;
}

/// Two instants nearer than this part of the duration are one [-]: rounding.
constexpr double one_instant = 1e-12;

std::size_t bodies_of(const State& /*state*/) { return 1; }
std::size_t bodies_of(const SpatialSystemState& state) { return state.bodies.size(); }

Eigen::Vector3d pose_of(const State& state, std::size_t /*body*/) {
  return {state.position.x(), state.position.y(), state.angle};
}
Eigen::Matrix<double, 7, 1> pose_of(const SpatialSystemState& state, std::size_t body) {
  Eigen::Matrix<double, 7, 1> result;
  result << state.bodies[body].position, state.bodies[body].orientation;
  return result;
}

/// The rates of the numbers of a pose at `at` where the body moves as in `state`.
Eigen::Vector3d rates_of(const State& state, const State& /*at*/, std::size_t /*body*/) {
  return {state.velocity.x(), state.velocity.y(), state.spin};
}
Eigen::Matrix<double, 7, 1> rates_of(const SpatialSystemState& state, const SpatialSystemState& at,
                                     std::size_t body) {
  Quaternion spin = Quaternion::Zero();
  spin.tail<3>() = 0.5 * state.bodies[body].spin;
  Eigen::Matrix<double, 7, 1> result;
  result << state.bodies[body].velocity, product<double>(at.bodies[body].orientation, spin);
  return result;
}

/// The states before and after a jump, or one twice.
template <class TheCase>
struct Instant {
  double time;  // [s]
  const StateOf<TheCase>* before;
  const StateOf<TheCase>* after;
};

template <int N>
bool is_finite(const Sample<N>& sample) {
  return sample.pose.allFinite() && sample.arriving.allFinite() && sample.leaving.allFinite() &&
         std::isfinite(sample.energy_before) && std::isfinite(sample.energy_after);
}

/// The samples of a body at `instants`. Samples of one instant become one: it is come to as the
/// first is, and left as the last is.
template <class TheCase>
std::vector<SampleOf<TheCase>> samples_at(const TheCase& the_case,
                                          const std::vector<Instant<TheCase>>& instants,
                                          std::size_t body) {
  std::vector<SampleOf<TheCase>> result;
  result.reserve(instants.size());
  for (const auto& [time, before, after] : instants) {
    const SampleOf<TheCase> one = {time,
                                   pose_of(*before, body),
                                   rates_of(*before, *before, body),
                                   rates_of(*after, *before, body),
                                   energy(the_case, *before),
                                   energy(the_case, *after)};
    if (!is_finite(one)) {
      break;  // the last of a run that diverged
    }
    if (!result.empty() && one.time - result.back().time <= one_instant * the_case.duration) {
      result.back().leaving = one.leaving;
      result.back().energy_after = one.energy_after;
    } else {
      result.push_back(one);
    }
  }
  return result;
}

/// A quaternion and its negative are one orientation: takes the one that is nearer to that before.
void make_continuous(std::vector<Sample<7>>& samples) {
  for (std::size_t next = 1; next < samples.size(); ++next) {
    if (samples[next].pose.tail<4>().dot(samples[next - 1].pose.tail<4>()) < 0.0) {
      for (auto* numbers : {&samples[next].pose, &samples[next].arriving, &samples[next].leaving}) {
        numbers->tail<4>() *= -1.0;
      }
    }
  }
}
void make_continuous(std::vector<Sample<3>>& /*samples*/) {}

/// The samples of all bodies at `instants`.
template <class TheCase>
std::vector<std::vector<SampleOf<TheCase>>> samples_at(
    const TheCase& the_case, const std::vector<Instant<TheCase>>& instants) {
  std::vector<std::vector<SampleOf<TheCase>>> result;
  for (std::size_t body = 0; body < bodies_of(the_case.initial); ++body) {
    make_continuous(result.emplace_back(samples_at(the_case, instants, body)));
  }
  return result;
}

/// Gives every sample the velocities of the straight ways to its neighbours.
template <int N>
void take_differences(std::vector<Sample<N>>& samples) {
  for (std::size_t next = 1; next < samples.size(); ++next) {
    Sample<N>& from = samples[next - 1];
    Sample<N>& to = samples[next];
    from.leaving = to.arriving = (to.pose - from.pose) / (to.time - from.time);
  }
}

}  // namespace

template <int N>
CurveColumns<N> drawn_motion(const std::vector<Sample<N>>& samples, double bound,
                             const Nearness::Turn& turn, std::size_t most) {
  for (;; bound *= 2.0) {
    if (std::optional<CurveColumns<N>> columns = Curve<N>(samples, bound, turn).draw(most)) {
      return *std::move(columns);
    }
  }
}
template CurveColumns<3> drawn_motion(const std::vector<Sample<3>>&, double, const Nearness::Turn&,
                                      std::size_t);
template CurveColumns<7> drawn_motion(const std::vector<Sample<7>>&, double, const Nearness::Turn&,
                                      std::size_t);

DrawnLine drawn_line(const std::vector<Level>& levels, double bound, std::size_t most) {
  const auto [least, largest] =
      std::minmax_element(levels.begin(), levels.end(),
                          [](const Level& a, const Level& b) { return a.value < b.value; });
  std::optional<std::vector<std::size_t>> knots = line_knots(levels, bound, most);
  while (!knots) {
    bound *= 2.0;
    knots = line_knots(levels, bound, most);
  }
  const double grid =
      even(std::max(grid_part * bound, (largest->value - least->value) / most_widths));
  // a step of an engine may lose much: its time is as fine as can be
  const double time_grid = even((levels.back().time - levels.front().time) / most_widths);
  std::vector<double> time;
  std::vector<double> values;
  double error = 0.0;
  for (const std::size_t index : *knots) {
    if (!time.empty()) {
      const std::size_t before = knots->at(time.size() - 1);
      const double length = levels[index].time - levels[before].time;
      const double slope =
          length > 0.0 ? std::abs(levels[index].value - levels[before].value) / length : 0.0;
      error = std::max(error, line_error(levels, before, index) + grid + slope * time_grid);
    }
    time.push_back(levels[index].time);
    values.push_back(levels[index].value);
  }
  return {{on_grid(time, time_grid > 0.0 ? time_grid : 1.0), on_grid(values, grid)}, error};
}

template <class TheCase>
std::vector<std::vector<SampleOf<TheCase>>> samples_of(const TheCase& the_case,
                                                       const BasicTrajectory<TheCase>& run) {
  const auto& impacts = run.impacts;
  const bool located = !impacts.empty() && std::all_of(impacts.begin(), impacts.end(),
                                                       [](const auto& i) { return i.steps == 0; });
  std::vector<Instant<TheCase>> instants;
  instants.reserve(run.points.size() + impacts.size());
  for (const BasicRecordedImpact<TheCase>& impact : impacts) {
    // a push over whole steps starts from a pose of the run; where it leads is another one
    instants.push_back(
        {impact.time, &impact.before, impact.steps == 0 ? &impact.after : &impact.before});
  }
  for (const BasicPoint<TheCase>& point : run.points) {
    instants.push_back({point.time, &point.state, &point.state});
  }
  // of one instant, the impact stands before the point, which is after it
  std::inplace_merge(instants.begin(),
                     instants.begin() + static_cast<std::ptrdiff_t>(impacts.size()), instants.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
  auto samples = samples_at(the_case, instants);
  if (!located) {
    for (auto& of_body : samples) {
      take_differences(of_body);
    }
  }
  return samples;
}
template std::vector<std::vector<Sample<3>>> samples_of(const Case&, const Trajectory&);
template std::vector<std::vector<Sample<7>>> samples_of(const SpatialSystem&,
                                                        const SystemTrajectory&);

template <class TheCase>
std::vector<std::vector<SampleOf<TheCase>>> samples_of(const TheCase& the_case,
                                                       const BasicSolution<TheCase>& solution) {
  constexpr double fine = 20000.0;   // parts of the whole motion: a millisecond of 20 s
  constexpr std::size_t least = 24;  // parts of an arc: a cubic may cut the corner at its end
  // an accumulation that is completed moves the body at once: so soon it is where it then goes on
  const double soon = 4e-6 * solution.end_time();  // [s], wide enough for two knots
  std::vector<BasicPoint<TheCase>> points;
  const auto add = [&](const BasicArc<TheCase>& arc, double dt) {
    points.push_back({arc.start + dt, arc.after(dt, solution.gravity())});
  };
  for (const BasicArc<TheCase>& arc : solution.arcs_until(solution.end_time())) {
    const double length = arc.end - arc.start;
    add(arc, 0.0);
    if (static_cast<double>(least) * soon < length) {
      add(arc, soon);
    }
    const std::size_t parts =
        std::max(least, static_cast<std::size_t>(fine * length / solution.end_time()));
    for (std::size_t part = 1; part <= parts; ++part) {
      add(arc, length * static_cast<double>(part) / static_cast<double>(parts));
    }
  }
  std::vector<Instant<TheCase>> instants;
  instants.reserve(points.size());
  for (const BasicPoint<TheCase>& point : points) {
    instants.push_back({point.time, &point.state, &point.state});
  }
  return samples_at(the_case, instants);
}
template std::vector<std::vector<Sample<3>>> samples_of(const Case&, const Solution&);
template std::vector<std::vector<Sample<7>>> samples_of(const SpatialSystem&,
                                                        const BasicSolution<SpatialSystem>&);

}  // namespace tautline::bench
