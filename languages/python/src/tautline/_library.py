"""The functions of libtautline.so, which tautline.h describes, by ctypes."""
from __future__ import annotations

import ctypes
import pathlib
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

Doubles = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]

#: Major and minor version of the library that this package can call.
VERSION = (0, 1)

MOST_OF_INT32 = 2**31 - 1

_INT, _DOUBLE, _SIZE, _POINTER, _TEXT = (ctypes.c_int32, ctypes.c_double, ctypes.c_size_t, ctypes.c_void_p,
                                         ctypes.c_char_p)


def _members(kind: Any, names: str) -> list[tuple[str, Any]]:
    return [(name, kind) for name in names.split()]


class Struct(ctypes.Structure):
    """A struct of the library, whose `size` is to be set."""

    @classmethod
    def names(cls) -> tuple[str, ...]:
        """Its members in their order."""
        return tuple(member[0] for member in cls._fields_)


class CableNumbers(Struct):
    """`tautline_cable`."""

    _fields_ = [("size", _INT), ("taut", _INT), ("anchor", _DOUBLE * 2), ("attachment", _DOUBLE * 2),
                ("length", _DOUBLE), ("restitution", _DOUBLE), ("capture_speed", _DOUBLE), ("table_points", _INT),
                ("reserved", _INT)]


class CaseNumbers(Struct):
    """`tautline_planar_case`."""

    _fields_ = [("size", _INT), ("has", _INT), ("mass", _DOUBLE), ("inertia", _DOUBLE), ("gravity", _DOUBLE * 2),
                ("start", _DOUBLE * 6), ("duration", _DOUBLE), ("angle_limit", _DOUBLE), ("ceiling", _DOUBLE)]


class Options(Struct):
    """`tautline_options`."""

    _fields_ = [("size", _INT), ("law", _INT), ("completion_error", _DOUBLE), ("completion_speed", _DOUBLE),
                ("completion_margin", _DOUBLE), ("max_events", _INT), ("max_steps", _INT), ("until_locked", _INT),
                ("swing_ahead", _INT)]


class Summary(Struct):
    """`tautline_summary`."""

    _fields_ = [*_members(_INT, "size status ending taut events impacts arcs accumulations"),
                *_members(_DOUBLE, "end_time start_energy end_energy repeat_start repeat_period repeat_turn")]


class SettlingNumbers(Struct):
    """`tautline_settling`."""

    _fields_ = [*_members(_INT, "size cables permanent rests swings goes_round angle_of_cable reserved"),
                *_members(_DOUBLE, "time uncertainty"), *_members(_DOUBLE * 2, "last_impact_speed last_impact_time"),
                *_members(_DOUBLE, "swing_energy swing_period swing_least swing_largest swing_amplitude swing_tension")]


#: The C name of each struct.
STRUCTS: dict[str, type[Struct]] = {
    "tautline_cable": CableNumbers, "tautline_planar_case": CaseNumbers, "tautline_options": Options,
    "tautline_summary": Summary, "tautline_settling": SettlingNumbers}

# each function with the type of its result and of its arguments
_FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "version": (_TEXT, []),
    "version_number": (_INT, []),
    "status_text": (_TEXT, [_INT]),
    "law_name": (_TEXT, [_INT]),
    "event_kind_name": (_TEXT, [_INT]),
    "ending_name": (_TEXT, [_INT]),
    "case_from_numbers": (_POINTER, [_POINTER, _POINTER, _SIZE, _POINTER, _SIZE, _TEXT]),
    "case_from_text": (_POINTER, [_TEXT, _SIZE, _TEXT]),
    "case_free": (None, [_POINTER]),
    "problems": (_SIZE, [_POINTER, _POINTER, _SIZE]),
    "notes": (_SIZE, [_POINTER, _POINTER, _SIZE]),
    "case_text": (_INT, [_POINTER, _INT, _POINTER, _SIZE, _POINTER]),
    "coordinates": (_SIZE, [_POINTER]),
    "coordinate_name": (_TEXT, [_POINTER, _SIZE]),
    "coordinate_unit": (_TEXT, [_POINTER, _SIZE]),
    "gaps": (_INT, [_POINTER, _POINTER, _SIZE, _POINTER, _POINTER]),
    "option_problems": (_SIZE, [_POINTER, _POINTER, _SIZE]),
    "solve": (_INT, [_POINTER, _POINTER, _POINTER]),
    "motion_free": (None, [_POINTER]),
    "summarise": (_INT, [_POINTER, _POINTER]),
    "states": (_INT, [_POINTER, _POINTER, _SIZE, _POINTER, _POINTER, _POINTER]),
    "tensions": (_INT, [_POINTER, _POINTER, _SIZE, _POINTER, _POINTER]),
    "energy": (_INT, [_POINTER, _POINTER, _SIZE, _POINTER, _POINTER, _POINTER, _POINTER]),
    "events": (_INT, [_POINTER, _SIZE, _SIZE] + [_POINTER] * 6),
    "arcs": (_INT, [_POINTER, _SIZE, _SIZE] + [_POINTER] * 3),
    "accumulations": (_INT, [_POINTER, _SIZE, _SIZE] + [_POINTER] * 5),
    "settle": (_INT, [_POINTER, _POINTER]),
    "horizon": (_INT, [_POINTER] * 4),
    "unsure": (_INT, [_POINTER, _SIZE, _SIZE] + [_POINTER] * 4),
    "event_errors": (_INT, [_POINTER, _SIZE, _SIZE] + [_POINTER] * 6),
    "state_errors": (_INT, [_POINTER, _POINTER, _SIZE, _POINTER, _POINTER, _POINTER]),
    "sweep_varied": (_INT, [_POINTER, _POINTER, _SIZE, _POINTER, _SIZE, _POINTER, _INT, _POINTER, _SIZE, _POINTER,
                            _POINTER, _POINTER, _POINTER]),
}

