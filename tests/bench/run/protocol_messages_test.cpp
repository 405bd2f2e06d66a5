// What the program writes to a child and reads from it: as the schema says, and each mistake a
// sentence.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "bench/run/protocol/child.hpp"
#include "bench/run/protocol/messages.hpp"
#include "tests/bench/run/protocol_support.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using bench::ChildModel;
using nlohmann::json;

bool is_message(const std::string& text) {
  return broken_rules(json::parse(text), json::parse(content_of(TAUTLINE_PROTOCOL_SCHEMA))).empty();
}

/// A body on two cables, one of which captures slow impacts.
Case speedy_case() {
  Case result;
  result.name = "speedy";
  result.cables.resize(2);
  result.cables[0].anchor = Vec2(0.0, 1.0);
  result.cables[0].restitution = 0.7;
  result.cables[1].capture_speed = 0.1;
  result.cables[1].restitution_table = {{0.05, 0.9}, {0.2, 0.8}, {1.0, 0.4}};
  return result;
}

/// Every kind of request, in an order in which a child can answer them.
std::vector<std::string> requests(const Case& the_case) {
  const State state{Vec2(1.0, -0.0), 1e300, Vec2(5e-324, std::numeric_limits<double>::infinity()),
                    std::numeric_limits<double>::quiet_NaN()};
  CableSet cables;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    cables.insert(index);
  }
  const CableVector rates =
      CableVector::Constant(static_cast<Eigen::Index>(the_case.cables.size()), 0.1);
  return {bench::info_request(1),
          bench::start_request(2, the_case, {{"row", "", {}}, false, true}, 1e-3),
          bench::step_request(3, 1e-3, 100),
          bench::fly_request(4, 0.25),
          bench::solve_request(5, cables, rates),
          bench::place_request(6, state)};
}

TEST(Messages, OfTheProgramAreAsTheSchemaSays) {
  for (const std::string& request : requests(speedy_case())) {
    EXPECT_TRUE(is_message(request)) << request;
    EXPECT_EQ(request.find('\n'), std::string::npos) << request;
  }
  EXPECT_FALSE(is_message(R"({"jsonrpc":"2.0","id":1,"method":"stop"})"));
  EXPECT_FALSE(
      is_message(R"({"jsonrpc":"2.0","id":1,"method":"step","params":{"dt":0,"count":1}})"));
}

TEST(Messages, OfAChildAreAsTheSchemaSays) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  bench::Child child(
      {{"python3", (children_folder / "twin.py").string()}, "/", std::size_t{1} << 30U});
  Case one_cable = speedy_case();
  one_cable.cables.resize(1);
  for (const std::string& request : requests(one_cable)) {
    const std::string answer(child.ask(request, "something"));
    EXPECT_TRUE(is_message(answer)) << request << "\n" << answer;
    EXPECT_TRUE(json::parse(answer).contains("result")) << answer;
  }
  EXPECT_FALSE(is_message(R"({"jsonrpc":"2.0","id":1,"result":{"state":[0,0,0,0,0,null]}})"));
  EXPECT_FALSE(is_message(R"({"jsonrpc":"2.0","id":1,"result":{"steps":[[0,0,0,0,0,0]]}})"));
}

TEST(Messages, SayNumbersThatJsonHasNotByWords) {
  EXPECT_EQ(json::parse(requests(speedy_case()).back()).at("params").at("state").dump(),
            R"([1.0,-0.0,1e+300,5e-324,"Infinity","NaN"])");
}

TEST(Messages, GiveATableOfRestitutionToWhoFollowsTheSpeed) {
  const auto restitution = [](const ChildModel& model, std::size_t cable) {
    const json request = json::parse(bench::start_request(1, speedy_case(), model, 1e-3));
    return request.at("params").at("case").at("cables").at(cable).at("restitution").dump();
  };
  const ChildModel follows{{"row", "", {}}, false, true};
  EXPECT_EQ(restitution(follows, 0), "0.7");
  // 0 below 0.1 m/s, and there what the table has between 0.05 and 0.2 m/s
  EXPECT_EQ(json::parse(restitution(follows, 1)),
            json({{0.0, 0.0},
                  {0.1, 0.0},
                  {0.1, tautline::restitution(speedy_case().cables[1], 0.1)},
                  {0.2, 0.8},
                  {1.0, 0.4}}));
  // the event driver takes it itself
  EXPECT_EQ(restitution({{"event", "", {}}, true, false}, 1), "1.0");
}

