#!/usr/bin/env python3
"""What calls of the package cost, in processor time: the best of several runs.

  PYTHONPATH=build/dev/languages/python measure.py [BATCH]

  BATCH    the program tautline_python_batch, for the ratio of a sweep to solve_batch in C++, in turns:
           cmake --build build/dev --target tautline_python_batch, then build/dev/tests/languages/python/tautline_python_batch
"""
import subprocess
import sys
import time

import numpy as np
import tautline as tl

DRAWS = 1000  # of a sweep; those of tests/languages/python/solve_batch.cpp


def cost(call, repeat, rounds=7):
    """Processor time of one call [s]."""
    best = np.inf
    for _ in range(rounds):
        start = time.process_time()
        for _ in range(repeat):
            call()
        best = min(best, (time.process_time() - start) / repeat)
    return best


def row(what, seconds, limit=None):
    unit, factor = ("ms", 1e3) if seconds > 2e-3 else ("µs", 1e6)
    print(f"{what:<50} {seconds * factor:8.1f} {unit}" + (f"  (at most {limit} on an idle machine)" if limit else ""))


def main(arguments):
    case = tl.Case.shipped("breakwater/1910121100")
    short, motion = case.but(duration=1e-3), tl.solve(case)
    times = np.linspace(0, motion.end_time, 1_000_000)
    row("solve where nothing happens", cost(lambda: tl.solve(short), 2000), "10 µs")
    row(f"solve of the standard case, {len(motion.events)} events", cost(lambda: tl.solve(case), 50))
    row("the same with its events and their errors", cost(lambda: tl.solve(case).events.errors, 20))
    row("one state", cost(lambda: motion(3.0), 2000))
    row("1e6 states in one call", cost(lambda: motion(times), 1), "100 ms")
    row("1e6 energies in one call", cost(lambda: motion.energy(times), 1))
    row("case.but(x=0.1)", cost(lambda: case.but(x=0.1), 500))
    row("first solve of a case that `but` made", cost(lambda: tl.solve(short.but(x=0.1)), 500))

    x = 0.1 + 1e-3 * (2 * np.arange(DRAWS) / DRAWS - 1)
    swept, settled, batch = [], [], []
    for _ in range(5 if arguments else 3):
        swept.append(cost(lambda: tl.sweep(case, {"x": x}, threads=1), 1, 3) / DRAWS)
        settled.append(cost(lambda: tl.sweep(case, {"x": x}, threads=1, settling=True), 1, 3) / DRAWS)
        if arguments:
            told = subprocess.run([arguments[0], str(DRAWS)], check=True, capture_output=True, text=True).stdout
            batch.append(float(told))
    row("a motion of a sweep, one thread", min(swept))
    row("the same with settling", min(settled))
    if batch:
        row("a motion of solve_batch in C++", min(batch))
        print(f"ratio of the sweep to solve_batch: {min(swept) / min(batch):.3f} (at most 1.1)")


if __name__ == "__main__":
    if len(sys.argv) > 2 or "--help" in sys.argv:
        sys.exit(__doc__.strip())
    main(sys.argv[1:])
