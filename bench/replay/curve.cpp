// From each knot the curve goes on as far as one cubic can follow: it is fitted to what was
// recorded between its two ends, rounded as it will be read, and compared with all of it.

#include "bench/replay/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tautline/geometry.hpp"

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

/// One cubic, as it is read back.
struct Piece {
  double start;  // [s]
  double end;    // [s]
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  Eigen::Vector3d first_bend = Eigen::Vector3d::Zero();
  Eigen::Vector3d second_bend = Eigen::Vector3d::Zero();

  [[nodiscard]] double part(double time) const {
    return std::clamp((time - start) / (end - start), 0.0, 1.0);
  }
  [[nodiscard]] Eigen::Vector3d straight(double s) const { return from + s * (to - from); }
  [[nodiscard]] Eigen::Vector3d at(double s) const {
    return straight(s) + 3.0 * s * (1.0 - s) * ((1.0 - s) * first_bend + s * second_bend);
  }
};

/// The power of two below `grid`, whose multiples are exact.
double even(double grid) { return std::exp2(std::floor(std::log2(grid))); }

double rounded_to(double value, double start, double grid) {
  return start + grid * std::round((value - start) / grid);
}

class Curve {
 public:
  Curve(const std::vector<Sample>& samples, const Nearness& nearness, double bound)
      : samples_(samples), nearness_(nearness), bound_(bound) {
    choose_grids();
  }

  /// Draws it; false where that takes more than `most_pieces`.
  [[nodiscard]] bool draw(Path& path) const;

 private:
  void choose_grids();
  [[nodiscard]] double time_of(std::size_t index) const {
    return rounded_to(samples_[index].time, samples_[0].time, time_grid_);
  }
  [[nodiscard]] Eigen::Vector3d knot(std::size_t index) const;
  [[nodiscard]] Piece fitted(std::size_t from, std::size_t to) const;
  [[nodiscard]] double error(const Piece& piece, std::size_t from, std::size_t to, double lever,
                             double enough) const;
  [[nodiscard]] std::size_t end_of_piece(std::size_t from) const;

  const std::vector<Sample>& samples_;
  const Nearness& nearness_;
  double bound_;                                    // [m]
  double time_grid_ = 0.0;                          // [s]
  Eigen::Vector3d grid_ = Eigen::Vector3d::Ones();  // [m, m, rad]
};

void Curve::choose_grids() {
  const double duration = samples_.back().time - samples_.front().time;
  Eigen::Array3d least = samples_[0].pose;
  Eigen::Array3d largest = samples_[0].pose;
  double speed = 0.0;  // [m/s], of the centre and of the lever's end
  for (const Sample& one : samples_) {
    least = least.min(one.pose.array());
    largest = largest.max(one.pose.array());
    speed =
        std::max(speed, one.leaving.head<2>().norm() + nearness_.lever * std::abs(one.leaving[2]));
  }
  const double grid = grid_part * bound_;
  grid_ = Eigen::Array3d(grid, grid, grid / nearness_.lever)
              .max((largest - least) / most_widths)
              .unaryExpr(&even);
  constexpr double coarsest = 1e-6;  // [-] of the duration: a page tells events so near apart
  const double moved = speed > 0.0 ? grid / speed : duration;
  const double fine = std::max(std::min(moved, coarsest * duration), duration / most_widths);
  time_grid_ = duration > 0.0 ? even(fine) : 1.0;
}

Eigen::Vector3d Curve::knot(std::size_t index) const {
  const Eigen::Vector3d& first = samples_[0].pose;
  const Eigen::Vector3d& pose = samples_[index].pose;
  return {rounded_to(pose[0], first[0], grid_[0]), rounded_to(pose[1], first[1], grid_[1]),
          rounded_to(pose[2], first[2], grid_[2])};
}

