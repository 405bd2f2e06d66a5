#include "bench/ensemble/spec/quantity.hpp"

#include <array>
#include <cassert>
#include <charconv>

#include "bench/base/listed.hpp"

namespace tautline::bench {
namespace {

struct CaseQuantity {
  std::string_view name;
  std::string_view unit;
  double& (*of)(Case& the_case);
};

constexpr std::array case_quantities = {
    CaseQuantity{"x", "m", [](Case& c) -> double& { return c.initial.position.x(); }},
    CaseQuantity{"y", "m", [](Case& c) -> double& { return c.initial.position.y(); }},
    CaseQuantity{"angle", "rad", [](Case& c) -> double& { return c.initial.angle; }},
    CaseQuantity{"velocity_x", "m/s", [](Case& c) -> double& { return c.initial.velocity.x(); }},
    CaseQuantity{"velocity_y", "m/s", [](Case& c) -> double& { return c.initial.velocity.y(); }},
    CaseQuantity{"spin", "rad/s", [](Case& c) -> double& { return c.initial.spin; }},
    CaseQuantity{"mass", "kg", [](Case& c) -> double& { return c.body.mass; }},
    CaseQuantity{"inertia", "kg m^2", [](Case& c) -> double& { return c.body.inertia; }},
    CaseQuantity{"gravity_x", "m/s^2", [](Case& c) -> double& { return c.gravity.x(); }},
    CaseQuantity{"gravity_y", "m/s^2", [](Case& c) -> double& { return c.gravity.y(); }},
};

struct CableQuantity {
  std::string_view name;
  std::string_view unit;
  double& (*of)(Cable& cable);
};

constexpr std::array cable_quantities = {
    CableQuantity{"restitution", "", [](Cable& c) -> double& { return c.restitution; }},
    CableQuantity{"length", "m", [](Cable& c) -> double& { return c.length; }},
    CableQuantity{"capture_speed", "m/s", [](Cable& c) -> double& { return c.capture_speed; }},
};

/// What "length" and "length_0" both begin with; null for the quantities of a case.
const CableQuantity* cable_quantity(std::string_view name) {
  for (const CableQuantity& one : cable_quantities) {
    if (name == one.name || name.starts_with(std::string(one.name) + "_")) {
      return &one;
    }
  }
  return nullptr;
}

/// The numbers that a name stands for: one, or one of each cable.
std::vector<double*> numbers(Case& the_case, std::string_view name) {
  for (const CaseQuantity& one : case_quantities) {
    if (name == one.name) {
      return {&one.of(the_case)};
    }
  }
  const CableQuantity* of_cable = cable_quantity(name);
  assert(of_cable != nullptr && "the name is one of quantities_of");
  std::vector<double*> result;
  if (name == of_cable->name) {
    result.reserve(the_case.cables.size());
    for (Cable& cable : the_case.cables) {
      result.push_back(&of_cable->of(cable));
    }
  } else {
    std::size_t index = 0;
    std::from_chars(name.data() + of_cable->name.size() + 1, name.data() + name.size(), index);
    result.push_back(&of_cable->of(the_case.cables.at(index)));
  }
  return result;
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
  Case copy = the_case;  // `numbers` is for writing, too
  return *numbers(copy, name).front();
}

void set_quantity(Case& the_case, std::string_view name, double value) {
  for (double* const number : numbers(the_case, name)) {
    *number = value;
  }
}

void scale_quantity(Case& the_case, std::string_view name, double factor) {
  for (double* const number : numbers(the_case, name)) {
    *number *= factor;
  }
}

}  // namespace tautline::bench
