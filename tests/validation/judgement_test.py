"""What scripts/judgement draws and counts.

  judgement_test.py SCRIPT BUILD
"""
import contextlib
import importlib.machinery
import importlib.util
import io
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import tomllib
import unittest
from unittest import mock

SCRIPT, BUILD = (pathlib.Path(word) for word in sys.argv[1:3])


def loaded(path):
    sys.dont_write_bytecode = True
    loader = importlib.machinery.SourceFileLoader("judgement", str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("judgement", loader))
    loader.exec_module(module)
    return module


judgement = loaded(SCRIPT)


def gap(cable, state):
    arm = judgement.turned(cable["attachment"], state["angle"])
    return cable["length"] - math.hypot(*(state["position"][i] + arm[i] - cable["anchor"][i] for i in range(2)))


def flown(case, state, time):
    """The state after a flight of `time` [s]."""
    return {"position": [state["position"][i] + time * state["velocity"][i] + 0.5 * time**2 * case["gravity"][i]
                         for i in range(2)],
            "angle": state["angle"] + time * state["spin"],
            "velocity": [state["velocity"][i] + time * case["gravity"][i] for i in range(2)], "spin": state["spin"]}


def report_run(model="row", engine="ode", step=0.001, case="one", **changed):
    """A run as a report has it, with nothing wrong unless `changed`."""
    judged = {"restitution": {"word": changed.get("word", "kept")}, "position": {"ratio": changed.get("ratio", 0.9)},
              "impacts": {"due": 4, "missed": changed.get("missed", 0)},
              "overstretch": changed.get("overstretch", 0.5), "energy": changed.get("energy", 0.5),
              "flight": changed.get("flight", 1e-9)}
    return {"case": case, "engine": engine, "model": model, "step": step, "judgement": judged,
            "verdict": {"word": "", "problems": changed.get("problems", [])}}


def runs_of(*runs):
    return list(judgement.runs_of({"runs": runs}))


def silently(function, *arguments):
    """What it returns, and what it prints."""
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        result = function(*arguments)
    return result, printed.getvalue()


class Drawing(unittest.TestCase):
    def test_cases_are_as_asked_and_the_same_for_a_seed(self):
        draw = random.Random(1)
        cases = [judgement.drawn_case(draw) for _ in range(300)]
        draw = random.Random(1)
        self.assertEqual(cases, [judgement.drawn_case(draw) for _ in range(300)])
        self.assertEqual({len(case["cables"]) for case in cases}, {1, 2, 3, 4})
        self.assertEqual({round(math.hypot(*case["gravity"]), 9) for case in cases}, {9.81, 1.0, 0.0})
        for case in cases:
            self.assertTrue(1.0 <= case["body"]["mass"] <= 200.0)
            read = tomllib.loads(judgement.toml(case, "drawn", 4.0))
            for cable in read["cables"]:
                self.assertGreater(gap(cable, read["initial"]), 0.0)

    def test_the_program_takes_the_cases(self):
        program = judgement.Program(BUILD)
        with tempfile.TemporaryDirectory() as folder:
            cases = judgement.draw_cases(program, 5, 3, 4.0, pathlib.Path(folder))
            self.assertEqual(sorted(pathlib.Path(folder).iterdir()), sorted(cases))
        self.assertEqual(len(cases), 5)
        self.assertTrue(all(judgement.impacts_of(exact) for exact in cases.values()))


class Counting(unittest.TestCase):
    def test_each_rule_calls_a_run_wrong_by_itself(self):
        for rule, changed in [("position", {"ratio": 2.1}), ("restitution", {"word": "off"}), ("missed", {"missed": 1}),
                              ("overstretch", {"overstretch": 2.1}), ("energy", {"energy": 1.1}), ("flight", {"flight": 0.01}),
                              ("verdict", {"problems": [{"kind": "events", "sentence": "off"}]})]:
            self.assertEqual([run.rules for run in runs_of(report_run(**changed))], [{rule}])
        for changed in [{}, {"ratio": None}, {"word": "too-few"}, {"ratio": 2.0}]:
            self.assertEqual([run.rules for run in runs_of(report_run(**changed))], [set()])

    def test_false_alarms_are_those_of_sound_models_alone(self):
        sound = [report_run(model) for model in ["row", "event", "moreau-jean-projected"] for _ in range(100)]
        missed, text = silently(judgement.print_sound, runs_of(*sound, report_run("contact", ratio=9.0),
                                                               report_run("row-sleeping", ratio=9.0),
                                                               report_run("cable", ratio=2.1, case="this")))
        self.assertEqual(missed, [])
        self.assertIn("called wrong: 1 of 301", text)
        self.assertEqual(text.count("false alarm"), 1)
        self.assertIn("false alarm: this, ode cable", text)
        missed, _ = silently(judgement.print_sound, runs_of(*sound[:99], report_run(ratio=2.1)))
        self.assertEqual(len(missed), 1)

    def test_a_fault_is_to_be_found_only_where_it_can_be_told(self):
        program = judgement.Program(BUILD)
        motions = {"bounces": program.exact("bouncing-ball", 8.0), "swings": program.exact("caught-swing", 4.0)}
        self.assertTrue(judgement.told("dead", motions["bounces"], 0.001))
        self.assertTrue(judgement.told("loses-third", motions["bounces"], 0.001))
        self.assertFalse(judgement.told("dead", motions["swings"], 0.001))  # e = 0
        not_found = [report_run("dead", judgement.PLANTED, case=case) for case in motions]
        missed, text = silently(judgement.print_faults, runs_of(*not_found), motions)
        self.assertEqual(len(missed), 1)
        self.assertIn("0 of 2 (0.0 %)  0 of 1 (0.0 %)", text)
        found = report_run("dead", judgement.PLANTED, case="bounces", word="none")
        self.assertEqual(silently(judgement.print_faults, runs_of(found, not_found[1]), motions)[0], [])

    def test_what_is_read_of_an_impact_is_that_of_its_gap(self):
        draw = random.Random(2)
        tick = 1e-4  # [s]
        for _ in range(20):
            case = judgement.drawn_case(draw)
            state, cable = case["initial"], case["cables"][0]
            gradient, _, acceleration = judgement.gap_motion(case, cable, state)
            earlier, now, later = (gap(cable, flown(case, state, time)) for time in (-tick, 0.0, tick))
            rate = sum(one * other for one, other in zip(gradient, [*state["velocity"], state["spin"]]))
            self.assertAlmostEqual(rate, (later - earlier) / (2.0 * tick), delta=1e-4 * (1.0 + abs(rate)))
            self.assertAlmostEqual(acceleration, (later - 2.0 * now + earlier) / tick**2,
                                   delta=1e-4 * (1.0 + abs(acceleration)))


