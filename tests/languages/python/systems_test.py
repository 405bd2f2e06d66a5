#!/usr/bin/env python3
"""The exact motion of systems compared with an integration that shares nothing with it: the equations of Newton and Euler with
multipliers for taut cables, collocated at Chebyshev points, every gap and tension looked at on a fine grid, and impacts by
Newton's law on each set of cables that could pull."""
import csv
import io
import itertools
import pathlib
import tempfile
import tomllib
import unittest

import support

import numpy as np
from numpy.polynomial import chebyshev

POINTS = 20          # of a step, at which it satisfies the equations
SAMPLES = 96         # of a step, between which a gap or a tension may change its sign once
TOUCH = 1e-12        # [-] of a length: gaps below that are zero
NOISE = 1e-14        # [m] or [N]: what is above that below zero is rounding
STILL = 1e-11        # [m/s]: rates below that are zero
SLOW = 3e-5          # [m/s]: a cable that rebounds slower and is drawn back stays taut; what that errs goes with its square
LEFT_OUT = 2e-15     # [-] of a step's largest terms: its last ones
ALLOWED = 1e-9       # [s], and of states; measured with three kernels of linear algebra: at most 5e-11 s and 5e-10
WEAK = 1e-4          # [-] of the largest impulse: a weaker impact is found as late as rounding is over its speed


class Function:
    """Numbers over time, as a case file gives them."""

    def __init__(self, given, size):
        self.pieces, self.waves, self.size = [], [], size
        if given is None:
            given = np.zeros(size)
        if not isinstance(given, dict):
            given = {"value": given}
        for wave in given.get("waves", []):
            self.waves.append((self.vector(wave["amplitude"]), wave["frequency"], wave.get("phase", 0.0)))
        for piece in given.get("pieces", []):
            self.pieces.append((piece["from"], [self.vector(one) for one in piece["polynomial"]]))
        if "times" in given:
            self.through(np.array(given["times"], float), np.array([self.vector(one) for one in given["values"]]),
                         given.get("spline", False))
        self.constant = self.vector(given.get("at", given.get("value", np.zeros(size))))

    def vector(self, numbers):
        return np.atleast_1d(np.array(numbers, float)).reshape(self.size)

    def through(self, times, values, spline):
        """Straight from value to value, or by cubes whose rate is zero at both ends."""
        slopes = np.diff(values, axis=0) / np.diff(times)[:, None]
        matrix, right = np.eye(len(times)), np.zeros_like(values)
        for i in range(1, len(times) - 1):
            before, after = times[i] - times[i - 1], times[i + 1] - times[i]
            matrix[i, i - 1:i + 2] = after, 2 * (before + after), before
            right[i] = 3 * (after * slopes[i - 1] + before * slopes[i])
        rates = np.linalg.solve(matrix, right)
        for i, slope in enumerate(slopes):
            long = times[i + 1] - times[i]
            cubes = [(3 * slope - 2 * rates[i] - rates[i + 1]) / long, (rates[i] + rates[i + 1] - 2 * slope) / long**2]
            self.pieces.append((times[i], [values[i], *([rates[i], *cubes] if spline else [slope])]))
        self.pieces.append((times[-1], [values[-1]]))

    def knots(self):
        return [begin for begin, _ in self.pieces]

    def __call__(self, times, since):
        """Value, rate and acceleration at `times`, all of them in the piece that holds from `since` on."""
        result = np.zeros((3, len(times), self.size))
        result[0] += self.constant
        if self.pieces:
            begin, terms = max(([one for one in self.pieces if one[0] <= since] or [(None, self.pieces[0][1][:1])]),
                               key=lambda one: one[0] or 0.0)
            after = (times - (begin or 0.0))[:, None]
            for k, term in enumerate(terms):
                result[0] += term * after**k
                if k > 0:
                    result[1] += k * term * after**(k - 1)
                if k > 1:
                    result[2] += k * (k - 1) * term * after**(k - 2)
        for amplitude, frequency, phase in self.waves:
            angle = (frequency * times + phase)[:, None]
            result[0] += amplitude * np.cos(angle)
            result[1] -= amplitude * frequency * np.sin(angle)
            result[2] -= amplitude * frequency**2 * np.cos(angle)
        return result


