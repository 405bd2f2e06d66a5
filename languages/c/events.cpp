#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "handles.hpp"

namespace tautline::c {
namespace {

/// Checks the rows that a function of columns is asked for, and calls `row` with the place of each
/// in the caller's arrays, and with the entry of the list that `list_of` returns.
template <class ListOf, class Row>
std::int32_t each_row(const tautline_motion* motion, std::size_t first, std::size_t count,
                      const ListOf& list_of, const Row& row) {
  if (motion == nullptr) {
    return TAUTLINE_NULL;
  }
  return guarded([&]() -> std::int32_t {
    const auto& list = list_of();
    if (count > list.size() || first > list.size() - count) {
      return TAUTLINE_BAD_RANGE;
    }
    for (std::size_t place = 0; place < count; ++place) {
      row(place, list[first + place]);
    }
    return TAUTLINE_OK;
  });
}

/// Writes a number of a column that is not null.
template <class Number>
void put(Number* column, std::size_t place, std::type_identity_t<Number> value) {
  if (column != nullptr) {
    column[place] = value;
  }
}

void put_state(double* column, std::size_t place, const State& state) {
  if (column != nullptr) {
    give_state(state, column + place * coordinate_count);
  }
}

/// One number for each cable of the case: those of `cables`, and 0 of the others.
void put_cables(double* column, std::size_t place, std::size_t width, CableSet cables,
                const CableVector& numbers) {
  if (column == nullptr) {
    return;
  }
  double* row = column + place * width;
  std::fill_n(row, width, 0.0);
  Eigen::Index index = 0;
  for (const std::size_t cable : cables) {
    if (index < numbers.size()) {
      row[cable] = numbers[index++];
    }
  }
}

}  // namespace
}  // namespace tautline::c

using namespace tautline::c;  // NOLINT(google-build-using-namespace)

int32_t tautline_events(const tautline_motion* motion, size_t first, size_t count, double* time,
                        int32_t* kind, int32_t* cables, double* before, double* after,
                        double* impulses) {
  const auto list = [&]() -> const auto& { return motion->solution.events(); };
  return each_row(motion, first, count, list, [&](std::size_t place, const tautline::Event& event) {
    put(time, place, event.time);
    put(kind, place, static_cast<std::int32_t>(event.kind));
    put(cables, place, bits(event.cables));
    put_state(before, place, event.before);
    put_state(after, place, event.after);
    put_cables(impulses, place, motion->the_case.cables.size(), event.cables, event.impulses);
  });
}

int32_t tautline_arcs(const tautline_motion* motion, size_t first, size_t count, double* start,
                      double* end, int32_t* taut) {
  const auto list = [&]() -> const auto& { return motion->solution.arcs(); };
  return each_row(motion, first, count, list, [&](std::size_t place, const tautline::Arc& arc) {
    put(start, place, arc.start);
    put(end, place, arc.end);
    put(taut, place, bits(arc.taut));
  });
}

int32_t tautline_accumulations(const tautline_motion* motion, size_t first, size_t count,
                               double* start, double* limit, double* uncertainty, int32_t* cables,
                               double* energy_lost) {
  const auto list = [&]() -> const auto& { return motion->solution.accumulations(); };
  return each_row(motion, first, count, list,
                  [&](std::size_t place, const tautline::Accumulation& one) {
                    put(start, place, one.start);
                    put(limit, place, one.time);
                    put(uncertainty, place, one.uncertainty);
                    put(cables, place, bits(one.cables));
                    put(energy_lost, place, one.energy_lost);
                  });
}

int32_t tautline_horizon(const tautline_motion* motion, double* horizon, double* lock_error,
                         size_t* unsure) {
  if (motion == nullptr) {
    return TAUTLINE_NULL;
  }
  return guarded([&] {
    const tautline::Uncertainty& errors = motion->errors();
    const double lock = lock_error != nullptr ? errors.lock().value_or(none) : none;
    give_number(lock_error, lock);
    give_number(horizon, errors.horizon().value_or(std::numeric_limits<double>::infinity()));
    give_number(unsure, errors.unsure().size());
    return TAUTLINE_OK;
  });
}

int32_t tautline_unsure(const tautline_motion* motion, size_t first, size_t count, double* from,
                        double* until, int32_t* tie_kind, int32_t* tie_cables) {
  const auto list = [&]() -> const auto& { return motion->errors().unsure(); };
  return each_row(motion, first, count, list, [&](std::size_t place, const tautline::Unsure& one) {
    put(from, place, one.from);
    put(until, place, one.until);
    put(tie_kind, place, one.tie ? static_cast<std::int32_t>(one.tie->kind) : -1);
    put(tie_cables, place, one.tie ? bits(one.tie->cables) : 0);
  });
}

int32_t tautline_event_errors(const tautline_motion* motion, size_t first, size_t count,
                              double* time, double* rate, double* before, double* after,
                              double* impulses, int32_t* indeterminate) {
  const auto list = [&]() -> const auto& { return motion->errors().events(); };
  return each_row(motion, first, count, list,
                  [&](std::size_t place, const std::optional<tautline::EventErrors>& errors) {
                    const std::size_t width = motion->the_case.cables.size();
                    put(time, place, errors ? errors->time : none);
                    put(rate, place, errors ? errors->rate : none);
                    put(indeterminate, place, errors ? bits(errors->indeterminate) : 0);
                    if (errors) {
                      put_state(before, place, errors->before);
                      put_state(after, place, errors->after);
                      put_cables(impulses, place, width,
                                 motion->solution.events()[first + place].cables, errors->impulses);
                      return;
                    }
                    for (double* const column : {before, after}) {
                      if (column != nullptr) {
                        give_no_state(column + place * coordinate_count);
                      }
                    }
                    if (impulses != nullptr) {
                      std::fill_n(impulses + place * width, width, none);
                    }
                  });
}
