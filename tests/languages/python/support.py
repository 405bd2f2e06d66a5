"""What the tests of the Python package share. They are run by CTest:

  NAME_test.py FOLDER PROGRAM COMPILER [TEST...]    FOLDER: of the package; the program `tautline`; a compiler of C
"""
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGES, PROGRAM, COMPILER = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
sys.path.insert(0, str(PACKAGES))
sys.dont_write_bytecode = True  # the folder becomes a wheel


def output(*command, **options):
    """What a command prints; an error shows what it said."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def main():
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
