"""Many exact motions at a time."""
from __future__ import annotations

import ctypes
import operator
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _library
from ._case import _SHORT, Case, unknown_quantity
from ._library import C, SettlingNumbers, Summary, address, doubles, shown
from ._motion import options_of

_AT_A_TIME = 1 << 16  # motions between two looks at Ctrl-C


def sweep(case: Case, vary: Mapping[str, npt.ArrayLike], *, times: npt.ArrayLike = (), settling: bool = False,
          threads: int = 0, law: str = "simultaneous", until_locked: bool = False, swing_ahead: bool = False,
          completion_error: float | None = None, completion_speed: float | None = None,
          completion_margin: float | None = None, max_events: int | None = None,
          max_steps: int | None = None) -> dict[str, npt.NDArray[Any]]:
    """The exact motions of many variations of `case`, with the same bits as `solve` gives one by one.

    vary: the values of each quantity that varies (`case.quantities`), in arrays that numpy can broadcast: `{"restitution":
    np.linspace(0, 1, 100)}`. The results have their shape.
    times: [s], >= 0; "states" has the states at them
    threads: 0: one for each processor
    The other options are those of `solve`.

    The dict has an array for each of these keys:
    solved: false where the case cannot be, such as a start beyond the end of a cable; all else is then NaN, 0 and ""
    ending, end_time [s], events, impacts, arcs, accumulations (counts), start_energy, end_energy [J],
    taut (of each cable, at the end), repeat_start, repeat_period [s], repeat_turn [rad]: as of a motion; NaN: none
    states (with `times`): for each time x, y [m], angle [rad], vx, vy [m/s], spin [rad/s]; NaN after the end
    and with `settling`, which takes half as long again, in the meaning and units of `Settling` and `Swing`:
    settling_time, settling_uncertainty, settling_cables, permanent, rests, last_impact_speed, last_impact_time,
    swings, goes_round, angle_of_cable, swing_energy, swing_period, swing_least, swing_largest, swing_amplitude,
    swing_tension
    """
    if not isinstance(case, Case):
        raise TypeError(f"case: must be a Case, is {shown(case)}")
    options = options_of(law, until_locked=until_locked, swing_ahead=swing_ahead, completion_error=completion_error,
                         completion_speed=completion_speed, completion_margin=completion_margin, max_events=max_events,
                         max_steps=max_steps)
    base = case._sound()
    threads = operator.index(threads)
    if not 0 <= threads <= _library.MOST_OF_INT32:
        raise ValueError(f"threads {threads} must be 0, for one on each processor, or above")
    at = _times(times)
    names, values, shape = _variations(case, vary)

    count, width = len(values), int(C["coordinates"](base))
    summaries: npt.NDArray[Any] = np.zeros(count, np.dtype(Summary))
    settlings: npt.NDArray[Any] = np.zeros(count if settling else 0, np.dtype(SettlingNumbers))
    states = np.empty((count, at.size, width)) if at.size else None
    for first in range(0, count, _AT_A_TIME):
        part = slice(first, first + _AT_A_TIME)
        summaries["size"][part] = summaries.itemsize
        settlings["size"][part] = settlings.itemsize
        _library.check(C["sweep_varied"](
            base, names, len(names), address(values[part]), len(values[part]), options and ctypes.byref(options), threads,
            address(at), at.size, address(summaries[part]), address(settlings[part]) if settling else None,
            None if states is None else address(states[part]), None))

    cables = len(case.cables)
    solved = summaries["status"] == _library.OK
    found: dict[str, npt.NDArray[Any]] = {"solved": solved}
    found["ending"] = np.where(solved, np.array(_library.ENDINGS)[summaries["ending"]], "")
    found["taut"] = _library.flags(summaries["taut"], cables)
    for name in Summary.names()[4:]:
        found[name] = np.ascontiguousarray(summaries[name])
    if settling:
        found["settling_cables"] = _library.flags(settlings["cables"], cables)
        for name in ("permanent", "rests", "swings", "goes_round", "angle_of_cable"):
            found[name] = settlings[name] != 0
        for name in SettlingNumbers.names()[8:]:
            key = "settling_" + name if name in ("time", "uncertainty") else name
            found[key] = np.ascontiguousarray(settlings[name])
    if states is not None:
        found["states"] = states
    return {name: column.reshape(shape + column.shape[1:]) for name, column in found.items()}


def _times(times: npt.ArrayLike) -> _library.Doubles:
    at = doubles("times", times).reshape(-1)
    wrong = np.flatnonzero(~((at >= 0.0) & (at < np.inf)))
    if wrong.size:
        raise ValueError(f"times[{wrong[0]}] = {float(at[wrong[0]])!r} must be at least 0 and finite")
    return at


def _variations(case: Case, vary: Mapping[str, npt.ArrayLike]) -> tuple[Any, _library.Doubles, tuple[int, ...]]:
    """The names for the library, a row of values for each case, and the shape of all of them."""
    known = case.quantities
    for name in vary:
        if not isinstance(name, str) or _SHORT.get(name, name) not in known:
            raise ValueError(unknown_quantity(str(name), known, known))
        word, _, index = name.rpartition("_")
        of_cable = case.cables[int(index):int(index) + 1] if index.isdecimal() else case.cables
        Case._refuse_table(word if index.isdecimal() else name, of_cable)
    arrays = [doubles(name, values) for name, values in vary.items()]
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in zip(vary, arrays))
        raise ValueError(f"the arrays have shapes that do not fit each other: {shapes}") from None
    rows = int(np.prod(shape, dtype=np.int64))
    values = np.empty((rows, len(arrays)))
    for place, array in enumerate(arrays):
        values[:, place] = np.broadcast_to(array, shape).reshape(-1)
    return (ctypes.c_char_p * len(arrays))(*(name.encode() for name in vary)), values, shape
