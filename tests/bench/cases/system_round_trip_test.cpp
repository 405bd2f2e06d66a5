// A system that is written reads back with every bit.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "bench/base/text.hpp"
#include "bench/data/coordinates.hpp"
#include "tautline/case_file.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

using Strings = std::vector<std::string>;

/// Draws systems that break no rule.
template <int D>
class Draw {
 public:
  using System = BasicSystem<double, D>;
  using BodyOfSystem = BasicBodyOfSystem<double, D>;
  using CableOfSystem = BasicCableOfSystem<double, D>;
  using End = BasicEnd<double, D>;

  explicit Draw(unsigned seed) : random_(seed) {}

  System system() {
    System result;
    result.name = "system \"" + std::to_string(below(1000)) + "\"";
    result.duration = between(0.5, 20.0);
    result.gravity = function<D>(9.81);
    const int bodies = 1 + below(5);
    for (int index = 0; index < bodies; ++index) {
      result.bodies.push_back(body(index));
      result.initial.bodies.push_back(state());
    }
    for (int index = below(9); index > 0; --index) {
      result.cables.push_back(cable(result));
    }
    return result;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  bool one_in(int count) { return below(count) == 0; }

  /// A number of full precision, or one that is easily lost.
  double number(double size) {
    switch (below(8)) {
      case 0:
        return -0.0;
      case 1:
        return 0.0;
      case 2:
        return std::round(size);
      default:
        return between(-size, size);
    }
  }
  auto state() {
    if constexpr (D == 2) {
      return State{value<2>(3.0), number(3.0), value<2>(2.0), number(5.0)};
    } else {
      return SpatialState{value<3>(3.0), quaternion_of<double>(value<3>(3.0)), value<3>(2.0),
                          value<3>(5.0)};
    }
  }

  template <int N>
  typename Function<N>::Value value(double size) {
    typename Function<N>::Value result;
    for (int row = 0; row < N; ++row) {
      result[row] = number(size);
    }
    return result;
  }

  /// Any form of a function that does not jump, about as large as `size`.
  template <int N>
  Function<N> function(double size,
                       const typename Function<N>::Value& middle = Function<N>::Value::Zero()) {
    Function<N> result;
    std::vector<double> times = {number(1.0)};
    std::vector<typename Function<N>::Value> values = {middle + value<N>(size)};
    for (int more = below(4); more > 0; --more) {
      times.push_back(times.back() + between(0.01, 2.0));
      values.push_back(middle + value<N>(size));
    }
    switch (below(5)) {
      case 0:
        result = Function<N>::constant(values[0]);
        break;
      case 1:
        result = Function<N>::linear(times, values);
        break;
      case 2:
        result = Function<N>::spline(times, values);
        break;
      case 3:
        result = Function<N>::linear(times, values);
        result.pieces.back().coefficients.push_back(value<N>(size / 1e3));
        break;
      default:
        result.pieces = {{times[0], {values[0], value<N>(size / 1e3), value<N>(size / 1e5)}}};
    }
    for (int more = one_in(2) ? below(200) == 0 ? 150 : below(3) : 0; more > 0; --more) {
      result.waves.push_back({value<N>(size / 1e3), std::abs(number(5.0)), number(3.0)});
    }
    return result;
  }

  BodyOfSystem body(int index) {
    BodyOfSystem body;
    body.name = one_in(4) ? "" : "b" + std::to_string(index) + (one_in(3) ? " \"é\"\n" : "");
    body.mass = between(0.1, 10.0);
    if constexpr (D == 2) {
      body.inertia = between(0.01, 1.0);
    } else {
      body.inertia = {between(0.5, 1.0), between(0.5, 1.0), between(0.5, 1.0)};
    }
    body.drag = one_in(2) ? std::abs(number(0.1)) : 0.0;
    body.spin_drag = one_in(2) ? std::abs(number(0.1)) : 0.0;
    if (one_in(2)) {
      body.force = function<D>(1.0);
    }
    if (one_in(2)) {
      body.moment = function<spins<D>>(1.0);
    }
    return body;
  }

  End end(const System& system, bool on_body, std::size_t other) {
    End end;
    if (on_body) {
      end.body = (other + 1 + static_cast<std::size_t>(below(8))) % system.bodies.size();
      end.at = value<D>(0.3);
    } else {
      end.at = value<D>(3.0);
      if (one_in(2)) {
        end.motion = function<D>(0.5);
      }
    }
    return end;
  }

  Elasticity elasticity() {
    Elasticity law;
    law.stiffness = {between(1.0, 1e4)};
    for (int more = below(3); more > 0; --more) {
      law.stiffness.push_back(std::abs(number(1e5)));
    }
    (one_in(2) ? law.damping : law.damping_ratio) = one_in(3) ? 0.0 : between(0.0, 2.0);
    return law;
  }

  CableOfSystem cable(const System& system) {
    CableOfSystem cable;
    const auto count = static_cast<int>(system.bodies.size());
    cable.from = end(system, true, static_cast<std::size_t>(below(count)));
    cable.to = end(system, false, 0);
    for (int rings = one_in(3) ? 1 + below(3) : 0; rings > 0; --rings) {
      cable.through.push_back(end(system, one_in(3), *cable.from.body));
    }
    if (count > 1 && one_in(2)) {
      cable.to = end(system, true, 0);
      if (cable.to.body == cable.from.body) {
        cable.to.body = (*cable.to.body + 1) % system.bodies.size();
      }
    }
    if (one_in(4)) {
      std::swap(cable.from, cable.to);
    }
    cable.length = function<1>(1.0, Function<1>::Value(60.0));
    if (one_in(4)) {
      cable.elasticity = elasticity();
    } else {
      cable.restitution = between(0.0, 1.0);
      cable.capture_speed = one_in(3) ? between(0.0, 1.0) : 0.0;
    }
    if (!cable.elasticity && one_in(4)) {
      cable.restitution_table = {{0.0, 0.9}, {between(0.1, 1.0), between(0.0, 1.0)}};
    }
    if (one_in(4)) {
      cable.from_time = between(0.1, 1.0);
    }
    if (one_in(4)) {
      cable.cut_at = between(1.1, 9.0);
    }
    return cable;
  }

  std::mt19937 random_;
};

template <int N>
void add_bits(const Function<N>& function, std::vector<std::uint64_t>& result) {
  const auto add = [&](double value) { result.push_back(std::bit_cast<std::uint64_t>(value)); };
  result.push_back(function.pieces.size());
  for (const auto& piece : function.pieces) {
    add(piece.from);
    result.push_back(piece.coefficients.size());
    for (const auto& coefficient : piece.coefficients) {
      for (int row = 0; row < N; ++row) {
        add(coefficient[row]);
      }
    }
  }
  result.push_back(function.waves.size());
  for (const auto& wave : function.waves) {
    for (int row = 0; row < N; ++row) {
      add(wave.amplitude[row]);
    }
    add(wave.frequency);
    add(wave.phase);
  }
}

/// Every number of a system, bit for bit, and its names.
template <int D>
std::vector<std::uint64_t> bits(const BasicSystem<double, D>& system) {
  std::vector<std::uint64_t> result;
  const auto add = [&result](auto... values) {
    (result.push_back(std::bit_cast<std::uint64_t>(values)), ...);
  };
  const auto add_all = [&](const auto& values) {
    for (const double value : values) {
      add(value);
    }
  };
  const auto add_end = [&](const auto& end) {
    result.push_back(end.body ? *end.body : 99);
    add_all(end.at);
    add_bits<D>(end.motion, result);
  };
  add(system.duration, system.initial.time);
  add_bits<D>(system.gravity, result);
  result.push_back(stable_hash(system.name));
  for (const auto& body : system.bodies) {
    result.push_back(stable_hash(body.name));
    add(body.mass, body.drag, body.spin_drag);
    add_all(moments(body.inertia));
    add_bits<D>(body.force, result);
    add_bits<spins<D>>(body.moment, result);
  }
  for (const auto& state : system.initial.bodies) {
    for (const auto& one : coordinates(state)) {
      add(one.value);
    }
  }
  for (const auto& cable : system.cables) {
    result.push_back(cable.through.size());
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      add_end(cable.end(i));
    }
    add_bits<1>(cable.length, result);
    add(cable.restitution, cable.capture_speed, cable.from_time.value_or(-1.0),
        cable.cut_at.value_or(-1.0));
    for (const RestitutionPoint& point : cable.restitution_table) {
      add(point.speed, point.restitution);
    }
    const Elasticity law = cable.elasticity.value_or(Elasticity());
    result.push_back(law.stiffness.size());
    add_all(law.stiffness);
    add(law.damping, law.damping_ratio);
  }
  return result;
}

