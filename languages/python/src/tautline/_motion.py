"""The exact motion of a case."""
from __future__ import annotations

import ctypes
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _library
from ._case import Case, number
from ._library import C, Doubles, Flags, Handle, Options, SettlingNumbers, Summary, address, doubles, shown

Names = npt.NDArray[np.str_]

_LAW_SENTENCE = "must be one of " + ", ".join(_library.LAWS)


def options_of(law: str, *, until_locked: bool, swing_ahead: bool, completion_error: float | None,
               completion_speed: float | None, completion_margin: float | None, max_events: int | None,
               max_steps: int | None) -> Options | None:
    """Options for the library, None for its defaults. A ValueError names all that is wrong."""
    numbers = {"completion_error": completion_error, "completion_speed": completion_speed,
               "completion_margin": completion_margin}
    counts = {"max_events": max_events, "max_steps": max_steps}
    if law == "simultaneous" and not (until_locked or swing_ahead) and (*numbers.values(), *counts.values()) == (None,) * 5:
        return None
    wrong = []
    options = Options(ctypes.sizeof(Options))
    if law in _library.LAWS:
        options.law = _library.LAWS.index(law)
    else:
        wrong.append(f"law: {shown(law)} {_LAW_SENTENCE}")
    for name, value in numbers.items():
        if value is not None:
            value = number(name, value)
            setattr(options, name, value)
            if value == 0.0:  # which the library takes for its default
                wrong.append(f"{name} 0 must be above 0, or None for the default")
    for name, count in counts.items():
        if count is not None:
            count = operator.index(count)
            if 1 <= count <= _library.MOST_OF_INT32:
                setattr(options, name, count)
            else:
                wrong.append(f"{name} {count} must be from 1 to {_library.MOST_OF_INT32}, or None for the default")
    options.until_locked, options.swing_ahead = bool(until_locked), bool(swing_ahead)
    wrong += _library.text_of("option_problems", ctypes.byref(options)).splitlines()
    if wrong:
        raise ValueError("\n".join(wrong))
    return options


def solve(case: Case, *, law: str = "simultaneous", until_locked: bool = False, swing_ahead: bool = False,
          completion_error: float | None = None, completion_speed: float | None = None,
          completion_margin: float | None = None, max_events: int | None = None, max_steps: int | None = None) -> Motion:
    """The exact motion of `case` from time 0 on.

    law: how impacts on several cables are resolved: "simultaneous", "poisson", "sequential" or "energetic"
    until_locked: the motion ends where nothing but one swing on taut cables can follow
    swing_ahead: with `until_locked`, at the lock already, if it is certain
    completion_error: [-] to the velocities, by completing infinitely many bounces; 1e-16 by default
    completion_speed: [m/s], instead: bounces up to this speed are completed
    completion_margin: [-], how far a derivative may grow while they last; 20 by default
    max_events, max_steps: the motion ends there; 200000 by default, about a second of work

    A case or an option that cannot be is one ValueError that names all its problems, a sentence a line.
    """
    if not isinstance(case, Case):
        raise TypeError(f"case: must be a Case, is {shown(case)}")
    options = options_of(law, until_locked=until_locked, swing_ahead=swing_ahead, completion_error=completion_error,
                         completion_speed=completion_speed, completion_margin=completion_margin, max_events=max_events,
                         max_steps=max_steps)
    return Motion(case, options)


def _solved_again(case: Case, options: bytes | None) -> Motion:
    """A motion that comes out of a pickle: the same bits."""
    return Motion(case, None if options is None else Options.from_buffer_copy(options))


def _addresses(*arrays: npt.NDArray[Any]) -> list[int]:
    return [address(array) for array in arrays]


def _frozen(*arrays: npt.NDArray[Any]) -> None:
    for array in arrays:
        array.flags.writeable = False


def _or_none(number: float) -> float | None:
    return None if math.isnan(number) else number


def _named(columns: dict[str, npt.NDArray[Any]], suffixes: dict[str, Sequence[str]]) -> dict[str, npt.NDArray[Any]]:
    """One-dimensional columns, such as before_x and impulse_0, of arrays with several."""
    flat: dict[str, npt.NDArray[Any]] = {}
    for name, array in columns.items():
        if array.ndim == 1:
            flat[name] = array
        else:
            flat.update({f"{name}_{suffix}": array[:, place] for place, suffix in enumerate(suffixes[name])})
    return flat