class System:
    """A case file as equations. A state is the places of all bodies, x y angle each, then their rates."""

    def __init__(self, text):
        given = tomllib.loads(text)
        self.duration, bodies = given["duration"], given["bodies"]
        names = [body["name"] for body in bodies]
        self.gravity = Function(given["gravity"], 2)
        self.force = [Function(body.get("force"), 2) for body in bodies]
        self.moment = [Function(body.get("moment"), 1) for body in bodies]
        inertia = [body.get("inertia", 0.0) for body in bodies]
        self.lightness = np.array([number for body, moment in zip(bodies, inertia)
                                   for number in (1 / body["mass"], 1 / body["mass"], 1 / moment if moment else 0.0)])
        self.drag = np.array([number for body in bodies
                              for number in (body.get("drag", 0.0), body.get("drag", 0.0), body.get("spin_drag", 0.0))])
        self.start = np.array([number for body in bodies for number in (*body["position"], body.get("angle", 0.0))] +
                              [number for body in bodies for number in (*body["velocity"], body.get("spin", 0.0))])
        self.freedoms = 3 * len(bodies)

        def end(of):
            return (names.index(of["body"]), np.array(of.get("at", (0.0, 0.0)), float)) if "body" in of else (None, Function(of, 2))
        cables = given.get("cables", [])
        self.ends = [[end(one) for one in (cable["from"], *cable.get("through", []), cable["to"])] for cable in cables]
        self.length = [Function(cable["length"], 1) for cable in cables]
        self.restitution = np.array([cable.get("restitution", 1.0) for cable in cables])
        self.acts = [(cable.get("from_time", -1.0), cable.get("cut_at", np.inf)) for cable in cables]
        functions = [self.gravity, *self.force, *self.moment, *self.length,
                     *(place for ends in self.ends for body, place in ends if body is None)]
        self.knots = sorted({knot for one in functions for knot in one.knots()} | {time for pair in self.acts for time in pair})

    def point(self, end, times, states, since):
        """Place, velocity, acceleration that needs none of the body's own, and derivative by the places of the bodies."""
        body, at = end
        by = np.zeros((len(times), 2, self.freedoms))
        if body is None:
            return (*at(times, since), by)
        first, rates = 3 * body, self.freedoms + 3 * body
        cos, sin = np.cos(states[:, first + 2]), np.sin(states[:, first + 2])
        arm = np.stack([cos * at[0] - sin * at[1], sin * at[0] + cos * at[1]], 1)
        across = np.stack([-arm[:, 1], arm[:, 0]], 1)
        spin = states[:, rates + 2, None]
        by[:, 0, first] = by[:, 1, first + 1] = 1.0
        by[:, :, first + 2] = across
        return states[:, first:first + 2] + arm, states[:, rates:rates + 2] + spin * across, -spin**2 * arm, by

    def cable(self, index, times, states, since):
        """Gap, its rate, its derivative by the places, and its acceleration where no body accelerates."""
        gap, rate, bend = (one[:, 0].copy() for one in self.length[index](times, since))
        row = np.zeros((len(times), self.freedoms))
        points = [self.point(end, times, states, since) for end in self.ends[index]]
        for first, second in itertools.pairwise(points):
            along, velocity, acceleration, by = (one - other for one, other in zip(first, second))
            distance = np.sqrt((along**2).sum(1))
            unit = along / distance[:, None]
            closing = (unit * velocity).sum(1)
            gap -= distance
            rate -= closing
            bend -= (unit * acceleration).sum(1) + ((velocity**2).sum(1) - closing**2) / distance
            row -= np.einsum("ti,tif->tf", unit, by)
        return gap, rate, row, bend

    def forces(self, times, states, since):
        """On every freedom, but for those of cables."""
        result = -self.drag * states[:, self.freedoms:]
        gravity = self.gravity(times, since)[0]
        for body, (force, moment) in enumerate(zip(self.force, self.moment)):
            result[:, 3 * body:3 * body + 2] += gravity / self.lightness[3 * body] + force(times, since)[0]
            result[:, 3 * body + 2] += moment(times, since)[0, :, 0]
        return result

    def accelerations(self, times, states, taut, since):
        """Of all bodies, and the tensions of the cables `taut`."""
        free = self.lightness * self.forces(times, states, since)
        if not taut:
            return free, np.zeros((len(times), 0))
        _, _, rows, bends = (np.stack(one, 1) for one in zip(*(self.cable(index, times, states, since) for index in taut)))
        pulls = rows * self.lightness
        tensions = np.linalg.solve(pulls @ rows.transpose(0, 2, 1), -(bends + np.einsum("tcf,tf->tc", rows, free))[:, :, None])
        return free + np.einsum("tcf,tc->tf", pulls, tensions[:, :, 0]), tensions[:, :, 0]

    def now(self, time, state, indices):
        """Gaps, rates, rows and accelerations of some cables at one instant."""
        found = [self.cable(index, np.array([time]), state[None], time) for index in indices]
        return tuple(np.array([one[k][0] for one in found]) for k in range(4))


