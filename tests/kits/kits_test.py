"""The kits of engines/protocol: how long they are, what they say, and that their examples keep every claim.

  kits_test.py Sizes|Python|C PROGRAM [EXAMPLE]    EXAMPLE: the example in C, built
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
KITS = ROOT / "engines/protocol"
MOST_OF_A_KIT = 100     # lines of a source of a kit
MOST_OF_AN_ENGINE = 60  # lines of one's own, as the tutorial says

PROGRAM, EXAMPLE = None, None

CASE = {"name": "ball", "duration": 10, "gravity": [0, -1], "body": {"mass": 1, "inertia": 0.4},
        "cables": [{"anchor": [0, 2], "attachment": [0, 0], "length": 2, "restitution": 0.5}],
        "initial": {"position": [0, 0.5], "angle": 0, "velocity": [0, 0], "spin": 0}}


def lines(path):
    return len(path.read_text(encoding="utf-8").splitlines())


class Child:
    """An engine that is asked one message after the other."""

    def __init__(self, command, folder):
        self.process = subprocess.Popen(command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.count = 0

    def ask(self, method, **params):
        self.count += 1
        self.process.stdin.write(json.dumps({"jsonrpc": "2.0", "id": self.count, "method": method, "params": params}) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        assert answer["id"] == self.count and answer["jsonrpc"] == "2.0", answer
        return answer

    def start(self, case):
        return self.ask("start", case=case, model="row", step=1e-2, law="simultaneous")

    def end(self):
        self.process.stdin.close()
        printed = self.process.stderr.read()
        rest = self.process.stdout.read()
        self.process.stdout.close()
        self.process.stderr.close()
        return self.process.wait(10), rest, printed


class Sizes(unittest.TestCase):
    def test_an_engine_takes_sixty_lines_of_its_own(self):
        examples = [path for path in KITS.glob("*/example/*") if path.suffix in (".py", ".c", ".mjs")]
        self.assertGreaterEqual(len(examples), 2)
        for path in examples:
            self.assertLessEqual(lines(path), MOST_OF_AN_ENGINE, path)

    def test_a_source_of_a_kit_takes_a_hundred_lines(self):
        kits = [path for pattern in ("python/*.py", "javascript/*.mjs", "c/*.h") for path in KITS.glob(pattern)]
        self.assertEqual(len(kits), 8)
        for path in kits:
            self.assertLessEqual(lines(path), MOST_OF_A_KIT, path)


class Kit:
    """What every example must do; `child` starts it and `engine_file` is its engine.toml."""

    def test_keeps_every_claim(self):
        done = subprocess.run([PROGRAM, "check", self.engine_file()], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("every claim holds for this model", done.stdout)

    def test_carries_every_number(self):
        child = self.child()
        case = json.loads(json.dumps(CASE))
        numbers = [5e-324, -0.0, 1.7976931348623157e308, 0.1, 1 / 3, -2.5]
        case["initial"] = {"position": numbers[0:2], "angle": numbers[2], "velocity": numbers[3:5], "spin": numbers[5]}
        state = child.start(case)["result"]["state"]
        self.assertEqual([x.hex() for x in map(float, state)], [x.hex() for x in numbers])
        case["initial"].update(position=["NaN", "Infinity"], velocity=["-Infinity", "-0"])
        state = child.start(case)["result"]["state"]
        self.assertEqual(state[0:2] + [state[3]], ["NaN", "Infinity", "-Infinity"])
        self.assertEqual(math.copysign(1, state[4]), -1)
        self.assertEqual(child.end()[0], 0)

    def test_answers_errors_and_goes_on(self):
        child = self.child()
        self.assertIn("error", child.ask("step", dt=0.1, count=1))
        self.assertEqual(child.ask("dance")["error"]["code"], -32601)
        self.assertIn("error", child.ask("start", case=CASE, model="none", step=1e-2, law="simultaneous"))
        self.assertEqual(child.start(CASE)["result"]["state"], [0, 0.5, 0, 0, 0, 0])
        steps = child.ask("step", dt=1e-2, count=3)["result"]["steps"]
        self.assertEqual([len(row) for row in steps], [7, 7, 7])
        self.assertEqual(child.end()[0:2], (0, ""))

    def test_interpolates_a_restitution_over_the_speed(self):
        # the fall hits at 1 m/s, within a step
        for table, least, most in [([[0.5, 0.2], [1.5, 0.6]], 0.38, 0.42), ([[2, 0.3], [3, 0.9]], 0.29, 0.31),
                                   ([[0.1, 0.9], [0.5, 0.7]], 0.69, 0.71)]:
            case = dict(CASE, cables=[dict(CASE["cables"][0], restitution=table)])
            child = self.child()
            child.start(case)
            rows = child.ask("step", dt=1e-2, count=120)["result"]["steps"]
            hit = next(k for k, row in enumerate(rows) if row[6] > 0)
            restitution = -rows[hit][4] / rows[hit - 1][4]
            self.assertTrue(least <= restitution <= most, (table, restitution))
            child.end()


class Python(Kit, unittest.TestCase):
    FOLDER = KITS / "python/example"

    def engine_file(self):
        return self.FOLDER / "engine.toml"

    def child(self, code=None):
        arguments = ["-c", code] if code else ["engine.py"]
        return Child(["env", f"PYTHONPATH={KITS / 'python'}", "PYTHONDONTWRITEBYTECODE=1", sys.executable, *arguments],
                     self.FOLDER)

    def test_keeps_standard_output_for_the_protocol(self):
        child = self.child("import os, tautline_engine\n"
                           "class Row:\n"
                           "    info = {'name': 'row'}\n"
                           "    def __init__(self, case, step, law):\n"
                           "        print('from Python'); os.write(1, b'from a library\\n')\n"
                           "        raise tautline_engine.Unsupported('two cables')\n"
                           "tautline_engine.serve([Row], name='noisy', version='1', precision='float64')\n")
        self.assertEqual(child.start(CASE)["error"], {"code": -32602, "message": "unsupported: two cables"})
        code, rest, printed = child.end()
        self.assertEqual((code, rest), (0, ""))
        self.assertIn("from Python", printed)
        self.assertIn("from a library", printed)

    def test_tells_that_a_run_stops(self):
        child = self.child("import tautline_engine\n"
                           "class Row:\n"
                           "    info, stopped, count = {'name': 'row'}, None, 0\n"
                           "    def __init__(self, case, step, law): pass\n"
                           "    def state(self): return [0.0] * 6\n"
                           "    def step(self, dt):\n"
                           "        self.count += 1\n"
                           "        if self.count == 3: self.stopped = {'time': 0.2, 'reason': 'enough'}\n"
                           "        return [0.0]\n"
                           "tautline_engine.serve([Row], name='short', version='1', precision='float64')\n")
        child.start(CASE)
        result = child.ask("step", dt=0.1, count=5)["result"]
        self.assertEqual(len(result["steps"]), 2)
        self.assertEqual(result["stopped"], {"time": 0.2, "reason": "enough"})
        child.end()


class C(Kit, unittest.TestCase):
    def engine_file(self):
        """Its engine.toml, and what it starts, as they lie beside each other where the example was built."""
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        (folder / "build").mkdir()
        (folder / "build/engine").symlink_to(EXAMPLE)
        shutil.copy(KITS / "c/example/engine.toml", folder)
        return folder / "engine.toml"

    def child(self):
        return Child([EXAMPLE], None)


if __name__ == "__main__":
    name, PROGRAM, *rest = sys.argv[1:]
    EXAMPLE = rest[0] if rest else None
    unittest.main(argv=[sys.argv[0], name])
