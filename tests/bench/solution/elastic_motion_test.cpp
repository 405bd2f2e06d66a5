// What `tautline solve` says of elastic cables.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/solution/json/solution_json.hpp"
#include "bench/solution/system_text.hpp"
#include "bench/tools/bridge/bridge.hpp"
#include "tautline/case_text.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// A mass of 1 kg that falls at 1 m/s when its cable becomes stretched.
System falling_mass() {
  const SystemReading reading = read_system_text(
      "name = \"drop\"\nduration = 0.2\ngravity = [0.0, -9.81]\n[[bodies]]\nmass = 1.0\n"
      "position = [0.0, -1.0]\nvelocity = [0.0, -1.0]\n[[cables]]\nfrom = { body = \"body\" }\n"
      "to = [0.0, 0.0]\nlength = 1.0\nstiffness = 1e4\ndamping_ratio = 0.1\n",
      "drop.toml");
  EXPECT_EQ(reading.problems, std::vector<std::string>());
  return reading.system.value_or(System());
}

/// Rounding of a length is eps L against a stretch of v / w = L / 100: a relative error of 1e-14.
constexpr double of_rounding = 1e-13;

// the closed forms of one contact under a load, in 20 digits
TEST(ElasticMotion, HasTheContactsOfTheClosedFormsAndTheirErrors) {
  const CheckedMotion motion(falling_mass(), {});
  const std::vector<CheckedContact> contacts = motion.contacts();
  ASSERT_GE(contacts.size(), 2U);
  const auto& [contact, errors] = contacts.front();
  const auto expect = [](double value, double error, double exact) {
    EXPECT_NEAR(value, exact, of_rounding * exact);
    EXPECT_GE(error, 0.0);
    EXPECT_LE(error, of_rounding * exact);
  };
  ASSERT_TRUE(contact.exit);
  EXPECT_EQ(contact.entry, 0.0);
  expect(*contact.exit, *errors.exit, .03190896504687642834);
  expect(contact.exit_speed, errors.exit_speed, .7263610024201973040);
  expect(contact.peak, errors.peak, 96.522859850036329926);
  expect(contact.peak_time, errors.peak_time, .01375446426663969516);
  expect(contact.impulse, errors.impulse, 2.03938794953005506607);
  const CheckedMotion unchecked(falling_mass(), {}, 0);
  ASSERT_EQ(unchecked.contacts().size(), contacts.size());
  EXPECT_LT(unchecked.contacts().front().errors.peak, 0.0);
  EXPECT_EQ(unchecked.contacts().front().contact.peak, contact.peak);
}

