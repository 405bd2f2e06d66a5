"""What the lines of the program `peers` (and scipy_peer.py) say, as tables, a page and a chart."""
import math

BANDS = ["≥ 1e-4", "1e-6 to 1e-4", "1e-8 to 1e-6", "1e-10 to 1e-8", "1e-12 to 1e-10"]
COST = ["peer", "tolerance", "longest step [s]", "time per impact, tautline = 1", "worst error, first impact [s]",
        "median error [s]", "impacts followed"]
MISSED = ["peer", "tolerance", "longest step [s]", *(f"depth {band} m" for band in BANDS), "missed in all"]


def number(text, none):
    """A number as a table shows it; `none` where it is zero."""
    value = float(text)
    return none if value == 0 else "–" if math.isinf(value) else f"{value:.2g}"


class Results:
    def __init__(self, lines, missing):
        self.missing = missing
        self.peers, self.cost, self.missed = [], [], []
        for line in lines:
            kind, *words = line.split("\t")
            if kind == "problems":
                self.motions, self.most, self.arcs, self.seed = words
            else:
                {"peer": self.peers, "cost": self.cost, "missed": self.missed}[kind].append(words)

    def cost_rows(self):
        for name, tolerance, step, ratio, _, first, median, followed, count in self.cost:
            factor = float(ratio)
            yield [name, number(tolerance, "none"), number(step, "own choice"),
                   f"{factor:.1f}" if factor < 100 else f"{factor:.0f}", number(first, "0"), number(median, "0"),
                   f"{followed} of {count}"]

    def missed_rows(self):
        for name, tolerance, step, *counts in self.missed:
            lost, there = [int(n) for n in counts[0::2]], [int(n) for n in counts[1::2]]
            yield [name, number(tolerance, "none"), number(step, "own choice"),
                   *(f"{a} of {b}" for a, b in zip(lost, there)), f"{sum(lost)} of {sum(there)}"]

    def text(self):
        """For a terminal."""
        return (plain(COST, self.cost_rows()) + "\n\n" + "Grazing flights whose impact was missed\n"
                + plain(["peer", "tolerance", "step", *BANDS, "in all"], self.missed_rows()))

    def page(self, arcs, rounds, machine):
        versions = "\n".join(f"- **{name}**, {version}: {method}." for name, version, method in self.peers)
        absent = "".join(f"\n- {line}" for line in self.missing)
        return PAGE.format(
            arcs=arcs, rounds=rounds, machine=machine, versions=versions + absent, motions=self.motions,
            most=self.most, seed=self.seed, cost=markdown(COST, self.cost_rows()),
            impacts=self.cost[0][-1], missed=markdown(MISSED, self.missed_rows()))

    def chart(self):
        """Median error over time per impact, both logarithmic, as SVG."""
        points = [(name, float(step), float(ratio), max(float(median), 1e-16))
                  for name, _, step, ratio, _, _, median, *_ in self.cost if not math.isinf(float(median))]
        names = [peer[0] for peer in self.peers]
        right = math.ceil(math.log10(max(point[2] for point in points)))
        low, high = -16, math.ceil(math.log10(max(point[3] for point in points)))

        def across(ratio):
            return 60 + 480 * math.log10(ratio) / right

        def down(error):
            return 330 - 300 * (math.log10(error) - low) / (high - low)

        parts = []
        for power in range(0, right + 1):
            x = across(10.0 ** power)
            parts.append(f'<path d="M{x:.0f} 30V330" class="grid"/><text x="{x:.0f}" y="348" '
                         f'text-anchor="middle">{10 ** power}</text>')
        for power in range(low, high + 1, 2):
            y = down(10.0 ** power)
            parts.append(f'<path d="M60 {y:.0f}H540" class="grid"/><text x="54" y="{y + 4:.0f}" '
                         f'text-anchor="end">1e{power}</text>')
        for name, step, ratio, error in points:
            colour = COLOURS[names.index(name)]
            fill = colour if step > 0 or name == names[0] else "white"
            parts.append(f'<circle cx="{across(ratio):.1f}" cy="{down(error):.1f}" r="5" stroke="{colour}" '
                         f'fill="{fill}"/>')
        for row, name in enumerate(names):
            y = 40 + 20 * row
            parts.append(f'<circle cx="560" cy="{y}" r="5" stroke="{COLOURS[row]}" fill="{COLOURS[row]}"/>'
                         f'<text x="572" y="{y + 4}">{name}</text>')
        return CHART.format(body="\n".join(parts))


def plain(head, rows):
    rows = [head, *rows]
    widths = [max(len(row[column]) for row in rows) for column in range(len(head))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows)


def markdown(head, rows):
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * len(head), *rows])


COLOURS = ["#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"]  # Okabe and Ito's

CHART = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 660 390" font-family="sans-serif" font-size="12">
<title>Error and cost of an impact</title>
<style>.grid {{ stroke: #ccc; }} circle {{ stroke-width: 2; }}</style>
<rect width="660" height="390" fill="white"/>
{body}
<text x="300" y="372" text-anchor="middle">time per impact, tautline = 1</text>
<text x="60" y="18">median error of impact times [s]; open: steps of the peer's own choice, full: at most 0.01 s</text>
</svg>
"""

PAGE = """# Compared with libraries that locate events

tautline finds every impact in the second table, and the libraries that integrate in steps miss most of the shallow ones. The
first table compares the error and the cost of an impact. `scripts/bench-peers --arcs {arcs} --rounds {rounds} --write` makes
this page. Each figure comes from one run on one machine ({machine}). Times are processor times, as ratios to tautline's in
the same round, and medians of {rounds} rounds.

{versions}

All libraries have the same motion and Newton's law for impacts, so the tables compare detection and integration. CVODE,
Odeint and SciPy get the analytic rate of the state. Siconos and Simbody compute it from mass and force, as they do for a
system of many bodies. CVODE, Odeint and Simbody call the same function for an impact. The same compiler, with the release
flags, compiles everything in C and C++. SciPy's times include Python, in which rate, gaps and impact are written; its ratio
is to tautline's median. "Longest step" is the limit on the step that each library offers for this purpose.

## Error and cost

The table is about {motions} shipped cases on one or two cables with a slack start. It counts their first impacts, at most
{most} of each case and {impacts} in all, as long as flights last more than 2 ms. The right instants come from the same doubles
in 40 digits. A library *follows* an impact if it follows all before it, has the right cables and is off by less than 1 ms.
tautline's time is the time of `solve`, with its list of arcs and events. The time of a library is the time of the whole run,
with its set-up for a case.

{cost}

![Error and cost of an impact](peers.svg)

A flight is a polynomial of second degree and a steady turn. A Runge-Kutta method of fifth order integrates it without an
error at any step. So the errors say little about other problems, and a long step is cheap. The next table shows the
price of a long step.

## Impacts that are missed

The table counts missed impacts in {arcs} flights (seed {seed}; Siconos and Simbody fly the first 10000, SciPy 1000). In each
flight the one cable is once too long by 1e-12 to 1e-2 of its length, and then slack again. So each flight has an impact: the
gap is positive at the start, and negative at a known instant, by the depth in the table's head. An impact is missed if nothing
is located nearer to that instant than the time that the gap is below zero.

An integrator looks for a change of sign between its steps, so it misses what begins and ends within one step. A limit on the
step makes this rarer, at its price, but no limit prevents it. tautline's search steps by a bound of the gap's third
derivative and cannot pass a root ([the mathematics](../../analytic/README.md), section 3).

{missed}
"""
