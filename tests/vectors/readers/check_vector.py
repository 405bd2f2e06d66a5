"""Checks an engine's samples against a test vector:  python3 check_vector.py VECTOR.json SAMPLES STEP
SAMPLES has a line `time x y angle` for the start and each step, `-` is standard input; what follows on a line and
lines that begin with # are ignored. Exit code 0: right, 1: wrong, 2: cannot be used. Or import it, and call `check`.
"""
import json, math, sys

def check(vector, samples, step):
    """(right, a sentence, the rows asked); `samples` has (time, x, y, angle, ...) for the start and each step."""
    place, asked, worst, hit = 1, 0, 0.0, 0.0
    if vector["format"] != "tautline-vector-1":
        raise ValueError("not a tautline-vector-1")
    for row in vector["rows"]:
        time, pose = row["time"], row["state"][:3]
        if step > row["step"] * (1 + 1e-9):
            break  # such a step cannot be judged here, nor later
        while place < len(samples) and samples[place][0] < time - 1e-9 * step:
            place += 1
        if place >= len(samples):
            return False, f"no sample at t = {time:g} or later", asked
        a, b = samples[place - 1], samples[place]
        part = min(1, (time - a[0]) / (b[0] - a[0])) if b[0] > a[0] else 1
        by = [one + part * (other - one) - exact for one, other, exact in zip(a[1:], b[1:], pose)]
        off, allowed = math.hypot(by[0], by[1], vector["radius"] * by[2]), 2 * step * vector["fastest"] * row["growth"]
        if not off <= allowed:
            return False, (f"at t = {time:g} it is {off:.2g} m off, {allowed:.2g} m are allowed; "
                           f"the impact before is at t = {hit:g}"), asked
        asked, worst, hit = asked + 1, max(worst, off / allowed), time if row["kind"] == "impact" else hit
    return True, f"{asked} rows asked, at worst {worst:.2g} of what is allowed", asked

if __name__ == "__main__":
    try:
        rows = sys.stdin if sys.argv[2] == "-" else open(sys.argv[2])
        steps = [tuple(map(float, line.split()[:4])) for line in rows if line.strip() and line[0] != "#"]
        if min(map(len, steps), default=0) < 4:
            raise ValueError("a sample is not `time x y angle`")
        right, sentence, asked = check(json.load(open(sys.argv[1])), steps, float(sys.argv[3]))
    except (LookupError, OSError, ValueError) as error:
        right, asked, sentence = True, 0, error
    print("unusable:" if right and asked < 2 else "right:" if right else "wrong:", sentence)
    sys.exit(2 if right and asked < 2 else not right)
