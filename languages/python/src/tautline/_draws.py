"""The samples of `tautline ensemble`, bit for bit."""
from __future__ import annotations

import ctypes
import functools
import math
import os
import pathlib
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from . import _library
from ._case import _OF_START, LONGEST_TEXT, Case, Source, unknown_quantity
from ._library import Doubles, shown

MOST_DRAWS = 10_000_000
LARGEST = 1e20  # no number of a case is larger
_AT_A_TIME = 1 << 16  # random numbers, of which each takes four of Philox's
_PURPOSE = 1  # of random numbers: draws


@dataclass(frozen=True, eq=False, kw_only=True, slots=True)
class Draws:
    """The samples of an ensemble: `sweep(drawn.case, drawn.values, law=drawn.law)` solves them. `len` counts them."""

    case: Case                  #: of which quantities vary, as long as the spec says
    values: dict[str, Doubles]  #: of each quantity, a value for each sample
    seed: int                   #: of the random numbers
    law: str                    #: of the exact motion: the option of `solve`
    completion_error: float     #: likewise

    def __len__(self) -> int:
        return len(next(iter(self.values.values())))


def draws(spec: Source, *, count: int | None = None, seed: int | None = None) -> Draws:
    """The samples that `tautline ensemble` draws for a spec: a path, or the text of a file, which has at least two lines.

    count: samples, or samples at each point of a grid, in place of those of the spec
    seed: in place of that of the spec

    Uniform and normal numbers, lists and grids have the same bits. A spec with sampling = "sobol" is refused. So is one
    that is wrong, with a ValueError that names all that is; tables of engines and variants are not read.
    """
    folder, source, text = pathlib.Path(), "spec", spec if isinstance(spec, str) and "\n" in spec else None
    if text is None:
        source = os.fspath(spec)
        folder = pathlib.Path(source).parent
        with open(source, "rb") as file:
            content = file.read(LONGEST_TEXT + 1)
        if len(content) > LONGEST_TEXT:
            raise ValueError(f"{source}: is longer than {LONGEST_TEXT} bytes")
        try:
            text = content.decode()
        except UnicodeDecodeError:
            raise ValueError(f"{source}: must be text in UTF-8") from None
    try:
        tables = tomllib.loads(text)
    except RecursionError:
        raise ValueError(f"{source}: is nested too deep") from None
    except ValueError as error:
        raise ValueError(f"{source}: {error}") from None
    if count is not None:
        tables["count"] = count
    if seed is not None:
        tables["seed"] = seed
    return _Spec(tables, source, folder).draws()


@dataclass(frozen=True, slots=True)
class _Varied:
    quantity: str
    kind: str
    numbers: tuple[float, ...]


class _Spec:
    """Reads the tables of a spec, and collects what is wrong with them."""

    def __init__(self, tables: dict[str, Any], source: str, folder: pathlib.Path) -> None:
        self.tables, self.source, self.folder = tables, source, folder
        self.wrong: list[str] = []

    def refuse(self, sentence: str) -> None:
        self.wrong.append(f"{self.source}: {sentence}")

    def draws(self) -> Draws:
        known = {"case", "until", "count", "seed", "sampling", "law", "speeds", "completion", "vary", "exact", "engines"}
        for key in self.tables.keys() - known:
            self.refuse(f"{key}: is unknown; a spec has {', '.join(sorted(known))}")
        case = self.case()
        count = self.whole("count", 1000, 1, MOST_DRAWS)
        seed = self.whole("seed", 1, 0, 2**53)
        law = self.tables.get("law", "simultaneous")
        if law not in _library.LAWS:
            self.refuse(f"law: {shown(law)} must be one of {', '.join(_library.LAWS)}")
        sampling = self.tables.get("sampling", "random")
        if sampling == "sobol":
            self.refuse('sampling: "sobol" cannot be drawn here; leave it out, or let `tautline ensemble` write its samples')
        elif sampling != "random":
            self.refuse(f"sampling: {shown(sampling)} must be random")
        completion = self.number("completion", self.tables.get("completion", 1e-16), 0.0, 1e-10)
        varied = list(self.varied(case)) if case is not None else []
        points = math.prod(len(one.numbers) for one in varied if one.kind == "grid")
        if count * points > MOST_DRAWS:
            self.refuse(f"count: {count * points} draws in all, must be at most {MOST_DRAWS}")
        if self.wrong or case is None:
            raise ValueError("\n".join(self.wrong))
        return Draws(case=case, values=_values(case, varied, count * points, points, seed), seed=seed, law=law,
                     completion_error=completion)

    def case(self) -> Case | None:
        name = self.tables.get("case")
        if not isinstance(name, str):
            self.refuse(f"case: must be the name of a shipped case or a path, is {shown(name)}")
            return None
        try:
            found = Case.from_toml(self.folder / name) if name.endswith(".toml") else Case.shipped(name)
        except (ValueError, OSError) as error:
            self.refuse(f"case: {error}")
            return None
        if "until" in self.tables:
            found = replace(found, duration=self.number("until", self.tables["until"], 0.0, LARGEST))
        return found

    def varied(self, case: Case) -> Iterator[_Varied]:
        tables = self.tables.get("vary")
        if not isinstance(tables, list) or not tables or not all(isinstance(one, dict) for one in tables):
            self.refuse("vary: must be tables [[vary]]")
            return
        before: set[str] = set()
        for place, table in enumerate(tables):
            path = f"vary[{place}]."
            kinds = [kind for kind in ("normal", "uniform", "list", "grid") if kind in table]
            for key in table.keys() - {"quantities", "normal", "uniform", "list", "grid", "points"}:
                self.refuse(f"{path}{key}: is unknown; it has quantities and one of normal, uniform, list and grid")
            if len(kinds) != 1:
                self.refuse(f"{path}quantities: needs one of normal, uniform, list and grid; "
                            + ("several are given" if kinds else "none is given"))
                continue
            if "points" in table and kinds != ["grid"]:
                self.refuse(f"{path}points: belongs to a grid")
            numbers = self.numbers(path, kinds[0], table)
            names = table.get("quantities")
            if not isinstance(names, list) or not names:
                self.refuse(f'{path}quantities: must be an array of names, such as ["x", "y"]')
                continue
            for name in names:
                if name not in case.quantities:
                    self.refuse(f"{path}quantities: " + unknown_quantity(str(name), case.quantities, case.quantities))
                elif name in before:
                    self.refuse(f"{path}quantities: {shown(name)} is varied twice")
                else:
                    before.add(name)
                    yield _Varied(name, kinds[0], numbers)

    def numbers(self, path: str, kind: str, table: dict[str, Any]) -> tuple[float, ...]:
        """What a distribution is made of."""
        given = table[kind]
        if kind == "normal":
            return (self.number(path + kind, given, 0.0, LARGEST),)
        if not isinstance(given, list) or not given:
            self.refuse(f"{path}{kind}: must be an array of numbers, is {shown(given)}")
            return (0.0,)
        numbers = tuple(self.number(path + kind, one, -math.inf, LARGEST) for one in given)
        if kind == "list":
            return numbers
        if len(numbers) != 2 or numbers[0] >= numbers[1]:
            self.refuse(f"{path}{kind}: must be two numbers [low, high] with low below high")
            return (0.0, 1.0)
        if kind == "uniform":
            return numbers
        points = self.whole(path + "points", table.get("points"), 2, 1000)
        low, high = numbers
        return tuple(low + (high - low) * index / (points - 1.0) for index in map(float, range(points)))

    def number(self, name: str, value: Any, above: float, most: float) -> float:
        if type(value) in (int, float) and above < value <= most and abs(value) <= LARGEST:
            return float(value)
        self.refuse(f"{name}: {shown(value)} must be " + (f"above {above:g} and at most {most:g}" if above == 0.0 else
                                                          "a number from -1e20 to 1e20"))
        return most

    def whole(self, name: str, default: Any, least: int, most: int) -> int:
        value = self.tables.get(name, default)
        if isinstance(value, (int, float, np.integer)) and not isinstance(value, bool) and least <= value <= most and (
                value == int(value)):
            return int(value)
        self.refuse(f"{name}: {shown(value)} must be a whole number from {least} to {most}")
        return least