@dataclass(frozen=True, eq=False, slots=True)
class EventErrors:
    """Bounds of the errors of events, a row each; NaN where nothing is sure."""

    time: Doubles          #: [s], (n,); of a completed accumulation: of its limit
    rate: Doubles          #: [m/s], of the fastest closing rate, (n,)
    before: Doubles        #: in the units of a state, (n, 6)
    after: Doubles         #: the same, (n, 6)
    impulses: Doubles      #: [N s], (n, cables)
    indeterminate: Flags   #: cables among which the impulse can be split in several ways, (n, cables)


@dataclass(frozen=True, eq=False, slots=True)
class Events:
    """Events of a motion, a row each, in order of time. `len` counts them."""

    time: Doubles      #: [s], (n,)
    kind: Names        #: "impact", "taut" or "slack", (n,)
    cables: Flags      #: which cables take part, (n, cables)
    before: Doubles    #: x, y [m], angle [rad], vx, vy [m/s], spin [rad/s] before the event, (n, 6)
    after: Doubles     #: the same after it, (n, 6)
    impulses: Doubles  #: [N s], (n, cables); below 0 only at a completed accumulation: gravity does that part
    _table: _EventTable
    _rows: npt.NDArray[np.intp]  # of the table

    def __len__(self) -> int:
        return len(self.time)

    def __repr__(self) -> str:
        counts = [f"{np.count_nonzero(self.kind == kind)} {kind}" for kind in _library.KINDS]
        return f"<{len(self)} events: {', '.join(counts)}>"

    def where(self, rows: str | Flags) -> Events:
        """The events of one kind, or those that an array of n flags chooses: `events.where(events.cables[:, 0])`."""
        if isinstance(rows, str):
            if rows not in _library.KINDS:
                raise ValueError(f"kind: {shown(rows)} must be one of {', '.join(_library.KINDS)}")
            rows = np.equal(self.kind, rows)
        found = Events(self.time[rows], self.kind[rows], self.cables[rows], self.before[rows], self.after[rows],
                       self.impulses[rows], self._table, self._rows[rows])
        _frozen(*(getattr(found, one.name) for one in fields(found)[:6]))
        return found

    @property
    def errors(self) -> EventErrors:
        """Bounds of the errors of these events. The first call takes about as long as the solution."""
        whole = self._table.errors()
        columns = [getattr(whole, one.name)[self._rows] for one in fields(EventErrors)]
        _frozen(*columns)
        return EventErrors(*columns)

    def columns(self, errors: bool = False) -> dict[str, npt.NDArray[Any]]:
        """One-dimensional columns by name, for pandas.DataFrame or a CSV file: time, kind, cable_0, before_x, ..."""
        state, cables = self._table.coordinates, [str(one) for one in range(self.cables.shape[1])]
        suffixes: dict[str, Sequence[str]] = {"cable": cables, "before": state, "after": state, "impulse": cables}
        found = _named({"time": self.time, "kind": self.kind, "cable": self.cables, "before": self.before,
                        "after": self.after, "impulse": self.impulses}, suffixes)
        if errors:
            of = self.errors
            bounds = _named({"time": of.time, "rate": of.rate, "before": of.before, "after": of.after,
                             "impulse": of.impulses}, suffixes)
            found.update({f"{name}_error": column for name, column in bounds.items()})
        return found


class _EventTable:
    """The events of a motion in the library, and the bounds of their errors as soon as somebody asks. Rows know it
    instead of their motion, so that nothing refers to itself and the motion is freed after its last use."""

    __slots__ = ("_errors", "cables", "coordinates", "count", "handle")

    def __init__(self, handle: Handle, count: int, coordinates: tuple[str, ...], cables: int) -> None:
        self.handle, self.count, self.coordinates, self.cables = handle, count, coordinates, cables
        self._errors: EventErrors | None = None

    def states(self) -> Doubles:
        return np.empty((self.count, len(self.coordinates)))

    def events(self) -> Events:
        time, kind, sets = np.empty(self.count), np.empty(self.count, np.int32), np.empty(self.count, np.int32)
        before, after, impulses = self.states(), self.states(), np.empty((self.count, self.cables))
        _library.check(C["events"](self.handle.pointer, 0, self.count,
                                   *_addresses(time, kind, sets, before, after, impulses)))
        found = Events(time, np.array(_library.KINDS)[kind], _library.flags(sets, self.cables), before, after, impulses,
                       self, np.arange(self.count))
        _frozen(*(getattr(found, one.name) for one in fields(found)[:6]))
        return found

    def errors(self) -> EventErrors:
        if self._errors is None:
            time, rate, sets = np.empty(self.count), np.empty(self.count), np.empty(self.count, np.int32)
            before, after, impulses = self.states(), self.states(), np.empty((self.count, self.cables))
            _library.check(C["event_errors"](self.handle.pointer, 0, self.count,
                                             *_addresses(time, rate, before, after, impulses, sets)))
            self._errors = EventErrors(time, rate, before, after, impulses, _library.flags(sets, self.cables))
        return self._errors


