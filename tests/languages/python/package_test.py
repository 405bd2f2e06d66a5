#!/usr/bin/env python3
"""The Python package: cases as values, motions with the program's bits, and what is refused."""
import concurrent.futures
import copy
import ctypes
import gc
import json
import os
import pathlib
import pickle
import random
import re
import resource
import subprocess
import sys
import tempfile
import unittest

import support
from support import COMPILER, PROGRAM, ROOT, output

import numpy as np
import tautline as tl
from tautline import _library

STANDARD = tl.Case.shipped("breakwater/1910121100")
BALL = tl.Case.shipped("bouncing-ball").but(duration=2.7)


def random_case(dice):
    """A body on 1 to 4 cables that are slack at its start."""
    x, y, angle = dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-0.5, 0.5)
    cables = []
    for _ in range(dice.randint(1, 4)):
        attachment = (dice.uniform(-0.3, 0.3), dice.uniform(-0.3, 0.3))
        anchor = (dice.uniform(-2, 2), dice.uniform(1, 3))
        at = (x + np.cos(angle) * attachment[0] - np.sin(angle) * attachment[1],
              y + np.sin(angle) * attachment[0] + np.cos(angle) * attachment[1])
        distance = np.hypot(anchor[0] - at[0], anchor[1] - at[1])
        table = [(0.1, dice.random()), (0.7, dice.random())] if dice.random() < 0.3 else ()
        cables.append(tl.Cable(anchor=anchor, attachment=attachment, length=distance * dice.uniform(1.001, 1.4),
                               restitution=dice.random(), restitution_table=table,
                               capture_speed=dice.choice([0.0, 0.0, 1e-3])))
    return tl.Case(name="random", duration=dice.uniform(1, 8), gravity=(dice.uniform(-0.3, 0.3), -1.0),
                   mass=dice.uniform(0.5, 2), inertia=dice.uniform(0.01, 0.1), cables=cables,
                   initial=tl.State(position=(x, y), angle=angle, velocity=(dice.uniform(-0.3, 0.3), 0.1),
                                    spin=dice.uniform(-0.5, 0.5)),
                   angle_limit=dice.choice([None, 3.0]), ceiling=dice.choice([None, 2.0]))


