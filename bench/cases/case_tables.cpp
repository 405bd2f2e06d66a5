#include "bench/cases/case_tables.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "bench/cases/case_form.hpp"
#include "bench/cases/elasticity_table.hpp"
#include "bench/cases/function_tables.hpp"

namespace tautline::bench {
namespace {

constexpr Key gravity_key = {
    "gravity",
    "the acceleration; its two or three numbers say whether the case is in the plane or in "
    "space"};
constexpr Key anchor_key = {"anchor", "the end in the world"};
constexpr Key attachment_key = {
    "attachment", "the end on the body, from its centre of mass, in the body's frame"};
constexpr Key length_key = {"length", "the length at which the cable is taut"};

constexpr std::string_view of_a_case =
    "is for a case of one [body] where all is constant; leave it out";

/// Calls `ask` for keys that a table has with `key`.
template <class Ask>
void ask_with(StrictTable& table, std::string_view key, const Ask& ask) {
  if (table.describes()) {
    table.with(key, ask);
  } else {
    ask();
  }
}

/// Reads the ends of cables.
template <int D>
class EndReader {
 public:
  using End = BasicEnd<double, D>;
  using Point = typename Function<D>::Value;

  explicit EndReader(const std::vector<BasicBodyOfSystem<double, D>>& bodies) {
    for (std::size_t index = 0; index < bodies.size(); ++index) {
      names_.push_back(name_in_file(bodies[index].name, index, bodies.size()));
    }
  }

  [[nodiscard]] std::size_t bodies() const { return names_.size(); }

  static constexpr const char* example = D == 2 ? "[0.1, 0.0]" : "[0.1, 0.0, 0.0]";

  /// An end in the world: where it is by itself, or a table.
  static End in_world(StrictTable table) {
    End end;
    read_place(table, end);
    finish(table);
    return end;
  }

  /// An end in the world or on a body.
  [[nodiscard]] End anywhere(StrictTable table) const {
    End end;
    if (!table.describes() &&
        table.refuse_other_than_array(
            "must be a table such as { body = \"" + (names_.empty() ? "ball" : names_.front()) +
            "\", at = " + example + " }, or a point " + coordinates + " of the world [m]")) {
      return end;
    }
    if (table.describes() || table.has("body")) {
      read_body(table, end);
    }
    if (end.body) {
      end.at = table.optional_vector<D>({"at", at_meaning}, "[m]").value_or(Point(Point::Zero()));
      for (const char* const key : {"waves", "times", "values", "spline", "pieces"}) {
        table.refuse_value(key, "is for an end in the world; leave it out, or leave body out");
      }
    } else {
      read_place(table, end);
    }
    finish(table);
    return end;
  }

 private:
  static constexpr const char* coordinates = D == 2 ? "[x, y]" : "[x, y, z]";
  static constexpr std::string_view at_meaning =
      "the constant part of its place; on a body from its centre of mass, in the body's frame; "
      "default 0";

  void read_body(StrictTable& table, End& end) const {
    const std::optional<std::string> name =
        table.optional_text({"body", "the name of the body that has the end; default: the world"});
    if (!name) {
      return;
    }
    const auto found = std::find(names_.begin(), names_.end(), *name);
    end.body = static_cast<std::size_t>(found - names_.begin());
    if (found == names_.end()) {
      end.body = 0;
      const std::string near = suggestion(printable(*name), names_);
      std::vector<std::string> printed;
      for (const std::string& one : names_) {
        printed.push_back(printable(one));
      }
      if (!name->empty() && !names_.empty()) {
        table.refuse_value(
            "body", "unknown body" + (near.empty() ? ", must be " + joined(printed, "or") : near));
      }
    }
  }

  static void read_place(StrictTable& table, End& end) {
    const Key key = {"at", at_meaning};
    if (table.is_short()) {
      end.at = table.vector<D>(key, "[m]");
    } else {
      end.at = table.optional_vector<D>(key, "[m]").value_or(Point(Point::Zero()));
      end.motion = read_changes<D>(table, "[m]", std::nullopt);
    }
  }

  static void finish(StrictTable& table) {
    table.refuse_empty("must have at, waves, times with values, pieces, or body");
    table.refuse_unknown_keys();
  }

