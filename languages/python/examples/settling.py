"""How long the standard case takes to settle, over the restitution of its cables: 2,000 exact motions."""
import matplotlib.pyplot as plt
import numpy as np
import tautline as tl

COUNT = 2000
case = tl.Case.shipped("breakwater/1910121100").but(duration=200)
e = np.linspace(0, 0.95, COUNT)
swept = tl.sweep(case, {"restitution": e}, settling=True, until_locked=True)

plt.plot(e, swept["settling_time"], ".", markersize=2)
plt.xlabel("restitution of both cables")
plt.ylabel("time from which both stay taut [s]")
plt.yscale("log")
