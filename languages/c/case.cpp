#include <charconv>
#include <optional>
#include <vector>

#include "bench/base/text.hpp"
#include "bench/cases/quantity.hpp"
#include "bench/data/coordinates.hpp"
#include "handles.hpp"
#include "tautline/case_text.hpp"
#include "tautline/geometry.hpp"

namespace tautline::c {

std::string lines_of(const std::vector<std::string>& sentences) {
  std::string lines;
  for (const std::string& sentence : sentences) {
    lines += (lines.empty() ? "" : "\n") + sentence;
  }
  return lines;
}

std::string wrong_size(const char* type, std::size_t known, const void* given) {
  std::int32_t size = 0;
  std::memcpy(&size, given, sizeof size);
  return std::string(type) + ": size " + std::to_string(size) +
         " is not that of the struct: must be sizeof(" + type + "), " + std::to_string(known) +
         " in this version, and the members that it does not know 0";
}

namespace {

/// The state of a row of the caller.
State state_from(const double* row) {
  State state;
  for (const auto& coordinate : bench::coordinates(state)) {
    coordinate.value = *row++;
  }
  return state;
}

/// Puts a case together from structs, with one sentence for each thing that is wrong.
class FromNumbers {
 public:
  FromNumbers(const tautline_planar_case* numbers, const tautline_cable* cables,
              std::size_t cable_count, const double* table, std::size_t points)
      : numbers_(numbers), cables_(cables), count_(cable_count), table_(table), points_(points) {}

  void run(tautline_case& to) {
    read_numbers(to.the_case);
    read_cables(to.the_case);
    if (wrong_.empty() && !taut_.empty()) {
      const StartChange change = start_taut(to.the_case, taut_);
      wrong_ = change.problems;
      to.notes = lines_of(change.notes);
    }
    if (wrong_.empty()) {
      wrong_ = problems(to.the_case);
    }
    to.problems = lines_of(wrong_);
  }

 private:
  void read_numbers(Case& to) {
    tautline_planar_case from{};
    if (numbers_ == nullptr) {
      return wrong_.emplace_back("tautline_planar_case: is null"), void();
    }
    const std::size_t size = size_of(numbers_);
    if (size == 0 || !take(numbers_, size, from)) {
      wrong_.push_back(wrong_size("tautline_planar_case", sizeof from, numbers_));
      return;
    }
    constexpr std::int32_t known = TAUTLINE_HAS_ANGLE_LIMIT | TAUTLINE_HAS_CEILING;
    if ((from.has & ~known) != 0) {
      wrong_.push_back("tautline_planar_case: has " + std::to_string(from.has) +
                       " has unknown bits: must be a sum of TAUTLINE_HAS_...");
    }
    to.body = {from.mass, from.inertia};
    to.gravity = {from.gravity[0], from.gravity[1]};
    to.initial = state_from(from.start);
    to.duration = from.duration;
    if ((from.has & TAUTLINE_HAS_ANGLE_LIMIT) != 0) {
      to.angle_limit = from.angle_limit;
    }
    if ((from.has & TAUTLINE_HAS_CEILING) != 0) {
      to.ceiling = from.ceiling;
    }
  }

  void read_cables(Case& to) {
    if (count_ < 1 || count_ > max_cables) {  // no further, whatever the count says
      wrong_.push_back("cables: " + std::to_string(count_) + " given; a case has 1 to " +
                       std::to_string(max_cables));
      return;
    }
    if (cables_ == nullptr || (table_ == nullptr && points_ > 0)) {
      wrong_.emplace_back(cables_ == nullptr ? "tautline_cable: is null" : "table: is null");
      return;
    }
    const std::size_t size = size_of(cables_);
    for (std::size_t index = 0; index < count_; ++index) {
      tautline_cable from{};
      if (size == 0 || !take(at(cables_, index, size), size, from)) {
        wrong_.push_back(wrong_size("tautline_cable", sizeof from, cables_));
        return;
      }
      to.cables.push_back(read_cable(from, index));
    }
    if (taken_ != points_ && wrong_.empty()) {
      wrong_.push_back("table: has " + std::to_string(points_) + " points, the cables take " +
                       std::to_string(taken_));
    }
  }