class Cases(unittest.TestCase):
    def test_are_values(self):
        twin = copy.deepcopy(STANDARD)
        self.assertEqual((twin, hash(twin)), (STANDARD, hash(STANDARD)))
        self.assertNotEqual(STANDARD.but(x=0.2), STANDARD)
        self.assertEqual(STANDARD.but(x=0.2).but(x=0.1), STANDARD)
        self.assertEqual({STANDARD: 1}[twin], 1)
        self.assertEqual(eval(repr(STANDARD), vars(tl)), STANDARD)  # pylint: disable=eval-used
        tl.solve(twin)  # with the library's copy in it
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            again = pickle.loads(pickle.dumps(twin, protocol))
            self.assertEqual((again, tl.solve(again).end_energy), (twin, tl.solve(twin).end_energy))
        with self.assertRaises(AttributeError):
            STANDARD.mass = 2.0

    def test_lists_and_other_numbers_become_tuples_of_doubles(self):
        cable = tl.Cable(anchor=[0, np.float32(2)], length=np.int64(2), restitution=1, restitution_table=[[0, 1], [1, 0]])
        case = tl.Case(duration=1, gravity=np.array([0.0, -1.0]), cables=[cable])
        self.assertEqual((cable.anchor, cable.length, cable.restitution_table), ((0.0, 2.0), 2.0, ((0.0, 1.0), (1.0, 0.0))))
        self.assertEqual((case.gravity, case.cables, type(case.duration)), ((0.0, -1.0), (cable,), float))
        hash(case)

    def test_what_is_no_number_or_pair_is_named(self):
        for wrong, words in [(lambda: STANDARD.but(mass="1"), "mass: must be a number, is '1'"),
                             (lambda: STANDARD.but(mass=True), "mass: must be a number, is True"),
                             (lambda: STANDARD.but(gravity=1), "gravity: must be two numbers, is 1"),
                             (lambda: STANDARD.but(position=(1, 2, 3)), r"position: must be two numbers, is \(1, 2, 3\)"),
                             (lambda: STANDARD.but(cables=3), "cables: must be a list, is 3"),
                             (lambda: STANDARD.but(cables=[3]), "cables: must be a list of Cable, has 3"),
                             (lambda: STANDARD.but(initial=3), "initial: must be a State, is 3"),
                             (lambda: STANDARD.but(name=3), "name: must be text, is 3"),
                             (lambda: STANDARD.but(velocity=(1, None)), "velocity: must be a number, is None"),
                             (lambda: tl.solve("standard.toml"), "case: must be a Case, is 'standard.toml'"),
                             (lambda: tl.Case.from_toml(7), "a path or text|expected str, bytes or os.PathLike object")]:
            with self.assertRaisesRegex(TypeError, words):
                wrong()
        with self.assertRaisesRegex(ValueError, "mass: 1000.* must fit a double"):
            STANDARD.but(mass=10**400)
        with self.assertRaisesRegex(ValueError, "mass: a large int must fit a double"):
            STANDARD.but(mass=10**5000)

    def test_but_takes_fields_quantities_and_short_names(self):
        case = STANDARD.but(restitution=0.5, length_1=1.6, x=0.3, vy=-0.2, velocity_x=0.4, spin=1, duration=3, gravity_x=0.1,
                            name="other", ceiling=2)
        self.assertEqual([cable.restitution for cable in case.cables], [0.5, 0.5])
        self.assertEqual([cable.length for cable in case.cables], [1.5, 1.6])
        self.assertEqual(case.initial, tl.State(position=(0.3, 0.1), velocity=(0.4, -0.2), spin=1))
        self.assertEqual((case.duration, case.gravity, case.name, case.ceiling), (3.0, (0.1, -1.0), "other", 2.0))
        for name in STANDARD.quantities:
            self.assertNotEqual(STANDARD.but(**{name: 0.77}), STANDARD, name)
        with self.assertRaisesRegex(ValueError, "'lenght' is no number of this case; did you mean length.* It has x, y"):
            STANDARD.but(lenght=1)
        with self.assertRaisesRegex(ValueError, "'length_2' is no number"):
            STANDARD.but(length_2=1)

    def test_a_table_of_restitution_is_not_passed_over(self):
        case = STANDARD.but(restitution_table=[(0.1, 0.9), (1, 0.5)])
        for wrong in (lambda: case.but(restitution=0.5), lambda: case.but(restitution_0=0.5),
                      lambda: tl.sweep(case, {"restitution": [0.5]}), lambda: tl.sweep(case, {"restitution_1": [0.5]})):
            with self.assertRaisesRegex(ValueError, "a cable has a restitution_table, which replaces it"):
                wrong()
        self.assertEqual(case.but(restitution_table=(), restitution=0.9), STANDARD)

    def test_text_reads_back_bit_for_bit(self):
        dice = random.Random(1)
        for case in [*(tl.Case.shipped(name) for name in tl.shipped_cases()), *(random_case(dice) for _ in range(50))]:
            self.assertEqual(case.problems, ())
            self.assertEqual(tl.Case.from_toml(case.to_toml()), case)
            self.assertEqual(tl.Case.from_json(case.to_json()), case)

    def test_text_and_paths_are_told_apart(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text, read in (("ä b.toml", BALL.to_toml(), tl.Case.from_toml), ("c.json", BALL.to_json(), tl.Case.from_json)):
                path = pathlib.Path(folder, name)
                path.write_text(text, encoding="utf-8")
                self.assertEqual((read(path), read(str(path))), (BALL, BALL))
            with self.assertRaisesRegex(FileNotFoundError, "not here.toml"):
                tl.Case.from_toml(f"{folder}/not here.toml")
            with self.assertRaises(FileNotFoundError):
                tl.Case.from_toml("")
            with self.assertRaises(IsADirectoryError):
                tl.Case.from_toml(folder)
            path.write_bytes(b"name = \"\xff\"\n")
            with self.assertRaisesRegex(ValueError, "c.json"):
                tl.Case.from_toml(path)
            with self.assertRaisesRegex(ValueError, "^/dev/zero: is longer than 1048576 bytes$"):
                tl.Case.from_toml("/dev/zero")

    def test_text_is_refused_with_the_sentences_of_the_program(self):
        text = STANDARD.to_toml().replace("length = 1.5", "length = -1\nlenght = 3", 1).replace("mass = 1.0", "")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "wrong.toml")
            path.write_text(text, encoding="utf-8")
            with self.assertRaises(ValueError) as refused:
                tl.Case.from_toml(path)
            done = subprocess.run([PROGRAM, "solve", path], capture_output=True, text=True, check=False)
        self.assertEqual(len(str(refused.exception).splitlines()), 3)
        for sentence in str(refused.exception).splitlines():
            self.assertIn("".join(sentence.split()), "".join(done.stderr.split()))

    def test_names_in_any_script(self):
        for name in ("Größe", "浮桥", "мост", "🌉", "a\nb", " "):
            case = BALL.but(name=name)
            self.assertEqual(tl.Case.from_toml(case.to_toml()).name, name)
            self.assertIn(name, repr(tl.solve(case)))
        for name, words in (("\ud800", "name: must be text in UTF-8"), ("", "name: must be text in UTF-8 that is not empty")):
            with self.assertRaisesRegex(ValueError, words):
                tl.solve(BALL.but(name=name))
        with self.assertRaisesRegex(ValueError, r"name: 'a\\x00b' must have no zero character"):
            BALL.but(name="a\0b")

    def test_a_taut_start_is_moved_and_said(self):
        cable = tl.Cable(anchor=(0, 1), length=1.0, restitution=0.5, taut=True)
        case = tl.Case(duration=1, gravity=(0, -1), cables=[cable], initial=tl.State(position=(0.6, 0.2000001)))
        self.assertRegex(case.notes[0], "cable 0 starts taut: the start changes its position by")
        self.assertTrue(tl.solve(case).taut(0.0)[0])
        written = tl.Case.from_toml(case.to_toml())
        self.assertTrue((tl.solve(written)([0, 0.5, 1]) == tl.solve(case)([0, 0.5, 1])).all())
        read = tl.Case.from_toml(case.to_toml().replace("restitution = 0.5", "restitution = 0.5\ntaut = true")
                                 .replace(repr(written.initial.position[0]), "0.6"))
        self.assertRegex(read.notes[0], "cable 0 starts taut")
        self.assertEqual(STANDARD.notes, ())

    def test_shipped_ones_are_those_of_the_program(self):
        sys.path.append(str(ROOT / "languages/python"))
        import make_cases
        self.assertEqual(make_cases.GOAL.read_text(encoding="utf-8"), make_cases.cases_text(PROGRAM))
        with self.assertRaisesRegex(ValueError, "'bouncing-bal' is not shipped; did you mean bouncing-ball"):
            tl.Case.shipped("bouncing-bal")

    def test_gaps_of_any_states(self):
        self.assertEqual(BALL.gaps([0, 0.5, 0, 0, -1, 0]).tolist(), [0.5])
        self.assertEqual(BALL.gap_rates([[[0, 0.5, 0, 0, -1, 0]] * 2]).tolist(), [[[-1.0]] * 2])
        self.assertEqual((BALL.coordinates, BALL.units), (("x", "y", "angle", "vx", "vy", "spin"),
                                                          ("m", "m", "rad", "m/s", "m/s", "rad/s")))
        for wrong in ([1, 2, 3], 4.0):
            with self.assertRaisesRegex(ValueError, r"states: has the shape .*, must end with 6 coordinates"):
                BALL.gaps(wrong)


