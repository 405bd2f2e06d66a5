"""An engine in a process of its own: `serve` answers tautline's messages until standard input ends.

The protocol is engines/protocol/README.md. A state is [x, y, angle, vx, vy, spin], a case and its cables are dicts.
"""
import json
import math
import os
import sys
from collections import namedtuple

# A cable as a one-sided row: an impulse along (nx, ny) at (px, py) raises its gap rate. The gap's gradient is
# (nx, ny, moment) [-, -, m]; gap [m]; rate [m/s], of the gap, negative when closing.
Row = namedtuple("Row", "px py nx ny moment gap rate")


def cable_row(cable, state):
    x, y, angle, vx, vy, spin = state
    (ax, ay), c, s = cable["attachment"], math.cos(angle), math.sin(angle)
    rx, ry = c * ax - s * ay, s * ax + c * ay  # [m], the arm
    dx, dy = cable["anchor"][0] - x - rx, cable["anchor"][1] - y - ry
    distance = math.hypot(dx, dy)
    nx, ny = (dx / distance, dy / distance) if distance else (0.0, 0.0)
    moment = rx * ny - ry * nx
    return Row(x + rx, y + ry, nx, ny, moment, cable["length"] - distance, nx * vx + ny * vy + moment * spin)


def restitution(cable, rate):
    """The restitution [-] of a cable whose gap closes at `rate` [m/s]: a number, or a table over the speed."""
    e, speed = cable["restitution"], abs(rate)
    if not isinstance(e, list):
        return e
    between = ((a, b) for a, b in zip(e, e[1:]) if a[0] <= speed < b[0])
    (v0, e0), (v1, e1) = next(between, (e[0], e[0]) if speed < e[0][0] else (e[-1], e[-1]))
    return e0 + (speed - v0) / (v1 - v0) * (e1 - e0) if v1 > v0 else e0


class Unsupported(Exception):
    """Raised where the engine cannot do what a case asks for; says what and why."""


def _mapped(value, change):  # with `change` of every number and text
    if isinstance(value, dict):
        return {key: _mapped(entry, change) for key, entry in value.items()}
    return [_mapped(entry, change) for entry in value] if isinstance(value, (list, tuple)) else change(value)


def _read(line):  # four texts stand for numbers that JSON has none for
    texts = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf, "-0": -0.0}
    return _mapped(json.loads(line), lambda entry: texts.get(entry, entry) if isinstance(entry, str) else entry)


def _written(answer):
    try:
        return json.dumps(answer, allow_nan=False, separators=(",", ":"))
    except ValueError:  # it has such a number
        names = {"nan": "NaN", "inf": "Infinity", "-inf": "-Infinity"}
        return json.dumps(_mapped(answer, lambda x: names.get(str(x), x) if isinstance(x, float) else x))


def _answer(engine, models, runs, method, params):
    if method == "info":
        return {"protocol": 2, **engine, "models": [model.info for model in models]}
    if method == "start":
        runs.clear()
        model = {model.info["name"]: model for model in models}[params["model"]]
        runs.append(model(*(params[key] for key in ("case", "step", "law", "parameters") if key in params)))
        told = {key: getattr(runs[0], key) for key in ("rounding", "soft") if hasattr(runs[0], key)}
        return {"state": runs[0].state(), **told}
    run, steps = runs[0], []  # empty before "start"
    if method != "step":
        result = getattr(run, method)(**params)
        return {"state": run.state(), **({"impulses": result} if method == "solve" else {})}
    for _ in range(params["count"]):
        impulses = run.step(params["dt"])
        if getattr(run, "stopped", None):
            return {"steps": steps, "stopped": run.stopped}
        steps.append([*run.state(), *impulses])
    return {"steps": steps}


def serve(models, **engine):
    """Serves an engine {name, version, precision} of `models`: classes with the `info` of the protocol, and objects,
    Model(case, step, law) or, where a run sets some, Model(case, step, law, parameters), that are runs. A run has state()
    and step(dt), which returns the impulse of each cable; or fly(dt), place(state) (place(state, time) in space) and
    solve(cables, rates), which returns impulses, and `rounding` where numbers are no float64. It may set `stopped`, and have `soft`."""
    protocol, sys.stdout = os.fdopen(os.dup(1), "w", encoding="utf-8"), sys.stderr
    os.dup2(2, 1)  # standard output is the protocol's, whatever a library prints
    runs = []
    for line in sys.stdin:
        request = _read(line)
        answer, method = {"jsonrpc": "2.0", "id": request["id"]}, request["method"]
        try:
            if method in ("info", "start", "step", "fly", "place", "solve"):
                answer["result"] = _answer(engine, models, runs, method, request.get("params", {}))
            else:
                answer["error"] = {"code": -32601, "message": f'no method "{method}"'}
        except Exception as error:  # the engine's own, or what it says
            code, kind = (-32602, "unsupported") if isinstance(error, Unsupported) else (-32000, type(error).__name__)
            answer["error"] = {"code": code, "message": f"{kind}: {error}"}
        print(_written(answer), file=protocol, flush=True)
