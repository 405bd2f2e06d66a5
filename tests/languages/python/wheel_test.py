#!/usr/bin/env python3
"""The wheel: it promises what its libraries need, holds what it lists, installs without a network, and is typed."""
import base64
import csv
import hashlib
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

import support
from support import PACKAGES, ROOT, output

sys.path.append(str(ROOT / "languages/python"))
import make_wheel

VERSION = re.search(r"project\(tautline VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.make("first"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def make(cls, where, package=PACKAGES / "tautline"):
        return output(sys.executable, ROOT / "languages/python/make_wheel.py", package, VERSION,
                      f"{cls.folder.name}/{where}", env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}).strip()

    def test_the_tag_promises_what_the_libraries_need(self):
        promised = tuple(map(int, re.search(r"-py3-none-manylinux_(\d+)_(\d+)_x86_64\.whl$", self.path.name).groups()))
        self.assertEqual(promised, (2, 34))
        with zipfile.ZipFile(self.path) as wheel, tempfile.TemporaryDirectory() as folder:
            libraries = [name for name in wheel.namelist() if ".so" in name]
            self.assertEqual(libraries, ["tautline/libtautline.so.0", "tautline/libtautline_normal.so"])
            for name in libraries:
                library = wheel.extract(name, folder)
                symbols = output("objdump", "-T", library)
                versions = [tuple(map(int, found.split("."))) for found in re.findall(r"\(GLIBC_([0-9.]+)\)", symbols)]
                self.assertLessEqual(max(versions), promised, name)
                shown = re.findall(r"^\w+ g    D[FO] \.\w+\s+\w+\s+(?:TAUTLINE_0|Base)\s+(\S+)$", symbols, re.MULTILINE)
                self.assertTrue(shown and all(one.startswith("tautline_") for one in shown), shown)
                needed = set(re.findall(r"NEEDED\s+(\S+)", output("objdump", "-p", library)))
                self.assertLessEqual(needed, {"libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6", "ld-linux-x86-64.so.2"})
                self.assertNotIn(".debug_info", output("objdump", "-h", library))

    def test_a_library_that_needs_more_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "needs glibc .*, the tag .* promises"):
            before, make_wheel.GLIBC = make_wheel.GLIBC, (2, 2)
            try:
                make_wheel.library_bytes(PACKAGES / "tautline/libtautline.so.0")
            finally:
                make_wheel.GLIBC = before

    def test_the_same_files_give_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = shutil.copytree(PACKAGES / "tautline", f"{folder}/tautline")  # elsewhere, at another time
            for path in pathlib.Path(copy).iterdir():
                os.utime(path, (1, 1))
            again = self.make("second", copy)
        self.assertEqual(pathlib.Path(again).read_bytes(), self.path.read_bytes())

    def test_its_record_is_right_and_its_licences_are_there(self):
        with zipfile.ZipFile(self.path) as wheel:
            self.assertIsNone(wheel.testzip())
            names = wheel.namelist()
            info = f"tautline-{VERSION}.dist-info"
            rows = list(csv.reader(wheel.read(f"{info}/RECORD").decode().splitlines()))
            self.assertEqual([row[0] for row in rows], names)
            for name, digest, size in rows[:-1]:
                content = wheel.read(name)
                made = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                self.assertEqual((digest, size), (f"sha256={made}", str(len(content))))
            self.assertIn("Eigen", wheel.read(f"{info}/THIRD_PARTY.md").decode())
            sources = {f"tautline/{path.name}" for path in (ROOT / "languages/python/src/tautline").iterdir() if path.is_file()}
            self.assertEqual({name for name in names if not name.startswith(info) and ".so" not in name}, sources)
            self.assertLess(self.path.stat().st_size, 1_000_000)

    def test_installs_without_a_network_and_serves_each_python(self):
        """A venv of the Python of this test, and those at PATH's other pythons whose numpy can be imported."""
        with tempfile.TemporaryDirectory() as folder:
            venv = f"{folder}/venv"
            if importlib.util.find_spec("ensurepip") is None:
                self.skipTest("no ensurepip here (Debian's python3-venv)")
            output(sys.executable, "-m", "venv", "--system-site-packages", venv)
            output(f"{venv}/bin/pip", "install", "--no-index", "--disable-pip-version-check", self.path)
            program = ("import numpy, tautline; case = tautline.Case.shipped('bouncing-ball')\n"
                       "print(tautline.__file__, tautline.solve(case.but(duration=2.7)).impacts.time.tolist())\n"
                       "print(tautline.draws('case = \"bouncing-ball\"\\ncount = 2\\n[[vary]]\\nquantities = [\"y\"]\\n"
                       "normal = 0.1').values['y'].shape)")
            told = output(f"{venv}/bin/python", "-c", program, cwd=folder)
            self.assertRegex(told, rf"^{venv}/lib/.*/site-packages/tautline/__init__.py \[1.0, 2.0, 2.5\]\n\(2,\)\n$")
            self.assertIn(f"Version: {VERSION}\n", output(f"{venv}/bin/pip", "show", "tautline"))
            output(f"{venv}/bin/pip", "uninstall", "--yes", "tautline")

    def test_the_package_says_what_it_misses(self):
        """Where it lies without its libraries, as in the source."""
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(ROOT / "languages/python/src/tautline", f"{folder}/tautline", ignore=shutil.ignore_patterns("__pycache__"))
            done = subprocess.run([sys.executable, "-c", "import tautline"], cwd=folder, capture_output=True, text=True, check=False,
                                  env={**os.environ, "LD_LIBRARY_PATH": folder})
            if "ImportError" in done.stderr:  # the library is not installed on this machine
                self.assertRegex(done.stderr, "libtautline.so.0 cannot be loaded: .* Install the wheel, or Debian's libtautline0")
            shutil.copy(PACKAGES / "tautline/libtautline.so.0", folder)
            program = ("import tautline\ntry: tautline.draws('case = \"bouncing-ball\"\\n[[vary]]\\nquantities = [\"y\"]\\n"
                       "normal = 1')\nexcept ValueError as error: print(error)")
            told = output(sys.executable, "-c", program, cwd=folder, env={**os.environ, "LD_LIBRARY_PATH": folder})
            self.assertRegex(told, "^normal: the wheel has the library that draws such numbers")


