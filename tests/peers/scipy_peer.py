#!/usr/bin/env python3
"""SciPy's solve_ivp with events on the problems of `peers --problems`, told in the lines that `peers` prints.

  scipy_peer.py PROBLEMS NANOSECONDS

PROBLEMS is what `peers --problems ARCS` printed, NANOSECONDS are tautline's per impact, to which the cost is told.
Impacts are those of Newton's law, all cables at once, as of the other peers.
"""
import itertools
import math
import sys
import time

import numpy
import scipy
from scipy.integrate import solve_ivp

OTHER_IMPACT = 1e-3  # [s], an impact off by more is another one
TOUCH = 100.0  # [-], tolerances times the length: a gap as small when another is struck is struck with it
AFTERWARDS = 0.1  # [s], a graze is looked for up to so long after its deepest instant, as by `peers`
BANDS = [1e-4, 1e-6, 1e-8, 1e-10, 0.0]  # [m], depths of grazes
EFFORTS = [(tolerance, step) for step in (0.0, 0.01) for tolerance in (1e-6, 1e-9, 1e-12)]


class Cable:
    def __init__(self, words):
        numbers = [float(word) for word in words]
        self.anchor, self.attachment = numpy.array(numbers[0:2]), numpy.array(numbers[2:4])
        self.length, self.restitution = numbers[4:6]

    def look(self, state):
        """The gap, and its derivatives with respect to x, y and angle."""
        cosine, sine = math.cos(state[2]), math.sin(state[2])
        x = cosine * self.attachment[0] - sine * self.attachment[1]
        y = sine * self.attachment[0] + cosine * self.attachment[1]
        dx, dy = state[0] + x - self.anchor[0], state[1] + y - self.anchor[1]
        distance = math.hypot(dx, dy)
        dx, dy = dx / distance, dy / distance
        return self.length - distance, numpy.array([-dx, -dy, -(x * dy - y * dx)])


class Case:
    def __init__(self, words):
        self.mass, self.inertia = float(words[1]), float(words[2])
        self.gravity = float(words[3]), float(words[4])
        self.initial = [float(word) for word in words[5:11]]
        self.cables = []

    def rate(self, _, state):
        return [*state[3:6], *self.gravity, 0.0]

    def after(self, state, struck):
        """The state after an impact on the cables `struck`: L >= 0, G L + (1 + e) rate >= 0, one of both zero."""
        rows = numpy.array([self.cables[index].look(state)[1] for index in struck])
        weights = numpy.array([1 / self.mass, 1 / self.mass, 1 / self.inertia if self.inertia > 0 else 0.0])
        delassus = rows * weights @ rows.T
        wanted = (1 + numpy.array([self.cables[index].restitution for index in struck])) * (rows @ state[3:6])
        for size in range(len(struck) + 1):
            for active in map(list, itertools.combinations(range(len(struck)), size)):
                impulses = numpy.zeros(len(struck))
                if active:
                    block = delassus[numpy.ix_(active, active)]
                    if abs(numpy.linalg.det(block)) < 1e-12 * block.trace() ** len(active):
                        continue
                    impulses[active] = numpy.linalg.solve(block, -wanted[active])
                left = delassus @ impulses + wanted
                if impulses.min() >= 0 and left.min() >= -1e-12 * abs(wanted).max():
                    result = state.copy()
                    result[3:6] += weights * (rows.T @ impulses)
                    return result
        sys.exit("scipy_peer: an impact without a solution")

    def impacts(self, horizon, most, tolerance, step):
        """(instant, cables) of its impacts."""
        events = []
        for cable in self.cables:
            def gap(_, state, cable=cable):
                return cable.look(state)[0]
            gap.terminal, gap.direction = True, -1.0
            events.append(gap)
        found, state, now = [], numpy.array(self.initial), 0.0
        while len(found) < most and now < horizon:
            run = solve_ivp(self.rate, (now, horizon), state, rtol=tolerance, atol=tolerance, events=events,
                            max_step=step or math.inf)
            if run.status != 1:
                break
            now, state = run.t[-1], run.y[:, -1]
            struck = [index for index, cable in enumerate(self.cables) if run.t_events[index].size or
                      cable.look(state)[0] <= TOUCH * tolerance * cable.length and
                      cable.look(state)[1] @ state[3:6] < 0]
            found.append((now, struck))
            state = self.after(state, struck)
        return found


def read(file):
    motions, grazes = [], []
    for line in file:
        kind, *words = line.rstrip("\n").split("\t")
        if kind == "motion":
            motions.append((float(words[0]), int(words[1]), Case(words[2:]), []))
        elif kind == "impact":
            motions[-1][3].append((float(words[0]), [int(word) for word in words[1:]]))
        elif kind == "graze":
            grazes.append((*(float(word) for word in words[0:3]), Case(words[3:])))
        elif kind == "cable":
            (grazes[-1][3] if grazes else motions[-1][2]).cables.append(Cable(words))
    return motions, grazes


def cost_row(motions, tolerance, step, nanoseconds):
    """What `peers` prints after "cost": ratio, time, error of first impacts, median error, followed, of."""
    begin, errors, first, followed, count = time.process_time(), [], 0.0, 0, 0
    runs = [case.impacts(horizon, most, tolerance, step) for horizon, most, case, _ in motions]
    spent = (time.process_time() - begin) * 1e9 / sum(len(run) for run in runs)
    for run, (_, _, _, known) in zip(runs, motions):
        right = list(itertools.takewhile(
            lambda pair: abs(pair[0][0] - pair[1][0]) <= OTHER_IMPACT and pair[0][1] == pair[1][1], zip(run, known)))
        errors += [abs(one[0] - other[0]) for one, other in right]
        first = max(first, abs(right[0][0][0] - right[0][1][0]) if right else math.inf)
        followed, count = followed + len(right), count + len(known)
    median = sorted(errors)[len(errors) // 2] if errors else math.inf
    return [f"{spent / nanoseconds:.4g}", f"{spent:.4g}", f"{first:.3g}", f"{median:.3g}", followed, count]


def missed_row(grazes, tolerance, step):
    """For each band of depth how many were missed, and of how many."""
    missed, there = [0] * len(BANDS), [0] * len(BANDS)
    for deepest, depth, width, case in grazes:
        band = next(index for index, least in enumerate(BANDS) if depth >= least)
        found = case.impacts(deepest + AFTERWARDS, 1, tolerance, step)
        there[band] += 1
        missed[band] += not any(abs(instant - deepest) <= 2 * width for instant, _ in found)
    return [number for pair in zip(missed, there) for number in pair]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        motions, grazes = read(file)
    print("peer", "SciPy", scipy.__version__, "solve_ivp, RK45, terminal events on the falling gaps", sep="\t")
    for tolerance, step in EFFORTS:
        row = ["SciPy", f"{tolerance:g}", f"{step:g}"]
        print("cost", *row, *cost_row(motions, tolerance, step, float(sys.argv[2])), sep="\t", flush=True)
    for tolerance, step in EFFORTS:
        row = ["SciPy", f"{tolerance:g}", f"{step:g}"]
        print("missed", *row, *missed_row(grazes, tolerance, step), sep="\t", flush=True)


if __name__ == "__main__":
    main()