/// Writes random systems, each as TOML and as JSON, and reads them.
template <int D>
void round_trip(int systems, std::optional<BasicSystem<double, D>> SystemReading::*kind) {
  Draw<D> draw(1);
  std::map<std::string, int> forms;
  for (int i = 0; i < systems; ++i) {
    auto system = draw.system();
    for (int again = 0; !problems(system).empty(); ++again) {  // a ring where its neighbour is
      ASSERT_LT(again, 10) << problems(system).front();
      system = draw.system();
    }
    const std::string text = write_system(system);
    for (const std::string& written : {text, write_system_json(system)}) {
      const SystemReading reading = read_system_text(written, "system");
      ASSERT_EQ(reading.problems, Strings()) << "system " << i << "\n" << written;
      ASSERT_EQ(bits(*(reading.*kind)), bits(system)) << "system " << i << "\n" << written;
    }
    for (const std::string form :
         {"{ value", "{ times", "spline", "pieces", "waves", "through", "cut_at", "from_time",
          "body = \"body", "stiffness = [", "stiffness", "damping =", "damping_ratio"}) {
      forms[form] += text.find(form) != std::string::npos ? 1 : 0;
    }
  }
  for (const auto& [form, count] : forms) {
    EXPECT_GE(count, systems / 40) << form;
  }
}

