#!/usr/bin/env python3
"""Writes src/tautline/cases.json, the cases that ship with the program, for `Case.shipped`.

  make_cases.py PROGRAM    PROGRAM: build/dev/bench/tautline
"""
import json
import pathlib
import subprocess
import sys
import tomllib

GOAL = pathlib.Path(__file__).resolve().with_name("src") / "tautline/cases.json"


def cases_text(program):
    """The text of the file: a line for each case."""
    def output(*words):
        return subprocess.run([program, "cases", *words], check=True, capture_output=True, text=True).stdout

    names = [line.split()[0] for line in output().split("\n\n")[0].splitlines()[1:] if not line.startswith(" ")]
    rows = [json.dumps(tomllib.loads(output(name))) for name in names]
    return "[\n" + ",\n".join(rows) + "\n]\n"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    GOAL.write_text(cases_text(sys.argv[1]), encoding="utf-8")