class Types(unittest.TestCase):
    @unittest.skipUnless(shutil.which("mypy"), "no mypy here (Debian's mypy): the types are not checked")
    def test_are_strict(self):
        with tempfile.TemporaryDirectory() as folder:
            user = pathlib.Path(folder, "user.py")
            user.write_text("import numpy as np\nimport tautline as tl\n"
                            "motion: tl.Motion = tl.solve(tl.Case.shipped('bouncing-ball'), law='poisson')\n"
                            "height: float = float(motion(np.linspace(0, 1, 3))[0, 1])\n"
                            "reveal_type(motion.impacts.time)\nreveal_type(motion.horizon)\n")
            told = output("mypy", "--strict", "--python-version", "3.11", "--cache-dir", f"{folder}/cache",
                          ROOT / "languages/python/src/tautline", user, env={**os.environ, "MYPYPATH": str(ROOT / "languages/python/src")})
        self.assertIn("Success: no issues found", told)
        self.assertRegex(told, r'Revealed type is "numpy.ndarray\[Any, numpy.dtype\[numpy.floating')
        self.assertRegex(told, r'Revealed type is "Union\[builtins.float, None\]"')


class Documentation(unittest.TestCase):
    def test_every_public_name_says_what_it_is(self):
        import tautline as tl
        for name in tl.__all__:
            thing = getattr(tl, name)
            if isinstance(thing, tuple):
                continue
            self.assertTrue(thing.__doc__, name)
            for member, value in vars(thing).items() if isinstance(thing, type) else ():
                if not member.startswith("_") and (callable(value) or isinstance(value, (property, classmethod))):
                    self.assertTrue(value.__doc__, f"{name}.{member}")

    def test_every_field_of_doubles_has_a_unit(self):
        for path in (ROOT / "languages/python/src/tautline").glob("_*.py"):
            for line in path.read_text(encoding="utf-8").splitlines():
                if re.match(r"    \w+: (Doubles|Pair|float)\b", line):
                    self.assertRegex(line, r"#: .*(\[|the same|the other|likewise|in the units|of each)", f"{path.name}: {line}")


if __name__ == "__main__":
    support.main()
