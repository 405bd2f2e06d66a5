"""Starts a millimetre apart: when 100,000 of them settle. `tautline ensemble` draws the same samples."""
import matplotlib.pyplot as plt
import tautline as tl

COUNT = 100_000
drawn = tl.draws("""
case = "breakwater/1910121100"
[[vary]]
quantities = ["x", "y", "angle", "velocity_x", "velocity_y", "spin"]
normal = 1e-3
""", count=COUNT)
swept = tl.sweep(drawn.case, drawn.values, settling=True, until_locked=True)
plt.hist(swept["settling_time"], bins=160, range=(7.8, 9.4), histtype="stepfilled")
plt.xlabel("time from which both cables stay taut [s]")
plt.ylabel(f"of {len(drawn)} samples")
