#!/usr/bin/env python3
"""Writes point_mass.json: the point mass of Table 5.1 up to t = 15 in 60-digit arithmetic.

Between impacts the squared distance to an anchor is a quartic in time, so every impact time is the
smallest real root of a polynomial: no search, no step, and nothing shared with the solver under
test. Needs mpmath. Run it in this folder; the output is committed.
"""

import json

from mpmath import mp, mpf, nstr, polyroots, sqrt

mp.dps = 60
LENGTH = mpf("1.5")
RESTITUTION = mpf("0.9")
ANCHORS = [(mpf(-1), sqrt(LENGTH**2 - 1)), (mpf(1), sqrt(LENGTH**2 - 1))]  # left, right
END = mpf(15)


def next_impact(x, y, vx, vy, just_hit):
    """Time to the next impact and its cable."""
    found = []
    for cable, (ax, ay) in enumerate(ANCHORS):
        dx, dy = x - ax, y - ay
        quartic = [mpf(1) / 4, -vy, vx**2 + vy**2 - dy, 2 * (dx * vx + dy * vy),
                   dx**2 + dy**2 - LENGTH**2]
        if cable == just_hit:
            quartic.pop()  # its root at zero is the impact just resolved
        for root in polyroots(quartic, maxsteps=500, extraprec=400):
            if abs(root.imag) < mpf(10) ** -40 and root.real > mpf(10) ** -30:
                t = root.real
                stretching = (dx + vx * t) * vx + (dy + vy * t - t**2 / 2) * (vy - t)
                if stretching > 0:
                    found.append((t, cable))
    return min(found)


def digits(value):
    return nstr(value, 25)


def main():
    time, x, y, vx, vy = mpf(0), mpf("0.4"), mpf(1), mpf("0.6"), mpf("-0.1")
    just_hit = None
    impacts = []
    while True:
        dt, cable = next_impact(x, y, vx, vy, just_hit)
        if time + dt > END:
            break
        time, x, y, vy = time + dt, x + vx * dt, y + vy * dt - dt**2 / 2, vy - dt
        before = [x, y, vx, vy]
        nx, ny = ((x - ANCHORS[cable][0]) / LENGTH, (y - ANCHORS[cable][1]) / LENGTH)
        stretching = nx * vx + ny * vy
        vx -= (1 + RESTITUTION) * stretching * nx
        vy -= (1 + RESTITUTION) * stretching * ny
        just_hit = cable
        impacts.append({"time": digits(time), "cable": cable,
                        "before": [digits(value) for value in before],
                        "after": [digits(value) for value in (x, y, vx, vy)]})
    dt = END - time
    at_end = [x + vx * dt, y + vy * dt - dt**2 / 2, vx, vy - dt]
    result = {"columns": ["x", "y", "vx", "vy"], "impacts": impacts, "end_time": "15",
              "at_end": [digits(value) for value in at_end]}
    with open("point_mass.json", "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
