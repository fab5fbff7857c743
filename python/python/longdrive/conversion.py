"""Conversion of arguments (numbers, pairs, dicts, quantities) to typed values, as the compiled
module takes them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from dataclasses import dataclass
from typing import Any, Union

from . import _longdrive
from .angles import BareAngles
from .arguments import count_of, kind_of, path_of, shown, switch_of
from .errors import InputError
from .options import Option
from .quantities import elements_of, is_quantity, number_of
from .tables import head_of

__all__ = [
    "Converter",
    "Distribution",
    "FILES",
    "Joined",
    "Named",
    "Number",
    "Range",
    "Value",
    "refuse_empty",
]

Number = Union[float, str]
"""A number in SI units, or a text with its unit."""


@dataclass(frozen=True)
class Range:
    """A range of a parameter; for a grid, also the number of values in the range."""

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
    """A parameter or an outcome with its value."""

    name: str
    value: Number | Range | Distribution


@dataclass(frozen=True)
class Joined:
    """Changes that together make one model."""

    parts: list[Value]


Value = Union[bool, int, float, str, Range, Distribution, Named, Joined, "list[Value]"]
"""The value of an argument."""

FILES = {"FILE": "file", "DIR": "folder", "DIR or FILE.csv": "folder or of a CSV file"}
"""Words for the placeholders of files and folders, for messages."""

_UNITS = {"LENGTH": "m", "SPEED": "m/s", "ANGLE": "rad", "SPIN": "rad/s"}
"""SI units of the values of options, by the placeholder of the value in the help."""

_DIFFERENCES = {"sigma", "change"}
"""Arguments whose numbers are differences: a difference of 2 degC is 2 K."""

_WHOLE = {"N", "K", "SEED", "PIXELS"}
_EXPECTED = {
    "OUTCOME": "one outcome or goal, as in {}='carry'",
    **dict.fromkeys(_WHOLE, "a whole number"),
    **dict.fromkeys(("NUMBER", "POINT"), "a number"),
}
"""Expected values of options with one value, for messages, by the placeholder in the help."""

_NO_EMPTY = {"distribution", "sigma", "model"}
"""Arguments that replace defaults: an empty list or dict would bring the defaults back."""


class Converter:
    """Converts the values of the arguments of one call."""

    def __init__(self, goal: str = "carry", bare_angles: BareAngles | None = None) -> None:
        self._goal = goal
        self._bare_angles = bare_angles or BareAngles("rad")

    def convert(self, option: Option, value: Any) -> Value:
        """The typed value of an argument.

        Raises
        ------
        InputError
            For a value that the option does not take.
        """
        if option.takes == "nothing":
            return switch_of(option.argument, value)
        if option.takes == "one":
            return self._one(option, value)
        return self._several(option, value)

    def _one(self, option: Option, value: Any) -> Value:
        name, expected = option.argument, option.value
        if expected in FILES:
            return path_of(name, value, FILES[expected])
        if expected in _UNITS:
            return self.number(name, value, _UNITS[expected])
        if expected == "AMOUNT":
            return self.number(name, value, _longdrive.unit_of_goal(self._goal))
        if option.is_named:
            return self._only(option, value)
        message = _EXPECTED.get(expected, "one text").format(name)
        if isinstance(value, (Mapping, Set)) or elements_of(value) is not None:
            raise InputError(f"{name} is {kind_of(value)}; expected {message}")
        try:
            text = str(value)
        except ValueError:  # Python does not write whole numbers of more than 4300 digits
            raise InputError(f"{name} = {shown(value)}; expected {message}") from None
        whole: int | None = value if type(value) is int else None
        return text if whole is None else whole

    def _only(self, option: Option, value: Any) -> Value:
        """The only entry (name and value) of an option that takes a single entry."""
        values = self._several(option, value)
        if len(values) == 1:
            only = values[0]
            names = _names_in(only) if isinstance(only, str) else []
            if len(names) < 2:
                return only
        else:
            names = [_name_of(value) for value in values]
        found = f"has {len(names)} parameters ({', '.join(names)})" if names else "is empty"
        name = option.argument
        raise InputError(
            f"{name} {found}; expected one, as in {name}={{'swing.speed': (40.0, 50.0)}}"
        )

    def _several(self, option: Option, value: Any) -> list[Value]:
        name = option.argument
        if isinstance(value, str):
            return [value]
        if isinstance(value, Mapping):
            if option.value == "CONSTRAINT":
                raise InputError(
                    f"{name} is {kind_of(value)}; expected a text or a list of texts, as in "
                    f"{name}=['descent_angle >= 38 deg']"
                )
            return [self._named(option, key, inner) for key, inner in value.items()]
        try:
            items = list(value)
        except TypeError:
            raise InputError(
                f"{name} is {kind_of(value)}; expected a text, a list of texts, or a dict of "
                "names with values"
            ) from None
        other = next((item for item in items if not isinstance(item, (str, Mapping))), None)
        if other is not None or None in items:
            one_dict = f", or one dict for all, as in {name}={{'club.loft': …}}"
            advice = one_dict if option.is_named else ""
            raise InputError(
                f"{name} has {kind_of(other)} in its {type(value).__name__}: {shown(other)}; "
                f"expected texts{advice}"
            )
        return [
            Joined(self._several(option, item)) if isinstance(item, Mapping) else str(item)
            for item in items
        ]

    def _named(self, option: Option, key: Any, value: Any) -> Value:
        """A name with its value: a number, a text, a range or a distribution."""
        name = option.argument
        if isinstance(key, tuple):
            names = ",".join(map(str, key))
            return Named(names, self.number(names, value, ""))
        text = str(key)
        if value is None:
            return text
        elements = elements_of(value)
        if elements is None:
            return Named(text, self._amount(text, value, is_difference=name in _DIFFERENCES))
        is_distribution = elements and isinstance(elements[0], str) and elements[0].isidentifier()
        if "KIND" in option.value and is_distribution:
            return Named(text, self._distribution(text, elements))
        # only a tuple can be (low, high, count): a list or an array of three has no count
        is_grid = len(elements) == 3 and isinstance(value, tuple) and ":" in option.value
        if ".." not in option.value or not (len(elements) == 2 or is_grid):
            raise InputError(
                f"{key} in {name} is {kind_of(value)} of {len(elements)}; expected "
                f"{_expected_for(option, key)}"
            )
        low, high = self._amount(text, elements[0]), self._amount(text, elements[1])
        count = _count_of(text, elements[-1]) if is_grid else None
        return Named(text, Range(low, high, count))

    def _distribution(self, key: str, elements: tuple[Any, ...]) -> Distribution:
        # the second number of a normal distribution is its standard deviation
        deviation = 1 if elements[0] in ("normal", "truncated") else None
        numbers = [
            self._amount(key, number, is_difference=at == deviation)
            for at, number in enumerate(elements[1:])
        ]
        return Distribution(elements[0], numbers)

    def _amount(self, name: str, value: Any, is_difference: bool = False) -> Number:
        unit = _longdrive.unit_of(name)
        if unit is None:
            # do not raise here for an unknown name: the command refuses it later
            value, unit = value.magnitude if is_quantity(value) else value, ""
        return self.number(name, value, unit, is_difference)

    def number(
        self, name: str, value: Any, unit: str, is_difference: bool = False
    ) -> Number:
        """A number in an SI unit, or a text with its unit unchanged.

        Raises
        ------
        InputError
            For other values. The message names the argument or the parameter.
        """
        if value is None:
            raise InputError(
                f"{name} has None where a value is needed; give a number (SI), or a text with its "
                "unit like '10.5 deg'"
            )
        if isinstance(value, str):
            return value
        has_unit = is_quantity(value)
        try:
            number = number_of(value, unit, is_difference)
        except InputError as error:
            raise InputError(f"{name}: {error}") from None
        return self._bare_angles.read(name, number) if unit == "rad" and not has_unit else number

    def places(self, along: Any, values: Any) -> list[Value]:
        """The argument ``at``: values of the parameter that ``along`` names."""
        first = along
        if not isinstance(along, str):
            first = str(next(iter(along), "")) if isinstance(along, Iterable) else ""
        parameter = first.split("=")[0].strip()
        elements = elements_of(values)
        return [
            self._amount(parameter, value)
            for value in ((values,) if elements is None else elements)
        ]


def _names_in(text: str) -> list[str]:
    """The names of parameters in a text such as ``a=1..2,b=3``."""
    return [part.rpartition(",")[2].strip() for part in text.split("=")[:-1]]


def _name_of(value: Value) -> str:
    if isinstance(value, Named):
        return value.name
    return ", ".join(_names_in(value) or [value]) if isinstance(value, str) else str(value)


def _count_of(name: str, value: Any) -> int:
    """The number of values of a range: an int, a whole float such as 11.0, or a text of digits."""
    is_whole = isinstance(value, float) and value.is_integer()
    is_digits = isinstance(value, str) and value.isdigit()
    return count_of(f"the count of {name}", int(value) if is_whole or is_digits else value, 1)


def _expected_for(option: Option, key: Any) -> str:
    """The values that an option takes for a name, for messages."""
    if "KIND" in option.value:
        return (
            "a kind with its numbers, as in ('normal', mean, deviation) or "
            "('uniform', low, high), or a text like 'normal(50 m/s, 1.5 m/s)'"
        )
    if ".." not in option.value:
        return "one number (SI), or a text with its unit"
    if ":" in option.value:
        advice = (
            "; your own values, with one drive for each, go into "
            f"points={{'{head_of(str(key))}': …}}, or to longdrive.batch"
        )
        return "a tuple (low, high, count), for values spread evenly" + (
            advice if option.argument == "over" else ""
        )
    return "(low, high)" + (
        "; your own values go into at=…" if option.argument == "along" else ""
    )


def is_empty(value: Any) -> bool:
    """True for an empty list, dict or array; false for a text."""
    if isinstance(value, str) or not (hasattr(value, "__len__") and hasattr(value, "__iter__")):
        return False
    try:
        return len(value) == 0
    except TypeError:  # a scalar quantity of pint has these methods, and no length
        return False


def refuse_empty(option: Option, value: Any) -> None:
    """Refuses an empty dict or list where it would silently mean the default.

    Raises
    ------
    InputError
        For such a value. The message has the purpose of the option.
    """
    needs_value = (
        option.argument in _NO_EMPTY or option.is_required or option.has_default
    )
    if needs_value and is_empty(value):
        advice = "" if option.is_required else ", or leave it out"
        raise InputError(f"{option.argument} is empty; give one or more{advice}: {option.help}")