class Motions(unittest.TestCase):
    def same_as_program(self, case, law="simultaneous"):
        """Every number of `tautline solve --json`, to the last bit."""
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "case.toml").write_text(case.to_toml(), encoding="utf-8")
            output(PROGRAM, "solve", "./case.toml", "--law", law, "--json", "out.json", cwd=folder)
            told = json.loads(pathlib.Path(folder, "out.json").read_text(encoding="utf-8"))
        motion = tl.solve(case, law=law)
        self.assertEqual((motion.ending, motion.end_time), (told["ending"], told["end_time"]))
        self.assertEqual((motion.start_energy, motion.end_energy), (told["energy"]["start"], told["energy"]["end"]))

        def row(state):
            return [*state["position"], state["angle"], *state["velocity"], state["spin"]]

        def by_cable(numbers, cables):
            return [numbers[cables.index(cable)] if cable in cables else 0.0 for cable in range(len(case.cables))]

        events, errors, rows = motion.events, motion.events.errors, told["events"]
        self.assertEqual(events.time.tolist(), [one["time"] for one in rows])
        self.assertEqual(events.kind.tolist(), [one["kind"] for one in rows])
        self.assertEqual([np.flatnonzero(one).tolist() for one in events.cables], [one["cables"] for one in rows])
        self.assertEqual(events.before.tolist(), [row(one["before"]) for one in rows])
        self.assertEqual(events.after.tolist(), [row(one["after"]) for one in rows])
        self.assertEqual(np.maximum(events.impulses, 0).tolist(), [by_cable(one["impulses"], one["cables"]) for one in rows])
        for place, one in enumerate(rows):
            if one["errors"] is None:
                self.assertTrue(np.isnan(errors.time[place]))
            else:
                self.assertEqual(errors.time[place], one["errors"]["time"])
                self.assertEqual(errors.before[place].tolist(), row(one["errors"]["before"]))
                self.assertEqual(errors.after[place].tolist(), row(one["errors"]["after"]))
                self.assertEqual(errors.impulses[place].tolist(), by_cable(one["errors"]["impulses"], one["cables"]))
        self.assertEqual(motion(motion.end_time).tolist(), row(told["end_state"]))
        self.assertEqual(motion.accumulations.start.tolist(), [one["start"] for one in told["accumulations"]])
        self.assertEqual(motion.accumulations.limit.tolist(), [one["time"] for one in told["accumulations"]])
        self.assertEqual(motion.unsure.start.tolist(), [one["from"] for one in told["unsure"]])
        self.assertEqual(motion.horizon, told["unsure"][0]["from"] if told["unsure"] else None)
        settling, lock = motion.settling, told["settling"]["lock"]
        self.assertEqual([list(one) for one in settling.last_impacts],
                         [[one["speed"], one["time"]] for one in told["settling"]["last_impacts"]])
        self.assertEqual(settling.time, lock and lock["time"])
        if lock:
            self.assertEqual((list(settling.cables), settling.permanent, settling.rests),
                             (lock["cables"], lock["permanent"], lock["rests"]))
            self.assertEqual(settling.swing and settling.swing.period, lock["swing"] and lock["swing"]["period"])

    def test_have_the_bits_of_the_program(self):
        for name in tl.shipped_cases():
            with self.subTest(name):
                self.same_as_program(tl.Case.shipped(name))

    def test_of_random_cases_have_the_bits_of_the_program(self):
        dice = random.Random(7)
        for number in range(24):
            with self.subTest(number):
                self.same_as_program(random_case(dice), tl.LAWS[number % 4])

    def test_are_known_in_closed_form(self):
        motion = tl.solve(BALL)  # falls 0.5 m at 1 m/s^2, and rebounds with half the speed each time
        self.assertEqual(motion.impacts.time.tolist(), [1.0, 2.0, 2.5])
        self.assertEqual(motion(0.5).tolist(), [0.0, 0.375, 0.0, 0.0, -0.5, 0.0])
        self.assertEqual(motion.energy([0.5, 1.5]).tolist(), [0.5, 0.125])
        self.assertEqual(motion.kinetic_energy(0.5) + motion.potential_energy(0.5), 0.5)
        rest = tl.solve(BALL.but(duration=10))
        self.assertEqual((rest.ending, rest.settling.time, rest.tensions(5.0).tolist()), ("rest", 3.0, [1.0]))
        self.assertEqual(rest.taut([1.5, 5]).tolist(), [[False], [True]])
        self.assertEqual((rest.settling.cables, rest.settling.rests, rest.settling.swing), ((0,), True, None))

    def test_take_times_of_any_shape_and_order(self):
        motion = tl.solve(BALL)
        self.assertEqual(motion(1).shape, (6,))
        self.assertEqual(motion([2, 0, 1]).shape, (3, 6))
        self.assertEqual(motion(np.zeros((2, 3))).shape, (2, 3, 6))
        self.assertEqual((motion([]).shape, motion.tensions([]).shape, motion.energy([]).shape), ((0, 6), (0, 1), (0,)))
        times = np.linspace(0, 2.7, 28)
        whole = motion(times)
        self.assertTrue((motion(times[::-3]) == whole[::-3]).all())
        self.assertTrue((motion(np.asfortranarray(times.reshape(4, 7))) == whole.reshape(4, 7, 6)).all())
        self.assertTrue((motion(times.astype(">f8")) == whole).all())
        self.assertTrue((motion.errors([0.5]) < 1e-13).all() and (motion.energy_errors([0.5]) < 1e-13).all())

    def test_a_time_outside_is_named(self):
        motion = tl.solve(BALL)
        for function in (motion, motion.tensions, motion.energy, motion.taut, motion.errors, motion.energy_errors):
            with self.assertRaisesRegex(ValueError, r"^times\[1, 0\] = 2.75 is outside of the motion, which lasts from 0 to 2.7 s$"):
                function([[0, 1], [2.75, 3]])
        for time in (-1e-300, float("nan"), float("inf"), -float("inf")):
            with self.assertRaisesRegex(ValueError, f"^time {time!r} is outside of the motion"):
                motion(time)
        for wrong in ("1", 1j, None, [True], [object()], np.datetime64("2020-01-01")):
            with self.assertRaisesRegex(TypeError, "times: must be real numbers, is"):
                motion(wrong)

    def test_events_are_columns_that_do_not_change(self):
        motion = tl.solve(STANDARD)
        events, impacts = motion.events, motion.impacts
        self.assertEqual(len(impacts), np.count_nonzero(events.kind == "impact"))
        self.assertIs(motion.events, events)
        with self.assertRaises(ValueError):
            events.time[0] = 1
        hit = events.where(events.cables[:, 0] & (events.time < 2))
        self.assertTrue(hit.cables[:, 0].all() and (hit.time < 2).all() and len(hit) > 3)
        self.assertTrue((hit.errors.time == events.errors.time[events.cables[:, 0] & (events.time < 2)]).all())
        self.assertTrue((hit.before[:, :3] == hit.after[:, :3]).all())
        columns = events.columns(errors=True)
        self.assertEqual({column.shape for column in columns.values()}, {(len(events),)})
        self.assertTrue((columns["before_vx"] == events.before[:, 3]).all() and "impulse_1_error" in columns)
        with self.assertRaisesRegex(ValueError, "kind: 'hit' must be one of impact, taut, slack"):
            events.where("hit")
        self.assertRegex(repr(events), rf"^<{len(events)} events: {len(impacts)} impact, \d+ taut, \d+ slack>$")
        self.assertEqual(repr(motion), f"<Motion of breakwater/1910121100: {len(impacts)} impacts, reached_duration at t = 20 s>")
        self.assertEqual(len(motion.arcs), len(motion.arcs.taut))

    def test_outlive_their_parts_and_pickle(self):
        motion = tl.solve(STANDARD, law="poisson", max_events=30)
        again = pickle.loads(pickle.dumps(motion))
        self.assertEqual((again.ending, motion.ending), ("event_limit", "event_limit"))
        self.assertTrue((again.events.after == motion.events.after).all())
        events = tl.solve(STANDARD).events  # whose motion is gone
        gc.collect()
        self.assertEqual(len(events.errors.time), len(events))

    def test_options_and_cases_that_cannot_be(self):
        with self.assertRaises(ValueError) as refused:
            tl.solve(STANDARD, law="newton", completion_error=0, completion_speed=-1, completion_margin=float("nan"), max_events=0,
                     max_steps=2**31)
        self.assertEqual(len(str(refused.exception).splitlines()), 6, refused.exception)
        self.assertIn("law: 'newton' must be one of simultaneous, poisson, sequential, energetic", str(refused.exception))
        for wrong in ({"max_events": 1.5}, {"completion_error": "1"}):
            with self.assertRaises(TypeError):
                tl.solve(STANDARD, **wrong)
        with self.assertRaises(AttributeError):
            tl.solve(STANDARD).case = BALL
        with self.assertRaises(ValueError) as refused:
            tl.solve(STANDARD.but(mass=-1, length_0=float("nan"), restitution_1=2, x=float("inf")))
        sentences = str(refused.exception).splitlines()
        self.assertGreaterEqual(len(sentences), 4)
        for start in ("body: mass -1", "cable 0: length nan", "cable 1: restitution 2"):
            self.assertTrue(any(one.startswith(start) for one in sentences), sentences)
        for cables in ((), STANDARD.cables * 5):
            with self.assertRaisesRegex(ValueError, f"cables: {len(cables)} given; a case has 1 to 8"):
                tl.solve(STANDARD.but(cables=cables))

    def test_an_option_does_what_it_says(self):
        self.assertEqual(tl.solve(STANDARD, until_locked=True).ending, "locked")
        ahead = tl.solve(STANDARD, until_locked=True, swing_ahead=True)
        self.assertIsNotNone(ahead.settling.swing.tension)
        self.assertEqual(len(tl.solve(STANDARD, max_events=5).events), 5)
        fewer, all_of_them = (len(tl.solve(BALL.but(duration=10), completion_speed=speed).impacts) for speed in (0.1, None))
        self.assertLess(fewer, all_of_them / 2)
        self.assertIsNone(tl.solve(BALL).repetition)
        swing = tl.solve(tl.Case.shipped("caught-swing").but(duration=100))
        again = swing.repetition
        later = swing(again.start + 0.5 + again.period * np.arange(20)) - swing(again.start + 0.5)
        self.assertLess(np.abs(later[:, [0, 1, 3, 4, 5]]).max(), 1e-12)
        self.assertLess(np.abs(later[:, 2] - again.turn * np.arange(20)).max(), 1e-12)


