"""The contacts of tests/vectors/snaps.json and the tables of docs/snap.md, held to a damped oscillator in closed form."""
import json
import math
import pathlib
import re
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
VECTORS = ROOT / "tests/vectors"
PAGE = (ROOT / "docs/snap.md").read_text(encoding="utf-8")
SNAPS = json.loads((VECTORS / "snaps.json").read_text(encoding="utf-8"))
CLOSE = 1e-12  # [-]: a stretch is the difference of lengths that are 100 and more times as large
HALVINGS = 100


def zero(function, low, high):
    """Where `function` changes its sign between both."""
    sign = function(low) > 0
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if (function(middle) > 0) == sign else (low, middle)
    return low


class Oscillator:
    """A mass of 1 at `speed` into a spring of this `frequency` [1/s] and damping `ratio`, with the load `gravity` [m/s^2]."""

    def __init__(self, frequency, ratio, speed=1.0, gravity=0.0):
        self.frequency, self.ratio, self.speed, self.gravity = frequency, ratio, speed, gravity
        self.still = gravity / frequency**2

    def motion(self, time):
        """Stretch and its rate."""
        decay = self.ratio * self.frequency
        square = 1 - self.ratio**2
        first = -self.still
        second = self.speed + decay * first
        if square == 0:
            wave, other = time, 1.0
        else:
            turn = self.frequency * math.sqrt(abs(square))
            wave, other = ((math.sin(turn * time) / turn, math.cos(turn * time)) if square > 0 else
                           (math.sinh(turn * time) / turn, math.cosh(turn * time)))
        fall = math.exp(-decay * time)
        stretch = fall * (first * other + second * wave)
        rate = -decay * stretch + fall * (second * other - first * square * self.frequency**2 * wave)
        return stretch + self.still, rate

    def tension(self, time):
        stretch, rate = self.motion(time)
        return self.frequency**2 * stretch + 2 * self.ratio * self.frequency * rate

    def slope(self, time):
        stretch, rate = self.motion(time)
        bend = self.gravity - self.frequency**2 * stretch - 2 * self.ratio * self.frequency * rate
        return self.frequency**2 * rate + 2 * self.ratio * self.frequency * bend