  std::vector<std::string> names_;
};

/// How a cable names its ends; says what is wrong with both forms at once.
template <int D>
void read_ends(StrictTable& table, BasicCableOfSystem<double, D>& cable, const EndReader<D>& ends) {
  const auto has_one = [&](std::initializer_list<std::string_view> keys) {
    return std::any_of(keys.begin(), keys.end(), [&](auto key) { return table.has(key); });
  };
  if (table.describes()) {
    static_cast<void>(table.count({"anchor", "from"}));
  }
  const bool by_ends =
      !table.describes() && (has_one({"from", "through", "to"}) ||
                             (ends.bodies() > 1 && !has_one({"anchor", "attachment"})));
  if (!by_ends) {
    ask_with(table, "anchor", [&] {
      cable.to = EndReader<D>::in_world(table.table_or(anchor_key, "at", true));
      cable.from.at = table.vector<D>(attachment_key, "[m]");
      cable.from.body = 0;
    });
    if (!table.describes() && ends.bodies() > 1) {
      table.refuse_value("attachment", "is for the only body of a file, which has " +
                                           std::to_string(ends.bodies()) +
                                           "; must be from and to, such as from = { body = \""
                                           "ball\", at = " +
                                           EndReader<D>::example + " }");
    }
  }
  if (by_ends || table.describes()) {
    ask_with(table, "from", [&] {
      cable.from = ends.anywhere(table.table_or({"from", "the first end"}, "at", true));
      for (StrictTable& ring : table.optional_tables(
               {"through", "rings that the cable runs through without friction, in order"}, no_most,
               "must be tables, each a point of a body or of the world", "at", D)) {
        cable.through.push_back(ends.anywhere(std::move(ring)));
      }
      cable.to = ends.anywhere(table.table_or({"to", "the last end"}, "at", true));
    });
    if (by_ends) {
      table.refuse_value("anchor", "is there with from and to, leave it out");
      table.refuse_value("attachment", "is there with from and to, leave it out");
    }
  }
}

/// Reads the impacts of an inextensible cable.
template <class TheCable>
void read_impacts(StrictTable& table, TheCable& cable) {
  cable.restitution = table.number(
      {"restitution", "the share of its closing rate with which the cable opens after an impact"},
      zero_to_one, "");
  cable.capture_speed =
      table
          .optional_number(
              {"capture_speed", "an impact slower than this has no rebound; default 0"},
              zero_or_above, "[m/s]")
          .value_or(0.0);
  const Key by_speed = {"restitution_table",
                        "replaces restitution: pairs of speed and restitution, in rising speed"};
  for (const Vec2& point : table.vectors<2>(by_speed, "[m/s, -]", false, "[speed, restitution]")) {
    cable.restitution_table.push_back({point.x(), point.y()});
  }
}

/// A cable, and whether it starts taut.
template <class TheCase>
std::pair<typename TheCase::Cable, bool> read_cable(StrictTable& table, const TheCase& the_case) {
  constexpr bool is_system = !std::is_same_v<TheCase, Case>;
  typename TheCase::Cable cable;
  bool is_elastic = false;
  if constexpr (is_system) {
    constexpr int dimension = TheCase::Vector::RowsAtCompileTime;
    read_ends(table, cable, EndReader<dimension>(the_case.bodies));
    cable.length =
        read_function<1>(table.table_or(length_key, "value", true, above_zero), "[m]", above_zero);
    cable.elasticity = read_elasticity(table);
    is_elastic = cable.elasticity.has_value();
  } else {
    cable.anchor = table.vector<2>(anchor_key, "[m]");
    cable.attachment = table.vector<2>(attachment_key, "[m]");
    cable.length = table.number(length_key, above_zero, "[m]");
  }
  if (!is_elastic) {
    read_impacts(table, cable);
  }
  bool taut = false;
  if constexpr (is_system) {
    table.note_rule("restitution", &Form::unless, {"stiffness", "EA"});
    if (is_elastic || table.describes()) {
      refuse_beside_elasticity(table);
    }
    cable.from_time = table.optional_number(
        {"from_time", "the cable is hooked up then; default: from the start"}, above_zero, "[s]");
    cable.cut_at = table.optional_number({"cut_at", "the cable is cut then; default: never"},
                                         above_zero, "[s]");
  }
  if (is_system && !table.describes()) {
    table.refuse_value("taut", std::string(of_a_case) + " and give the start its exact digits");
  } else {
    taut = table.flag(
        {"taut", "true moves the body by the little that the typed digits leave to a taut cable"});
  }
  table.refuse_unknown_keys();
  return {std::move(cable), taut};
}

void read_orientation(StrictTable& table, State& state) {
  state.angle = table.optional_number({"angle", "anticlockwise; default 0"}, any_number, "[rad]")
                    .value_or(0.0);
}

/// As a quaternion, which typed digits leave a little off a length of 1, or as an axis times an
/// angle.
void read_orientation(StrictTable& table, SpatialState& state) {
  const auto typed = table.optional_vector<4>(
      {"orientation", "the turn from the body's axes to the world's, a unit quaternion w, x, y, z"},
      "");
  const auto rotation = table.optional_vector<3>(
      {"rotation", "the same as an axis times an angle; instead of orientation"}, "[rad]");
  if (typed) {
    constexpr double by_digits = 1e-6;  // [-]
    const double length = typed->norm();
    if (length > 0.0 && std::abs(length - 1.0) > by_digits) {
      table.refuse_value("orientation", "has the length " + shortest(length) +
                                            ", must be 1: a unit quaternion w, x, y, z");
    }
    const bool exact = std::abs(length - 1.0) <= 2.0 * std::numeric_limits<double>::epsilon();
    state.orientation = exact ? *typed : Quaternion(*typed / (length > 0.0 ? length : 1.0));
  } else if (rotation) {
    state.orientation = quaternion_of<double>(*rotation);
  }
  table.refuse_beside("rotation", {"orientation"}, "must be one of the two");
}

void read_spin(StrictTable& table, State& state) {
  state.spin = table.optional_number({"spin", "anticlockwise; default 0"}, any_number, "[rad/s]")
                   .value_or(0.0);
}

void read_spin(StrictTable& table, SpatialState& state) {
  state.spin = table.optional_vector<3>({"spin", "in the body's axes; default 0"}, "[rad/s]")
                   .value_or(Numbers<3>(Numbers<3>::Zero()));
}

template <class TheState>
TheState read_state(StrictTable& table) {
  TheState state;
  using Vector = decltype(state.position);
  constexpr int dimension = Vector::RowsAtCompileTime;
  state.position = table.vector<dimension>({"position", "of the centre of mass"}, "[m]");
  read_orientation(table, state);
  state.velocity =
      table.optional_vector<dimension>({"velocity", "of the centre of mass; default 0"}, "[m/s]")
          .value_or(Vector(Vector::Zero()));
  read_spin(table, state);
  return state;
}

/// Reads what moves a body, besides cables and gravity.
template <int D>
void read_loads(StrictTable& table, BasicBodyOfSystem<double, D>& body) {
  body.drag = table
                  .optional_number({"drag", "the drag per speed of the centre of mass; default 0"},
                                   zero_or_above, "[N s/m]")
                  .value_or(0.0);
  body.spin_drag =
      table
          .optional_number({"spin_drag", "the moment against the spin, per spin; default 0"},
                           zero_or_above, "[N m s]")
          .value_or(0.0);
  body.force = read_optional_function<D>(
      table, {"force", "on the centre of mass, over time; default 0"}, "[N]");
  body.moment = read_optional_function<spins<D>>(
      table, {"moment", "on the body, anticlockwise or in the world's axes, over time; default 0"},
      "[N m]");
}

constexpr std::string_view inertia_meaning = "about the centre of mass; 0 makes a point mass";

/// In the plane one number.
void read_inertia(StrictTable& table, bool required, double& inertia) {
  const Key key = {"inertia", inertia_meaning};
  const Key optional = {"inertia", "about the centre of mass; 0 makes a point mass; default 0"};
  inertia = required ? table.number(key, zero_or_above, "[kg m^2]")
                     : table.optional_number(optional, zero_or_above, "[kg m^2]").value_or(0.0);
}

/// In space three, the principal moments.
void read_inertia(StrictTable& table, bool /*required*/, Numbers<3>& inertia) {
  inertia = table
                .optional_vector<3>({"inertia",
                                     "about the body's axes through its centre of mass, which are "
                                     "its principal axes; default 0, a point mass"},
                                    "[kg m^2]", zero_or_above)
                .value_or(Numbers<3>(Numbers<3>::Zero()));
}

/// The only body.
template <class TheBody>
TheBody read_only_body(StrictTable& root) {
  StrictTable table = root.table({"body", "the rigid body"});
  TheBody body;
  body.mass = table.number({"mass", "the mass"}, above_zero, "[kg]");
  read_inertia(table, true, body.inertia);
  if constexpr (!std::is_same_v<TheBody, Body>) {
    read_loads(table, body);
  }
  table.refuse_unknown_keys();
  return body;
}

template <class TheState>
TheState read_only_start(StrictTable& root) {
  StrictTable table = root.table({"initial", "the start, at t = 0"});
  TheState state = read_state<TheState>(table);
  table.refuse_unknown_keys();
  return state;
}

/// [[bodies]], each with its start.
template <class TheSystem>
void read_bodies(StrictTable& root, TheSystem& system) {
  const std::string right = "must be 1 to " + std::to_string(max_bodies) +
                            " tables [[bodies]], each with mass and position";
  for (StrictTable& table :
       root.tables({"bodies", "1 to 8 rigid bodies, instead of body"}, max_bodies, right)) {
    auto& body = system.bodies.emplace_back();
    body.name = table.optional_text({"name", "by which cables name the body"}).value_or("");
    body.mass = table.number({"mass", "the mass"}, above_zero, "[kg]");
    read_inertia(table, false, body.inertia);
    read_loads(table, body);
    system.initial.bodies.push_back(read_state<typename TheSystem::State::Body>(table));
    table.refuse_unknown_keys();
    const auto first = std::find_if(system.bodies.begin(), system.bodies.end(),
                                    [&](const auto& other) { return other.name == body.name; });
    if (!body.name.empty() && &*first != &body) {
      table.refuse_value("name", "is the name of bodies[" +
                                     std::to_string(first - system.bodies.begin()) +
                                     "] too, must be another one");
    }
  }
}

const toml::node* node_inside(const toml::node* table, std::string_view key) {
  return table != nullptr && table->is_table() ? table->as_table()->get(key) : nullptr;
}

/// Reads what a case or a system has with its cables: its bodies before them, its start after them.
template <class TheCase, class ReadBodies, class ReadStart>
CaseTables<TheCase> read_tables(StrictTable& root, const std::string& ends, bool needs_cables,
                                const ReadBodies& read_bodies, const ReadStart& read_start) {
  CaseTables<TheCase> result;
  TheCase& the_case = result.the_case;
  the_case.name = root.text({"name", "the name in tables and files"});
  the_case.duration = root.number({"duration", "the run ends at this time"}, above_zero, "[s]");
  read_bodies(the_case);
  const std::string right = "must be 1 to " + std::to_string(max_cables) +
                            " tables [[cables]], each with " + ends + "length and restitution";
  const Key cables = {"cables", "1 to 8 cables without mass, slack or taut"};
  for (StrictTable& table : needs_cables ? root.tables(cables, max_cables, right)
                                         : root.optional_tables(cables, max_cables, right)) {
    auto [cable, starts_taut] = read_cable(table, the_case);
    if (starts_taut) {
      result.taut.insert(the_case.cables.size());
    }
    the_case.cables.push_back(std::move(cable));
  }
  read_start(the_case);
  root.refuse_unknown_keys();
  return result;
}

constexpr Key angle_limit_key = {
    "angle_limit", "the run ends when the body has turned to this angle, to either side"};
constexpr Key ceiling_key = {"ceiling", "the run ends when an attachment rises to this height"};

}  // namespace

std::string name_in_file(const std::string& name, std::size_t index, std::size_t bodies) {
  return !name.empty() ? name : bodies == 1 ? "body" : "body " + std::to_string(index);
}

/// The numbers of the first vector inside of `node`; none: it has none.
static std::optional<std::size_t> numbers_in(const toml::node* node) {
  if (node == nullptr) {
    return std::nullopt;
  }
  if (const toml::array* array = node->as_array(); array != nullptr && !array->empty()) {
    return array->get(0)->is_number() ? std::optional(array->size()) : numbers_in(array->get(0));
  }
  for (const char* const key : {"value", "values", "waves", "amplitude", "pieces", "polynomial"}) {
    if (const auto found = numbers_in(node_inside(node, key))) {
      return found;
    }
  }
  return std::nullopt;
}

bool is_in_space(const toml::table& file) {
  bool has_points = false;
  bool has_points_in_space = false;
  const auto look_at = [&](const toml::node* table, std::string_view key) {
    const auto numbers = numbers_in(node_inside(table, key));
    has_points = has_points || numbers;
    has_points_in_space = has_points_in_space || numbers == 3U;
  };
  look_at(file.get("initial"), "position");
  for (const char* const list : {"bodies", "cables"}) {
    const toml::array* entries = file[list].as_array();
    for (std::size_t index = 0; entries != nullptr && index < entries->size(); ++index) {
      for (const char* const key : {"position", "anchor", "attachment"}) {
        look_at(entries->get(index), key);
      }
    }
  }
  return numbers_in(file.get("gravity")) == 3U && (has_points_in_space || !has_points);
}

std::optional<SystemKey> system_key(const toml::table& file) {
  const auto key_of = [](const toml::node& node, std::string name) {
    return SystemKey{std::move(name), line_of(&node)};
  };
  if (const toml::node* bodies = file.get("bodies")) {
    return key_of(*bodies, "bodies");
  }
  if (const toml::node* gravity = file.get("gravity"); gravity && gravity->is_table()) {
    return key_of(*gravity, "gravity");
  }
  for (const char* const key : {"drag", "spin_drag", "force", "moment"}) {
    if (const toml::node* found = node_inside(file.get("body"), key)) {
      return key_of(*found, std::string("body.") + key);
    }
  }
  const toml::array* cables = file["cables"].as_array();
  for (std::size_t index = 0; cables != nullptr && index < cables->size(); ++index) {
    const toml::node* cable = cables->get(index);
    const std::string name = "cables[" + std::to_string(index) + "].";
    for (const char* const key :
         {"from", "through", "to", "from_time", "cut_at", "stiffness", "EA"}) {
      if (const toml::node* found = node_inside(cable, key)) {
        return key_of(*found, name + key);
      }
    }
    for (const char* const key : {"anchor", "length"}) {
      if (const toml::node* found = node_inside(cable, key); found && found->is_table()) {
        return key_of(*found, name + key);
      }
    }
  }
  return std::nullopt;
}

CaseTables<Case> read_case_tables(StrictTable root) {
  const auto read_bodies = [&](Case& the_case) {
    the_case.gravity = root.vector<2>(gravity_key, "[m/s^2]");
    the_case.angle_limit = root.optional_number(angle_limit_key, above_zero, "[rad]");
    the_case.ceiling = root.optional_number(ceiling_key, any_number, "[m]");
    the_case.body = read_only_body<Body>(root);
  };
  const auto read_start = [&](Case& the_case) { the_case.initial = read_only_start<State>(root); };
  return read_tables<Case>(root, "anchor, attachment, ", true, read_bodies, read_start);
}

template <class TheSystem>
TheSystem read_system_tables(StrictTable root) {
  constexpr int dimension = TheSystem::Vector::RowsAtCompileTime;
  const bool describes = root.describes();
  const bool has_bodies = !describes && root.has("bodies");
  const auto read_only = [&](TheSystem& system) {
    system.bodies = {read_only_body<typename TheSystem::Body>(root)};
    system.initial.bodies = {read_only_start<typename TheSystem::State::Body>(root)};
    root.note_rule("body", &Form::needs, {"cables"});
  };
  const auto read_all_bodies = [&](TheSystem& system) {
    system.gravity = read_function<dimension>(root.table_or(gravity_key, "value", true), "[m/s^2]");
    if (describes) {
      static_cast<void>(root.optional_number(angle_limit_key, above_zero, "[rad]"));
      static_cast<void>(root.optional_number(ceiling_key, any_number, "[m]"));
      static_cast<void>(root.count({"body", "bodies"}));
    } else {
      root.refuse_value(angle_limit_key.name, std::string(of_a_case));
      root.refuse_value(ceiling_key.name, std::string(of_a_case));
    }
    if (!has_bodies) {
      ask_with(root, "body", [&] { read_only(system); });
    }
    if (has_bodies || describes) {
      ask_with(root, "bodies", [&] { read_bodies(root, system); });
    }
    root.refuse_beside("body", {"bodies"}, "must be one of the two");
    root.refuse_beside("initial", {"bodies"}, "which have the start; leave it out");
  };
  return read_tables<TheSystem>(root, "from and to, or anchor and attachment, ",
                                !has_bodies && !describes, read_all_bodies, [](TheSystem&) {})
      .the_case;
}
template System read_system_tables(StrictTable root);
template SpatialSystem read_system_tables(StrictTable root);

/// What both forms of a value take, in the plane and in space.
static Form either_form(Form one, const Form& other) {
  if (one.kind != other.kind) {
    one.also = {other};
    return one;
  }
  one.required = one.required && other.required;
  one.meaning += one.meaning != other.meaning ? " or " + other.meaning : "";
  if (one.kind == Form::Kind::array) {
    one.least = std::min(one.least, other.least);
    one.most =
        one.most && other.most ? std::optional(std::max(*one.most, *other.most)) : std::nullopt;
    one.inside.front() = either_form(one.inside.front(), other.inside.front());
    return one;
  }
  for (const Form& key : other.inside) {
    const auto same = std::find_if(one.inside.begin(), one.inside.end(),
                                   [&](const Form& mine) { return mine.key == key.key; });
    if (same == one.inside.end()) {
      one.inside.push_back(key);
    } else {
      *same = either_form(*same, key);
    }
  }
  return one;
}

Form case_form() {
  Form in_plane;
  Form in_space;
  static_cast<void>(read_system_tables<System>(StrictTable(in_plane)));
  static_cast<void>(read_system_tables<SpatialSystem>(StrictTable(in_space)));
  return either_form(std::move(in_plane), in_space);
}

}  // namespace tautline::bench
