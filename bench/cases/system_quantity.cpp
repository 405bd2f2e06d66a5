#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <functional>
#include <numbers>
#include <optional>

#include "bench/base/listed.hpp"
#include "bench/cases/any_case.hpp"
#include "bench/cases/case_tables.hpp"

namespace tautline::bench {
namespace {

/// A number of a system: its value, and how to give it another one.
struct Number {
  double value;
  std::function<void(double)> set;
};
using MaybeNumber = std::optional<Number>;

Number plain(double& number) {
  return {number, [&number](double value) { number = value; }};
}

MaybeNumber plain(std::optional<double>& number) {
  return number ? MaybeNumber(plain(*number)) : std::nullopt;
}

/// A number of `body`, which a point mass does not have.
template <int D>
MaybeNumber of_turn(const BasicBodyOfSystem<double, D>& body, double& number) {
  return has_inertia(body.inertia) ? MaybeNumber(plain(number)) : std::nullopt;
}

/// Number `axis` of the orientation as a file has it, an axis times an angle; to set it leaves the
/// other two. The sign of its quaternion says whether it turns by more than pi.
MaybeNumber rotation(const SpatialBody& body, Quaternion& orientation, int axis) {
  if (!has_inertia(body.inertia)) {
    return std::nullopt;
  }
  using Rotation = BasicVector<double, 3>;
  const Rotation part = orientation.tail<3>();
  const double size = part.norm();
  const double angle = 2.0 * tautline::atan2(size, orientation[0]);
  const Rotation now = size > 0.0 ? Rotation(angle / size * part) : Rotation(Rotation::Zero());
  return Number{now[axis], [&orientation, now, axis](double value) {
                  Rotation changed = now;
                  changed[axis] = value;
                  orientation = quaternion_of<double>(changed);
                }};
}

/// Its value before the first knot; all values move with it.
template <int N>
Number constant_part(BasicFunction<double, N>& function, int axis) {
  using Value = typename BasicFunction<double, N>::Value;
  const double now =
      function.pieces.empty() ? 0.0 : function.pieces.front().coefficients.front()[axis];
  return {now, [&function, axis, now](double value) {
            if (function.pieces.empty()) {
              function.pieces = BasicFunction<double, N>::constant(Value(Value::Zero())).pieces;
            }
            for (auto& piece : function.pieces) {
              double& constant = piece.coefficients.front()[axis];
              constant = &piece == &function.pieces.front() ? value : constant + (value - now);
            }
          }};
}

/// The first mean rate from knot to knot that is not zero, or the rate of the last piece; all
/// changes grow with it.
MaybeNumber rate(BasicFunction<double, 1>& function) {
  double now = 0.0;
  for (std::size_t i = 0; i < function.pieces.size() && now == 0.0; ++i) {
    const auto& piece = function.pieces[i];
    if (i + 1 < function.pieces.size()) {
      const double next = function.pieces[i + 1].from;
      now = (function.at(next)[0] - function.at(piece.from)[0]) / (next - piece.from);
    } else if (piece.coefficients.size() > 1) {
      now = piece.coefficients[1][0];
    }
  }
  if (now == 0.0) {
    return std::nullopt;
  }
  return Number{now, [&function, now](double value) {
                  const double first = function.pieces.front().coefficients.front()[0];
                  for (auto& piece : function.pieces) {
                    piece.coefficients.front()[0] -= first;
                    for (auto& coefficient : piece.coefficients) {
                      coefficient *= value / now;
                    }
                    piece.coefficients.front()[0] += first;
                  }
                }};
}

/// A number of a cable that impacts, which an elastic one does not have.
template <int D>
MaybeNumber of_impact(const BasicCableOfSystem<double, D>& cable, double& number) {
  return cable.elasticity ? std::nullopt : MaybeNumber(plain(number));
}

/// The first coefficient of a law of stretch, or of strain; all that there is grows with it.
MaybeNumber stiffness(std::optional<Elasticity>& law, bool of_strain) {
  if (!law || law->of_strain != of_strain) {
    return std::nullopt;
  }
  const Elasticity now = *law;
  return Number{now.stiffness.front(), [&law, now](double value) {
                  const double times = value / now.stiffness.front();
                  for (std::size_t i = 0; i < now.stiffness.size(); ++i) {
                    law->stiffness[i] = i == 0 ? value : now.stiffness[i] * times;
                  }
                  for (std::size_t i = 0; i < now.corners.size(); ++i) {
                    law->corners[i].stiffness = now.corners[i].stiffness * times;
                  }
                }};
}

/// A cable has one of damping and damping ratio.
MaybeNumber damping(std::optional<Elasticity>& law) {
  return law && !(law->damping_ratio > 0.0) ? MaybeNumber(plain(law->damping)) : std::nullopt;
}
MaybeNumber damping_ratio(std::optional<Elasticity>& law) {
  return law && !(law->damping > 0.0) ? MaybeNumber(plain(law->damping_ratio)) : std::nullopt;
}

template <int N>
MaybeNumber amplitude(BasicWave<double, N>& wave) {
  const double now = wave.amplitude.norm();
  if (!(now > 0.0)) {
    return std::nullopt;
  }
  return Number{now, [&wave, now](double value) { wave.amplitude *= value / now; }};
}

template <int N>
MaybeNumber period(BasicWave<double, N>& wave) {
  constexpr double turn = 2.0 * std::numbers::pi;
  if (!(wave.frequency > 0.0)) {
    return std::nullopt;
  }
  return Number{turn / wave.frequency, [&wave](double value) { wave.frequency = turn / value; }};
}

/// A wave without a frequency is a constant.
template <int N>
MaybeNumber phase(BasicWave<double, N>& wave) {
  return wave.frequency > 0.0 ? MaybeNumber(plain(wave.phase)) : std::nullopt;
}

/// Wave `index` of `system` as `number_of` sees it; none where there are fewer waves.
template <int D, class NumberOf>
MaybeNumber of_wave(BasicSystem<double, D>& system, std::size_t index, const NumberOf& number_of) {
  MaybeNumber result;
  each_function(system, [&](auto& function) {
    for (auto& wave : function.waves) {
      result = index-- == 0 ? number_of(wave) : result;
    }
  });
  return result;
}

/// How many numbers of one name a system may have.
enum class Owner { system, bodies, cables, waves };

/// A name of numbers, their unit and whose they are.
struct Kind {
  std::string name;
  std::string_view unit;
  Owner owner;
};

/// Calls `use` with each kind of number of `s`, and what makes of the index of a body, a cable or a
/// wave its number; none: it has no such number.
template <int D, class Use>
void each_kind(BasicSystem<double, D>& s, const Use& use) {
  using Index = std::size_t;
  const auto of_bodies = [&](const std::string& name, std::string_view unit, const auto& number) {
    use(Kind{name, unit, Owner::bodies},
        [&](Index i) -> MaybeNumber { return number(s.bodies[i], s.initial.bodies[i]); });
  };
  // one for each number of a vector
  const auto of_axes = [](const std::string& name, int count, const auto& of_axis) {
    for (int axis = 0; axis < count; ++axis) {
      of_axis(name + "xyz"[axis], axis);
    }
  };
  const auto of_cables = [&](const char* name, std::string_view unit, const auto& number) {
    use(Kind{name, unit, Owner::cables},
        [&](Index i) -> MaybeNumber { return number(s.cables[i]); });
  };
  const auto of_waves = [&](const char* name, std::string_view unit, const auto& number) {
    use(Kind{name, unit, Owner::waves},
        [&](Index i) -> MaybeNumber { return of_wave(s, i, number); });
  };
  of_axes("", D, [&](const std::string& name, int axis) {
    of_bodies(name, "m", [&](auto&, auto& start) { return plain(start.position[axis]); });
  });
  if constexpr (D == 2) {
    of_bodies("angle", "rad", [](auto& body, auto& start) { return of_turn(body, start.angle); });
  } else {
    of_axes("rotation_", 3, [&](const std::string& name, int axis) {
      of_bodies(name, "rad",
                [&](auto& body, auto& start) { return rotation(body, start.orientation, axis); });
    });
  }
  of_axes("velocity_", D, [&](const std::string& name, int axis) {
    of_bodies(name, "m/s", [&](auto&, auto& start) { return plain(start.velocity[axis]); });
  });
  if constexpr (D == 2) {
    of_bodies("spin", "rad/s", [](auto& body, auto& start) { return of_turn(body, start.spin); });
  } else {
    of_axes("spin_", 3, [&](const std::string& name, int axis) {
      of_bodies(name, "rad/s",
                [&](auto& body, auto& start) { return of_turn(body, start.spin[axis]); });
    });
  }
  of_bodies("mass", "kg", [](auto& body, auto&) { return plain(body.mass); });
  if constexpr (D == 2) {
    of_bodies("inertia", "kg m^2", [](auto& body, auto&) { return of_turn(body, body.inertia); });
  } else {
    of_axes("inertia_", 3, [&](const std::string& name, int axis) {
      of_bodies(name, "kg m^2",
                [&](auto& body, auto&) { return of_turn(body, body.inertia[axis]); });
    });
  }
  of_bodies("drag", "N s/m", [](auto& body, auto&) { return plain(body.drag); });
  of_bodies("spin_drag", "N m s", [](auto& body, auto&) { return of_turn(body, body.spin_drag); });
  of_axes("gravity_", D, [&](const std::string& name, int axis) {
    use(Kind{name, "m/s^2", Owner::system},
        [&](Index) -> MaybeNumber { return constant_part(s.gravity, axis); });
  });
  of_cables("restitution", "", [](auto& cable) { return of_impact(cable, cable.restitution); });
  of_cables("length_rate", "m/s", [](auto& cable) { return rate(cable.length); });
  of_cables("length", "m", [](auto& cable) { return constant_part(cable.length, 0); });
  of_cables("capture_speed", "m/s",
            [](auto& cable) { return of_impact(cable, cable.capture_speed); });
  of_cables("stiffness", "N/m", [](auto& cable) { return stiffness(cable.elasticity, false); });
  of_cables("EA", "N", [](auto& cable) { return stiffness(cable.elasticity, true); });
  of_cables("damping", "N s/m", [](auto& cable) { return damping(cable.elasticity); });
  of_cables("damping_ratio", "", [](auto& cable) { return damping_ratio(cable.elasticity); });
  of_cables("from_time", "s", [](auto& cable) { return plain(cable.from_time); });
  of_cables("cut_at", "s", [](auto& cable) { return plain(cable.cut_at); });
  of_waves("amplitude", "", [](auto& wave) { return amplitude(wave); });
  of_waves("period", "s", [](auto& wave) { return period(wave); });
  of_waves("phase", "rad", [](auto& wave) { return phase(wave); });
}

template <int D>
std::size_t how_many(const BasicSystem<double, D>& system, Owner owner) {
  std::size_t waves = 0;
  switch (owner) {
    case Owner::system:
      return 1;
    case Owner::bodies:
      return system.bodies.size();
    case Owner::cables:
      return system.cables.size();
    case Owner::waves:
      break;
  }
  each_function(system, [&](const auto& function) { waves += function.waves.size(); });
  return waves;
}

/// The name of a quantity of one body, cable or wave: a body may be called as a quantity is.
template <int D>
std::string name_of_one(const BasicSystem<double, D>& system, const Kind& kind, std::size_t index) {
  return kind.owner == Owner::bodies
             ? name_in_file(system.bodies[index].name, index, system.bodies.size()) + "." +
                   kind.name
             : kind.name + "_" + std::to_string(index);
}

/// A name of quantities_of, as it is understood.
struct Meant {
  Kind kind;
  std::vector<Number> numbers;  // of the system, in order
};

/// Calls `visit` with each name of one kind and what it means, which holds as long as `system`
/// does.
template <int D, class NumberOf, class Visit>
void visit_kind(const BasicSystem<double, D>& system, const Kind& kind, const NumberOf& number_of,
                const Visit& visit) {
  Meant all{kind, {}};
  for (std::size_t i = 0; i < how_many(system, kind.owner); ++i) {
    if (MaybeNumber number = number_of(i)) {
      all.numbers.push_back(*number);
      if (kind.owner != Owner::system) {
        visit(name_of_one(system, kind, i), Meant{kind, {*number}});
      }
    }
  }
  if (!all.numbers.empty()) {
    visit(kind.name, all);
  }
}

/// Without numbers where there are none now: an amplitude of 0 has no direction to grow in, and
/// what is no system may have lost more.
template <int D>
Meant meant(BasicSystem<double, D>& system, std::string_view name) {
  Meant result{};
  each_kind(system, [&](const Kind& kind, const auto& number_of) {
    if (name.ends_with(kind.name) || name.starts_with(kind.name)) {
      visit_kind(system, kind, number_of, [&](const std::string& known, const Meant& one) {
        if (known == name) {
          result = one;
        }
      });
    }
  });
  return result;
}

/// The unit of the amplitude of the wave that `name` ends with the number of, or of the first.
template <int D>
std::string_view unit_of_wave(const BasicSystem<double, D>& system, std::string_view name) {
  std::vector<std::string_view> units = {
      "m/s^2"};  // of the functions, in the order of each_function
  for (std::size_t body = 0; body < system.bodies.size(); ++body) {
    units.insert(units.end(), {"N", "N m"});
  }
  std::size_t wave = 0;
  if (const std::size_t at = name.find('_'); at != std::string_view::npos) {
    std::from_chars(name.data() + at + 1, name.data() + name.size(), wave);
  }
  std::string_view result = "m";  // of lengths and ends
  std::size_t waves = 0;
  std::size_t function_index = 0;
  each_function(system, [&](const auto& function) {
    const bool has_it = waves <= wave && wave < waves + function.waves.size();
    result = has_it && function_index < units.size() ? units[function_index] : result;
    waves += function.waves.size();
    ++function_index;
  });
  return result;
}

}  // namespace

template <int D>
std::vector<std::string> quantities_of(const BasicSystem<double, D>& system) {
  std::vector<std::string> names;
  BasicSystem<double, D> copy = system;
  each_kind(copy, [&](const Kind& kind, const auto& number_of) {
    visit_kind(copy, kind, number_of,
               [&](const std::string& name, const Meant&) { names.push_back(name); });
  });
  return names;
}
template std::vector<std::string> quantities_of(const System&);
template std::vector<std::string> quantities_of(const SpatialSystem&);

template <int D>
std::string_view unit_of_quantity(const BasicSystem<double, D>& system, std::string_view name) {
  BasicSystem<double, D> copy = system;
  const Kind kind = meant(copy, name).kind;
  assert(!kind.name.empty() && "the name is one of quantities_of");
  return kind.name == "amplitude" ? unit_of_wave(copy, name) : kind.unit;
}
template std::string_view unit_of_quantity(const System&, std::string_view);
template std::string_view unit_of_quantity(const SpatialSystem&, std::string_view);

template <int D>
double quantity(const BasicSystem<double, D>& system, std::string_view name) {
  BasicSystem<double, D> copy = system;
  const std::vector<Number> numbers = meant(copy, name).numbers;
  return numbers.empty() ? 0.0 : numbers.front().value;
}
template double quantity(const System&, std::string_view);
template double quantity(const SpatialSystem&, std::string_view);

template <int D>
void set_quantity(BasicSystem<double, D>& system, std::string_view name, double value) {
  const Meant all = meant(system, name);
  if (all.numbers.empty()) {
    return;
  }
  const double first = all.numbers.front().value;
  const std::vector<Number> periods = all.kind.name == "phase" && all.numbers.size() > 1
                                          ? meant(system, "period").numbers
                                          : std::vector<Number>();
  for (std::size_t i = 0; i < all.numbers.size(); ++i) {
    const Number& number = all.numbers[i];
    if (all.kind.owner != Owner::waves || i == 0) {
      number.set(value);
    } else if (periods.empty()) {
      number.set(number.value * (value / first));
    } else {
      number.set(number.value + (value - first) * (periods.front().value / periods[i].value));
    }
  }
}
template void set_quantity(System&, std::string_view, double);
template void set_quantity(SpatialSystem&, std::string_view, double);

template <int D>
void scale_quantity(BasicSystem<double, D>& system, std::string_view name, double factor) {
  for (const Number& number : meant(system, name).numbers) {
    number.set(number.value * factor);
  }
}
template void scale_quantity(System&, std::string_view, double);
template void scale_quantity(SpatialSystem&, std::string_view, double);

}  // namespace tautline::bench
