"""The path of the standard case with its impacts on it, and the energy that each of them takes."""
import matplotlib.pyplot as plt
import numpy as np
import tautline as tl

motion = tl.solve(tl.Case.shipped("breakwater/1910121100"))
t = np.linspace(0, motion.end_time, 2000)
figure, (path, energy) = plt.subplots(1, 2, figsize=(10, 4))
path.plot(*motion(t)[:, :2].T, linewidth=1)
path.plot(*motion.impacts.before[:, :2].T, ".", markersize=4)
path.set(xlabel="x [m]", ylabel="y [m]", title="path, and where it is hit")
energy.plot(t, motion.energy(t))
energy.axvspan(motion.horizon, motion.unsure.end[-1], alpha=0.3)
energy.set(xlabel="time [s]", ylabel="energy [J]", title="energy; shaded: nothing is sure")
