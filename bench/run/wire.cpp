// A message is a JSON head, then numbers as they are in memory: those of a trajectory are too many
// for JSON, and some of them may be no numbers.

#include "bench/run/wire.hpp"
#include "bench/data/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <type_traits>

namespace tautline {
namespace {

/// An integer from `least` to `most`. Throws for any other number: nlohmann's own conversion does
/// not look whether a number fits.
int whole_number(const nlohmann::json& value, int least, int most) {
  const std::int64_t whole = value.is_number_integer() ? value.get<std::int64_t>() : most + 1L;
  if (whole < least || whole > most) {
    throw std::out_of_range("a number of a message is out of its range");
  }
  return static_cast<int>(whole);
}

/// No engine's parameter grows with a higher power of the step, or a lower one than its negative.
constexpr int most_power = 1000;

}  // namespace

/// One of the words of an enumeration that ends with `last`.
template <class Enumeration>
static void read_word(const nlohmann::json& value, Enumeration& word, Enumeration last) {
  word = static_cast<Enumeration>(whole_number(value, 0, static_cast<int>(last)));
}

static void from_json(const nlohmann::json& value, Origin& origin) {
  read_word(value, origin, Origin::ours);
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Setting, name, value, reason, origin)

static void to_json(nlohmann::json& row, const Parameter& one) {
  row = nlohmann::json::array({one.name, one.low, one.high, one.logarithmic, one.step_power});
}

static void from_json(const nlohmann::json& row, Parameter& one) {
  one = {row.at(0), row.at(1), row.at(2), row.at(3),
         whole_number(row.at(4), -most_power, most_power)};
}

static void from_json(const nlohmann::json& value, Maker& maker) {
  read_word(value, maker, Maker::tautline);
}

static void from_json(const nlohmann::json& value, Cables& cables) {
  read_word(value, cables, Cables::any);
}

static void to_json(nlohmann::json& row, const std::optional<std::vector<Setting>>& some) {
  row = some ? nlohmann::json(*some) : nlohmann::json();
}

static void from_json(const nlohmann::json& row, std::optional<std::vector<Setting>>& some) {
  if (!row.is_null()) {
    some = row.get<std::vector<Setting>>();
  }
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Model, name, sentence, settings, maker, parameters, code,
                                   in_space, cables)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EngineInfo, name, version, precision, models, dimensions)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunSettings, step, law, parameters)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StopOfRun, time, reason)

}  // namespace tautline

namespace tautline::bench {

using nlohmann::json;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// JSON writes what is not finite as null.
double finite_or_none(const json& value) {
  return value.is_number() ? value.get<double>() : no_number;
}

}  // namespace

// What follows is found by its argument's type: it must not be in the unnamed namespace.

static void to_json(json& row, const SettledClaim& one) {
  row = json::array({one.claim, one.found, one.limit, one.holds, one.sentence, one.applies});
}

static void from_json(const json& row, SettledClaim& one) {
  one = {row.at(0), finite_or_none(row.at(1)), finite_or_none(row.at(2)), row.at(3), row.at(4), "",
         row.at(5)};
}

/// Without its numbers.
template <class TheCase>
static void to_json(json& stop, const BasicRunAnswer<TheCase>& run) {
  stop = run.trajectory.stop ? json(*run.trajectory.stop) : json(nullptr);
}

template <class TheCase>
static void from_json(const json& stop, BasicRunAnswer<TheCase>& run) {
  if (!stop.is_null()) {
    run.trajectory.stop = stop.get<StopOfRun>();
  }
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Strike, speed, arm, inertia, spin_part)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WorkerRequest, task, plugin, memory, model, case_text, settings,
                                   strikes, restitution, costs, more)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Failure, sentence, of_process)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckAnswer, claims, unfinished, digest)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DigestAnswer, digest)

/// A strike that gave no number is null, and so is a law that there is not.
static void to_json(json& row, const StrikesAnswer& strikes) {
  row = {{"restitutions", strikes.restitutions}, {"law", nullptr}};
  if (strikes.law) {
    row["law"] = {strikes.law->stiffness, strikes.law->damping, strikes.law->load};
  }
}

static void from_json(const json& row, StrikesAnswer& strikes) {
  for (const json& one : row.at("restitutions")) {
    strikes.restitutions.push_back(finite_or_none(one));
  }
  if (const json& law = row.at("law"); !law.is_null()) {
    strikes.law = {law.at(0), law.at(1), law.at(2)};
  }
}

