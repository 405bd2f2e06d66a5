"""A planar body in semi-implicit Euler, with a row for each overstretched cable. `Body` stands for your engine."""
from tautline_engine import cable_row, restitution, serve

CORRECTION = 0.2  # [-], the part of an overstretch that a step takes out
SWEEPS = 10000    # at most, until no rate changes by more than
ROUNDING = 1e-15  # [m/s]


class Body:
    def __init__(self, body, gravity, start):
        self.gravity = gravity
        self.inverse = [1 / body["mass"], 1 / body["mass"], 1 / body["inertia"] if body["inertia"] else 0]
        self.pose = [*start["position"], start["angle"]]
        self.velocity = [*start["velocity"], start["spin"]]

    def step(self, dt, rows, wanted):
        """Every row opens with its `wanted` rate or faster; returns the impulses."""
        impulses = [0.0] * len(rows)
        self.velocity = [v + dt * g for v, g in zip(self.velocity, [*self.gravity, 0])]
        for _ in range(SWEEPS):
            changes = [self.pull(k, rows, wanted, impulses) for k in range(len(rows))]
            if max(changes, default=0) <= ROUNDING:
                break
        self.pose = [q + dt * v for q, v in zip(self.pose, self.velocity)]
        return impulses

    def pull(self, k, rows, wanted, impulses):
        """Brings row k to its wanted rate by an impulse that is not below 0 in all; returns the change of rate."""
        gradient = rows[k].nx, rows[k].ny, rows[k].moment
        response = sum(m * g * g for m, g in zip(self.inverse, gradient))
        rate = sum(g * v for g, v in zip(gradient, self.velocity))
        before, impulses[k] = impulses[k], max(0.0, impulses[k] + (wanted[k] - rate) / response)
        change = impulses[k] - before
        self.velocity = [v + m * g * change for v, m, g in zip(self.velocity, self.inverse, gradient)]
        return abs(change) * response


class Row:
    info = {"name": "row", "sentence": "One row for each cable that is at its length.", "maker": "by_hand",
            "follows_speed": True, "tension": True, "settings": []}

    def __init__(self, case, step, law):
        self.cables, self.correction = case["cables"], CORRECTION / step
        self.body = Body(case["body"], case["gravity"], case["initial"])

    def state(self):
        return [*self.body.pose, *self.body.velocity]

    def step(self, dt):
        rows = [cable_row(cable, self.state()) for cable in self.cables]
        acting = [k for k, row in enumerate(rows) if row.gap <= 0]
        wanted = [max(restitution(self.cables[k], rows[k].rate) * -rows[k].rate, self.correction * -rows[k].gap)
                  for k in acting]
        impulses = self.body.step(dt, [rows[k] for k in acting], wanted)
        return [dict(zip(acting, impulses)).get(k, 0.0) for k in range(len(rows))]


serve([Row], name="python-example", version="1.0", precision="float64")
