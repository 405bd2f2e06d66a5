"""The standard case by SciPy's `solve_ivp`, event by event, and how far its impacts are from the exact ones."""
import matplotlib.pyplot as plt
import numpy as np
from scipy.integrate import solve_ivp
import tautline as tl

case = tl.Case.shipped("breakwater/1910121100")
start, s, times = 0.0, np.array([0.1, 0.1, 0.0, 0.2, -0.1, 0.0]), []
def gap(cable):
    def event(t, s): return case.gaps(s)[cable] + 1e-9 * (t <= start)  # what has rebounded begins at a gap of 0
    event.terminal, event.direction = True, -1
    return event
while len(times) < 70:
    run = solve_ivp(lambda t, s: [*s[3:], *case.gravity, 0], (start, 20), s, events=[gap(0), gap(1)], rtol=1e-12, atol=1e-14)
    start, s, hit = run.t[-1], run.y[:, -1], [len(found) for found in run.t_events].index(1)
    row = case.gap_rates(np.c_[np.tile(s[:3], (3, 1)), np.eye(3)])[:, hit]  # the gap's rate is linear in the velocity
    s[3:] -= 1.9 * (row @ s[3:]) / (row**2 @ [1, 1, 100]) * row * [1, 1, 100]
    times.append(start)
exact = tl.solve(case).impacts
plt.semilogy(np.abs(times - exact.time[:70]) + 1e-17, ".", label="solve_ivp: distance from the exact time")
plt.semilogy(exact.errors.time[:70], label="tautline: bound of its own error")
plt.legend()
plt.xlabel("impact")
plt.ylabel("time [s]")
