#!/usr/bin/env python3
"""Draws the pictures of docs/guides/python.md: runs each example and writes its figure as SVG, for light and dark pages.
Writes the examples into the guide, too.

  PYTHONPATH=build/dev/languages/python pictures.py [NAME...]    such as: settling. `draws` takes a minute
"""
import io
import pathlib
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = HERE / "examples"
GUIDE = HERE.parents[1] / "docs/guides/python.md"
GOAL = GUIDE.with_suffix("")
GREY = "#7a7a7a"  # is read on white and on black
COLOURS = ["#2f81c7", "#d0722b", "#2f9e5b", "#b358b3", "#a58a1f", "#d25353", "#3aa3a3", "#8a78d6"]
STYLE = {"axes.prop_cycle": plt.cycler(color=COLOURS), "axes.spines.top": False, "axes.spines.right": False, "font.size": 11,
         "figure.figsize": (7, 4.2), "figure.autolayout": True, "svg.fonttype": "none", "svg.hashsalt": "tautline",
         "font.family": "sans-serif", "font.sans-serif": ["Helvetica", "Arial", "DejaVu Sans"], "legend.framealpha": 0,
         "savefig.transparent": True, "path.simplify_threshold": 0.3,
         **{f"{part}.{kind}": GREY for part, kind in (("text", "color"), ("axes", "edgecolor"), ("axes", "labelcolor"),
                                                      ("xtick", "color"), ("ytick", "color"))}}
GROUP = re.compile(r"((?:\s*<use [^>]*/>){10,})")
USE = re.compile(r'<use xlink:href="#(\w+)" x="([\d.-]+)" y="([\d.-]+)" style="fill: (#\w+)')
EXAMPLE = re.compile(r"(<!-- example: (\w+) -->\n```python\n).*?```\n", re.DOTALL)


def points(group):
    """One path of dots in place of an element for each. A dot has the size of its marker, and of its edge of 1."""
    found = USE.findall(group[1])
    radius = re.search(rf'id="{found[0][0]}" d="M 0 ([\d.]+)', group.string)[1]
    path = "".join(f"M{float(x):.1f} {float(y):.1f}h0" for _, x, y, _ in found)
    return (f'\n<path d="{path}" style="fill:none;stroke:{found[0][3]};stroke-width:{2 * float(radius) + 1:.1f};'
            'stroke-linecap:round"/>')


def svg(title):
    """The current figure, in few bytes."""
    text = io.StringIO()
    plt.gcf().savefig(text, format="svg", metadata={"Date": None, "Creator": None})
    picture = re.sub(r"\s*<metadata>.*?</metadata>", f"\n <title>{title}</title>", text.getvalue(), flags=re.DOTALL)
    picture = GROUP.sub(points, picture)
    picture = re.sub(r"(-?\d+\.\d{2})\d+", r"\1", picture)
    return re.sub(r" +$", "", re.sub(r"\n +", "\n", picture), flags=re.MULTILINE)


def run(name, changes=()):
    """Runs an example, with other numbers where a test asks for them; its figure is then matplotlib's current one."""
    text = (EXAMPLES / f"{name}.py").read_text(encoding="utf-8")
    for old, new in changes:
        if old not in text:
            raise ValueError(f"examples/{name}.py has no {old!r}")
        text = text.replace(old, new)
    names = {"__name__": name}
    with plt.rc_context(STYLE):
        plt.figure()
        exec(compile(text, f"examples/{name}.py", "exec"), names)  # pylint: disable=exec-used
    return names


def guide():
    """The guide with the examples as they are."""
    def filled(found):
        return found[1] + (EXAMPLES / f"{found[2]}.py").read_text(encoding="utf-8") + "```\n"
    return EXAMPLE.sub(filled, GUIDE.read_text(encoding="utf-8"))


def main(names):
    GUIDE.write_text(guide(), encoding="utf-8")
    GOAL.mkdir(exist_ok=True)
    for name in names or sorted(path.stem for path in EXAMPLES.glob("*.py")):
        plt.close("all")
        title = run(name)["__doc__"].strip()
        with plt.rc_context(STYLE):
            picture = svg(title)
        (GOAL / f"{name}.svg").write_text(picture, encoding="utf-8")
        print(f"{name}.svg: {len(picture) // 1000} kB")


if __name__ == "__main__":
    main(sys.argv[1:])
