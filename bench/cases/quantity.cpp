#include "bench/cases/quantity.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <optional>

#include "bench/base/listed.hpp"

namespace tautline::bench {
namespace {

struct CaseQuantity {
  std::string_view name;
  std::string_view unit;
  const double& (*of)(const Case& the_case);
};

constexpr std::array case_quantities = {
    CaseQuantity{"x", "m", [](const Case& c) -> const double& { return c.initial.position.x(); }},
    CaseQuantity{"y", "m", [](const Case& c) -> const double& { return c.initial.position.y(); }},
    CaseQuantity{"angle", "rad", [](const Case& c) -> const double& { return c.initial.angle; }},
    CaseQuantity{"velocity_x", "m/s",
                 [](const Case& c) -> const double& { return c.initial.velocity.x(); }},
    CaseQuantity{"velocity_y", "m/s",
                 [](const Case& c) -> const double& { return c.initial.velocity.y(); }},
    CaseQuantity{"spin", "rad/s", [](const Case& c) -> const double& { return c.initial.spin; }},
    CaseQuantity{"mass", "kg", [](const Case& c) -> const double& { return c.body.mass; }},
    CaseQuantity{"inertia", "kg m^2",
                 [](const Case& c) -> const double& { return c.body.inertia; }},
    CaseQuantity{"gravity_x", "m/s^2",
                 [](const Case& c) -> const double& { return c.gravity.x(); }},
    CaseQuantity{"gravity_y", "m/s^2",
                 [](const Case& c) -> const double& { return c.gravity.y(); }},
};

struct CableQuantity {
  std::string_view name;
  std::string_view unit;
  const double& (*of)(const Cable& cable);
};

constexpr std::array cable_quantities = {
    CableQuantity{"restitution", "", [](const Cable& c) -> const double& { return c.restitution; }},
    CableQuantity{"length", "m", [](const Cable& c) -> const double& { return c.length; }},
    CableQuantity{"capture_speed", "m/s",
                  [](const Cable& c) -> const double& { return c.capture_speed; }},
};

/// True for "length_0" and "length", but not for "lengths".
bool begins_with_word(std::string_view name, std::string_view word) {
  return name.starts_with(word) && (name.size() == word.size() || name[word.size()] == '_');
}

/// What "length" and "length_0" both begin with; null for the quantities of a case.
const CableQuantity* cable_quantity(std::string_view name) {
  for (const CableQuantity& one : cable_quantities) {
    if (begins_with_word(name, one.name)) {
      return &one;
    }
  }
  return nullptr;
}

/// Calls `visit` with the numbers that a name means: one, or one of each cable.
template <class Visit>
void visit_numbers(const Case& the_case, std::string_view name, const Visit& visit) {
  for (const CaseQuantity& one : case_quantities) {
    if (name == one.name) {
      return visit(one.of(the_case));
    }
  }
  const CableQuantity* of_cable = cable_quantity(name);
  assert(of_cable != nullptr && "the name is one of quantities_of");
  if (name == of_cable->name) {
    for (const Cable& cable : the_case.cables) {
      visit(of_cable->of(cable));
    }
  } else {
    std::size_t index = 0;
    std::from_chars(name.data() + of_cable->name.size() + 1, name.data() + name.size(), index);
    visit(of_cable->of(the_case.cables.at(index)));
  }
}

/// The same for a case that may be written to.
template <class Visit>
void change_numbers(Case& the_case, std::string_view name, const Visit& change) {
  visit_numbers(the_case, name, [&](const double& number) { change(const_cast<double&>(number)); });
}

}  // namespace

std::vector<std::string> quantities_of(const Case& the_case) {
  std::vector<std::string> names = listed<std::string>(case_quantities, &CaseQuantity::name);
  for (const CableQuantity& one : cable_quantities) {
    names.emplace_back(one.name);
    for (std::size_t cable = 0; cable < the_case.cables.size(); ++cable) {
      names.push_back(std::string(one.name) + "_" + std::to_string(cable));
    }
  }
  return names;
}

std::string_view unit_of_quantity(std::string_view name) {
  for (const CaseQuantity& one : case_quantities) {
    if (name == one.name) {
      return one.unit;
    }
  }
  const CableQuantity* of_cable = cable_quantity(name);
  return of_cable != nullptr ? of_cable->unit : "";
}

double quantity(const Case& the_case, std::string_view name) {
  std::optional<double> first;
  visit_numbers(the_case, name, [&](const double& number) { first = first.value_or(number); });
  return first.value();
}

void set_quantity(Case& the_case, std::string_view name, double value) {
  change_numbers(the_case, name, [&](double& number) { number = value; });
}

void scale_quantity(Case& the_case, std::string_view name, double factor) {
  change_numbers(the_case, name, [&](double& number) { number *= factor; });
}

}  // namespace tautline::bench
