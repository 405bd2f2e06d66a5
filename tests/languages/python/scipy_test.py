#!/usr/bin/env python3
"""The exact motion compared with SciPy's `solve_ivp`, which knows nothing of it: ordinary differential equations that
are integrated from event to event, and an impact written down from its textbook."""
import unittest

import support

import numpy as np
import tautline as tl

try:
    from scipy.integrate import solve_ivp
except ImportError:
    solve_ivp = None

TOLERANCE = 1e-12  # of each step of SciPy, relative; it allows no less than 100 roundings
IMPACTS = 40       # of the standard case: after more of them the motion has magnified SciPy's errors too far
# [s], and ten times that for a state; measured: 2.3e-13 s and 1.2e-12. SciPy's own roundings are magnified by the motion
ALLOWED = 1e-11


class Body:
    """A case as equations for SciPy."""

    def __init__(self, case):
        self.case = case
        self.inverse = np.array([1 / case.mass, 1 / case.mass, 1 / case.inertia])

    def lever(self, state, cable):
        cos, sin = np.cos(state[2]), np.sin(state[2])
        return np.array([cos * cable.attachment[0] - sin * cable.attachment[1],
                         sin * cable.attachment[0] + cos * cable.attachment[1]])

    def gap(self, state, cable):
        return cable.length - np.linalg.norm(state[:2] + self.lever(state, cable) - cable.anchor)

    def row(self, state, cable):
        """The derivative of the gap by the position and the angle."""
        lever = self.lever(state, cable)
        pull = np.asarray(cable.anchor) - state[:2] - lever
        pull /= np.linalg.norm(pull)
        return np.array([*pull, lever[0] * pull[1] - lever[1] * pull[0]])

    def rebound(self, state, cable):
        """Newton's law of impact for one cable."""
        row = self.row(state, cable)
        impulse = -(1 + cable.restitution) * (row @ state[3:]) / (row @ (self.inverse * row))
        return np.array([*state[:3], *(state[3:] + self.inverse * row * impulse)])

    def impacts(self, most):
        """Time, state before and state after each impact."""
        found, time = [], 0.0
        start = self.case.initial
        state = np.array([*start.position, start.angle, *start.velocity, start.spin])
        hit = None
        while len(found) < most:
            def of_cable(index, after=hit, begin=time):
                # the cable that has just rebounded begins at a gap of zero: its opening is no event
                def gap(at, y):
                    return self.gap(y, self.case.cables[index]) + (1e-9 if index == after and at <= begin else 0.0)
                gap.terminal, gap.direction = True, -1.0
                return gap
            flight = solve_ivp(lambda _, y: [*y[3:], *self.case.gravity, 0.0], (time, self.case.duration), state, rtol=TOLERANCE,
                               atol=1e-14, method="DOP853", max_step=0.05,
                               events=[of_cable(index) for index in range(len(self.case.cables))])
            hits = [index for index, times in enumerate(flight.t_events) if len(times)]
            if not hits:
                break
            hit, time = hits[0], flight.t[-1]
            before = flight.y[:, -1]
            state = self.rebound(before, self.case.cables[hit])
            found.append((time, before, state))
        return found


@unittest.skipUnless(solve_ivp, "no SciPy here (Debian's python3-scipy): the comparison with solve_ivp is left out")
class AgainstSciPy(unittest.TestCase):
    def compare(self, case, most, allowed):
        theirs, ours = Body(case).impacts(most), tl.solve(case).impacts
        count = min(len(theirs), most)
        self.assertGreaterEqual(len(ours), count)
        self.assertGreater(count, 2)
        for place, (time, before, after) in enumerate(theirs[:count]):
            self.assertLess(abs(time - ours.time[place]), allowed, f"impact {place}")
            self.assertLess(np.abs(before - ours.before[place]).max(), 10 * allowed, f"impact {place}")
            self.assertLess(np.abs(after - ours.after[place]).max(), 10 * allowed, f"impact {place}")

    def test_the_standard_case_hits_when_and_how_scipy_says(self):
        self.compare(tl.Case.shipped("breakwater/1910121100"), IMPACTS, ALLOWED)

    def test_other_cases_do(self):
        for name in ("spinning-rod", "elastic-box", "plate-four-cables", "crane-load"):
            with self.subTest(name):
                self.compare(tl.Case.shipped(name), 6, ALLOWED)

    def test_a_wrong_law_would_be_seen(self):
        case = tl.Case.shipped("breakwater/1910121100")
        theirs, ours = Body(case.but(restitution=0.9 + 1e-8)).impacts(5), tl.solve(case).impacts
        self.assertGreater(abs(theirs[4][0] - ours.time[4]), 10 * ALLOWED)


if __name__ == "__main__":
    support.main()