  Cable read_cable(const tautline_cable& from, std::size_t index) {
    Cable cable{{from.anchor[0], from.anchor[1]},
                {from.attachment[0], from.attachment[1]},
                from.length,
                from.restitution,
                from.capture_speed,
                {}};
    const std::string name = "cable " + std::to_string(index) + ": ";
    if (from.reserved != 0) {
      wrong_.push_back(name + "reserved " + std::to_string(from.reserved) + " must be 0");
    }
    const auto points = static_cast<std::size_t>(std::max(from.table_points, 0));
    if (from.table_points < 0 || points > points_ - taken_) {
      wrong_.push_back(name + "table_points " + std::to_string(from.table_points) +
                       " must be 0 or above, and no more than the table has left: " +
                       std::to_string(points_ - taken_));
      return cable;
    }
    for (std::size_t point = taken_; point < taken_ + points; ++point) {
      cable.restitution_table.push_back({table_[2 * point], table_[2 * point + 1]});
    }
    taken_ += points;
    if (from.taut != 0) {
      taut_.insert(index);
    }
    return cable;
  }

  const tautline_planar_case* numbers_;
  const tautline_cable* cables_;
  std::size_t count_;  // of cables
  const double* table_;
  std::size_t points_;
  std::size_t taken_ = 0;  // of the points
  CableSet taut_;
  std::vector<std::string> wrong_;
};

void read_text(const char* text, std::size_t length, const char* source_name, tautline_case& to) {
  const std::string source = source_name != nullptr ? source_name : "case";
  if (text == nullptr && length > 0) {
    to.problems = "case: text is null";
  } else if (length > longest_case_file) {
    to.problems = source + ": is " + std::to_string(length) + " bytes long, must be at most " +
                  std::to_string(longest_case_file);
  } else {
    CaseReading reading = read_case_text({length > 0 ? text : "", length}, source);
    to.problems = lines_of(reading.problems);
    to.notes = lines_of(reading.notes);
    if (reading.the_case) {
      to.the_case = std::move(*reading.the_case);
    }
  }
}

/// A case that `fill` fills; null if memory is missing.
template <class Fill>
tautline_case* new_case(const Fill& fill) {
  std::unique_ptr<tautline_case> made;
  const std::int32_t status = guarded([&] {
    made = std::make_unique<tautline_case>();
    fill(*made);
    return TAUTLINE_OK;
  });
  return status == TAUTLINE_OK ? made.release() : nullptr;
}

bool is_sound(const tautline_case* the_case) {
  return the_case != nullptr && the_case->problems.empty();
}

}  // namespace

void give_state(const State& state, double* row) {
  for (const auto& coordinate : bench::coordinates(state)) {
    *row++ = coordinate.value;
  }
}

void give_no_state(double* row) { std::fill_n(row, coordinate_count, none); }

std::int32_t Variation::read(const Case& base, const char* const* names, std::size_t count,
                             std::size_t* wrong) {
  if (names == nullptr && count > 0) {
    return TAUTLINE_NULL;
  }
  const std::vector<std::string> known = bench::quantities_of(base);
  for (std::size_t index = 0; index < count; ++index) {
    if (names[index] == nullptr) {
      give_number(wrong, index);
      return TAUTLINE_NULL;
    }
    const std::string_view name = names[index];
    // the columns of a state are as short as those of tables
    names_.emplace_back(name == "vx" ? "velocity_x" : name == "vy" ? "velocity_y" : name);
    if (std::find(known.begin(), known.end(), names_.back()) == known.end()) {
      give_number(wrong, index);
      return TAUTLINE_UNKNOWN_NAME;
    }
  }
  return TAUTLINE_OK;
}

void Variation::apply(Case& the_case, const double* values) const {
  for (const std::string& name : names_) {
    bench::set_quantity(the_case, name, *values++);
  }
}

}  // namespace tautline::c

using namespace tautline::c;  // NOLINT(google-build-using-namespace)

tautline_case* tautline_case_from_numbers(const tautline_planar_case* numbers,
                                          const tautline_cable* cables, size_t cable_count,
                                          const double* table, size_t table_points,
                                          const char* name) {
  return new_case([&](tautline_case& to) {
    to.the_case.name = name != nullptr ? name : "case";
    FromNumbers(numbers, cables, cable_count, table, table_points).run(to);
    if (to.the_case.name.empty() || !tautline::bench::is_utf8(to.the_case.name)) {
      to.problems = std::string("name: must be text in UTF-8 that is not empty") +
                    (to.problems.empty() ? "" : "\n") + to.problems;
    }
  });
}

