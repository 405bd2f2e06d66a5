#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "bench/cases/case_tables.hpp"
#include "bench/cases/elasticity_table.hpp"
#include "tautline/case_text.hpp"

namespace tautline::bench {
namespace {

enum class Syntax { toml, json };

/// A TOML float. `shortest` may look like an integer, which has no -0 and ends at 2^63.
std::string number(double value) {
  const std::string text = shortest(value);
  return text.find_first_not_of("+-0123456789") == std::string::npos ? text + ".0" : text;
}

/// An array, or one number by itself.
template <int N>
std::string value_of(const Eigen::Matrix<double, N, 1>& value) {
  std::string result;
  for (const double one : value) {
    result += (result.empty() ? "" : ", ") + number(one);
  }
  return N == 1 ? result : "[" + result + "]";
}
std::string value_of(double value) { return number(value); }
std::string value_of(const RestitutionPoint& point) {
  return value_of(Vec2(point.speed, point.restitution));
}
std::string value_of(const Corner& corner) {
  return value_of(Vec2(corner.stretch, corner.stiffness));
}
std::string value_of(const std::string& text) { return text; }

/// An array. What is long has a line for each entry, since a line of a file is at most 4096 bytes.
template <class Values>
std::string list(const Values& values) {
  constexpr std::size_t long_line = 1000;  // [bytes]
  std::vector<std::string> entries;
  std::size_t length = 0;
  for (const auto& value : values) {
    entries.push_back(value_of(value));
    length += entries.back().size() + 2;
  }
  const std::string between = length > long_line ? "\n" : "";
  std::string result = "[" + between;
  for (std::size_t index = 0; index < entries.size(); ++index) {
    result += (index == 0 ? "" : between.empty() ? ", " : ",\n") + entries[index];
  }
  return result + between + "]";
}

/// The keys of a table and their values; numbers, arrays and strings are the same in TOML and JSON.
class Members {
 public:
  explicit Members(Syntax syntax) : syntax_(syntax) {}

  void add(std::string_view key, std::string value) {
    members_.emplace_back(key, std::move(value));
  }
  /// If it is not the default of its key, which is 0.
  void add_unless_zero(std::string_view key, double value) {
    if (std::bit_cast<std::uint64_t>(value) != 0) {
      add(key, number(value));
    }
  }

  /// The table between braces.
  [[nodiscard]] std::string inside() const {
    const bool toml = syntax_ == Syntax::toml;
    std::string text;
    for (const auto& [key, value] : members_) {
      text += text.empty() ? "" : ", ";
      text += toml ? key + " = " + value : "\"" + key + "\": " + value;
    }
    return toml ? "{ " + text + " }" : "{" + text + "}";
  }

  /// The keys of a TOML table, a line each.
  [[nodiscard]] std::string lines() const {
    std::string text;
    for (const auto& [key, value] : members_) {
      text += key + " = " + value + "\n";
    }
    return text;
  }

 private:
  Syntax syntax_;
  std::vector<std::pair<std::string, std::string>> members_;
};

/// The tables of a file.
class Tables {
 public:
  Tables(Syntax syntax, Members root) : syntax_(syntax), root_(std::move(root)) {}

  void add(const std::string& key, const Members& table) {
    text_ += "\n[" + key + "]\n" + table.lines();
    root_.add(key, syntax_ == Syntax::json ? table.inside() : "");
  }

  void add(const std::string& key, const std::vector<Members>& tables) {
    std::vector<std::string> entries;
    for (const Members& table : tables) {
      text_ += "\n[[" + key + "]]\n" + table.lines();
      entries.push_back(table.inside());
    }
    if (!tables.empty()) {
      std::string all;
      for (const std::string& entry : entries) {
        all += (all.empty() ? "[" : ", ") + entry;
      }
      root_.add(key, all + "]");
    }
  }

  [[nodiscard]] std::string text(const std::string& head) const {
    return syntax_ == Syntax::toml ? head + text_ : root_.inside();
  }

