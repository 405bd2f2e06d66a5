#!/usr/bin/env python3
"""`tl.draws` gives the samples of `tautline ensemble`, bit for bit."""
import csv
import pathlib
import re
import tempfile
import unittest

import support
from support import PROGRAM, ROOT, output

import numpy as np
import tautline as tl

ALL_KINDS = """
case = "breakwater/1910121100"
count = 30
until = 4.0
seed = 11

[[vary]]
quantities = ["x", "length", "velocity_y"]
normal = 1e-3

[[vary]]
quantities = ["restitution_0", "gravity_x"]
uniform = [0.3, 0.9]

[[vary]]
quantities = ["mass", "capture_speed_1"]
list = [1, 0.1, 0.35]

[[vary]]
quantities = ["spin"]
grid = [-0.1, 0.1]
points = 3

[[vary]]
quantities = ["angle"]
grid = [-0.1, 0.2]
points = 4
"""


class Draws(unittest.TestCase):
    def solved_by_program(self, path, *words):
        """A row of CSV for each sample that the program solves."""
        with tempfile.TemporaryDirectory() as out:
            output(PROGRAM, "ensemble", path, *words, "--out", out)
            rows = []
            for file in sorted(pathlib.Path(out, "draws/exact").iterdir()):
                rows += csv.DictReader(file.read_text(encoding="utf-8").splitlines()[1:])
        return rows

    def same_as_program(self, path, *words, **options):
        """The motions are as sensitive as motions can be, and agree to the last bit. So do their starts."""
        rows, drawn = self.solved_by_program(path, *words), tl.draws(path, **options)
        swept = tl.sweep(drawn.case, drawn.values, law=drawn.law, until_locked=True, swing_ahead=True, settling=True)
        self.assertEqual((len(rows), len(drawn)), (len(drawn), len(swept["solved"])))
        for row, solved, last in zip(rows, swept["solved"], swept["last_impact_time"]):
            self.assertEqual(row["problem"] == "", solved, row)
            if solved:
                self.assertEqual([row["settled_fast"], row["settled_slow"]],
                                 ["" if np.isnan(time) else shortest(time) for time in last])
            elif "overstretched" in row["problem"]:
                self.assertIn(row["problem"][:60], "no such case: " + problem(drawn, int(row["draw"])))
        return drawn, swept

    def test_of_every_kind_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "all.toml")
            path.write_text(ALL_KINDS, encoding="utf-8")
            drawn, swept = self.same_as_program(path)
            self.assertEqual((len(drawn), drawn.seed, drawn.case.duration), (360, 11, 4.0))
            self.assertGreater(np.count_nonzero(swept["solved"]), 100)
            path.write_text(ALL_KINDS.replace("seed = 11", "seed = 9007199254740992"), encoding="utf-8")
            self.same_as_program(path, "--count", "3", count=3)

    def test_of_the_guides_are_those_of_the_program(self):
        self.same_as_program(ROOT / "docs/guides/ensembles/laws.toml", "--count", "300", count=300)

    def test_normal_numbers_are_those_that_integers_give(self):
        """The short way to them compared with the program's, which takes 20 us for each."""
        from tautline import _draws
        parts = np.concatenate([_draws._random_parts(3, 0, 30000), [2.0**-53, 2.0**-30, 0.5 - 2.0**-53, 0.5 + 2.0**-53, 1 - 2.0**-53]])
        always = 2048
        self.assertTrue((_draws._normal_quantiles(parts) == _draws._normal_quantiles(parts, always)).all())

    def test_do_not_depend_on_their_count(self):
        self.assertTrue((tl.draws(ALL_KINDS, seed=12).values["x"] != tl.draws(ALL_KINDS).values["x"]).all())
        few, many = tl.draws(ALL_KINDS, count=3), tl.draws(ALL_KINDS, count=7000)  # more than are drawn at a time
        for name, values in few.values.items():
            self.assertTrue((many.values[name][:len(values)] == values).all())
        self.assertTrue((np.abs(many.values["x"] - 0.1) < 7e-3).all())
        self.assertEqual(set(many.values["mass"]), {1.0, 0.1, 0.35})
        self.assertTrue(((many.values["gravity_x"] > 0.3) & (many.values["gravity_x"] < 0.9)).all())

    def test_a_case_next_to_the_spec(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "ball.toml").write_text(tl.Case.shipped("bouncing-ball").to_toml(), encoding="utf-8")
            path = pathlib.Path(folder, "spec.toml")
            path.write_text('case = "ball.toml"\n[[vary]]\nquantities = ["y"]\nnormal = 0.1\n', encoding="utf-8")
            self.assertEqual((len(tl.draws(path)), tl.draws(path).case.name), (1000, "bouncing-ball"))

    def test_what_is_refused(self):
        head, vary = 'case = "bouncing-ball"\n', '[[vary]]\nquantities = ["y"]\n'
        good = head + vary + "normal = 1.0\n"
        for text, words in [
                (head, "spec: vary: must be tables"),
                (good.replace("ball", "bal"), "spec: case: case 'bouncing-bal' is not shipped; did you mean bouncing-ball"),
                (good.replace("bouncing-ball", "no.toml"), "spec: case: .*No such file or directory: 'no.toml'"),
                (vary + "normal = 1.0\n", "spec: case: must be the name of a shipped case or a path, is None"),
                ("sampling = \"sobol\"\n" + good, "spec: sampling: \"sobol\" cannot be drawn here"),
                ("sampling = 1\n" + good, "spec: sampling: 1 must be random"),
                ("count = 0\n" + good, "spec: count: 0 must be a whole number from 1 to 10000000"),
                ("count = 1.5\n" + good, "spec: count: 1.5 must be a whole number"),
                ("count = nan\n" + good, "spec: count: nan must be a whole number"),
                ("count = inf\n" + good, "spec: count: inf must be a whole number"),
                ("count = \"3\"\n" + good, "spec: count: '3' must be a whole number"),
                ("seed = -1\n" + good, "spec: seed: -1 must be a whole number from 0 to 9007199254740992"),
                ("until = 0\n" + good, "spec: until: 0 must be above 0"),
                ("law = \"x\"\n" + good, "spec: law: 'x' must be one of simultaneous"),
                ("law = []\n" + good, r"spec: law: \[\] must be one of simultaneous"),
                ("completion = 1\n" + good, "spec: completion: 1 must be above 0 and at most 1e-10"),
                ("cuont = 3\n" + good, "spec: cuont: is unknown"),
                (good + "deviation = 1\n", r"spec: vary\[0\].deviation: is unknown"),
                (good + "uniform = [0, 1]\n", r"spec: vary\[0\].quantities: needs one of normal, uniform, list and grid; several"),
                (head + vary, r"spec: vary\[0\].quantities: needs one of .* none is given"),
                (head + vary + "normal = -1\n", r"spec: vary\[0\].normal: -1 must be above 0"),
                (head + vary + "normal = nan\n", r"spec: vary\[0\].normal: nan must be above 0"),
                (head + vary + "uniform = [1, 0]\n", r"spec: vary\[0\].uniform: must be two numbers \[low, high\]"),
                (head + vary + "uniform = 1\n", r"spec: vary\[0\].uniform: must be an array of numbers, is 1"),
                (head + vary + "list = []\n", r"spec: vary\[0\].list: must be an array of numbers"),
                (head + vary + "list = [\"a\"]\n", r"spec: vary\[0\].list: 'a' must be a number"),
                (head + vary + "list = [nan]\n", r"spec: vary\[0\].list: nan must be a number"),
                (head + vary + "grid = [0, 1]\n", r"spec: vary\[0\].points: None must be a whole number from 2 to 1000"),
                (good + "points = 3\n", r"spec: vary\[0\].points: belongs to a grid"),
                (good.replace("\"y\"", "\"z\""), r"spec: vary\[0\].quantities: 'z' is no number of this case"),
                (good.replace("\"y\"", "7"), r"spec: vary\[0\].quantities: '7' is no number of this case"),
                (good.replace("\"y\"", "\"y\", \"y\""), r"spec: vary\[0\].quantities: 'y' is varied twice"),
                (good.replace("[\"y\"]", "3"), r"spec: vary\[0\].quantities: must be an array of names"),
                (good + "x = = 3\n", "spec: Invalid value"),
                ("count = 9999999\n" + head + vary + "grid = [0, 1]\npoints = 3\n", "spec: count: 29999997 draws in all")]:
            with self.subTest(text), self.assertRaisesRegex(ValueError, words):
                tl.draws(text)
        with self.assertRaises(ValueError) as refused:
            tl.draws("count = 0\nseed = -1\nlaw = 3\n" + good)
        self.assertEqual(len(str(refused.exception).splitlines()), 3)
        with self.assertRaises(FileNotFoundError):
            tl.draws("no spec.toml")
        with self.assertRaisesRegex(ValueError, "^/dev/zero: is longer than 1048576 bytes"):
            tl.draws("/dev/zero")
        with self.assertRaisesRegex(ValueError, "^spec: is nested too deep"):
            tl.draws("x = " + "[" * 100000 + "\n")
        with tempfile.NamedTemporaryFile() as file:
            file.write(b"\xff")
            file.flush()
            with self.assertRaisesRegex(ValueError, "must be text in UTF-8"):
                tl.draws(file.name)


def shortest(number):
    """A number as the program writes it: 3 for 3.0."""
    return re.sub(r"\.0$", "", repr(float(number)))


def problem(drawn, place):
    """What is wrong with the case of a sample."""
    return "; ".join(drawn.case.but(**{name: values[place] for name, values in drawn.values.items()}).problems)


if __name__ == "__main__":
    support.main()