class SafeSteps(unittest.TestCase):
    def test_the_steps_are_those_that_the_program_says(self):
        text = judgement.Program(BUILD).output("bench", "bouncing-ball", "--within", "1%", "--engines", "exact",
                                               "--models", "plain").stdout
        self.assertEqual(judgement.steps_from(text), (0.01, 0.02))
        self.assertEqual(judgement.steps_from("A step-by-step model needs steps of 1e-05 s.\n"), (1e-5, 1e-5))
        self.assertEqual(judgement.steps_from("For a step-by-step model any step up to 0.02 s does.\n"), (0.02, 0.02))
        self.assertIsNone(judgement.steps_from("A step-by-step model needs steps below 1e-05 s.\n"))

    def test_too_many_runs_over_and_too_small_steps_are_missed_targets(self):
        def missed(*used):
            return silently(judgement.print_safe, [judgement.AtStep("c", "e", "row", 0.01, one) for one in used])[0]

        self.assertEqual(missed(*[0.3] * 19, 1.1), [])
        self.assertEqual(missed(*[0.3] * 18, 1.1, math.inf), ["90.0 % hold, 95 % is the least"])
        self.assertEqual(missed(0.3, 0.2, 0.2), ["33.3 % come to a quarter, 50 % is the least"])

    def test_runs_are_compared_with_a_hundredth_of_the_shortest_cable(self):
        program = judgement.Program(BUILD)
        with tempfile.TemporaryDirectory() as folder:
            runs = list(judgement.runs_at(program, "bouncing-ball", 0.01, ["exact"], ["plain"], pathlib.Path(folder)))
        self.assertEqual([(run.engine, run.model, run.step) for run in runs], [("exact", "plain", 0.01)])
        self.assertTrue(0.1 < runs[0].used < 1.0, runs)


class Command(unittest.TestCase):
    def test_an_engine_without_runs_is_an_error(self):
        program = judgement.Program(BUILD)
        program.planted = BUILD / "tests/fixtures/tautline-engine-wrong-interface.so"
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(SystemExit) as ended:
            program.report(["bouncing-ball"], 1.0, ["exact"], "0.01", pathlib.Path(folder))
        self.assertIn("no runs of planted", str(ended.exception))

    def test_prints_its_tables_and_what_it_misses(self):
        done = subprocess.run([SCRIPT, "--count", "2", "--seed", "1", "--until", "2", "--no-shipped", "--engines", "exact",
                               BUILD], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        lines = done.stdout.splitlines()
        self.assertEqual(done.returncode, int(lines[-1].startswith("Missed: ")), done.stderr)
        self.assertEqual(lines[0], "2 random cases of seed 1")
        self.assertTrue(any(line.startswith("exact plain") for line in lines))
        self.assertRegex(done.stdout, r"\nless-bouncy at 0.001 s +2 of 2 ")
        self.assertTrue(done.returncode or lines[-1].startswith("All targets are reached"), lines[-1])

    def test_fails_if_a_fault_is_not_found_or_a_sound_model_is_called_wrong(self):
        exact = judgement.Program(BUILD).exact("bouncing-ball", 8.0)
        sound = [report_run() for _ in range(200)]
        for code, more in [(0, [report_run("dead", judgement.PLANTED, case="ball", word="none")]),
                           (1, [report_run("dead", judgement.PLANTED, case="ball")]),
                           (1, [report_run(ratio=2.1), report_run(ratio=2.1)])]:
            asked = judgement.options([str(BUILD)])
            with mock.patch.object(judgement, "options", lambda: asked), \
                    mock.patch.object(judgement, "measure", lambda *_: (runs_of(*sound, *more), {"ball": exact})):
                result, text = silently(judgement.main)
            self.assertEqual(result, code, text)
            self.assertEqual(text.splitlines()[-1].startswith("Missed: "), code == 1, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