OK, BAD_CASE, BAD_TIME, OUT_OF_MEMORY = 0, 3, 5, 9


def load(name: str) -> ctypes.CDLL:
    """A shared library of this package; where the package lies without, the system's."""
    here = pathlib.Path(__file__).with_name(name)
    try:
        return ctypes.CDLL(str(here) if here.exists() else name)
    except OSError as error:
        raise ImportError(f"{name} cannot be loaded: {error}. Install the wheel, or Debian's libtautline0, on a system "
                          "with glibc 2.34 or later") from error


def _functions() -> dict[str, Callable[..., Any]]:
    library = load("libtautline.so.0")
    library.tautline_version_number.restype = _INT
    number = library.tautline_version_number()
    if (number // 10000, number // 100 % 100) != VERSION:
        raise ImportError(f"libtautline.so.0 has version {number // 10000}.{number // 100 % 100}, "
                          f"must have {VERSION[0]}.{VERSION[1]}")
    found: dict[str, Callable[..., Any]] = {}
    for name, (result, arguments) in _FUNCTIONS.items():
        function = getattr(library, "tautline_" + name)
        function.restype, function.argtypes = result, arguments
        found[name] = function
    return found


#: The functions by their names without `tautline_`.
C = _functions()


def _names(function: str) -> tuple[str, ...]:
    """The names of an enum, in the order of their values."""
    found: list[str] = []
    while (name := C[function](len(found))) is not None:
        found.append(name.decode())
    return tuple(found)


LAWS = _names("law_name")
KINDS = _names("event_kind_name")
ENDINGS = _names("ending_name")


class Handle:
    """Frees a case or a motion of the library after its last use."""

    __slots__ = ("_free", "pointer")

    def __init__(self, pointer: int, free: Callable[[int], None]) -> None:
        self.pointer = pointer
        self._free = free

    def __del__(self) -> None:
        self._free(self.pointer)


def text_of(function: str, of: Any, *arguments: Any) -> str:
    """The text that a function writes into the caller's room."""
    length = C[function](of, *arguments, None, 0)
    if length == 0:
        return ""
    room = ctypes.create_string_buffer(length + 1)
    C[function](of, *arguments, room, len(room))
    return room.raw[:-1].decode("utf-8", "replace")


def check(status: int) -> None:
    """Raises what a status means that the caller cannot put better."""
    if status == OUT_OF_MEMORY:
        raise MemoryError("tautline: memory is missing")
    if status != OK:
        raise RuntimeError(f"tautline: {C['status_text'](status).decode()}")


def address(array: npt.NDArray[Any]) -> int:
    """Where the first number is."""
    return array.ctypes.data


def doubles(name: str, values: npt.ArrayLike) -> Doubles:
    """Real numbers as contiguous doubles; anything else is a TypeError that names them."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: must be real numbers, is {shown(values)}")
    return np.require(array, np.float64, ["C", "A"])


def shown(value: object) -> str:
    """A value for a sentence, cut where it is long."""
    try:
        text = repr(value)
    except ValueError:  # an integer of thousands of digits
        text = f"a large {type(value).__name__}"
    return text if len(text) <= 60 else text[:57] + "..."


def flags(sets: npt.NDArray[np.int32], width: int) -> Flags:
    """A column for each cable: is it in the set?"""
    bits = np.asarray(sets)[..., np.newaxis] >> np.arange(width, dtype=np.int32)
    return (bits & 1).astype(np.bool_)


def members(of_set: int) -> tuple[int, ...]:
    """The cables of a set."""
    return tuple(cable for cable in range(31) if of_set >> cable & 1)
