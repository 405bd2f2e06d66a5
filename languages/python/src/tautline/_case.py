"""What can be solved: one rigid body in the plane on 1 to 8 inextensible cables."""
from __future__ import annotations

import ctypes
import difflib
import functools
import importlib.resources
import json
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _library
from ._library import C, CableNumbers, CaseNumbers, Doubles, Handle, address, doubles, shown

Pair = tuple[float, float]
#: Where text comes from: the path of a file, or the text itself.
Source = str | os.PathLike[str]

LONGEST_TEXT = 1 << 20  # [bytes], of a case file

_SET = object.__setattr__  # the one way into a frozen dataclass


def number(name: str, value: Any) -> float:
    """A number as a double; anything else is an error that names it."""
    if type(value) is float:
        return value
    if not isinstance(value, (str, bytes, bytearray, bool)):
        try:
            return float(value)
        except OverflowError:
            raise ValueError(f"{name}: {shown(value)} must fit a double") from None
        except (TypeError, ValueError):
            pass
    raise TypeError(f"{name}: must be a number, is {shown(value)}")


def _pair(name: str, value: Any) -> Pair:
    try:
        first, second = value
    except (TypeError, ValueError):
        raise TypeError(f"{name}: must be two numbers, is {shown(value)}") from None
    return number(name, first), number(name, second)


def _entries(name: str, value: Any) -> tuple[Any, ...]:
    if not isinstance(value, Iterable) or isinstance(value, (str, bytes)):
        raise TypeError(f"{name}: must be a list, is {shown(value)}")
    return tuple(value)


@dataclass(frozen=True, kw_only=True, slots=True)
class State:
    """Where the body is, and how it moves."""

    position: Pair = (0.0, 0.0)  #: [m], of the centre of mass
    angle: float = 0.0           #: [rad], anticlockwise, not wrapped
    velocity: Pair = (0.0, 0.0)  #: [m/s]
    spin: float = 0.0            #: [rad/s], anticlockwise

    def __post_init__(self) -> None:
        for name in ("position", "velocity"):
            _SET(self, name, _pair(name, getattr(self, name)))
        for name in ("angle", "spin"):
            _SET(self, name, number(name, getattr(self, name)))


@dataclass(frozen=True, kw_only=True, slots=True)
class Cable:
    """A massless inextensible line from a point of the world to a point of the body."""

    anchor: Pair                    #: [m], in the world
    attachment: Pair = (0.0, 0.0)   #: [m], in the body's frame, from its centre of mass
    length: float                   #: [m], > 0
    restitution: float              #: [-], Newton's coefficient, 0 to 1
    restitution_table: Sequence[Pair] = ()  #: replaces `restitution`: pairs of speed [m/s] and restitution, rising
    capture_speed: float = 0.0      #: [m/s], >= 0: a slower impact does not rebound
    taut: bool = False              #: it starts taut, and the start is moved onto it as far as needed

    def __post_init__(self) -> None:
        for name in ("anchor", "attachment"):
            _SET(self, name, _pair(name, getattr(self, name)))
        for name in ("length", "restitution", "capture_speed"):
            _SET(self, name, number(name, getattr(self, name)))
        table = _entries("restitution_table", self.restitution_table)
        _SET(self, "restitution_table", tuple(_pair("restitution_table", point) for point in table))
        _SET(self, "taut", bool(self.taut))


class _Native:
    """Room for the library's own copy of a case, which is made when it is first needed."""

    __slots__ = ("_native",)
    _native: Handle


# the quantities of a case that are one number of its start: the field, and the place in a pair
_OF_START = {"x": ("position", 0), "y": ("position", 1), "angle": ("angle", None), "velocity_x": ("velocity", 0),
             "velocity_y": ("velocity", 1), "spin": ("spin", None)}
_SHORT = {"vx": "velocity_x", "vy": "velocity_y"}
_OF_CABLES = ("restitution", "length", "capture_speed")