def _values(case: Case, varied: list[_Varied], total: int, points: int, seed: int) -> dict[str, Doubles]:
    """The values of each quantity in all draws."""
    found: dict[str, Doubles] = {}
    place = 0  # among those that are drawn
    stride = 1  # the first grid goes fastest
    for one in varied:
        numbers = np.array(one.numbers)
        if one.kind == "grid":
            found[one.quantity] = numbers[np.arange(total) % points // stride % numbers.size]
            stride *= numbers.size
            continue
        parts = _random_parts(seed, place, total)
        place += 1
        if one.kind == "normal":
            found[one.quantity] = _value_of(case, one.quantity) + numbers[0] * _normal_quantiles(parts)
        elif one.kind == "uniform":
            found[one.quantity] = numbers[0] + (numbers[1] - numbers[0]) * parts
        else:
            found[one.quantity] = numbers[np.minimum((parts * numbers.size).astype(np.intp), numbers.size - 1)]
    return found


def _random_parts(seed: int, place: int, count: int) -> Doubles:
    """Numbers in (0, 1), one for each draw: Philox4x64 of the draw, the place and the purpose, the first of its words."""
    found = np.empty(count)
    for first in range(0, count, _AT_A_TIME):
        part = found[first:first + _AT_A_TIME]
        counter = (first | place << 64 | _PURPOSE << 128) - 1  # numpy counts before it draws
        bits = np.random.Philox(counter=counter, key=seed).random_raw(4 * part.size)[::4]
        part[:] = (bits >> np.uint64(11) | np.uint64(1)) * 2.0**-53
    return found


def _value_of(case: Case, quantity: str) -> float:
    """The case's own value; of the first cable, where it is that of all."""
    if quantity in _OF_START:
        name, place = _OF_START[quantity]
        value = getattr(case.initial, name)
        return float(value if place is None else value[place])
    if quantity in ("gravity_x", "gravity_y"):
        return case.gravity[quantity == "gravity_y"]
    if hasattr(case, quantity):
        return float(getattr(case, quantity))
    word, _, index = quantity.rpartition("_")
    return float(getattr(case.cables[int(index)], word) if index.isdecimal() else getattr(case.cables[0], quantity))


@functools.cache
def _function() -> Any:
    try:
        function = _library.load("libtautline_normal.so").tautline_normal_quantiles
    except ImportError:
        raise ValueError("normal: the wheel has the library that draws such numbers, and this package lies without; "
                         "take uniform, list or grid") from None
    function.restype = None
    function.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_uint64, ctypes.c_void_p]
    return function


def _normal_quantiles(parts: Doubles, margin: int = 64) -> Doubles:
    """Those of the standard normal distribution; `margin` as in the library."""
    found = np.empty_like(parts)
    _function()(_library.address(parts), parts.size, margin, _library.address(found))
    return found