/// The bends by least squares over what lies between. That may be too little to tell both: then,
/// with a weight that is nothing against one sample, those that the velocities at the ends give.
Piece Curve::fitted(std::size_t from, std::size_t to) const {
  constexpr double weight = 1e-7;   // [-]
  constexpr std::size_t most = 32;  // samples: more do not change a cubic
  Piece piece{time_of(from), time_of(to), knot(from), knot(to)};
  const double length = piece.end - piece.start;
  const Eigen::Vector3d way = piece.to - piece.from;
  Eigen::Matrix2d matrix = weight * Eigen::Matrix2d::Identity();
  Eigen::Matrix<double, 2, 3> right;
  right.row(0) = weight / 3.0 * (length * samples_[from].leaving - way).transpose();
  right.row(1) = weight / 3.0 * (way - length * samples_[to].arriving).transpose();
  const std::size_t stride = std::max<std::size_t>(1, (to - from) / most);
  for (std::size_t index = from + 1; index < to; index += stride) {
    const double s = piece.part(samples_[index].time);
    const Eigen::Vector2d shape = 3.0 * s * (1.0 - s) * Eigen::Vector2d(1.0 - s, s);
    matrix += shape * shape.transpose();
    right += shape * (samples_[index].pose - piece.straight(s)).transpose();
  }
  const Eigen::Matrix<double, 2, 3> bends = matrix.inverse() * right;
  for (int k = 0; k < 3; ++k) {
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
double Curve::error(const Piece& piece, std::size_t from, std::size_t to, double lever,
                    double enough) const {
  double largest = 0.0;
  for (std::size_t index = from; index <= to && largest <= enough; ++index) {
    const Eigen::Vector3d off = piece.at(piece.part(samples_[index].time)) - samples_[index].pose;
    largest = std::max(largest, off.head<2>().norm() + lever * std::abs(off[2]));
  }
  return largest;
}

std::size_t Curve::end_of_piece(std::size_t from) const {
  const std::size_t last = samples_.size() - 1;
  std::size_t next = from + 1;
  while (next < last && time_of(next) <= time_of(from)) {
    ++next;  // too near to be two knots
  }
  return farthest(next, last, [&](std::size_t to) {
    return time_of(to) > time_of(from) &&
           error(fitted(from, to), from, to, nearness_.lever, bound_) <= bound_;
  });
}

bool Curve::draw(Path& path) const {
  std::vector<double> time = {time_of(0)};
  std::vector<double> places[3];
  std::vector<double> bends[3];
  const auto add = [](std::vector<double>(&columns)[3], const Eigen::Vector3d& values) {
    for (int k = 0; k < 3; ++k) {
      columns[k].push_back(values[k]);
    }
  };
  add(places, knot(0));
  path.error = 0.0;
  for (std::size_t from = 0; from + 1 < samples_.size();) {
    if (time.size() > most_pieces) {
      return false;
    }
    const std::size_t to = end_of_piece(from);
    if (!(time_of(to) > time_of(from))) {
      break;  // the last samples are of one instant
    }
    const Piece piece = fitted(from, to);
    const double any = std::numeric_limits<double>::infinity();
    path.error = std::max(path.error, error(piece, from, to, nearness_.reach, any));
    time.push_back(piece.end);
    add(places, piece.to);
    add(bends, piece.first_bend);
    add(bends, piece.second_bend);
    from = to;
  }
  path.time = on_grid(time, time_grid_);
  path.x = on_grid(places[0], grid_[0]);
  path.y = on_grid(places[1], grid_[1]);
  path.angle = on_grid(places[2], grid_[2]);
  path.x_bends = on_grid(bends[0], grid_[0]);
  path.y_bends = on_grid(bends[1], grid_[1]);
  path.angle_bends = on_grid(bends[2], grid_[2]);
  return true;
}

/// Energy over time, a jump as two of one time.
struct Level {
  double time;    // [s]
  double energy;  // [J]
};

std::vector<Level> levels_of(const std::vector<Sample>& samples) {
  std::vector<Level> levels;
  for (const Sample& one : samples) {
    levels.push_back({one.time, one.energy_before});
    if (one.energy_after != one.energy_before) {
      levels.push_back({one.time, one.energy_after});
    }
  }
  return levels;
}

/// The largest distance of the line from `from` to `to` from what lies between [J].
double line_error(const std::vector<Level>& levels, std::size_t from, std::size_t to) {
  const double length = levels[to].time - levels[from].time;
  double largest = 0.0;
  for (std::size_t index = from + 1; index < to; ++index) {
    const double s = length > 0.0 ? (levels[index].time - levels[from].time) / length : 0.0;
    const double line = levels[from].energy + s * (levels[to].energy - levels[from].energy);
    largest = std::max(largest, std::abs(line - levels[index].energy));
  }
  return largest;
}

/// The knots of a line that is off by no more than `bound` [J]; none where they are too many.
std::optional<std::vector<std::size_t>> line_knots(const std::vector<Level>& levels, double bound) {
  std::vector<std::size_t> knots = {0};
  while (knots.back() + 1 < levels.size()) {
    if (knots.size() > most_pieces) {
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

Eigen::Vector3d pose_of(const State& state) {
  return {state.position.x(), state.position.y(), state.angle};
}

Eigen::Vector3d velocity_of(const State& state) {
  return {state.velocity.x(), state.velocity.y(), state.spin};
}

Sample sample(const Case& the_case, double time, const State& before, const State& after) {
  return {time,
          pose_of(before),
          velocity_of(before),
          velocity_of(after),
          energy(the_case, before),
          energy(the_case, after)};
}

bool is_finite(const Sample& sample) {
  return sample.pose.allFinite() && sample.arriving.allFinite() && sample.leaving.allFinite() &&
         std::isfinite(sample.energy_before) && std::isfinite(sample.energy_after);
}

/// Samples of one instant become one: it is come to as the first is, and left as the last is.
std::vector<Sample> merged(const Case& the_case, const std::vector<Sample>& samples) {
  std::vector<Sample> result;
  for (const Sample& one : samples) {
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

/// Gives every sample the velocities of the straight ways to its neighbours.
void take_differences(std::vector<Sample>& samples) {
  for (std::size_t next = 1; next < samples.size(); ++next) {
    Sample& from = samples[next - 1];
    Sample& to = samples[next];
    from.leaving = to.arriving = (to.pose - from.pose) / (to.time - from.time);
  }
}

}  // namespace

void draw_motion(const std::vector<Sample>& samples, const Nearness& nearness, Path& path) {
  for (double bound = nearness.bound; !Curve(samples, nearness, bound).draw(path); bound *= 2.0) {
  }
}

void draw_energy(const std::vector<Sample>& samples, const Nearness& nearness, Path& path) {
  const std::vector<Level> levels = levels_of(samples);
  const auto [least, largest] =
      std::minmax_element(levels.begin(), levels.end(),
                          [](const Level& a, const Level& b) { return a.energy < b.energy; });
  double bound = nearness.energy;
  std::optional<std::vector<std::size_t>> knots = line_knots(levels, bound);
  while (!knots) {
    bound *= 2.0;
    knots = line_knots(levels, bound);
  }
  const double grid =
      even(std::max(grid_part * bound, (largest->energy - least->energy) / most_widths));
  // a step of an engine may lose much: its time is as fine as can be
  const double time_grid = even((levels.back().time - levels.front().time) / most_widths);
  std::vector<double> time;
  std::vector<double> energy;
  path.energy_error = 0.0;
  for (const std::size_t index : *knots) {
    if (!time.empty()) {
      const std::size_t before = knots->at(time.size() - 1);
      const double length = levels[index].time - levels[before].time;
      const double slope =
          length > 0.0 ? std::abs(levels[index].energy - levels[before].energy) / length : 0.0;
      path.energy_error =
          std::max(path.energy_error, line_error(levels, before, index) + grid + slope * time_grid);
    }
    time.push_back(levels[index].time);
    energy.push_back(levels[index].energy);
  }
  path.energy = on_grid(energy, grid);
  path.energy_time = on_grid(time, time_grid > 0.0 ? time_grid : 1.0);
}

std::vector<Sample> samples_of(const Case& the_case, const Trajectory& run) {
  const auto& impacts = run.impacts;
  const bool located = !impacts.empty() && std::all_of(impacts.begin(), impacts.end(),
                                                       [](const auto& i) { return i.steps == 0; });
  std::vector<Sample> samples;
  samples.reserve(run.points.size() + impacts.size());
  for (const RecordedImpact& impact : impacts) {
    // a push over whole steps starts from a pose of the run; where it leads is another one
    samples.push_back(sample(the_case, impact.time, impact.before,
                             impact.steps == 0 ? impact.after : impact.before));
  }
  for (const Point& point : run.points) {
    samples.push_back(sample(the_case, point.time, point.state, point.state));
  }
  // of one instant, the impact stands before the point, which is after it
  std::inplace_merge(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(impacts.size()),
                     samples.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  samples = merged(the_case, samples);
  if (!located) {
    take_differences(samples);
  }
  return samples;
}

std::vector<Sample> samples_of(const Case& the_case, const Solution& solution) {
  constexpr double fine = 20000.0;   // parts of the whole motion: a millisecond of 20 s
  constexpr std::size_t least = 24;  // parts of an arc: a cubic may cut the corner at its end
  // an accumulation that is completed moves the body at once: so soon it is where it then goes on
  const double soon = 4e-6 * solution.end_time();  // [s], wide enough for two knots
  std::vector<Sample> samples;
  const auto add = [&](const Arc& arc, double dt) {
    const State state = arc.after(dt, solution.gravity());
    samples.push_back(sample(the_case, arc.start + dt, state, state));
  };
  for (const Arc& arc : solution.arcs_until(solution.end_time())) {
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
  return merged(the_case, samples);
}

}  // namespace tautline::bench