def pulls_of(lightness, rows, rates):
    """The pulls >= 0 after which no rate is below zero and those that pull make it zero: the best of all sets that could."""
    answers = (rows * lightness) @ rows.T
    best, found = np.inf, np.zeros(len(rates))
    for count in range(len(rates) + 1):
        for some in map(list, itertools.combinations(range(len(rates)), count)):
            pulls = np.zeros(len(rates))
            pulls[some] = np.linalg.lstsq(answers[np.ix_(some, some)], -rates[some], rcond=None)[0] if some else 0.0
            wrong = max(0.0, *-(answers @ pulls + rates), *-pulls)
            if wrong < best - 1e-15 * np.abs(rates).max():
                best, found = wrong, pulls
    return found


NODES = (1 - np.cos(np.pi * np.arange(POINTS) / (POINTS - 1))) / 2
TO_TERMS = np.linalg.inv(chebyshev.chebvander(2 * NODES - 1, POINTS - 1))
TO_INTEGRAL = chebyshev.chebvander(2 * NODES - 1, POINTS) @ np.array(
    [chebyshev.chebint(unit, lbnd=-1) for unit in np.eye(POINTS)]).T @ TO_TERMS / 2


class Step:
    """The motion with some cables taut from a state on, for a while in which its terms fall below rounding."""

    def __init__(self, system, time, state, taut, longest):
        self.system, self.time, self.taut, self.long = system, time, taut, longest
        half = system.freedoms
        while True:
            times = time + self.long * NODES
            states = np.repeat(state[None], POINTS, 0)
            last = np.inf
            for _ in range(60):
                rates = np.concatenate([states[:, half:], system.accelerations(times, states, taut, time)[0]], 1)
                better = state + self.long * TO_INTEGRAL @ rates
                change = np.abs(better - states).max()
                states = better
                if not change < 1e3 or (change < 1e-12 and change >= last / 2):  # it diverges, or is as near as it gets
                    break
                last = change
            self.terms = TO_TERMS @ states
            size = np.abs(self.terms).max() + 1e-3
            if np.isfinite(size) and change < 1e-13 * size and np.abs(self.terms[-3:]).max() < LEFT_OUT * size:
                return
            self.long /= 2

    def states(self, part):
        """After these parts of the step."""
        return chebyshev.chebval(2 * np.atleast_1d(part) - 1, self.terms).T

    def watched(self, index, part):
        """The tension of a taut cable, the gap of another one."""
        times, states = self.time + self.long * np.atleast_1d(part), self.states(part)
        if index in self.taut:
            return self.system.accelerations(times, states, self.taut, self.time)[1][:, self.taut.index(index)]
        return self.system.cable(index, times, states, self.time)[0]

    def first_zero(self, index):
        """The part of the step after which it falls through zero; none if it does not."""
        parts = np.linspace(0, 1, SAMPLES + 1)
        values = self.watched(index, parts)
        if values[0] <= TOUCH:
            values -= values[0]  # it begins there
        below = np.flatnonzero(values[1:] < -NOISE) + 1
        dips = np.flatnonzero((values[1:-1] < values[:-2]) & (values[1:-1] <= values[2:])) + 1
        for dip in dips[values[dips] > 0]:  # it may be below zero between two samples
            if len(below) and dip > below[0]:
                break
            middle = np.linspace(parts[dip - 1], parts[dip + 1], SAMPLES + 1)
            fine = self.watched(index, middle)
            if fine.min() < 0:
                return self.zero(index, parts[dip - 1], middle[np.flatnonzero(fine < 0)[0]])
        if not len(below):
            return self.zero(index, parts[-2], 1.0) if values[-1] < 0 < values[-2] else None
        above = np.flatnonzero(values[:below[0]] > 0)
        return self.zero(index, parts[above[-1]] if len(above) else 0.0, parts[below[0]])

    def zero(self, index, low, high):
        start = self.watched(index, 0.0)[0]
        shift = start if abs(start) <= TOUCH else 0.0
        above, below = self.watched(index, low)[0] - shift, self.watched(index, high)[0] - shift
        for turn in range(100):
            middle = low + (high - low) * (above / (above - below) if turn % 3 < 2 and above > 0 > below else 0.5)
            middle = min(max(middle, low), high)
            value = self.watched(index, middle)[0] - shift
            if value > 0:
                low, above = middle, value
            else:
                high, below = middle, value
            if value == 0 or high - low <= 2e-16 * max(1.0, abs(self.time) / self.long):
                break
        return high