tautline_case* tautline_case_from_text(const char* text, size_t length, const char* source_name) {
  return new_case([&](tautline_case& to) { read_text(text, length, source_name, to); });
}

int32_t tautline_case_vary(const tautline_case* base, const char* const* names,
                           const double* values, size_t count, tautline_case** to, size_t* wrong) {
  if (to == nullptr) {
    return TAUTLINE_NULL;
  }
  *to = nullptr;
  if (base == nullptr || (values == nullptr && count > 0)) {
    return TAUTLINE_NULL;
  }
  if (!is_sound(base)) {
    return TAUTLINE_BAD_CASE;
  }
  return guarded([&]() -> std::int32_t {
    Variation variation;
    if (const std::int32_t status = variation.read(base->the_case, names, count, wrong);
        status != TAUTLINE_OK) {
      return status;
    }
    auto made = std::make_unique<tautline_case>();
    made->the_case = base->the_case;
    variation.apply(made->the_case, values);
    made->problems = lines_of(problems(made->the_case));
    *to = made.release();
    return TAUTLINE_OK;
  });
}

void tautline_case_free(tautline_case* the_case) { delete the_case; }

size_t tautline_problems(const tautline_case* the_case, char* text, size_t room) {
  return give_text(the_case != nullptr ? the_case->problems : "case: is null", text, room);
}

size_t tautline_notes(const tautline_case* the_case, char* text, size_t room) {
  return give_text(the_case != nullptr ? the_case->notes : "", text, room);
}

size_t tautline_case_name(const tautline_case* the_case, char* text, size_t room) {
  return give_text(the_case != nullptr ? the_case->the_case.name : "", text, room);
}

int32_t tautline_case_text(const tautline_case* the_case, int32_t format, char* text, size_t room,
                           size_t* length) {
  if (the_case == nullptr) {
    return TAUTLINE_NULL;
  }
  if (!is_sound(the_case)) {
    return TAUTLINE_BAD_CASE;
  }
  if (format != TAUTLINE_TOML && format != TAUTLINE_JSON) {
    return TAUTLINE_BAD_OPTION;
  }
  return guarded([&] {
    const std::string whole = format == TAUTLINE_TOML ? write_case(the_case->the_case)
                                                      : write_case_json(the_case->the_case);
    give_number(length, give_text(whole, text, room));
    return TAUTLINE_OK;
  });
}

size_t tautline_coordinates(const tautline_case* the_case) {
  return is_sound(the_case) ? coordinate_count : 0;
}

const char* tautline_coordinate_name(const tautline_case* the_case, size_t index) {
  const tautline::State any;
  return index < tautline_coordinates(the_case) ? tautline::bench::coordinates(any)[index].name
                                                : nullptr;
}

const char* tautline_coordinate_unit(const tautline_case* the_case, size_t index) {
  const tautline::State any;
  return index < tautline_coordinates(the_case) ? tautline::bench::coordinates(any)[index].unit
                                                : nullptr;
}

size_t tautline_cables(const tautline_case* the_case) {
  return is_sound(the_case) ? the_case->the_case.cables.size() : 0;
}

int32_t tautline_gaps(const tautline_case* the_case, const double* states, size_t count,
                      double* gaps, double* rates) {
  if (the_case == nullptr || (states == nullptr && count > 0)) {
    return TAUTLINE_NULL;
  }
  if (!is_sound(the_case)) {
    return TAUTLINE_BAD_CASE;
  }
  const auto& cables = the_case->the_case.cables;
  if (!fits_memory(count, std::max(coordinate_count, cables.size()))) {
    return TAUTLINE_BAD_RANGE;
  }
  for (std::size_t row = 0; row < count; ++row) {
    const tautline::State state = state_from(states + row * coordinate_count);
    for (std::size_t cable = 0; cable < cables.size(); ++cable) {
      const std::size_t place = row * cables.size() + cable;
      if (gaps != nullptr) {
        gaps[place] = tautline::gap(cables[cable], state);
      }
      if (rates != nullptr) {
        rates[place] = tautline::gap_rate(cables[cable], state);
      }
    }
  }
  return TAUTLINE_OK;
}