class Contact(Oscillator):
    """What it does on a cable, from the entry to the instant at which its tension is zero."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        frequency, speed, gravity = self.frequency, self.speed, self.gravity
        # the tension rises at first or falls at once, and has one zero before the oscillator is back where it starts
        step = 1e-3 / frequency
        end = 2 * step
        while self.tension(end) > 0:
            end += step
        self.duration = zero(self.tension, end - step, end)
        self.exit_speed = -self.motion(self.duration)[1]
        self.stretch_at_exit = self.motion(self.duration)[0]
        self.greatest_stretch = self.motion(zero(lambda t: self.motion(t)[1], 0.0, self.duration))[0]
        self.peak_time = 0.0 if self.slope(0.0) <= 0 else zero(self.slope, 0.0, self.duration)
        self.peak = self.tension(self.peak_time)
        self.impulse = speed + self.exit_speed + gravity * self.duration


def lets_go(ratio, speed):
    """Whether the tension of a cable falls to zero under a load of 1, at a frequency of 1."""
    one = Oscillator(1.0, ratio, speed, 1.0)
    return min(one.tension(0.005 * step) for step in range(20, 1400)) < 0  # it is least before a period is over


def contact_of(name):
    """The contact that a case file describes, its mass [kg] and when it begins [s]."""
    system = tomllib.loads((VECTORS / f"snaps/{name}.toml").read_text(encoding="utf-8"))
    cable, bodies = system["cables"][0], system["bodies"]
    mass = 1 / sum(1 / body["mass"] for body in bodies)
    begin, speed, gravity = 0.0, math.hypot(*bodies[0].get("velocity", [0.0, 0.0])), -system["gravity"][1]
    if not speed:  # it falls from the place where its cable ends
        speed = math.sqrt(2 * gravity * cable["length"])
        begin = speed / gravity
    return Contact(math.sqrt(cable["stiffness"] / mass), cable.get("damping_ratio", 0.0), speed, gravity), mass, begin


def table(below):
    """The rows of numbers in the table after the heading `below`, as they are written."""
    part = PAGE.split(f"## {below}\n")[1].split("\n## ")[0]
    return [re.findall(r"[-0-9.e]+", line) for line in part.splitlines() if re.match(r"\| [0-9]", line)]


class Snaps(unittest.TestCase):
    def is_written(self, texts, values):
        """That each text has the digits of its value."""
        self.assertEqual(len(texts), len(values))
        for text, value in zip(texts, values):
            place = len(text.split(".")[1]) if "." in text else 0
            self.assertLessEqual(abs(float(text) - value), 0.51 * 10.0**-place, text)

    def test_each_contact_is_that_of_an_oscillator(self):
        self.assertEqual(sorted(SNAPS), sorted(path.stem for path in VECTORS.glob("snaps/*.toml")))
        for name, found in SNAPS.items():
            right, mass, begin = contact_of(name)
            for member, value in {"entry": begin, "exit": begin + right.duration, "entry_speed": right.speed,
                                  "exit_speed": right.exit_speed, "peak": mass * right.peak,
                                  "peak_time": begin + right.peak_time, "greatest_stretch": right.greatest_stretch,
                                  "impulse": mass * right.impulse}.items():
                with self.subTest(name, member=member):
                    self.assertLessEqual(abs(found[member]["value"] - value), CLOSE * max(value, begin), (found[member], value))
                    self.assertLessEqual(found[member]["error"], CLOSE * max(value, begin))

    def test_the_page_has_their_numbers(self):
        for row in table("One contact without a load"):
            one = Contact(1.0, float(row[0]))
            self.is_written(row[1:], [one.exit_speed, one.duration, one.peak, one.greatest_stretch])
            self.assertAlmostEqual(one.stretch_at_exit, 2 * one.ratio * one.exit_speed, delta=CLOSE)
            self.assertIn(f"free-{row[0]}", SNAPS)
        for share, ratio in table("Which damping ratio gives which restitution"):
            self.is_written([ratio], [zero(lambda z: Contact(1.0, z).exit_speed - float(share), 0.0, 2.0)])
        for row in table("Under a load"):
            one = Contact(100.0, float(row[0]), 1.0, 9.81)
            self.is_written(row[1:], [one.duration, one.exit_speed, one.peak, one.peak_time, one.impulse])
            self.assertIn(f"loaded-{row[0]}", SNAPS)
        self.assertEqual([len(table(name)) for name in ("One contact without a load", "Which damping ratio gives which restitution",
                                                        "Under a load")], [7, 6, 3])

    def test_slow_contacts_end_where_the_page_says(self):
        ratios, speeds = (re.findall(r"[0-9.]+", line) for line in PAGE.split("\n")
                          if re.match(r"\| (damping ratio \| 0.01|speed, in)", line))
        self.assertEqual(len(ratios), 6)
        self.is_written(speeds, [zero(lambda v: lets_go(float(ratio), v), 0.01, 20.0) for ratio in ratios])

    def test_the_least_peak_is_where_the_page_says(self):
        ratio, peak = map(float, re.search(r"damping ratio of ([0-9.]+):\*\* there it is ([0-9.]+) v", PAGE).groups())
        self.assertAlmostEqual(Contact(1.0, ratio).peak, peak, delta=1e-10)
        for off in (-1e-3, 1e-3):
            self.assertGreater(Contact(1.0, ratio + off).peak, peak)
        bungee, mass, _ = contact_of("bungee")
        self.is_written(re.findall(r"pull with ([0-9.]+) N", PAGE), [mass * bungee.peak])


if __name__ == "__main__":
    unittest.main()