class Motion:
    """The impacts of a system, and its states at some times."""

    def __init__(self, system, times, most):
        self.system, self.impacts, self.settled, self.states = system, [], [], {}
        self.end = system.duration
        time, state, taut, let_go = 0.0, system.start, [], set()
        times = sorted(times)
        while time < system.duration and len(self.impacts) < most:
            held = taut
            state, taut = self.instant(time, state, held, let_go)
            self.settled += [(time, index) for index in taut if index not in held]
            stop = min([knot for knot in system.knots if knot > time] + [system.duration])
            step = Step(system, time, state, taut, min(stop - time, self.patience(time, state, taut)))
            zeros = []
            for index in self.acting(time):
                part = step.first_zero(index)
                if part is not None:
                    zeros.append((part, index))
            part = min(zeros)[0] if zeros else 1.0
            while times and times[0] < time + part * step.long:
                self.states[times[0]] = step.states((times[0] - time) / step.long)[0]
                times.pop(0)
            let_go = {index for zero, index in zeros if zero == part and index in taut}
            time, state = stop if part == 1.0 and step.long == stop - time else time + part * step.long, step.states(part)[0]
        self.end = time if len(self.impacts) < most else self.impacts[-1][0]

    def acting(self, time):
        return [index for index, (begin, end) in enumerate(self.system.acts) if begin <= time < end]

    def patience(self, time, state, taut):
        """The longest step: that to the return of a cable that has just rebounded."""
        acting = [index for index in self.acting(time) if index not in taut]
        longest = 0.15
        if acting:
            gaps, rates, rows, bends = self.system.now(time, state, acting)
            towards = bends + rows @ self.system.accelerations(np.array([time]), state[None], taut, time)[0][0]
            for gap, rate, bend in zip(gaps, rates, towards):
                if gap < 1e-6 and rate > 0 > bend:
                    longest = min(longest, 3 * rate / -bend)
        return longest

    def instant(self, time, state, held, let_go):
        """The state after what happens at `time`, where `held` are taut, and the cables that are taut from then on."""
        half, lightness = self.system.freedoms, self.system.lightness
        acting = self.acting(time)
        if not acting:
            return state, []
        gaps = self.system.now(time, state, acting)[0]
        lengths = [self.system.length[index](np.array([time]), time)[0, 0, 0] for index in acting]
        near = [index for index, gap, length in zip(acting, gaps, lengths)
                if (gap < TOUCH * length or index in held) and index not in let_go]
        while near:
            _, rates, rows, _ = self.system.now(time, state, near)
            if rates.min() >= -STILL:
                break
            hit = [k for k, rate in enumerate(rates) if rate < STILL]
            kept = self.system.restitution[[near[k] for k in hit]]
            impulses = pulls_of(lightness, rows[hit], (1 + kept) * rates[hit])
            before, state = state, state.copy()
            state[half:] += lightness * (impulses @ rows[hit])
            self.impacts.append((time, [near[k] for k in hit], impulses, before, state))
        near = [index for index, rate in zip(near, self.system.now(time, state, near)[1]) if rate < SLOW] if near else []
        if not near:
            return state, []
        _, rates, rows, bends = self.system.now(time, state, near)
        towards = bends + rows @ self.system.accelerations(np.array([time]), state[None], [], time)[0][0]
        taut = [k for k, pull in enumerate(pulls_of(lightness, rows, towards)) if pull > 0]
        state = state.copy()
        rows, rates = rows[taut], rates[taut]
        if taut:
            state[half:] -= lightness * (np.linalg.lstsq((rows * lightness) @ rows.T, rates, rcond=None)[0] @ rows)
        return state, [near[k] for k in taut]


