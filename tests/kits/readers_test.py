"""The readers of test vectors, each run on right samples, on wrong ones and on what is no sample.

  readers_test.py PROGRAM

A reader is left out if its language is not installed.
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
VECTORS = ROOT / "tests/vectors"
READERS = VECTORS / "readers"
MOST_LINES = 40
STEP = 0.001  # [s]

PROGRAM = None

FORMS = {"json": "json", "text": "txt"}  # folders, with the ends of the names in them

# how each is built and started: {source}, {made}, and the form of the vector that it reads
LANGUAGES = {
    "check_vector.c": (["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "{source}", "-lm", "-o", "{made}"], ["{made}"], "text"),
    "check_vector.cpp": (["c++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "{source}", "-o", "{made}"], ["{made}"], "text"),
    "check_vector.rs": (["rustc", "-D", "warnings", "{source}", "-o", "{made}"], ["{made}"], "text"),
    "check_vector.py": (None, [sys.executable, "-B", "{source}"], "json"),
    "check_vector.mjs": (None, ["node", "{source}"], "json"),
}


def exact_samples(name):
    """The exact motion of a vector's case, sampled as a scheme with fixed steps is."""
    vector = json.loads((VECTORS / f"json/{name}.json").read_text(encoding="utf-8"))
    done = subprocess.run([PROGRAM, "solve", VECTORS / f"cases/{name}.toml", "--every", str(STEP), "--csv", "-"],
                          capture_output=True, text=True, check=True)
    head, *lines = done.stdout.splitlines()
    columns = [head.split(",").index(one) for one in ("time", "x", "y", "angle", "vx", "vy", "spin")]
    rows = [[float(line.split(",")[column] or "nan") for column in columns] for line in lines]
    return vector, [row for row in rows if math.isfinite(sum(row))]


def text(rows):
    return "".join(" ".join(map(repr, row)) + "\n" for row in rows)


class Reader:
    """What each reader must do."""

    source = None

    @classmethod
    def setUpClass(cls):
        build, cls.start, cls.form = LANGUAGES[cls.source]
        tool = (build or cls.start)[0]
        if tool[0] != "{" and not shutil.which(tool):
            raise unittest.SkipTest(f"no {tool}")
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.names = {"source": READERS / cls.source, "made": cls.folder / "check_vector"}
        if build:
            subprocess.run([word.format(**cls.names) for word in build], check=True)

    def run_on(self, name, samples, step=STEP):
        path = self.folder / "samples.txt"
        path.write_text(samples, encoding="utf-8")
        vector = name if isinstance(name, pathlib.Path) else VECTORS / self.form / f"{name}.{FORMS[self.form]}"
        done = subprocess.run([*(word.format(**self.names) for word in self.start), vector, path, str(step)],
                              capture_output=True, text=True, check=False, timeout=60)
        return done.returncode, done.stdout + done.stderr

    def assert_says(self, code, words, found):
        self.assertEqual(found[0], code, found[1])
        self.assertIn(words, found[1])
        self.assertEqual(found[1].count("\n"), 1, found[1])

    def test_is_short(self):
        self.assertLessEqual(len((READERS / self.source).read_text(encoding="utf-8").splitlines()), MOST_LINES)

    def test_calls_the_exact_motion_right(self):
        for name in ("central-half", "ladder", "four-cables", "point-mass"):
            vector, rows = exact_samples(name)
            code, said = self.run_on(name, "# time x y angle vx vy spin\n" + text(rows))
            due = sum(STEP <= row["step"] for row in vector["rows"])
            self.assertEqual(code, 0, said)
            self.assertTrue(said.startswith(f"right: {due} rows asked"), said)

    def test_takes_the_start_twice_and_a_blank_line(self):
        rows = text(exact_samples("central-half")[1])
        self.assertEqual(self.run_on("central-half", rows.split("\n")[0] + "\n" + rows + "\n")[0], 0)

    def test_names_the_instant_and_the_impact_from_which_on_a_motion_is_wrong(self):
        rows = exact_samples("central-half")[1]
        wrong = [row if row[0] < 0.5 else [row[0], row[1], row[2] + 0.01, *row[3:]] for row in rows]
        self.assert_says(1, "wrong: at t = 0.5", self.run_on("central-half", text(wrong)))
        self.assert_says(1, "the impact before is at t = 0.25", self.run_on("central-half", text(wrong)))
        turned = [[*row[:3], row[3] + (0.1 if row[0] > 0.5 else 0.0), *row[4:]] for row in exact_samples("corner-half")[1]]
        self.assert_says(1, "wrong: at t = 0.525", self.run_on("corner-half", text(turned)))

    def test_calls_what_is_no_number_and_what_ends_early_wrong(self):
        rows = exact_samples("central-half")[1]
        lost = [row if row[0] < 0.5 else [row[0], math.nan, *row[2:]] for row in rows]
        self.assert_says(1, "wrong: at t = 0.5", self.run_on("central-half", text(lost)))
        self.assert_says(1, "no sample at t = 0.65", self.run_on("central-half", text(rows[:650])))

    def test_refuses_what_it_cannot_use(self):
        rows = text(exact_samples("central-half")[1])
        for name, samples, step in (("central-half", rows, 1.0), ("central-half", "time x y\n", STEP),
                                    ("central-half", "0 0\n", STEP), (VECTORS / "LICENSE", rows, STEP),
                                    (VECTORS / "none", rows, STEP)):
            code, said = self.run_on(name, samples, step)
            self.assertEqual(code, 2, said)
            self.assertTrue(said.strip())


class C(Reader, unittest.TestCase):
    source = "check_vector.c"


class Cpp(Reader, unittest.TestCase):
    source = "check_vector.cpp"


class Rust(Reader, unittest.TestCase):
    source = "check_vector.rs"


class Python(Reader, unittest.TestCase):
    source = "check_vector.py"


class JavaScript(Reader, unittest.TestCase):
    source = "check_vector.mjs"


class Folder(unittest.TestCase):
    def test_has_a_reader_for_each_language(self):
        self.assertEqual({path.name for path in READERS.glob("check_vector.*")}, set(LANGUAGES))


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=[sys.argv[0]])