TEST(SystemRoundTrip, RandomSystemsKeepEveryBitAsTomlAndAsJson) {
  round_trip(2000, &SystemReading::system);
}

TEST(SystemRoundTrip, ThoseInSpaceDoSo) { round_trip(500, &SystemReading::in_space); }

/// Each of `shipped` has a name of its own, breaks no rule and reads back.
template <int D>
void expect_sound(const std::vector<BasicShippedSystem<D>>& shipped,
                  std::optional<BasicSystem<double, D>> SystemReading::*kind,
                  std::set<std::string>& names) {
  for (const auto& [system, shows] : shipped) {
    EXPECT_TRUE(names.insert(system.name).second) << system.name << " is another one's name too";
    EXPECT_EQ(problems(system), Strings()) << system.name;
    EXPECT_NE(shows.find(". "), std::string_view::npos) << system.name << " has two sentences";
    EXPECT_TRUE(shows.ends_with('.')) << system.name;
    for (const std::string& written : {write_system(system), write_system_json(system)}) {
      const SystemReading reading = read_system_text(written, "system");
      ASSERT_EQ(reading.problems, Strings()) << written;
      EXPECT_EQ(bits(*(reading.*kind)), bits(system)) << system.name;
      EXPECT_FALSE(reading.the_case) << system.name;
    }
  }
}

TEST(ShippedSystems, AreSoundAndKeepEveryBitInAFile) {
  EXPECT_GE(shipped_systems().size(), 14U);
  EXPECT_GE(shipped_spatial_systems().size(), 12U);
  std::set<std::string> names;
  for (const Case& the_case : shipped_cases()) {
    names.insert(the_case.name);
  }
  expect_sound(shipped_systems(), &SystemReading::system, names);
  expect_sound(shipped_spatial_systems(), &SystemReading::in_space, names);
}

TEST(SystemRoundTrip, OfEveryShippedCaseKeepsItsNumbers) {
  for (const Case& the_case : shipped_cases()) {
    const System system = as_system(the_case);
    const SystemReading reading = read_system_text(write_system(system), "system");
    ASSERT_EQ(reading.problems, Strings()) << the_case.name;
    EXPECT_EQ(bits(*reading.system), bits(system)) << the_case.name;
  }
}

}  // namespace
}  // namespace tautline::bench
