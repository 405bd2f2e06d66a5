#!/usr/bin/env python3
"""Holds a report of schema 4 against one of schema 3 of the same suite: every number must be the same,
bit for bit, under its new name. What was redefined is told with the largest difference.

    same_numbers.py OLD/report.json NEW/report.json

Exit code 1 if a number differs that was not redefined.
"""
import json
import math
import sys

# Names of schema 3 and of schema 4, below a run; {w} is a window.
RENAMED = {
    "metrics/{w}/until": "details/{w}/until",
    "metrics/{w}/covered": "details/{w}/covered",
    "metrics/{w}/position_error": "metrics/{w}_position_error",
    "metrics/{w}/angle_error": "metrics/{w}_angle_error",
    "metrics/{w}/velocity_error": "metrics/{w}_velocity_error",
    "metrics/{w}/impacts/exact": "details/{w}/exact",
    "metrics/{w}/impacts/found": "details/{w}/found",
    "metrics/{w}/impacts/matched": "details/{w}/matched",
    "metrics/{w}/impacts/worst_time_error": "metrics/{w}_impact_error",
    "metrics/horizon/impacts/first_time_error": "metrics/first_impact_error",
    "metrics/settling/last_impacts": "details/last_impacts",
    "metrics/settling/later_impacts": "metrics/later_impacts",
    "metrics/settling/swing": "details/swing",
    "metrics/long_impacts": "metrics/long_impacts",
    "metrics/overstretch": "metrics/overstretch",
    "metrics/energy/largest_gain": "metrics/energy_gain",
    "metrics/energy/error": "metrics/energy_error",
    "metrics/restitution/count": "details/restitution/count",
    "metrics/restitution/smallest": "details/restitution/smallest",
    "metrics/restitution/mean": "details/restitution/mean",
    "metrics/restitution/largest": "details/restitution/largest",
    "metrics/restitution/worst_error": "metrics/restitution_error",
    "stride": "details/stride",
    "recorded_impacts": "details/recorded_impacts",
    "slow_impacts": "details/slow_impacts",
    "status": "status",
    "reason": "reason",
    "output_tail": "output_tail",
    "path": "path",
    "impacts": "impacts",
    "attribution": "attribution",
    "verdict": "verdict",
}
SUMMARY = {
    "cases": "cases",
    "failed": "failed",
    "early_position_error": "metrics/early_position_error",
    "horizon_position_error": "metrics/horizon_position_error",
    "impacts": "impacts",
    "settling/exact": "settled/exact",
    "settling/found": "settled/found",
    "worst_restitution_error": "metrics/restitution_error/worst",
    "overstretch": "metrics/overstretch/worst",
    "energy_gain": "metrics/energy_gain/worst",
}
# Computed otherwise since schema 3: by name, why.
REDEFINED = {
    "audit/scatter": "from all counted impacts and before rounding, not from the fastest 300 in six digits; "
                     "impacts share a velocity jump where their times are the same, not alike in six digits",
    "audit/ladder": "before rounding; of more than 300 bounces the first 300, not none",
    "findings": "before rounding; quantiles are linear between neighbours",
    "settling/error": "of the runs that did their work, as every median",
}
WINDOWS = ("early", "horizon", "whole")


def at(tree, path):
    for key in path.split("/"):
        if not isinstance(tree, dict) or key not in tree:
            return None
        tree = tree[key]
    return tree


def same(one, two):
    """Bit for bit; an integer may have become a float of the same value."""
    if isinstance(one, dict) and isinstance(two, dict):
        return one.keys() == two.keys() and all(same(one[key], two[key]) for key in one)
    if isinstance(one, list) and isinstance(two, list):
        return len(one) == len(two) and all(map(same, one, two))
    return one == two and isinstance(one, bool) == isinstance(two, bool)


