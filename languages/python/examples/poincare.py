"""A Poincaré section of a point mass on cables of restitution 1: motions of one energy, each with a colour of its own."""
import matplotlib.pyplot as plt
import numpy as np
import tautline as tl

DURATION = 320
case = tl.Case.shipped("breakwater/1900461100").but(restitution=1, duration=DURATION, x=0, y=0.3)
for way in np.linspace(-1.4, 1.5, 16):
    impacts = tl.solve(case.but(vx=0.6 * np.cos(way), vy=0.6 * np.sin(way))).impacts
    hits = impacts.where(impacts.cables[:, 0]).before
    arm = hits[:, :2] - case.cables[0].anchor
    along = (arm[:, 0] * hits[:, 4] - arm[:, 1] * hits[:, 3]) / case.cables[0].length
    plt.plot(np.arctan2(arm[:, 0], -arm[:, 1]), along, ".", markersize=2)
plt.xlabel("angle of cable 0 at its impacts, from the vertical [rad]")
plt.ylabel("speed across the cable [m/s]")
