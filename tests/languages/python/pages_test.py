#!/usr/bin/env python3
"""Whatever code a page for users of Python shows runs, and the guide shows the examples as they are."""
import contextlib
import io
import json
import os
import pathlib
import re
import sys
import tempfile
import unittest

import numpy as np
import support
from support import ROOT

import tautline as tl

try:
    os.environ.setdefault("MPLCONFIGDIR", tempfile.gettempdir())
    sys.path.append(str(ROOT / "languages/python"))
    import matplotlib.pyplot as plt
    import pictures
except ImportError:
    plt = None

HERE = ROOT / "languages/python"
EXAMPLES = {path.stem: path.read_text(encoding="utf-8") for path in sorted((HERE / "examples").glob("*.py"))}
# a test is short: fewer motions, or shorter ones, show that the example runs
SHORT = {"settling": [("COUNT = 2000", "COUNT = 60")], "draws": [("COUNT = 100_000", "COUNT = 200")],
         "poincare": [("DURATION = 320", "DURATION = 20")], "against_scipy": [("< 70", "< 12"), (":70]", ":12]")]}
MOST_BYTES = 60_000  # of a picture


def code_of(path, language="python"):
    """The blocks of code of a page."""
    return re.findall(rf"^```{language}\n(.*?)^```", (ROOT / path).read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)


def run(code):
    """What code prints."""
    told = io.StringIO()
    with contextlib.redirect_stdout(told):
        exec(compile(code, "page", "exec"), {"__name__": "page"})  # pylint: disable=exec-used
    return told.getvalue()


class Readme(unittest.TestCase):
    def test_of_the_package_runs(self):
        (code,) = code_of("languages/python/README.md")
        self.assertRegex(run(code), r"^\d+ impacts; -?0\.\d+ rad at the end; settles after 0\.\d+ s or later\n$")

    def test_of_the_project_runs(self):
        text = (ROOT / "README.md").read_text(encoding="utf-8")
        section = text[text.index("From Python"):]
        code = re.search(r"```python\n(.*?)```", section, re.DOTALL)[1]
        self.assertLessEqual(len(code.splitlines()), 10)
        self.assertEqual(run(code), "[1.  2.  2.5]\n")

    def test_of_a_vector_tells_right_from_wrong(self):
        text = (ROOT / "README.md").read_text(encoding="utf-8")
        code = re.search(r"```python\n(.*?)```", text[text.index("In your own tests"):], re.DOTALL)[1]
        self.assertLessEqual(len(code.splitlines()), 10)

        def engine(of, step, **wrong):
            motion = tl.solve(tl.Case.from_json(json.dumps(of)).but(**wrong))
            times = np.append(np.arange(0, motion.end_time, step), motion.end_time)
            return [(time, *state[:3]) for time, state in zip(times, motion(times))]

        def dull_engine(of, step):
            return engine(of, step, restitution=0.4)

        with contextlib.chdir(ROOT):
            sys.path.append(str(ROOT / "tests/vectors/readers"))
            exec(code, {"my_engine": engine})  # pylint: disable=exec-used
            with self.assertRaisesRegex(AssertionError, r"^at t = .* m off"):
                exec(code, {"my_engine": dull_engine})  # pylint: disable=exec-used

    def test_of_the_package_is_about_what_there_is(self):
        for name in re.findall(r"`(src/tautline/\w+\.\w+|\w+\.(?:py|cpp)|examples)`", (HERE / "README.md").read_text(encoding="utf-8")):
            self.assertTrue((HERE / name).exists() or (HERE / "src/tautline" / name).exists(), name)


class Guide(unittest.TestCase):
    def test_first_steps_run(self):
        told = run(code_of("docs/guides/python.md")[0])
        self.assertRegex(told, r"^<Motion of case: \d+ impacts, reached_duration at t = 20 s>\n")

    def test_examples_are_short(self):
        self.assertEqual(len(EXAMPLES), 5)
        for name, text in EXAMPLES.items():
            self.assertLessEqual(len(text.splitlines()), 24 if name == "against_scipy" else 16, name)

    @unittest.skipUnless(plt, "no matplotlib here (Debian's python3-matplotlib): the examples are left out")
    def test_shows_the_examples(self):
        self.assertEqual(pictures.guide(), pictures.GUIDE.read_text(encoding="utf-8"), "pictures.py writes them")

    @unittest.skipUnless(plt, "no matplotlib here (Debian's python3-matplotlib): the examples are left out")
    def test_examples_draw_their_pictures(self):
        for name, text in EXAMPLES.items():
            with self.subTest(name):
                if "scipy" in text:
                    try:
                        import scipy  # pylint: disable=unused-import
                    except ImportError:
                        self.skipTest("no SciPy here (Debian's python3-scipy)")
                plt.close("all")
                pictures.run(name, SHORT.get(name, ()))
                words = {axes.get_xlabel() for axes in plt.gcf().axes} | {axes.get_ylabel() for axes in plt.gcf().axes}
                committed = (pictures.GOAL / f"{name}.svg").read_text(encoding="utf-8")
                for word in words - {"of 200 samples"}:
                    self.assertIn(f">{word}</text>", committed)
                self.assertLess(len(committed), MOST_BYTES)
                self.assertNotIn("<metadata", committed)
                with plt.rc_context(pictures.STYLE):
                    self.assertIn("<title>", pictures.svg("title"))
        plt.close("all")

    def test_sweep_of_an_example_is_what_the_page_says(self):
        case = tl.Case.shipped("breakwater/1910121100").but(duration=200)
        ends = tl.sweep(case, {"restitution": [0, 0.95]}, settling=True, until_locked=True)["settling_time"]
        self.assertEqual([round(float(time), 1) for time in ends][:1], [0.8])


class Notebook(unittest.TestCase):
    def test_runs_cell_by_cell(self):
        book = json.loads((HERE / "examples/tautline.ipynb").read_text(encoding="utf-8"))
        self.assertEqual((book["nbformat"], book["metadata"]["kernelspec"]["language"]), (4, "python"))
        self.assertEqual(len({cell["id"] for cell in book["cells"]}), len(book["cells"]))
        names = {"__name__": "notebook"}
        told = io.StringIO()
        for cell in book["cells"]:
            if cell["cell_type"] != "code":
                continue
            self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None))
            code = "".join(cell["source"])
            if "matplotlib" in code and plt is None:
                self.skipTest("no matplotlib here (Debian's python3-matplotlib)")
            with contextlib.redirect_stdout(told), tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
                exec(compile(code, "cell", "exec"), names)  # pylint: disable=exec-used
        self.assertIn("[1.  2.  2.5]", told.getvalue())
        if plt:
            plt.close("all")


if __name__ == "__main__":
    support.main()