@dataclass(frozen=True, kw_only=True, slots=True)
class Case(_Native):
    """One system, its start and its duration. In SI units, or without units: `gravity` decides.

    A case is a value: it does not change, compares by its numbers, and can be a key of a dict. `but` gives another one.
    Lists become tuples. Numbers that cannot be are refused by `solve`; `problems` has the same sentences.
    """

    name: str = "case"                #: in tables and files
    duration: float                   #: [s], > 0: the motion ends there
    gravity: Pair                     #: [m/s^2]
    mass: float = 1.0                 #: [kg], > 0
    inertia: float = 0.0              #: [kg m^2] about the centre of mass; 0 only for a point mass
    cables: Sequence[Cable]           #: 1 to 8
    initial: State = field(default_factory=State)
    angle_limit: float | None = None  #: [rad], > 0: the motion ends where |angle| reaches it
    ceiling: float | None = None      #: [m]: the motion ends where an attachment rises to it

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise TypeError(f"name: must be text, is {shown(self.name)}")
        if "\0" in self.name:
            raise ValueError(f"name: {shown(self.name)} must have no zero character")
        if not isinstance(self.initial, State):
            raise TypeError(f"initial: must be a State, is {shown(self.initial)}")
        cables = _entries("cables", self.cables)
        for cable in cables:
            if not isinstance(cable, Cable):
                raise TypeError(f"cables: must be a list of Cable, has {shown(cable)}")
        _SET(self, "cables", cables)
        _SET(self, "gravity", _pair("gravity", self.gravity))
        for name in ("duration", "mass", "inertia"):
            _SET(self, name, number(name, getattr(self, name)))
        for name in ("angle_limit", "ceiling"):
            if getattr(self, name) is not None:
                _SET(self, name, number(name, getattr(self, name)))

    # ---- text

    @classmethod
    def from_toml(cls, source: Source) -> Case:
        """The case of a case file: its path, or its text, which has at least two lines.

        A file that cannot be read is an OSError. All that is wrong in it is one ValueError, a sentence a line.
        """
        text = source if isinstance(source, str) and "\n" in source else None
        return _read(source, text)

    @classmethod
    def from_json(cls, source: Source) -> Case:
        """The same of JSON with the keys of a case file: a path, or text that begins with {."""
        text = source if isinstance(source, str) and source.lstrip().startswith("{") else None
        return _read(source, text)

    @classmethod
    def shipped(cls, name: str) -> Case:
        """A case that comes with tautline, such as "bouncing-ball". `shipped_cases()` has the names."""
        known = _shipped()
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            raise ValueError(f"case {shown(name)} is not shipped" + (f"; did you mean {near[0]}?" if near else "")
                             + " See shipped_cases()")
        return _from_members(known[name])

    def to_toml(self) -> str:
        """The text of a case file that reads back as this case, bit for bit. A start on taut cables is written as moved."""
        return self._text(0)

    def to_json(self) -> str:
        """The same as JSON."""
        return self._text(1)

    def _text(self, form: int) -> str:
        handle = self._sound()
        length = ctypes.c_size_t()
        _library.check(C["case_text"](handle, form, None, 0, ctypes.byref(length)))
        room = ctypes.create_string_buffer(length.value + 1)
        _library.check(C["case_text"](handle, form, room, len(room), None))
        return room.raw[:-1].decode()

    # ---- what is wrong, and what is what

    @property
    def problems(self) -> tuple[str, ...]:
        """A sentence for each thing that is wrong; empty: `solve` accepts the case."""
        return tuple(_library.text_of("problems", self._handle().pointer).splitlines())

    @property
    def notes(self) -> tuple[str, ...]:
        """How the start was changed for cables that start taut, in sentences; usually empty."""
        return tuple(_library.text_of("notes", self._handle().pointer).splitlines())

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The names of the columns of a state: x, y, angle, vx, vy, spin."""
        handle = self._sound()
        return tuple(C["coordinate_name"](handle, place).decode() for place in range(C["coordinates"](handle)))

    @property
    def units(self) -> tuple[str, ...]:
        """The units of the columns of a state."""
        handle = self._sound()
        return tuple(C["coordinate_unit"](handle, place).decode() for place in range(C["coordinates"](handle)))

    @property
    def quantities(self) -> tuple[str, ...]:
        """The names of the numbers that `but`, `sweep` and the specs of ensembles vary."""
        of_cables = [[name, *(f"{name}_{cable}" for cable in range(len(self.cables)))] for name in _OF_CABLES]
        return (*_OF_START, "mass", "inertia", "gravity_x", "gravity_y", *(name for names in of_cables for name in names))

    def gaps(self, states: npt.ArrayLike) -> Doubles:
        """The gap [m] of each cable, its length less its distance, at `states` of any origin, in the last axis."""
        return self._gaps(states)[0]

    def gap_rates(self, states: npt.ArrayLike) -> Doubles:
        """The rate [m/s] of each gap, < 0 where it closes, at `states` of any origin, in the last axis."""
        return self._gaps(states)[1]

    def _gaps(self, states: npt.ArrayLike) -> tuple[Doubles, Doubles]:
        handle, rows = self._sound(), doubles("states", states)
        width = C["coordinates"](handle)
        if rows.ndim == 0 or rows.shape[-1] != width:
            raise ValueError(f"states: has the shape {rows.shape}, must end with {width} coordinates")
        shape = (*rows.shape[:-1], len(self.cables))
        gaps, rates = np.empty(shape), np.empty(shape)
        _library.check(C["gaps"](handle, address(rows), rows.size // width, address(gaps), address(rates)))
        return gaps, rates

    # ---- another case

    def but(self, **changes: Any) -> Case:
        """The same case with other numbers.

        Names are those of the fields of a case, a cable (then it holds for all cables) and a state, and those of
        `quantities`: `but(restitution=0.7, length_0=1.4, x=0.1, duration=5)`. For thousands of cases take `sweep`.
        """
        own, start = {one.name for one in fields(Case)}, {one.name for one in fields(State)}
        of_cable = {one.name for one in fields(Cable)}
        ours: dict[str, Any] = {}
        cables, initial, gravity = list(self.cables), self.initial, self.gravity
        if "cables" in changes:
            cables = list(_entries("cables", changes["cables"]))
        initial = changes.get("initial", initial)
        gravity = _pair("gravity", changes.get("gravity", gravity))
        for given, value in changes.items():
            name = _SHORT.get(given, given)
            word, _, index = name.rpartition("_")
            if name in ("cables", "initial", "gravity"):
                continue
            if name in own:
                ours[name] = value
            elif name in ("gravity_x", "gravity_y"):
                gravity = _with(gravity, name == "gravity_y", number(name, value))
            elif name in _OF_START and _OF_START[name][1] is not None:
                pair, place = _OF_START[name]
                initial = replace(initial, **{pair: _with(getattr(initial, pair), place == 1, number(name, value))})
            elif name in start:
                initial = replace(initial, **{name: value})
            elif name in of_cable:
                self._refuse_table(given, cables, changes)
                cables = [replace(cable, **{name: value}) for cable in cables]
            elif word in _OF_CABLES and index.isdecimal() and int(index) < len(cables):
                self._refuse_table(given, cables[int(index):int(index) + 1], changes)
                cables[int(index)] = replace(cables[int(index)], **{word: value})
            else:
                known = {*self.quantities, *own, *start, *of_cable}
                raise ValueError(unknown_quantity(given, known, self.quantities))
        return replace(self, cables=cables, initial=initial, gravity=gravity, **ours)

    @staticmethod
    def _refuse_table(name: str, cables: Sequence[Cable], others: Iterable[str] = ()) -> None:
        if name.startswith("restitution") and name != "restitution_table" and "restitution_table" not in others and any(
                cable.restitution_table for cable in cables):
            raise ValueError(f"{name}: a cable has a restitution_table, which replaces it; "
                             "give restitution_table=() with it")

    # ---- the library's copy

    def _handle(self) -> Handle:
        try:
            found = self._native
        except AttributeError:
            found = self._made()
            _SET(self, "_native", found)
        return found

    def _sound(self) -> int:
        """The library's copy of a case without problems."""
        handle = self._handle().pointer
        wrong = _library.text_of("problems", handle)
        if wrong:
            raise ValueError(wrong)
        return handle

    def _made(self) -> Handle:
        numbers = CaseNumbers(ctypes.sizeof(CaseNumbers), 0, self.mass, self.inertia)
        numbers.gravity[:] = self.gravity
        start = self.initial
        numbers.start[:] = (*start.position, start.angle, *start.velocity, start.spin)
        numbers.duration = self.duration
        if self.angle_limit is not None:
            numbers.has |= 1
            numbers.angle_limit = self.angle_limit
        if self.ceiling is not None:
            numbers.has |= 2
            numbers.ceiling = self.ceiling
        cables = (CableNumbers * len(self.cables))()
        table: list[float] = []
        for to, cable in zip(cables, self.cables):
            to.size = ctypes.sizeof(CableNumbers)
            to.taut = cable.taut
            to.anchor[:] = cable.anchor
            to.attachment[:] = cable.attachment
            to.length, to.restitution, to.capture_speed = cable.length, cable.restitution, cable.capture_speed
            to.table_points = len(cable.restitution_table)
            for point in cable.restitution_table:
                table += point
        pairs = (ctypes.c_double * len(table))(*table)
        name = self.name.encode("utf-8", "surrogatepass")
        return _handle_of(C["case_from_numbers"](ctypes.byref(numbers), cables, len(cables), pairs, len(table) // 2, name))


def _with(pair: Pair, second: bool, value: float) -> Pair:
    return (pair[0], value) if second else (value, pair[1])


def unknown_quantity(name: str, known: Iterable[str], listed: Sequence[str]) -> str:
    """The sentence on a name that no number of the case has."""
    near = difflib.get_close_matches(name, sorted(known), 1)
    return (f"{shown(name)} is no number of this case" + (f"; did you mean {near[0]}?" if near else ";")
            + f" It has {', '.join(listed)}")


def _handle_of(pointer: int | None) -> Handle:
    if pointer is None:
        raise MemoryError("tautline: memory is missing")
    return Handle(pointer, C["case_free"])


def _read(source: Source, text: str | None) -> Case:
    if text is not None:
        content, name = text.encode("utf-8", "surrogatepass"), "case"
    else:
        name = os.fspath(source)
        if not isinstance(name, str):
            raise TypeError(f"a case: must be a path or text, is {shown(source)}")
        with open(name, "rb") as file:
            content = file.read(LONGEST_TEXT + 1)
    if len(content) > LONGEST_TEXT:
        raise ValueError(f"{name}: is longer than {LONGEST_TEXT} bytes")
    handle = _handle_of(C["case_from_text"](content, len(content), os.fsencode(name)))
    wrong = _library.text_of("problems", handle.pointer)
    if wrong:
        raise ValueError(wrong)
    length = ctypes.c_size_t()
    _library.check(C["case_text"](handle.pointer, 1, None, 0, ctypes.byref(length)))
    room = ctypes.create_string_buffer(length.value + 1)
    _library.check(C["case_text"](handle.pointer, 1, room, len(room), None))
    found = _from_members(json.loads(room.raw[:-1]))
    _SET(found, "_native", handle)  # which knows its notes
    return found


def _from_members(members: dict[str, Any]) -> Case:
    """The case of what its JSON holds."""
    others = {key: value for key, value in members.items() if key not in ("body", "cables", "initial")}
    return Case(**others, **members["body"], cables=[Cable(**cable) for cable in members["cables"]],
                initial=State(**members["initial"]))


@functools.cache
def _shipped() -> dict[str, dict[str, Any]]:
    text = importlib.resources.files(__package__).joinpath("cases.json").read_text("utf-8")
    return {case["name"]: case for case in json.loads(text)}


def shipped_cases() -> tuple[str, ...]:
    """The names of the cases that come with tautline, for `Case.shipped`."""
    return tuple(_shipped())