namespace {

/// Takes numbers into a message; what is not finite is no number there.
struct NumberWriter {
  std::vector<double>& numbers;

  void operator()(const auto& value) {
    const auto number = static_cast<double>(value);
    numbers.push_back(std::isfinite(number) ? number : no_number);
  }
  void operator()(const std::optional<double>& value) { (*this)(value.value_or(no_number)); }
  template <class Item>
  void fit(const std::vector<Item>& items, std::size_t /*most*/ = 0) {
    (*this)(items.size());
  }
};

/// Gives them back in the same order.
struct NumberReader {
  std::span<const double> numbers;

  template <class Value>
  void operator()(Value& value) {
    if (numbers.empty()) {
      throw std::out_of_range("a message ends early");
    }
    if constexpr (std::is_integral_v<Value>) {
      // a double that does not fit would become any integer
      const double most = std::is_same_v<Value, bool> ? 1.0 : 0x1p53;
      const double number = numbers.front();
      if (!(number >= 0.0 && number <= most && std::trunc(number) == number)) {
        throw std::out_of_range("a number of a message is out of its range");
      }
    }
    value = static_cast<Value>(numbers.front());
    numbers = numbers.subspan(1);
  }
  void operator()(std::optional<double>& value) {
    double number = 0.0;
    (*this)(number);
    value = std::isnan(number) ? std::nullopt : std::optional(number);
  }
  template <class Item>
  void fit(std::vector<Item>& items, std::size_t most = std::numeric_limits<std::size_t>::max()) {
    std::size_t count = 0;
    (*this)(count);
    if (count > most) {
      throw std::out_of_range("a message has too many of something");
    }
    items.resize(std::min(count, numbers.size()));
  }
};

// Each of these lists the numbers of a type once, for the writer and for the reader.

void pass_state(auto& numbers, auto& state) {
  if constexpr (requires { state.bodies; }) {
    numbers(state.time);
    numbers.fit(state.bodies, max_bodies);
    for (auto& body : state.bodies) {
      pass_state(numbers, body);
    }
  } else {
    for (const auto& one : coordinates(state)) {
      numbers(one.value);
    }
  }
}

void pass_impact(auto& numbers, auto& impact) {
  numbers(impact.time);
  numbers(impact.cable);
  numbers(impact.impulse);
  numbers(impact.rate_before);
  numbers(impact.rate_after);
  numbers(impact.steps);
  pass_state(numbers, impact.before);
  pass_state(numbers, impact.after);
  numbers(impact.ended);
  for (int k = 0; k < 3; ++k) {
    numbers(impact.stray[k]);
  }
  numbers(impact.shared);
  numbers(impact.snap);
  numbers(impact.rate_first);
}

void pass_contact(auto& numbers, auto& contact) {
  numbers(contact.cable);
  numbers(contact.entry);
  numbers(contact.exit);
  numbers(contact.entry_speed);
  numbers(contact.exit_speed);
  numbers(contact.peak);
  numbers(contact.peak_time);
  numbers(contact.greatest_stretch);
  numbers(contact.impulse);
}

void pass_run(auto& numbers, auto& run) {
  numbers(run.cost.step);
  numbers(run.cost.memory);
  numbers(run.cost.reference);
  numbers(run.cost.smallest);
  numbers(run.cost.lower);
  numbers(run.cost.upper);
  numbers(run.cost.dt);
  numbers(run.cost.repetitions);
  auto& trajectory = run.trajectory;
  numbers(trajectory.step);
  numbers(trajectory.stride);
  numbers(trajectory.slow_impacts);
  numbers(trajectory.overstretch);
  numbers(trajectory.largest_energy);
  numbers(trajectory.diverged);
  numbers.fit(trajectory.points);
  for (auto& point : trajectory.points) {
    numbers(point.time);
    pass_state(numbers, point.state);
  }
  numbers.fit(trajectory.tensions);
  for (auto& tension : trajectory.tensions) {
    numbers(tension);
  }
  numbers.fit(trajectory.impacts);
  for (auto& impact : trajectory.impacts) {
    pass_impact(numbers, impact);
  }
  numbers.fit(trajectory.contacts);
  for (auto& contact : trajectory.contacts) {
    pass_contact(numbers, contact);
  }
  numbers.fit(trajectory.soft_rows, max_cables);
  for (auto& row : trajectory.soft_rows) {
    numbers(row.stiffness);
    numbers(row.damping);
    numbers(row.load);
  }
}

/// Throws where the parts of a run do not fit each other, so that no reader looks past their ends.
template <class TheCase>
void require_whole(const BasicRunAnswer<TheCase>& run) {
  const BasicTrajectory<TheCase>& trajectory = run.trajectory;
  const std::size_t points = trajectory.points.size();
  const bool fits = points > 0 && trajectory.tensions.size() % points == 0;
  const auto is_of_a_cable = [](const auto& one) { return one.cable < max_cables; };
  if (!fits || !std::ranges::all_of(trajectory.impacts, is_of_a_cable) ||
      !std::ranges::all_of(trajectory.contacts, is_of_a_cable)) {
    throw std::out_of_range("the parts of a run do not fit each other");
  }
}

/// Calls `use` with the run that `answer`, a WorkerAnswer, is, if it is one.
void with_run(auto& answer, const auto& use) {
  if (auto* const run = std::get_if<RunAnswer>(&answer)) {
    use(*run);
  } else if (auto* const of_system = std::get_if<SystemRunAnswer>(&answer)) {
    use(*of_system);
  }
}

struct Message {
  json head;
  std::vector<double> numbers;
};

std::string bytes_of(const Message& message) {
  const std::string head = message.head.dump();
  const std::uint64_t sizes[2] = {head.size(), message.numbers.size()};
  std::string bytes(sizeof sizes, '\0');
  std::memcpy(bytes.data(), sizes, sizeof sizes);
  bytes += head;
  const std::size_t start = bytes.size();
  const std::size_t size = message.numbers.size() * sizeof(double);
  bytes.resize(start + size);
  if (size > 0) {
    std::memcpy(bytes.data() + start, message.numbers.data(), size);
  }
  return bytes;
}

/// None if `bytes` is not a whole message.
std::optional<Message> message_from(std::string_view bytes) {
  std::uint64_t sizes[2] = {};
  if (bytes.size() < sizeof sizes) {
    return std::nullopt;
  }
  std::memcpy(sizes, bytes.data(), sizeof sizes);
  bytes.remove_prefix(sizeof sizes);
  if (sizes[0] > bytes.size() || sizes[1] != (bytes.size() - sizes[0]) / sizeof(double)) {
    return std::nullopt;
  }
  Message message;
  message.head = json::parse(bytes.substr(0, sizes[0]), nullptr, false);
  if (message.head.is_discarded()) {
    return std::nullopt;
  }
  message.numbers.resize(sizes[1]);
  if (sizes[1] > 0) {
    std::memcpy(message.numbers.data(), bytes.data() + sizes[0], sizes[1] * sizeof(double));
  }
  return message;
}

/// The answer of kind `kind`, which is its place in WorkerAnswer.
template <std::size_t index = 0>
WorkerAnswer answer_of(std::size_t kind, const json& content) {
  if constexpr (index < std::variant_size_v<WorkerAnswer>) {
    return kind == index ? content.get<std::variant_alternative_t<index, WorkerAnswer>>()
                         : answer_of<index + 1>(kind, content);
  }
  throw std::out_of_range("an answer of no known kind");
}

}  // namespace