class Sweeps(unittest.TestCase):
    def test_have_the_bits_of_solve(self):
        e, times = np.linspace(0.1, 0.9, 40), [0.0, 3.0, 19.0]
        swept = tl.sweep(STANDARD, {"restitution": e, "x": 0.1}, times=times, settling=True, until_locked=True)
        for place, one in enumerate(e):
            motion = tl.solve(STANDARD.but(restitution=one), until_locked=True)
            known = [time for time in times if time <= motion.end_time]
            self.assertTrue((swept["states"][place, :len(known)] == motion(known)).all())
            self.assertTrue(np.isnan(swept["states"][place, len(known):]).all())
            settling = motion.settling
            self.assertEqual((swept["ending"][place], swept["end_time"][place], swept["impacts"][place]),
                             (motion.ending, motion.end_time, len(motion.impacts)))
            self.assertEqual((swept["settling_time"][place], swept["last_impact_time"][place, 1]),
                             (settling.time, settling.last_impacts[1][1]))
            self.assertEqual(tuple(np.flatnonzero(swept["settling_cables"][place])), settling.cables)

    def test_are_the_same_in_any_number_of_threads(self):
        x = np.linspace(0, 0.1, 300)
        one = tl.sweep(STANDARD, {"x": x}, threads=1, times=[4.0])
        for threads in (0, 2, 5):
            other = tl.sweep(STANDARD, {"x": x}, threads=threads, times=[4.0])
            self.assertTrue(all((one[name] == other[name]).all() for name in ("states", "events", "ending", "end_energy")))

    def test_broadcast(self):
        swept = tl.sweep(BALL, {"y": [[0.5], [0.4]], "restitution_0": [0.1, 0.5, 0.9]}, times=[1.0, 2.0])
        self.assertEqual((swept["ending"].shape, swept["states"].shape, swept["taut"].shape), ((2, 3), (2, 3, 2, 6), (2, 3, 1)))
        self.assertEqual(swept["states"][1, 2, 1].tolist(), tl.solve(BALL.but(y=0.4, restitution=0.9))(2.0).tolist())
        self.assertEqual(tl.sweep(BALL, {})["end_time"].shape, ())
        self.assertEqual(tl.sweep(BALL, {"x": []}, times=[1.0])["states"].shape, (0, 1, 6))
        self.assertNotIn("states", tl.sweep(BALL, {"x": 0.0}))

    def test_a_case_that_cannot_be_does_not_stop_the_others(self):
        swept = tl.sweep(BALL, {"y": [0.5, -1.0, float("nan")]}, times=[1.5], settling=True)
        self.assertEqual(swept["solved"].tolist(), [True, False, False])
        self.assertEqual(swept["ending"].tolist(), ["reached_duration", "", ""])
        self.assertTrue(np.isnan(swept["states"][1:]).all() and np.isnan(swept["end_energy"][1:]).all())

    def test_what_is_refused(self):
        for wrong, words in [
                (lambda: tl.sweep(BALL, {"z": [1]}), "'z' is no number of this case"),
                (lambda: tl.sweep(BALL, {"x\0": [1]}), "is no number of this case"),
                (lambda: tl.sweep(BALL, {"x": [1, 2], "y": [1, 2, 3]}), r"do not fit each other: x \(2,\), y \(3,\)"),
                (lambda: tl.sweep(BALL, {"x": [0]}, threads=-1), "threads -1 must be 0"),
                (lambda: tl.sweep(BALL, {"x": [0]}, threads=2**40), "threads 1099511627776 must be 0"),
                (lambda: tl.sweep(BALL, {"x": [0]}, times=[0, -1]), r"times\[1\] = -1.0 must be at least 0 and finite"),
                (lambda: tl.sweep(BALL, {"x": [0]}, times=float("nan")), r"times\[0\] = nan must be"),
                (lambda: tl.sweep(BALL, {"x": [0]}, law="x"), "law: 'x' must be one of"),
                (lambda: tl.sweep(BALL.but(mass=0), {"x": [0]}), "body: mass 0 must be")]:
            with self.assertRaisesRegex(ValueError, words):
                wrong()
        with self.assertRaisesRegex(TypeError, "x: must be real numbers, is"):
            tl.sweep(BALL, {"x": ["0"]})