TEST(ElasticMotion, HasItsContactsInJsonAndOthersHaveNone) {
  const CheckedMotion motion(falling_mass(), {});
  const auto solution = nlohmann::json::parse(solution_json(motion, {}, {}));
  const auto contacts = motion.contacts();
  ASSERT_EQ(solution.at("contacts").size(), contacts.size());
  const auto& first = solution.at("contacts").front();
  EXPECT_EQ(first.at("cable"), 0);
  EXPECT_EQ(solution.at("events").front().at("kind"), "entry");
  const std::string schema = solution_schema_json();
  for (const char* const word : {"\"entry\"", "\"exit\"", "\"contacts\"", "\"dissipated\""}) {
    EXPECT_NE(schema.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(first.at("peak").at("value"), contacts.front().contact.peak);
  EXPECT_EQ(first.at("impulse").at("error"), contacts.front().errors.impulse);
  EXPECT_EQ(solution.at("energy").at("dissipated"), motion.ledger().dissipated);
  EXPECT_GT(motion.ledger().dissipated, 0.0);
  const CheckedMotion other(shipped_systems().front().system, {}, 0);
  const auto inextensible = nlohmann::json::parse(solution_json(other, {}, {}));
  EXPECT_FALSE(inextensible.contains("contacts"));
  EXPECT_FALSE(inextensible.at("energy").contains("stored"));
}

/// A load that hangs on a cable for ever, and one that two equal cables throw about.
constexpr const char* hanging_and_thrown = R"(
name = "hanging and thrown"
duration = 1.5
gravity = [0.0, -9.81]
bodies = [{ name = "hanging", mass = 1.0, position = [0.0, -1.0] },
          { name = "thrown", mass = 1.0, position = [9.0, -0.5] }]
[[cables]]
from = { body = "hanging" }
to = [0.0, 0.0]
length = 1.0
stiffness = 100.0
damping = 1.0
[[cables]]
from = { body = "thrown" }
to = [9.7, 0.1]
length = 1.1
stiffness = 1000.0
damping_ratio = 0.05
[[cables]]
from = { body = "thrown" }
to = [8.3, 0.1]
length = 1.1
stiffness = 1000.0
damping_ratio = 0.05
)";

TEST(ElasticMotion, KnowsEachNumberUpToTheHorizon) {
  const SystemReading reading = read_system_text(hanging_and_thrown, "hanging.toml");
  ASSERT_TRUE(reading.system);
  const CheckedMotion motion(*reading.system, {});
  const auto contacts = motion.contacts();
  ASSERT_GE(contacts.size(), 3U);
  const double horizon = motion.horizon().value_or(reading.system->duration);
  for (const auto& [contact, errors] : contacts) {
    EXPECT_EQ(errors.entry >= 0.0, contact.entry <= horizon) << contact.entry;
    const double known = contact.exit.value_or(reading.system->duration);
    EXPECT_EQ(errors.peak >= 0.0, known <= horizon) << contact.entry;
  }
  // the cable that hangs on hides no contact of another
  const std::string text = contacts_text(motion, true, {});
  EXPECT_NE(text.find("\n  0.000000      0 "), std::string::npos) << text;
  EXPECT_NE(text.find("      1 "), std::string::npos) << text;
  EXPECT_NE(text.find("      2 "), std::string::npos) << text;
}

// what --csv and --at print of the cable is what it pulls with
TEST(ElasticMotion, SamplesHaveTheTensionOfAStretchedCable) {
  const CheckedMotion motion(falling_mass(), {});
  const std::vector<SampleName> names = motion.names();
  const auto place = std::find_if(names.begin(), names.end(),
                                  [](const SampleName& one) { return one.name == "tension 0"; });
  ASSERT_NE(place, names.end());
  const ElasticContact first = motion.contacts().front().contact;
  const Bounded tension =
      motion.at(first.peak_time)[static_cast<std::size_t>(place - names.begin())];
  EXPECT_NEAR(tension.value, first.peak, of_rounding * first.peak);
}

TEST(ElasticMotion, ListsItsContacts) {
  const CheckedMotion motion(falling_mass(), {});
  const std::string text = contacts_text(motion, true, {});
  EXPECT_NE(text.find("0.031909"), std::string::npos) << text;
  EXPECT_NE(text.find("96.5229"), std::string::npos) << text;
  EXPECT_NE(system_text(motion).find("Elastic cables lose "), std::string::npos);
  const CheckedMotion other(shipped_systems().front().system, {}, 0);
  EXPECT_EQ(contacts_text(other, true, {}), "");
  EXPECT_EQ(system_text(other).find("Elastic"), std::string::npos);
}

/// The number in the sentences on a shipped system, as it is written there, that `value` rounds to.
template <class Shipped>
void expect_said(const Shipped& one, const std::string& number, double value) {
  EXPECT_NE(one.shows.find(number), std::string_view::npos) << one.system.name << ": " << number;
  const std::size_t point = number.find('.');
  const std::size_t places = point == std::string::npos ? 0 : number.size() - point - 1;
  EXPECT_NEAR(value, std::stod(number), 0.51 * std::pow(10.0, -static_cast<double>(places)))
      << one.system.name;
}

/// The contact of `motion` that pulls hardest.
template <class Motion>
ElasticContact hardest(const Motion& motion) {
  const auto all = motion.contacts();
  return std::max_element(
             all.begin(), all.end(),
             [](const auto& a, const auto& b) { return a.contact.peak < b.contact.peak; })
      ->contact;
}

/// "Its first five contacts come in the order of its impacts, up to 48 ms earlier or later."
template <class Contacts>
void expect_first_five_shifted(const ShippedSystem& one, const Contacts& contacts) {
  constexpr std::size_t first = 5;
  const std::vector<Case> cases = shipped_cases();
  const auto inextensible = std::ranges::find(cases, "breakwater/1910121100", &Case::name);
  ASSERT_NE(inextensible, cases.end());
  const Bridge bridge = bridge_of(*inextensible, {1e4, 1e5, first}).bridge.value();
  EXPECT_NE(one.shows.find("first five contacts"), std::string_view::npos);
  ASSERT_EQ(bridge.impacts.size(), first);
  double largest = 0.0;  // [s]
  for (std::size_t index = 0; index < first; ++index) {
    const ElasticContact& contact = contacts.at(index).contact;
    EXPECT_EQ(contact.cable, bridge.impacts[index].cable) << index;
    largest = std::max(largest, std::abs(contact.entry - bridge.impacts[index].time));
  }
  expect_said(one, "48", 1e3 * largest);
}

TEST(ElasticMotion, UnderWavesHasContactsAndNoImpacts) {
  System system = falling_mass();
  system.duration = 2.0;
  system.cables[0].to.motion.waves = {{Vec2(0.0, -0.1), 10.0, 0.0}};
  const CheckedMotion all_elastic(system, {}, 0);
  const std::string text = system_text(all_elastic);
  EXPECT_NE(text.find("The waves come again every 0.628319, and "), std::string::npos) << text;
  EXPECT_EQ(text.find("impacts"), std::string::npos) << text;
  EXPECT_EQ(text.find("Last impact"), std::string::npos) << text;
  system.cables[0].elasticity.reset();
  system.cables[0].restitution = 0.5;
  const std::string other = system_text(CheckedMotion(system, {}, 0));
  for (const char* const words :
       {"Last impact faster", "; in a period there ", "; impacts take "}) {
    EXPECT_NE(other.find(words), std::string::npos) << words << "\n" << other;
  }
}

TEST(ElasticMotion, OfShippedSystemsIsWhatTheySay) {
  std::size_t elastic = 0;
  for (const ShippedSystem& one : shipped_systems()) {
    if (!first_elastic(one.system)) {
      continue;
    }
    ++elastic;
    const CheckedMotion motion(one.system, {}, 0);
    const auto contacts = motion.contacts();
    if (one.system.name == "snap") {
      expect_said(one, "277.952", hardest(motion).peak);
      ASSERT_EQ(contacts.size(), 8U) << "seven end";
      EXPECT_TRUE(contacts[6].contact.exit && !contacts[7].contact.exit);
    } else if (one.system.name == "bungee") {
      expect_said(one, "2924.64", hardest(motion).peak);
      expect_said(one, "3.26727", hardest(motion).peak_time);
      expect_said(one, "21.9", contacts.back().contact.entry);
      EXPECT_FALSE(contacts.back().contact.exit);
    } else if (one.system.name == "elastic-strop") {
      expect_said(one, "2807.26", hardest(motion).peak);
      expect_said(one, "0.322664", motion.solution().accumulations().front().time);
      EXPECT_EQ(hardest(motion).cable, 1U);
    } else {
      EXPECT_EQ(one.system.name, "breakwater-elastic");
      expect_first_five_shifted(one, contacts);
    }
  }
  EXPECT_EQ(elastic, 4U);
  for (const ShippedSpatialSystem& one : shipped_spatial_systems()) {
    if (first_elastic(one.system)) {
      const BasicCheckedMotion<3> motion(one.system, {}, 0);
      expect_said(one, "1668.97", hardest(motion).peak);
      const auto let_go = motion.contacts().front().contact.exit;
      ASSERT_TRUE(let_go);
      expect_said(one, "1.2", *let_go);  // where the hoist stops
    }
  }
}

}  // namespace
}  // namespace tautline::bench