@dataclass(frozen=True, eq=False, slots=True)
class Arcs:
    """Stretches without events, a row each."""

    start: Doubles  #: [s], (n,)
    end: Doubles    #: [s], (n,)
    taut: Flags     #: which cables are taut, (n, cables)

    def __len__(self) -> int:
        return len(self.start)


@dataclass(frozen=True, eq=False, slots=True)
class Accumulations:
    """Infinitely many impacts in a finite time, a row each time that happens."""

    start: Doubles        #: [s], of the event that completes them, (n,)
    limit: Doubles        #: [s], of the times of the impacts, (n,)
    uncertainty: Doubles  #: [s], by how much `limit` may be wrong, (n,)
    cables: Flags         #: which cables are taut from then on, (n, cables)
    energy_lost: Doubles  #: [J], by the impacts after `start`, (n,)

    def __len__(self) -> int:
        return len(self.start)


@dataclass(frozen=True, eq=False, slots=True)
class Unsure:
    """Stretches of time in which nothing is sure, a row each."""

    start: Doubles      #: [s], (n,)
    end: Doubles        #: [s], infinite where it is the end of the motion, (n,)
    tie: Names          #: the kind of event that rounding decides at `start`; "": errors have grown, (n,)
    tie_cables: Flags   #: its cables, (n, cables)

    def __len__(self) -> int:
        return len(self.start)


@dataclass(frozen=True, kw_only=True, slots=True)
class Swing:
    """A motion with one degree of freedom that repeats for ever on taut cables."""

    energy: float            #: [J], above the equilibrium that it swings about
    period: float            #: [s]
    goes_round: bool         #: it has no turning points
    angle_of: str            #: "body", or "cable": of the first that pulls, from gravity's direction
    least: float | None      #: [rad], the smaller angle of the turning points; None if it goes round
    largest: float | None    #: [rad], the other
    amplitude: float | None  #: [rad], half the difference
    tension: float | None    #: [N], the largest of one cable; known with `swing_ahead` alone


@dataclass(frozen=True, kw_only=True, slots=True)
class Settling:
    """How a motion settles."""

    time: float | None         #: [s], from which on `cables` are taut; None: it ends without a taut cable
    uncertainty: float | None  #: [s], of `time`; 0 where no accumulation led there
    cables: tuple[int, ...]    #: the final set of taut cables
    permanent: bool            #: no tension falls to zero ever after
    rests: bool                #: nothing is left to swing
    swing: Swing | None        #: what is left, if that is one degree of freedom
    last_impacts: tuple[tuple[float, float | None], ...]  #: speed [m/s], and time [s] of the last impact faster than it


@dataclass(frozen=True, kw_only=True, slots=True)
class Repetition:
    """From `start` on the arcs are one period that repeats to the end."""

    start: float   #: [s]
    period: float  #: [s]
    turn: float    #: [rad], by which the angle grows in each period


