"""Checks of arguments before any computation."""

from __future__ import annotations

import operator
import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from typing import Any

import numpy as np

from . import _longdrive
from .errors import InputError

__all__ = [
    "MOST_SCENARIOS",
    "MOST_SEED",
    "count_of",
    "kind_of",
    "nearest_outcome",
    "no_attribute",
    "one_name",
    "outcome_names",
    "path_of",
    "refuse_idle_seed",
    "refuse_stated_launch",
    "shown",
    "switch_of",
    "whole_characters",
]

MOST_SEED = 2**32 - 1
"""The largest seed."""

MOST_SCENARIOS = 100_000
"""The largest number of swings in a search."""


def kind_of(value: Any) -> str:
    """The type of a value with its article, for messages: ``an int``, ``a list``."""
    name = type(value).__name__
    return f"{'an' if name[0].lower() in 'aeio' or name == 'ndarray' else 'a'} {name}"


def shown(value: Any) -> str:
    """The repr of a value for messages, shortened to 400 characters."""
    try:
        text = repr(value)
    # repr fails for deeply nested values and for whole numbers of more than 4300 digits
    except (RecursionError, ValueError):
        return f"{kind_of(value)} too long to show"
    return text if len(text) <= 400 else f"{text[:60]}… ({len(text)} characters)"


@contextmanager
def whole_characters(name: str) -> Iterator[None]:
    """Makes the error of a text with a lone surrogate (half a character) name the argument."""
    try:
        yield
    except UnicodeEncodeError as error:
        raise InputError(
            f"{name}: {shown(error.object.strip())} has half a character (a lone surrogate); give "
            "the text without it"
        ) from None


def no_attribute(owner: object, name: str, advice: str) -> AttributeError:
    """The error of an unknown attribute, with advice."""
    return AttributeError(
        f"a {type(owner).__name__} has no attribute '{name}'; {advice}", name=name, obj=owner
    )


@cache
def outcome_names() -> frozenset[str]:
    """The names of all outcomes."""
    return frozenset(row["name"] for row in _longdrive.outcomes())


def nearest_outcome(name: str) -> str:
    """An outcome as an example in a message: ``name`` if it is an outcome, else carry."""
    return name if name in outcome_names() else "carry"


_MEASURED_LAUNCH = (
    "launch",
    "ball_speed",
    "launch_angle",
    "launch_direction",
    "spin",
    "spin_axis",
    "backspin",
    "sidespin",
    "shots",
)
"""Arguments of ``delivery`` that give a measured launch."""


def refuse_stated_launch(setup: Any, arguments: Mapping[str, Any]) -> None:
    """Refuses a launch in a dict in place of a setup if arguments give the measured launch too.

    The launch of the dict would have no effect.
    """
    if not isinstance(setup, Mapping) or isinstance(setup, _longdrive.Setup):
        return
    stated = [name for name in _longdrive.parameter_names_in(setup) if name.startswith("launch.")]
    measured = [name for name in _MEASURED_LAUNCH if arguments.get(name) is not None]
    if stated and measured:
        raise InputError(
            f"{', '.join(stated)} of the setup: {', '.join(measured)} give the measured launch, so "
            "this one is not used; leave it out"
        )


def refuse_idle_seed(seed: Any, sample: Any) -> None:
    """Refuses a seed without a sample, because the seed would have no effect.

    Raises
    ------
    InputError
        For such a seed. The message has its value.
    """
    if seed is None:
        return
    count_of("seed", seed, most=MOST_SEED)
    if sample is None:
        raise InputError(
            f"seed = {seed!r} chooses the points of a sample, and nothing is sampled; give sample "
            "too, or leave seed out"
        )


def count_of(name: str, value: Any, least: int = 0, most: int = sys.maxsize) -> int:
    """A whole number from `least` to `most`.

    Raises
    ------
    InputError
        For other values. The message names the argument.
    """
    try:
        number = operator.index(value)
    except TypeError:
        number = least - 1
    if isinstance(value, bool) or not least <= number <= most:
        end = f" (at most {most})" if number > most else ""
        raise InputError(
            f"{name} = {shown(value)}; expected a whole number of {least} or more{end}"
        )
    return number


def switch_of(name: str, value: Any, alternative: str = "") -> bool:
    """True or False, also of NumPy. Other values are refused: ``overwrite="no"`` is not False.

    Parameters
    ----------
    name : str
        The argument, for messages.
    value : Any
        The value.
    alternative : str
        Other values that the argument accepts, for messages.

    Raises
    ------
    InputError
        For another value.
    """
    if not isinstance(value, (bool, np.bool_)):
        others = f", or {alternative}" if alternative else ""
        raise InputError(f"{name} = {shown(value)}; expected True or False{others}")
    return bool(value)


def one_name(name: str, value: Any, advice: str) -> str:
    """One name; `advice` names the function that takes several.

    Raises
    ------
    InputError
        For another value.
    """
    if not isinstance(value, str):
        raise InputError(
            f"{name} is {kind_of(value)}; expected one name, as in {name}='carry'; {advice}"
        )
    with whole_characters(name):
        value.encode()
    return value


def path_of(name: str, value: Any, expected: str = "file") -> str:
    """The name of a file or a folder.

    Raises
    ------
    InputError
        For another value; the message has `expected`.
    """
    if not isinstance(value, (str, os.PathLike)):
        raise InputError(f"{name} is {kind_of(value)}; expected the name of a {expected}")
    with whole_characters(name):
        os.fsencode(value)
    return os.fsdecode(value)
