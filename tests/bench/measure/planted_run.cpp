#include "tests/bench/measure/planted_run.hpp"

#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench::test {

double exact_rate(const Case& the_case, std::size_t cable, const State& at_contact) {
  const double rate = gap_rate(the_case.cables[cable], at_contact);
  return -restitution(the_case.cables[cable], rate) * rate;
}

State bounced(const Case& the_case, const State& before, std::size_t cable, double rate) {
  CableVector change(1);
  change[0] = rate - gap_rate(the_case.cables[cable], before);
  const CableSet only = CableSet::of(cable);
  return with_impulses<double>(the_case, before, only, multipliers(the_case, before, only, change));
}

Trajectory planted_run(const Case& the_case, double end, const Planted& planted,
                       const PlantedFlight& flight) {
  Trajectory run;
  run.step = planted_step;
  State state = the_case.initial;
  double time = 0.0;  // of `state`, the start of the flight
  run.points.push_back({0.0, state});
  std::size_t next = 1;
  const auto sample_until = [&](double until) {
    for (; static_cast<double>(next) * planted_step < until; ++next) {
      const double now = static_cast<double>(next) * planted_step;
      run.points.push_back({now, flight(state, now - time)});
    }
  };
  Touching touching;
  Case flown = the_case;
  flown.gravity = flight.gravity;
  while (time < end) {
    const auto search = first_contact(flown, flight.start(state), touching, end - time);
    if (!search.contact) {
      break;
    }
    const double wait = std::max(0.0, search.contact->dt + planted.delay);
    const std::size_t cable = search.contact->cables.indices().front();
    sample_until(time + wait);
    const State at_contact = flight(state, search.contact->dt);
    const State before = flight(state, wait);
    State after = bounced(the_case, before, cable,
                          planted.rate ? planted.rate(the_case, cable, at_contact, before)
                                       : exact_rate(the_case, cable, at_contact));
    if (planted.spoil) {
      planted.spoil(after, run.impacts.size());
    }
    time += wait;
    run.impacts.push_back({time, cable, 1.0, gap_rate(the_case.cables[cable], before),
                           gap_rate(the_case.cables[cable], after), 0, before, after});
    if (gap_rate(the_case.cables[cable], after) < 1e-8) {  // it sticks: the rest is exact
      Case rest = the_case;
      rest.initial = after;
      rest.duration = end - time;
      const Solution solution = solve(rest);
      for (; static_cast<double>(next) * planted_step < end; ++next) {
        const double now = static_cast<double>(next) * planted_step;
        run.points.push_back({now, solution.at(now - time)});
      }
      return run;
    }
    state = after;
    touching = {};
    if (gap(the_case.cables[cable], state) <= 1e-13) {
      touching.cables.insert(cable);
      // out of the overstretch of a late impact, before the next contact is looked for
      double out = 0.0;
      while (gap(the_case.cables[cable], flight(state, out)) < -1e-13) {
        out += 1e-3 * planted_step;
      }
      if (out > 0.0) {
        sample_until(time + out);
        state = flight(state, out);
        time += out;
        touching = {};
      }
    }
  }
  sample_until(end);
  return run;
}

}  // namespace tautline::bench::test