class Motion:
    """The exact motion of a case, from `solve`.

    Call it with times [s] for the states at them, like the dense output of SciPy's solve_ivp: `motion(t)[..., 0]` is x.
    Times may be in any order, in an array of any shape. At an event, states are those after it. A time before 0 or after
    `end_time` is a ValueError that names it. Several threads may use one motion.
    """

    __slots__ = ("_case", "_events", "_handle", "_impacts", "_options", "_summary")

    _events: Events
    _impacts: Events

    def __init__(self, case: Case, options: Options | None = None) -> None:
        self._case = case
        self._options = options
        pointer = ctypes.c_void_p()
        status = C["solve"](case._handle().pointer, options and ctypes.byref(options), ctypes.byref(pointer))
        if status == _library.BAD_CASE:
            raise ValueError("\n".join(case.problems))
        _library.check(status)
        assert pointer.value is not None
        self._handle = Handle(pointer.value, C["motion_free"])
        self._summary = Summary(ctypes.sizeof(Summary))
        _library.check(C["summarise"](self._handle.pointer, ctypes.byref(self._summary)))

    def __reduce__(self) -> tuple[Any, ...]:
        return _solved_again, (self._case, None if self._options is None else bytes(self._options))

    def __repr__(self) -> str:
        return (f"<Motion of {self._case.name}: {self._summary.impacts} impacts, {self.ending} at t = {self.end_time:.6g} s>")

    # ---- the whole

    @property
    def case(self) -> Case:
        """What was solved."""
        return self._case

    @property
    def ending(self) -> str:
        """Why the motion ends: "reached_duration", "rest", "locked" and so on, as in files."""
        return _library.ENDINGS[int(self._summary.ending)]

    @property
    def end_time(self) -> float:
        """[s]: states are known from 0 to there."""
        return float(self._summary.end_time)

    @property
    def start_energy(self) -> float:
        """[J], kinetic and potential; zero potential at the origin of the world."""
        return float(self._summary.start_energy)

    @property
    def end_energy(self) -> float:
        """[J]"""
        return float(self._summary.end_energy)

    @property
    def repetition(self) -> Repetition | None:
        """From when on the motion repeats itself to its end, if it does."""
        one = self._summary
        if math.isnan(one.repeat_start):
            return None
        return Repetition(start=one.repeat_start, period=one.repeat_period, turn=one.repeat_turn)

    @property
    def settling(self) -> Settling:
        """How the motion settles. Looks past its end if its swing is not known by then."""
        numbers = SettlingNumbers(ctypes.sizeof(SettlingNumbers))
        _library.check(C["settle"](self._handle.pointer, ctypes.byref(numbers)))
        swing = None
        if numbers.swings:
            swing = Swing(energy=numbers.swing_energy, period=numbers.swing_period, goes_round=bool(numbers.goes_round),
                          angle_of="cable" if numbers.angle_of_cable else "body", least=_or_none(numbers.swing_least),
                          largest=_or_none(numbers.swing_largest), amplitude=_or_none(numbers.swing_amplitude),
                          tension=_or_none(numbers.swing_tension))
        last = tuple((speed, _or_none(time)) for speed, time in zip(numbers.last_impact_speed, numbers.last_impact_time)
                     if not math.isnan(speed))
        return Settling(time=_or_none(numbers.time), uncertainty=_or_none(numbers.uncertainty),
                        cables=_library.members(numbers.cables), permanent=bool(numbers.permanent),
                        rests=bool(numbers.rests), swing=swing, last_impacts=last)

    # ---- states at times

    def __call__(self, times: npt.ArrayLike) -> Doubles:
        """x, y [m], angle [rad], vx, vy [m/s] and spin [rad/s] at `times` [s], in the last axis."""
        return self._rows_at("states", times, self._width, None)

    def taut(self, times: npt.ArrayLike) -> Flags:
        """Which cables are taut at `times` [s], in the last axis."""
        at = doubles("times", times)
        sets = np.empty(at.shape, np.int32)
        self._ask("states", at, None, address(sets))
        return _library.flags(sets, self._cables)

    def tensions(self, times: npt.ArrayLike) -> Doubles:
        """The tension [N] of each cable at `times` [s], in the last axis; 0 of a slack one."""
        return self._rows_at("tensions", times, self._cables)

    def energy(self, times: npt.ArrayLike) -> Doubles:
        """Kinetic and potential energy [J] at `times` [s]; zero potential at the origin of the world."""
        return self._energies(times, 2)

    def kinetic_energy(self, times: npt.ArrayLike) -> Doubles:
        """[J] at `times` [s]."""
        return self._energies(times, 0)

    def potential_energy(self, times: npt.ArrayLike) -> Doubles:
        """[J] at `times` [s]; zero at the origin of the world."""
        return self._energies(times, 1)

    def errors(self, times: npt.ArrayLike) -> Doubles:
        """Bounds of the errors of the states at `times` [s], in the last axis; NaN where nothing is sure."""
        return self._rows_at("state_errors", times, self._width, None)

    def energy_errors(self, times: npt.ArrayLike) -> Doubles:
        """Bounds of the errors of `energy` [J] at `times` [s]; NaN where nothing is sure."""
        at = doubles("times", times)
        found = np.empty(at.shape)
        self._ask("state_errors", at, None, address(found))
        return found

    # ---- rows

    @property
    def events(self) -> Events:
        """All events."""
        try:
            return self._events
        except AttributeError:
            self._events = _EventTable(self._handle, self._summary.events, self._case.coordinates, self._cables).events()
            return self._events

    @property
    def impacts(self) -> Events:
        """The events at which the velocity jumps."""
        try:
            return self._impacts
        except AttributeError:
            self._impacts = self.events.where("impact")
            return self._impacts

    @property
    def arcs(self) -> Arcs:
        """The stretches without events."""
        count = self._summary.arcs
        start, end, sets = np.empty(count), np.empty(count), np.empty(count, np.int32)
        _library.check(C["arcs"](self._handle.pointer, 0, count, *_addresses(start, end, sets)))
        return Arcs(start, end, _library.flags(sets, self._cables))

    @property
    def accumulations(self) -> Accumulations:
        """Where infinitely many impacts happen in a finite time."""
        count = self._summary.accumulations
        start, limit, uncertainty, lost = (np.empty(count) for _ in range(4))
        sets = np.empty(count, np.int32)
        _library.check(C["accumulations"](self._handle.pointer, 0, count, *_addresses(start, limit, uncertainty, sets, lost)))
        return Accumulations(start, limit, uncertainty, _library.flags(sets, self._cables), lost)

    # ---- how far the numbers can be trusted: the first of these takes about as long as the solution

    @property
    def horizon(self) -> float | None:
        """[s], the first instant at which nothing is sure any more; None: there is none."""
        found = self._horizon()[0]
        return None if math.isinf(found) else found

    @property
    def lock_error(self) -> float | None:
        """[s], a bound of the error of the last event, if cables stay taut from there on; None: not known."""
        return _or_none(self._horizon()[1])

    @property
    def unsure(self) -> Unsure:
        """The stretches in which nothing is sure."""
        count = self._horizon()[2]
        start, end, kind, sets = np.empty(count), np.empty(count), np.empty(count, np.int32), np.empty(count, np.int32)
        _library.check(C["unsure"](self._handle.pointer, 0, count, *_addresses(start, end, kind, sets)))
        return Unsure(start, end, np.array((*_library.KINDS, ""))[kind], _library.flags(sets, self._cables))

    # ---- how the library is asked

    @property
    def _width(self) -> int:
        return int(C["coordinates"](self._case._handle().pointer))

    @property
    def _cables(self) -> int:
        return len(self._case.cables)

    def _ask(self, function: str, times: Doubles, *columns: int | None) -> None:
        wrong = ctypes.c_size_t()
        status = C[function](self._handle.pointer, address(times), times.size, *columns, ctypes.byref(wrong))
        if status == _library.BAD_TIME:
            place = tuple(int(index) for index in np.unravel_index(wrong.value, times.shape))
            where = f"times[{', '.join(map(str, place))}] = " if place else "time "
            raise ValueError(f"{where}{float(times[place])!r} is outside of the motion, which lasts from 0 to "
                             f"{self.end_time!r} s")
        _library.check(status)

    def _rows_at(self, function: str, times: npt.ArrayLike, width: int, *others: None) -> Doubles:
        """Rows of `width` numbers at the times, the first output of a function; the others are left out."""
        at = doubles("times", times)
        found = np.empty((*at.shape, width))
        self._ask(function, at, address(found), *others)
        return found

    def _energies(self, times: npt.ArrayLike, which: int) -> Doubles:
        at = doubles("times", times)
        found = np.empty(at.shape)
        self._ask("energy", at, *[address(found) if which == output else None for output in range(3)])
        return found

    def _horizon(self) -> tuple[float, float, int]:
        horizon, lock, unsure = ctypes.c_double(), ctypes.c_double(), ctypes.c_size_t()
        _library.check(C["horizon"](self._handle.pointer, ctypes.byref(horizon), ctypes.byref(lock), ctypes.byref(unsure)))
        return horizon.value, lock.value, unsure.value