/// What the program says of an answer; "" if there is nothing to say.
template <class Read>
std::string said_of(const std::string& answer, const Read& read) {
  try {
    read(answer);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

std::string said_of_result(const std::string& result, const std::string& method) {
  return said_of(R"({"jsonrpc":"2.0","id":4,"result":)" + result + "}", [&](std::string_view line) {
    if (method == "info") {
      static_cast<void>(bench::info_answer(line, 4));
    } else if (method == "start") {
      static_cast<void>(bench::start_answer(line, 4));
    } else if (method == "step") {
      static_cast<void>(bench::step_answer(line, 4, 1, 2));
    } else if (method == "solve") {
      static_cast<void>(bench::solve_answer(line, 4, 2));
    } else {
      static_cast<void>(bench::state_answer(line, 4, method));
    }
  });
}

std::string said_of_line(const std::string& line) {
  return said_of(
      line, [](std::string_view text) { static_cast<void>(bench::state_answer(text, 4, "fly")); });
}

/// The answer to `info` of an engine with this model.
std::string info_with(const std::string& model) {
  return R"({"protocol":1,"name":"mine","version":"1","precision":"float64","models":[)" + model +
         "]}";
}

TEST(Answers, ThatAreSoundSayNothing) {
  EXPECT_EQ(said_of_result(R"({"state":[0,-0.0,"-0",1e308,"NaN","-Infinity"]})", "fly"), "");
  EXPECT_EQ(said_of_result(R"({"steps":[[0,0,0,0,0,0,1],[1,2,3,4,5,6,0]]})", "step"), "");
  EXPECT_EQ(said_of_result(R"({"steps":[],"stopped":{"time":0,"reason":"tired"}})", "step"), "");
  EXPECT_EQ(said_of_result(info_with(R"({"name":"row","sentence":"x","maker":"engine"})"), "info"),
            "");
}

TEST(Answers, WithAMistakeSayWhereItIsAndWhatWouldBeRight) {
  const std::vector<std::array<std::string, 3>> mistakes = {
      {"fly", R"({"state":[0,0,0,0,0]})",
       "the engine's answer to fly: state is [0,0,0,0,0], must be 6 numbers: x, y, angle, vx, vy, "
       "spin"},
      {"fly", R"({"state":[0,0,0,true,0,0]})",
       "the engine's answer to fly: state[3] is true, must be a number, or \"NaN\", \"Infinity\", "
       "\"-Infinity\" or \"-0\""},
      {"fly", R"({"state":[0,0,0,"nan",0,0]})",
       "the engine's answer to fly: state[3] is \"nan\", must be a number, or \"NaN\", "
       "\"Infinity\", \"-Infinity\" or \"-0\""},
      {"fly", "[]", "the engine's answer to fly: the result is [], must be an object"},
      {"place", "{}", "the engine's answer to place lacks state"},
      {"solve", R"({"impulses":[1],"state":[0,0,0,0,0,0]})",
       "the engine's answer to solve: impulses is [1], must be 2 numbers: one for each of the "
       "cables"},
      {"solve", R"({"impulses":[1,-1e-3],"state":[0,0,0,0,0,0]})",
       "the engine's answer to solve: impulses[1] is -0.001, must be an impulse of at least 0"},
      {"step", R"({"steps":[[0,0,0,0,0,0,0],[0,0,0,0,0,0,-1]]})",
       "the engine's answer to step: steps[1][6] is -1, must be an impulse of at least 0"},
      {"step", R"({"steps":[[0,0,0,0,0,0,"NaN"],[0,0,0,0,0,0,0]]})",
       "the engine's answer to step: steps[0][6] is \"NaN\", must be an impulse of at least 0"},
      {"step", R"({"steps":{"a":{"a":{}}}})",
       "the engine's answer to step: steps is an object, must be an array"},
      {"start", R"({"state":[0,0,0,0,0,0],"rounding":{"gap":0,"rate":1e-6}})",
       "the engine's answer to start: rounding.gap is 0, must be above 0 and below 1"},
      {"start", R"({"state":[0,0,0,0,0,0],"soft":[{"stiffness":1}]})",
       "the engine's answer to start lacks soft[0].damping"},
      {"start", R"({"state":[0,0,0,0,0,0],"soft":[{"stiffness":1,"damping":0,"ratio":1}]})",
       "the engine's answer to start has an unknown key soft[0].ratio"},
      {"step", R"({"steps":[[0,0,0,0,0,0,0]]})",
       "the engine answered 1 steps where 2 were asked, and not why it stopped"},
      {"step", R"({"steps":[[0,0,0,0,0,0,0],[0,0,0,0,0,0,0],[0,0,0,0,0,0,0]]})",
       "the engine answered 3 steps where 2 were asked"},
      {"info",
       R"({"protocol":1,"name":"My engine","version":"1","precision":"float64","models":[]})",
       "the engine's answer to info: name is \"My engine\", must be a name of small letters, "
       "digits "
       "and hyphens"},
      {"info", R"({"protocol":1,"name":"mine","version":1,"precision":"float64","models":[]})",
       "the engine's answer to info: version is 1, must be a string"},
      {"info", R"({"protocol":1,"name":"mine","version":"1","precision":"double","models":[]})",
       "the engine's answer to info: precision is \"double\", must be float64 or float32"},
      {"info", info_with(""),
       "the engine's answer to info: models is [], must be at least one model"},
      {"info", info_with(R"({"name":"row","sentence":"x","maker":"me"})"),
       "the engine's answer to info: models[0].maker is \"me\", must be engine, by_hand or "
       "tautline"},
      {"info", info_with(R"({"name":"row","sentence":"x","maker":"engine","drives":"events"})"),
       "the engine's answer to info has an unknown key models[0].drives; did you mean drive?"},
      {"info",
       info_with(R"({"name":"row","sentence":"x","maker":"engine","settings":[{"name":"a"}]})"),
       "the engine's answer to info lacks models[0].settings[0].value"},
      {"info",
       info_with(R"({"name":"row","sentence":"x","maker":"engine","settings":)"
                 R"([{"name":"a","value":"1","reason":"x","origin":"mine"}]})"),
       "the engine's answer to info: models[0].settings[0].origin is \"mine\", must be "
       "engine_default, engine_demo or ours"},
      {"info",
       info_with(R"({"name":"row","sentence":"x","maker":"engine","parameters":)"
                 R"([{"name":"a","low":2,"high":1}]})"),
       "the engine's answer to info: models[0].parameters[0].low is 2, must be below high, and "
       "above 0 on a scale of logarithms"},
      {"info",
       info_with(R"({"name":"row","sentence":"x","maker":"engine","parameters":)"
                 R"([{"name":"a","low":1,"high":2,"step_power":0.5}]})"),
       "the engine's answer to info: models[0].parameters[0].step_power is 0.5, must be a whole "
       "number from -4 to 4"}};
  for (const auto& [method, result, sentence] : mistakes) {
    EXPECT_EQ(said_of_result(result, method), sentence);
  }
}

TEST(Answers, ThatAreNoMessageAreQuoted) {
  EXPECT_EQ(said_of_line("Hello\x1b[31m"),
            "the engine wrote on its standard output what is no message: Hello\\x1b[31m; what a "
            "library prints must go to standard error");
  EXPECT_EQ(said_of_line(""),
            "the engine wrote on its standard output what is no message: an empty line; what a "
            "library prints must go to standard error");
  EXPECT_EQ(said_of_line(R"({"jsonrpc":"2.0","id":5,"result":{}})"),
            "the engine's answer to fly: id is 5, must be 4, as in the request");
  EXPECT_EQ(said_of_line(R"({"id":4,"result":{}})"), "the engine's answer to fly lacks jsonrpc");
  EXPECT_EQ(said_of_line(R"({"jsonrpc":"2.0","id":4})"), "the engine's answer to fly lacks result");
}

TEST(Answers, ThatAreErrorsSayWhatTheEngineSays) {
  const auto said_of_error = [](const std::string& error) {
    return said_of_line(R"({"jsonrpc":"2.0","id":4,"error":)" + error + "}");
  };
  EXPECT_EQ(said_of_error(R"({"code":-32602,"message":"unsupported: two cables at most"})"),
            "unsupported: two cables at most");
  EXPECT_EQ(said_of_error(R"({"code":-32000,"message":"TypeError: x is not a function"})"),
            "TypeError: x is not a function");
  EXPECT_EQ(said_of_error(R"({"code":-32601,"message":"Method not found"})"),
            "the engine does not know the method fly");
  EXPECT_EQ(said_of_line(
                R"({"jsonrpc":"2.0","id":null,"error":{"code":-32700,"message":"Parse error"}})"),
            "the engine could not read what it was asked: Parse error");
}

}  // namespace
}  // namespace tautline::test