 private:
  Syntax syntax_;
  Members root_;
  std::string text_;  // of the tables, as TOML
};

template <class TheCable>
void add_restitution(const TheCable& cable, Members& members) {
  members.add("restitution", number(cable.restitution));
  if (cable.capture_speed != 0.0) {  // exactly: the default
    members.add("capture_speed", number(cable.capture_speed));
  }
  if (!cable.restitution_table.empty()) {
    members.add("restitution_table", list(cable.restitution_table));
  }
}

void add_elasticity(const Elasticity& law, Members& members) {
  members.add(law.of_strain ? "EA" : "stiffness",
              law.stiffness.size() == 1 ? number(law.stiffness[0]) : list(law.stiffness));
  if (!law.corners.empty()) {
    members.add("corners", list(law.corners));
  }
  if (law.damping != 0.0) {  // exactly: the default
    members.add("damping", number(law.damping));
  }
  if (law.damping_ratio != 0.0) {
    members.add("damping_ratio", number(law.damping_ratio));
  }
  if (law.cut != ElasticCut::force) {
    members.add("cut", toml_string(cut_words[static_cast<std::size_t>(law.cut)]));
  }
}

void add_state(const State& state, Members& members) {
  members.add("position", value_of(state.position));
  members.add("angle", number(state.angle));
  members.add("velocity", value_of(state.velocity));
  members.add("spin", number(state.spin));
}

void add_state(const SpatialState& state, Members& members) {
  members.add("position", value_of(state.position));
  members.add("orientation", value_of(state.orientation));
  members.add("velocity", value_of(state.velocity));
  members.add("spin", value_of(state.spin));
}

std::string case_text(const Case& the_case, Syntax syntax) {
  Members root(syntax);
  root.add("name", toml_string(the_case.name));
  root.add("duration", number(the_case.duration));
  root.add("gravity", value_of(the_case.gravity));
  if (the_case.angle_limit) {
    root.add("angle_limit", number(*the_case.angle_limit));
  }
  if (the_case.ceiling) {
    root.add("ceiling", number(*the_case.ceiling));
  }
  Tables tables(syntax, root);
  Members body(syntax);
  body.add("mass", number(the_case.body.mass));
  body.add("inertia", number(the_case.body.inertia));
  tables.add("body", body);
  std::vector<Members> cables;
  for (const Cable& cable : the_case.cables) {
    Members& members = cables.emplace_back(syntax);
    members.add("anchor", value_of(cable.anchor));
    members.add("attachment", value_of(cable.attachment));
    members.add("length", number(cable.length));
    add_restitution(cable, members);
  }
  tables.add("cables", cables);
  Members initial(syntax);
  add_state(the_case.initial, initial);
  tables.add("initial", initial);
  return tables.text(root.lines());
}

template <int N>
using Pieces = std::vector<BasicPiece<double, N>>;

bool same_bits(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

template <int N>
bool same_bits(const Pieces<N>& one, const Pieces<N>& other) {
  bool same = one.size() == other.size();
  for (std::size_t i = 0; same && i < one.size(); ++i) {
    same = same_bits(one[i].from, other[i].from) &&
           one[i].coefficients.size() == other[i].coefficients.size();
    for (std::size_t k = 0; same && k < one[i].coefficients.size(); ++k) {
      for (int row = 0; row < N; ++row) {
        same = same && same_bits(one[i].coefficients[k][row], other[i].coefficients[k][row]);
      }
    }
  }
  return same;
}

/// True where the pieces are one number, or N, at all times.
template <int N>
bool one_constant(const Pieces<N>& pieces) {
  return pieces.size() == 1 && pieces[0].coefficients.size() == 1 && same_bits(pieces[0].from, 0.0);
}

/// As times and values if it was made of them, since they are shorter and say more.
template <int N>
void add_pieces(const Pieces<N>& pieces, Syntax syntax, Members& members) {
  std::vector<double> times;
  std::vector<typename Function<N>::Value> values;
  for (const auto& piece : pieces) {
    times.push_back(piece.from);
    values.push_back(piece.coefficients.front());
  }
  const bool linear = same_bits<N>(pieces, Function<N>::linear(times, values).pieces);
  if (linear || same_bits<N>(pieces, Function<N>::spline(times, values).pieces)) {
    members.add("times", list(times));
    members.add("values", list(values));
    if (!linear) {
      members.add("spline", "true");
    }
    return;
  }
  std::vector<std::string> entries;
  for (const auto& piece : pieces) {
    Members one(syntax);
    one.add("from", number(piece.from));
    one.add("polynomial", list(piece.coefficients));
    entries.push_back(one.inside());
  }
  members.add("pieces", list(entries));
}

template <int N>
void add_waves(const Function<N>& function, Syntax syntax, Members& members) {
  std::vector<std::string> entries;
  for (const auto& wave : function.waves) {
    Members one(syntax);
    one.add("amplitude", value_of(wave.amplitude));
    one.add("frequency", number(wave.frequency));
    one.add_unless_zero("phase", wave.phase);
    entries.push_back(one.inside());
  }
  if (!entries.empty()) {
    members.add("waves", list(entries));
  }
}

template <int N>
std::string function_text(const Function<N>& function, Syntax syntax) {
  using Value = typename Function<N>::Value;
  const bool constant = one_constant<N>(function.pieces);
  const Value value = constant ? function.pieces[0].coefficients[0] : Value(Value::Zero());
  if (function.empty() || (constant && function.waves.empty())) {
    return value_of(value);
  }
  Members members(syntax);
  if (constant) {
    members.add("value", value_of(value));
  } else if (!function.pieces.empty()) {
    add_pieces<N>(function.pieces, syntax, members);
  }
  add_waves<N>(function, syntax, members);
  return members.inside();
}

/// Writes what a system has.
template <int D>
class SystemWriter {
 public:
  using System = BasicSystem<double, D>;

  SystemWriter(const System& system, Syntax syntax) : system_(system), syntax_(syntax) {}

  [[nodiscard]] std::string text() const {
    Members root(syntax_);
    root.add("name", toml_string(system_.name));
    root.add("duration", number(system_.duration));
    root.add("gravity", function_text<D>(system_.gravity, syntax_));
    Tables tables(syntax_, root);
    std::vector<Members> bodies;
    for (std::size_t index = 0; index < system_.bodies.size(); ++index) {
      bodies.push_back(body(system_.bodies[index], system_.initial.bodies[index]));
    }
    tables.add("bodies", bodies);
    std::vector<Members> cables;
    for (const auto& one : system_.cables) {
      cables.push_back(cable(one));
    }
    tables.add("cables", cables);
    return tables.text(root.lines());
  }

 private:
  [[nodiscard]] Members body(const typename System::Body& body,
                             const typename System::State::Body& start) const {
    Members members(syntax_);
    if (!body.name.empty()) {
      members.add("name", toml_string(body.name));
    }
    members.add("mass", number(body.mass));
    if constexpr (D == 2) {
      members.add_unless_zero("inertia", body.inertia);
    } else if (has_inertia(body.inertia)) {
      members.add("inertia", value_of(body.inertia));
    }
    members.add_unless_zero("drag", body.drag);
    members.add_unless_zero("spin_drag", body.spin_drag);
    if (!body.force.empty()) {
      members.add("force", function_text<D>(body.force, syntax_));
    }
    if (!body.moment.empty()) {
      members.add("moment", function_text<spins<D>>(body.moment, syntax_));
    }
    add_state(start, members);
    return members;
  }

  [[nodiscard]] Members cable(const typename System::Cable& cable) const {
    Members members(syntax_);
    members.add("from", end(cable.from));
    if (!cable.through.empty()) {
      std::vector<std::string> rings;
      for (const auto& ring : cable.through) {
        rings.push_back(end(ring));
      }
      members.add("through", list(rings));
    }
    members.add("to", end(cable.to));
    members.add("length", function_text<1>(cable.length, syntax_));
    if (cable.elasticity) {
      add_elasticity(*cable.elasticity, members);
    } else {
      add_restitution(cable, members);
    }
    if (cable.from_time) {
      members.add("from_time", number(*cable.from_time));
    }
    if (cable.cut_at) {
      members.add("cut_at", number(*cable.cut_at));
    }
    return members;
  }

  [[nodiscard]] std::string end(const BasicEnd<double, D>& end) const {
    Members members(syntax_);
    if (end.body) {
      members.add("body", toml_string(name_in_file(system_.bodies[*end.body].name, *end.body,
                                                   system_.bodies.size())));
    }
    members.add("at", value_of(end.at));
    if (!end.motion.pieces.empty()) {
      add_pieces<D>(end.motion.pieces, syntax_, members);
    }
    add_waves<D>(end.motion, syntax_, members);
    return members.inside();
  }

  const System& system_;
  Syntax syntax_;
};

}  // namespace
}  // namespace tautline::bench

namespace tautline {

std::string write_case(const Case& the_case) {
  return bench::case_text(the_case, bench::Syntax::toml);
}

std::string write_case_json(const Case& the_case) {
  return bench::case_text(the_case, bench::Syntax::json);
}

std::string write_system(const System& system) {
  return bench::SystemWriter<2>(system, bench::Syntax::toml).text();
}
std::string write_system(const SpatialSystem& system) {
  return bench::SystemWriter<3>(system, bench::Syntax::toml).text();
}

std::string write_system_json(const System& system) {
  return bench::SystemWriter<2>(system, bench::Syntax::json).text();
}
std::string write_system_json(const SpatialSystem& system) {
  return bench::SystemWriter<3>(system, bench::Syntax::json).text();
}

}  // namespace tautline