def largest_difference(one, two):
    """Of numbers in the same place; infinite where the shapes differ."""
    if isinstance(one, dict) and isinstance(two, dict) and one.keys() == two.keys():
        return max((largest_difference(one[key], two[key]) for key in one), default=0.0)
    if isinstance(one, list) and isinstance(two, list) and len(one) == len(two):
        return max(map(largest_difference, one, two), default=0.0)
    if isinstance(one, (int, float)) and isinstance(two, (int, float)):
        return abs(one - two)
    return 0.0 if one == two else math.inf


def key_of(row):
    return tuple(row.get(key) for key in ("case", "engine", "model", "step"))


class Comparison:
    def __init__(self):
        self.numbers = 0
        self.differences = []
        self.redefined = {}

    def hold(self, where, one, two):
        self.numbers += 1
        if not same(one, two):
            self.differences.append(f"{where}: {json.dumps(one)[:120]} became {json.dumps(two)[:120]}")

    def redefine(self, name, one, two):
        changed, largest, total = self.redefined.get(name, (0, 0.0, 0))
        difference = largest_difference(one, two)
        if math.isinf(difference):
            self.differences.append(f"redefined {name}: {json.dumps(one)[:120]} became {json.dumps(two)[:120]}")
            difference = 0.0
        self.redefined[name] = (changed + (difference != 0.0), max(largest, difference), total + 1)

    def hold_rows(self, what, old, new, names):
        others = {key_of(row): row for row in new}
        if len(others) != len(old):
            self.differences.append(f"{what}: {len(old)} rows became {len(others)}")
        for row in old:
            other = others.get(key_of(row))
            if other is None:
                self.differences.append(f"{what}: {key_of(row)} is gone")
                continue
            for name, renamed in names:
                self.hold(f"{what} {key_of(row)} {name}", at(row, name), at(other, renamed))
            yield row, other


def main():
    old, new = (json.load(open(path, encoding="utf-8")) for path in sys.argv[1:3])
    comparison = Comparison()
    names = [(name.format(w=w), renamed.format(w=w)) for name, renamed in RENAMED.items()
             for w in (WINDOWS if "{w}" in name else ("",))]
    for row, other in comparison.hold_rows("runs", old["runs"], new["runs"], names):
        for window in WINDOWS if row["metrics"] else ():
            impacts = row["metrics"][window]["impacts"]
            found = other["details"][window]
            comparison.hold(f"missed {key_of(row)}", impacts["missed"], found["exact"] - found["matched"])
        for name in ("audit/scatter", "audit/ladder"):
            comparison.redefine(name, at(row, name), at(other, name))
    for row, other in comparison.hold_rows("summary", old["summary"], new["summary"], list(SUMMARY.items())):
        comparison.redefine("settling/error", row["settling"]["error"], at(other, "metrics/last_impact_error"))
    same_keys = lambda rows: [(name, name) for name in (rows[0] if rows else ())]
    for what, renamed in (("convergence", "convergence"), ("attribution_summary", "causes")):
        list(comparison.hold_rows(renamed, old[what], new[renamed], same_keys(old[what])))
    untitled = [{key: value for key, value in row.items() if key != "title"} for row in new["cases"]]
    comparison.hold("cases", old["cases"], untitled)  # titles are new
    comparison.hold("options", old["options"], new["options"])
    by_kind = lambda rows: {(row["engine"], row["model"], row["kind"]): row for row in rows}
    one, two = by_kind(old["findings"]), by_kind(new["findings"])
    for key in sorted(one.keys() | two.keys()):
        comparison.redefine("findings", at(one.get(key), "value"), at(two.get(key), "value"))
        if key not in one or key not in two:
            print("finding", *key, "is", "new" if key not in one else "gone")
    for name, (changed, largest, total) in comparison.redefined.items():
        print(f"redefined {name}: {changed} of {total} differ, by up to {largest:.2g} ({REDEFINED[name]})")
    for line in comparison.differences[:50]:
        print("DIFFERS", line)
    print(f"{comparison.numbers} entries compared, {len(comparison.differences)} differ")
    return 1 if comparison.differences else 0


if __name__ == "__main__":
    sys.exit(main())
