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

/// A point mass does not turn.
MaybeNumber of_turn(const System& system, std::size_t body, double& number) {
  return system.bodies[body].inertia > 0.0 ? MaybeNumber(plain(number)) : std::nullopt;
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
template <class NumberOf>
MaybeNumber of_wave(System& system, std::size_t index, const NumberOf& number_of) {
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

struct SystemQuantity {
  std::string_view name;
  std::string_view unit;
  Owner owner;
  MaybeNumber (*of)(System& system, std::size_t index);  // none: it has no such number
};

using Index = std::size_t;
constexpr std::array system_quantities = {
    SystemQuantity{
        "x", "m", Owner::bodies,
        [](System& s, Index i) -> MaybeNumber { return plain(s.initial.bodies[i].position.x()); }},
    SystemQuantity{
        "y", "m", Owner::bodies,
        [](System& s, Index i) -> MaybeNumber { return plain(s.initial.bodies[i].position.y()); }},
    SystemQuantity{
        "angle", "rad", Owner::bodies,
        [](System& s, Index i) -> MaybeNumber { return of_turn(s, i, s.initial.bodies[i].angle); }},
    SystemQuantity{
        "velocity_x", "m/s", Owner::bodies,
        [](System& s, Index i) -> MaybeNumber { return plain(s.initial.bodies[i].velocity.x()); }},
    SystemQuantity{
        "velocity_y", "m/s", Owner::bodies,
        [](System& s, Index i) -> MaybeNumber { return plain(s.initial.bodies[i].velocity.y()); }},
    SystemQuantity{
        "spin", "rad/s", Owner::bodies,
        [](System& s, Index i) -> MaybeNumber { return of_turn(s, i, s.initial.bodies[i].spin); }},
    SystemQuantity{"mass", "kg", Owner::bodies,
                   [](System& s, Index i) -> MaybeNumber { return plain(s.bodies[i].mass); }},
    SystemQuantity{
        "inertia", "kg m^2", Owner::bodies,
        [](System& s, Index i) -> MaybeNumber { return of_turn(s, i, s.bodies[i].inertia); }},
    SystemQuantity{"drag", "N s/m", Owner::bodies,
                   [](System& s, Index i) -> MaybeNumber { return plain(s.bodies[i].drag); }},
    SystemQuantity{
        "spin_drag", "N m s", Owner::bodies,
        [](System& s, Index i) -> MaybeNumber { return of_turn(s, i, s.bodies[i].spin_drag); }},
    SystemQuantity{"gravity_x", "m/s^2", Owner::system,
                   [](System& s, Index) -> MaybeNumber { return constant_part(s.gravity, 0); }},
    SystemQuantity{"gravity_y", "m/s^2", Owner::system,
                   [](System& s, Index) -> MaybeNumber { return constant_part(s.gravity, 1); }},
    SystemQuantity{
        "restitution", "", Owner::cables,
        [](System& s, Index i) -> MaybeNumber { return plain(s.cables[i].restitution); }},
    SystemQuantity{"length_rate", "m/s", Owner::cables,
                   [](System& s, Index i) -> MaybeNumber { return rate(s.cables[i].length); }},
    SystemQuantity{
        "length", "m", Owner::cables,
        [](System& s, Index i) -> MaybeNumber { return constant_part(s.cables[i].length, 0); }},
    SystemQuantity{
        "capture_speed", "m/s", Owner::cables,
        [](System& s, Index i) -> MaybeNumber { return plain(s.cables[i].capture_speed); }},
    SystemQuantity{"from_time", "s", Owner::cables,
                   [](System& s, Index i) -> MaybeNumber { return plain(s.cables[i].from_time); }},
    SystemQuantity{"cut_at", "s", Owner::cables,
                   [](System& s, Index i) -> MaybeNumber { return plain(s.cables[i].cut_at); }},
    SystemQuantity{"amplitude", "", Owner::waves,
                   [](System& s, Index i) {
                     return of_wave(s, i, [](auto& wave) { return amplitude(wave); });
                   }},
    SystemQuantity{
        "period", "s", Owner::waves,
        [](System& s, Index i) { return of_wave(s, i, [](auto& wave) { return period(wave); }); }},
    SystemQuantity{
        "phase", "rad", Owner::waves,
        [](System& s, Index i) { return of_wave(s, i, [](auto& wave) { return phase(wave); }); }},
};

std::size_t how_many(const System& system, Owner owner) {
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
std::string name_of_one(const System& system, const SystemQuantity& quantity, std::size_t index) {
  const std::string name(quantity.name);
  return quantity.owner == Owner::bodies
             ? name_in_file(system.bodies[index].name, index, system.bodies.size()) + "." + name
             : name + "_" + std::to_string(index);
}

/// A name of quantities_of, as it is understood.
struct Meant {
  const SystemQuantity* quantity;
  std::vector<Number> numbers;  // of `system`, in order
};

/// Calls `visit` with each name and what it means, which holds as long as `system` does.
template <class Visit>
void visit_quantities(System& system, const Visit& visit) {
  for (const SystemQuantity& one : system_quantities) {
    Meant all{&one, {}};
    for (std::size_t i = 0; i < how_many(system, one.owner); ++i) {
      if (MaybeNumber number = one.of(system, i)) {
        all.numbers.push_back(*number);
        if (one.owner != Owner::system) {
          visit(name_of_one(system, one, i), Meant{&one, {*number}});
        }
      }
    }
    if (!all.numbers.empty()) {
      visit(std::string(one.name), all);
    }
  }
}

/// Without numbers where there are none now: an amplitude of 0 has no direction to grow in, and
/// what is no system may have lost more.
Meant meant(System& system, std::string_view name) {
  Meant result{nullptr, {}};
  visit_quantities(system, [&](const std::string& known, const Meant& one) {
    if (known == name) {
      result = one;
    }
  });
  return result;
}

/// The unit of the amplitude of the wave that `name` ends with the number of, or of the first.
std::string_view unit_of_wave(const System& system, std::string_view name) {
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

std::vector<std::string> quantities_of(const System& system) {
  std::vector<std::string> names;
  System copy = system;
  visit_quantities(copy, [&](const std::string& name, const Meant&) { names.push_back(name); });
  return names;
}

std::string_view unit_of_quantity(const AnyCase& any, std::string_view name) {
  const auto* const system = std::get_if<System>(&any);
  if (system == nullptr) {
    return unit_of_quantity(name);
  }
  System copy = *system;
  const Meant one = meant(copy, name);
  assert(one.quantity != nullptr && "the name is one of quantities_of");
  return one.quantity->name == "amplitude" ? unit_of_wave(copy, name) : one.quantity->unit;
}

double quantity(const System& system, std::string_view name) {
  System copy = system;
  const std::vector<Number> numbers = meant(copy, name).numbers;
  return numbers.empty() ? 0.0 : numbers.front().value;
}

void set_quantity(System& system, std::string_view name, double value) {
  const Meant all = meant(system, name);
  if (all.numbers.empty()) {
    return;
  }
  const double first = all.numbers.front().value;
  const std::vector<Number> periods = all.quantity->name == "phase" && all.numbers.size() > 1
                                          ? meant(system, "period").numbers
                                          : std::vector<Number>();
  for (std::size_t i = 0; i < all.numbers.size(); ++i) {
    const Number& number = all.numbers[i];
    if (all.quantity->owner != Owner::waves || i == 0) {
      number.set(value);
    } else if (periods.empty()) {
      number.set(number.value * (value / first));
    } else {
      number.set(number.value + (value - first) * (periods.front().value / periods[i].value));
    }
  }
}

void scale_quantity(System& system, std::string_view name, double factor) {
  for (const Number& number : meant(system, name).numbers) {
    number.set(number.value * factor);
  }
}

}  // namespace tautline::bench