class Library(unittest.TestCase):
    def test_structs_are_those_of_the_header(self):
        lines, expected = [], []
        for name, struct in _library.STRUCTS.items():
            lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
            expected.append(f"{name} {ctypes.sizeof(struct)}")
            for member in struct.names():
                lines.append(f'printf("{member} %zu %zu\\n", offsetof({name}, {member}), sizeof((({name}*)0)->{member}));')
                expected.append(f"{member} {getattr(struct, member).offset} {getattr(struct, member).size}")
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder, "layout.c")
            source.write_text("#include <stdio.h>\n#include <tautline/tautline.h>\nint main(void) {\n" + "\n".join(lines)
                              + "\nreturn 0; }\n")
            output(COMPILER, "-std=c99", f"-I{ROOT}/languages/c/include", source, "-o", f"{folder}/layout")
            self.assertEqual(output(f"{folder}/layout").splitlines(), expected)

    def test_functions_and_members_are_those_of_the_header(self):
        header = (ROOT / "languages/c/include/tautline/tautline.h").read_text(encoding="utf-8")
        for name, struct in _library.STRUCTS.items():
            body = re.sub(r"/\*.*?\*/", "", re.search(rf"typedef struct {name} {{(.*?)}}", header, re.DOTALL)[1], flags=re.DOTALL)
            self.assertEqual(tuple(re.findall(r"(\w+)(?:\[\d\])?;", body)), struct.names())
        for name, (_, arguments) in _library._FUNCTIONS.items():
            prototype = re.search(rf"TAUTLINE_API [^;(]*\btautline_{name}\(([^)]*)\);", header)[1]
            self.assertEqual(len(arguments), 0 if prototype == "void" else prototype.count(",") + 1, name)
        self.assertEqual(tl.__version__, re.search(r"project\(tautline VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1])

    def test_threads_solve_side_by_side(self):
        alone = tl.solve(STANDARD).events
        def work(_):
            motion = tl.solve(STANDARD)
            return (motion.events.after == alone.after).all(), motion.horizon
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertEqual(set(pool.map(work, range(100))), {(True, tl.solve(STANDARD).horizon)})
        shared = tl.solve(STANDARD)  # one motion in four threads
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            found = list(pool.map(lambda _: (shared.horizon, shared(7.0).tolist(), len(shared.impacts)), range(40)))
        self.assertEqual(found, [found[0]] * 40)

    def test_memory_stays_where_it_was(self):
        def resident():
            return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()
        def work(count):
            for number in range(count):
                case = BALL.but(x=1e-9 * number)
                motion = tl.solve(case)
                motion.events.where("impact")
        work(2000)
        gc.collect()
        gc.disable()  # nothing may wait for it
        try:
            before = resident()
            work(20000)
            self.assertLess(resident() - before, 4e6)  # a motion alone takes 2 kB, so a leak of all is 40 MB
        finally:
            gc.enable()

    def test_missing_memory_is_a_memory_error(self):
        for status, error in ((_library.OUT_OF_MEMORY, MemoryError), (10, RuntimeError)):
            with self.assertRaises(error):
                _library.check(status)

    def test_a_library_of_another_version_is_refused(self):
        program = "import tautline._library as l; l.VERSION = (0, 2); l._functions()"
        with self.assertRaisesRegex(AssertionError, "ImportError: libtautline.so.0 has version 0.1, must have 0.2"):
            output(sys.executable, "-c", program, env={**os.environ, "PYTHONPATH": str(support.PACKAGES)})


if __name__ == "__main__":
    support.main()