MOVING_RING = """
name = "moving-ring"
duration = 6.0
gravity = [0.0, -1.0]
bodies = [
  { name = "block", mass = 1.0, inertia = 0.02, position = [-0.5, -0.8], velocity = [0.2, 0.0] },
  { name = "ball", mass = 0.8, position = [0.4, -0.7], velocity = [0.0, 0.1] },
]
[[cables]]
from = { body = "block", at = [0.05, 0.1] }
through = [{ at = [0.0, 0.0], waves = [{ amplitude = [0.0, 0.05], frequency = 3.0 }] }]
to = { body = "ball" }
length = 2.1
restitution = 0.7
[[cables]]
from = { body = "block", at = [-0.05, 0.1] }
to = { at = [-1.0, 0.0] }
length = 1.5
restitution = 0.5
[[cables]]
from = { body = "ball" }
to = { at = [1.0, 0.0] }
length = 1.4
restitution = 0.5
"""

# both cables are taut from 0.46 on; a wave draws one of them in and out, and the other end moves
DRAWN = """
name = "drawn"
duration = 6.0
gravity = [0.0, -1.0]
[[bodies]]
name = "breakwater"
mass = 1.0
inertia = 0.01
position = [0.1, 0.1]
velocity = [0.2, -0.1]
[[cables]]
from = { body = "breakwater", at = [-0.1, 0.0] }
to = { at = [-1.0, 1.2], waves = [{ amplitude = [0.1, 0.0], frequency = 2.0, phase = -1.5707963267948966 }] }
length = { value = 1.5, waves = [{ amplitude = 0.05, frequency = 1.3, phase = -1.5707963267948966 }] }
restitution = 0.0
[[cables]]
from = { body = "breakwater", at = [0.1, 0.0] }
to = { at = [1.0, 1.2], waves = [{ amplitude = [0.1, 0.0], frequency = 2.0, phase = -1.5707963267948966 }] }
length = 1.5
restitution = 0.0
"""

