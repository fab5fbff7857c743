"""Typed values of arguments, as the compiled module takes them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Union

__all__ = ["Distribution", "Joined", "Named", "Number", "Range", "Value"]

Number = Union[float, str]
"""A number in SI units, or a text with its unit."""


@dataclass(frozen=True)
class Range:
    """A range of a parameter; of a grid, with the number of values."""

    low: Number
    high: Number
    count: int | None


@dataclass(frozen=True)
class Distribution:
    """A distribution of a parameter: its kind and its numbers."""

    kind: str
    numbers: list[Number]


@dataclass(frozen=True)
class Named:
    """The value of a parameter or an outcome."""

    name: str
    value: Number | Range | Distribution


@dataclass(frozen=True)
class Joined:
    """Changes that make one model together."""

    parts: list[Value]


Value = Union[bool, int, float, str, Range, Distribution, Named, Joined, "list[Value]"]
"""The value of an argument."""