std::string to_bytes(const WorkerRequest& request) { return bytes_of({request, {}}); }

WorkerRequest request_from(std::string_view bytes) {
  const std::optional<Message> message = message_from(bytes);
  if (!message) {
    throw std::runtime_error("no whole request came");
  }
  WorkerRequest request;
  message->head.get_to(request);
  return request;
}

std::string to_bytes(const WorkerAnswer& answer) {
  Message message;
  message.head =
      json::array({answer.index(), std::visit([](const auto& one) { return json(one); }, answer)});
  with_run(answer, [&](const auto& run) {
    NumberWriter writer{message.numbers};
    pass_run(writer, run);
  });
  return bytes_of(message);
}

std::optional<WorkerAnswer> answer_from(std::string_view bytes) {
  const std::optional<Message> message = message_from(bytes);
  if (!message) {
    return std::nullopt;
  }
  try {
    constexpr int kinds = std::variant_size_v<WorkerAnswer>;
    const int kind = whole_number(message->head.at(0), 0, kinds - 1);
    WorkerAnswer answer = answer_of(static_cast<std::size_t>(kind), message->head.at(1));
    with_run(answer, [&](auto& run) {
      NumberReader reader{message->numbers};
      pass_run(reader, run);
      require_whole(run);
    });
    return answer;
  } catch (const std::exception&) {  // an engine has written into it
    return Failure{"gave a result that makes no sense"};
  }
}

}  // namespace tautline::bench