# a cubic winch, gravity that swings, a cable that is hooked up and cut, and a body that carries a ring
CRANE = """
name = "crane"
duration = 5.0
gravity = { value = [0.0, -9.81], waves = [{ amplitude = [0.3, 0.0], frequency = 2.5 }] }
[[bodies]]
name = "load"
mass = 20.0
inertia = 0.8
drag = 0.4
spin_drag = 0.02
position = [0.1, -1.5]
angle = 0.1
velocity = [0.3, 0.2]
spin = -0.4
moment = { waves = [{ amplitude = 0.5, frequency = 4.0, phase = 0.2 }] }
[[bodies]]
name = "block"
mass = 2.0
inertia = 0.05
position = [0.05, -0.6]
velocity = [0.0, -0.2]
[[cables]]
from = { at = [-0.4, 0.3] }
through = [{ body = "block", at = [0.0, 0.1] }]
to = { at = [0.4, 0.3] }
length = { times = [0.5, 1.2, 2.5], values = [2.4, 2.2, 1.9], spline = true }
restitution = 0.4
[[cables]]
from = { body = "block", at = [0.0, -0.1] }
to = { body = "load", at = [0.05, 0.2] }
length = 0.9
restitution = 0.0
[[cables]]
from = { body = "load", at = [-0.2, 0.0] }
to = { at = [-1.5, -1.5] }
length = 1.9
restitution = 0.6
from_time = 0.4
cut_at = 3.0
"""


class Rows:
    """What the program writes of a system: the state before and after each impact, and at other times."""

    def __init__(self, file, until):
        self.jumps, self.samples = [], []
        table = csv.reader(io.StringIO(support.output(support.PROGRAM, "solve", file, "--csv", "-", "--until", until, "--every",
                                                      until / 50)))
        head = next(table)
        places = [k for k, one in enumerate(head) if one.split("_")[-1] in ("x", "y", "angle")]
        rates = [k for k, one in enumerate(head) if one.split("_")[-1] in ("vx", "vy", "spin")]
        impulses = [k for k, one in enumerate(head) if one.startswith("impulse_")]

        def numbers(row, columns):
            return np.array([float(row[k]) if row[k] else np.nan for k in columns])
        before = None
        for row in table:
            time, state = float(row[0] or "nan"), numbers(row, places + rates)
            if row[1] == "before impact":
                before = state
            elif row[1] == "after impact":
                self.jumps.append((time, before, state, numbers(row, impulses)))
            else:
                self.samples.append((time, state))


def apart(one, other, size=1.0):
    """The largest difference of two lists of numbers, of those above `size` in parts of them; infinite where the program tells
    none."""
    difference = (np.abs(one - other) / np.maximum(size, np.abs(one))).max() / size
    return np.inf if np.isnan(difference) else difference


class Compared:
    """The motion of a case file by the program and by the integration, up to `most` impacts."""

    def __init__(self, text, until, most, wrong=lambda system: None):
        system = System(text)
        wrong(system)
        system.duration = until
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "system.toml")
            file.write_text(text, encoding="utf-8")
            rows = Rows(file, until)
        motion = Motion(system, [time for time, _ in rows.samples], most)
        self.late = self.off = 0.0  # [s]; of states and impulses
        self.impacts = self.samples = self.completed = 0
        mine, last, largest = list(motion.impacts), 0.0, 1.0
        unlike = [(one[0], one[0]) for one in mine]  # there the motion has two states
        for time, before, after, impulses in rows.jumps:
            if not mine and time > motion.end:
                break
            hit = np.flatnonzero(impulses)
            if not mine or abs(time - mine[0][0]) > ALLOWED or not set(hit) <= set(mine[0][1]):
                # impacts that the program completes at once: from here on the cable is as if it were taut already
                taut = next((when for when, index in motion.settled if when >= last and index in hit), np.inf)
                if abs(taut - time) > 1e-3:
                    raise AssertionError(f"impact {self.impacts} at {time} is at {mine[0][0] if mine else None} here")
                unlike.append((last, taut))
                mine = [one for one in mine if one[0] > taut]
                self.completed += 1
                continue
            last, cables, pulls, first, then = mine.pop(0)
            largest = max(largest, pulls.max())
            weight = min(1.0, pulls.max() / (WEAK * largest))
            self.late = max(self.late, weight * abs(time - last))
            self.off = max(self.off, weight * apart(before, first), weight * apart(after, then),
                           apart(impulses[cables], pulls, largest))
            self.impacts += 1
        for time, state in rows.samples:
            if time in motion.states and not any(begin - ALLOWED <= time <= end + ALLOWED for begin, end in unlike):
                self.off = max(self.off, apart(state, motion.states[time]))
                self.samples += 1

    def agrees(self):
        return max(self.late, self.off) <= ALLOWED


