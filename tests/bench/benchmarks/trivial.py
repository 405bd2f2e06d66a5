"""A child that costs next to nothing: a body that flies, in the fewest words that the protocol allows."""
import json
import sys

MODEL = {"name": "flight", "sentence": "It flies.", "maker": "by_hand"}
INFO = {"protocol": 1, "name": "trivial", "version": "1", "precision": "float64", "models": [MODEL]}


def start(params):
    global state, gravity
    initial, gravity = params["case"]["initial"], params["case"]["gravity"]
    state = [*initial["position"], initial["angle"], *initial["velocity"], initial["spin"]]
    return {"state": state}


def step(params):
    global state
    x, y, angle, vx, vy, spin = state
    dt, steps = params["dt"], []
    for _ in range(params["count"]):
        vx += dt * gravity[0]
        vy += dt * gravity[1]
        x += dt * vx
        y += dt * vy
        angle += dt * spin
        steps.append((x, y, angle, vx, vy, spin, 0.0, 0.0))
    state = [x, y, angle, vx, vy, spin]
    return {"steps": steps}


calls = {"info": lambda _: INFO, "start": start, "step": step}
encode = json.JSONEncoder(separators=(",", ":"), check_circular=False).encode
for line in sys.stdin:
    request = json.loads(line)
    result = calls[request["method"]](request.get("params"))
    sys.stdout.write(encode({"jsonrpc": "2.0", "id": request["id"], "result": result}) + "\n")
    sys.stdout.flush()