# name of a shipped system or text of one, time that is compared [s], impacts at most, at least, and completions; a motion
# that magnifies errors is compared up to where they are still small
COMPARED = [
    ("breakwater-in-waves", 12.0, 30, 30, 0),
    ("breakwater-shaken", 12.0, 30, 30, 0),
    ("breakwater-and-ball", 2.5, 23, 23, 0),
    ("bouncer-stable", 60.0, 30, 30, 0),
    ("bouncer-unstable", 60.0, 12, 12, 0),
    ("winch", 2.0, 40, 18, 1),
    ("buoy-heave", 8.0, 30, 6, 0),
    ("two-bodies", 1.0, 2, 1, 0),
    ("pulley", 0.45, 2, 0, 0),
    ("peg", 0.569, 20, 11, 0),
    ("chain-of-three", 12.0, 18, 18, 0),
    ("tow", 60.0, 20, 7, 1),
    ("slung-load", 5.0, 2, 0, 0),
    ("newtons-cradle", 5.0, 5, 3, 0),
    (MOVING_RING, 6.0, 28, 28, 0),
    (DRAWN, 5.0, 20, 3, 0),
    (CRANE, 1.2, 80, 16, 1),
]


class Systems(unittest.TestCase):
    def compared(self, name, *arguments):
        return Compared(name if "\n" in name else support.output(support.PROGRAM, "cases", name), *arguments)

    def test_systems_move_as_an_integration_of_its_own_says(self):
        for name, until, most, least, completed in COMPARED:
            title = name.split('"')[1] if "\n" in name else name
            with self.subTest(title):
                found = self.compared(name, until, most)
                print(f"{title}: {found.impacts} impacts, {found.completed} completions, {found.samples} samples: "
                      f"{found.late:.1e} s, {found.off:.1e}")
                self.assertLess(found.late, ALLOWED)
                self.assertLess(found.off, ALLOWED)
                self.assertGreaterEqual(found.impacts, least)
                self.assertGreaterEqual(found.completed, completed)
                self.assertGreater(found.samples, 8)

    def refuse(self, name, until, most, wrong):
        """That the comparison sees what is `wrong`."""
        try:
            found = self.compared(name, until, most, wrong)
        except AssertionError:
            return
        self.assertFalse(found.agrees())

    def test_a_wrong_restitution_would_be_seen(self):
        def wrong(system):
            system.restitution = 0.99 * system.restitution
        self.refuse("breakwater-shaken", 12.0, 3, wrong)
        self.refuse("chain-of-three", 12.0, 3, wrong)

    def test_ends_that_move_by_another_ten_millionth_would_be_seen(self):
        def wrong(system):
            for ends in system.ends:
                for body, function in ends:
                    if body is None:
                        function.waves = [(amplitude + 1e-7, frequency, phase) for amplitude, frequency, phase in function.waves]
        self.refuse("breakwater-shaken", 12.0, 3, wrong)
        self.refuse(MOVING_RING, 6.0, 3, wrong)


if __name__ == "__main__":
    support.main()
