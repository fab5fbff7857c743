"""Arguments that are looked at before anything is computed."""

from __future__ import annotations

import operator
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from .errors import InputError

__all__ = [
    "MOST_SCENARIOS",
    "MOST_SEED",
    "count_of",
    "kind_of",
    "no_attribute",
    "one_name",
    "path_of",
    "refuse_idle_seed",
    "shown",
    "switch_of",
    "whole_characters",
]

MOST_SEED = 2**32 - 1
"""The greatest seed of swings and of samples."""

MOST_SCENARIOS = 100_000
"""As many swings may stand for all."""


def kind_of(value: Any) -> str:
    """The type of a value with its article, for messages: ``an int``, ``a list``."""
    name = type(value).__name__
    return f"{'an' if name[0].lower() in 'aeio' or name == 'ndarray' else 'a'} {name}"


def shown(value: Any) -> str:
    """A value as messages show it: as Python writes it, cut where it is long."""
    try:
        text = repr(value)
    # what lies too deep within itself, and whole numbers of more than 4300 digits
    except (RecursionError, ValueError):
        return f"{kind_of(value)} too long to show"
    return text if len(text) <= 400 else f"{text[:60]}… ({len(text)} characters)"


@contextmanager
def whole_characters(name: str) -> Iterator[None]:
    """A text that is no Unicode is told with the argument that has it."""
    try:
        yield
    except UnicodeEncodeError as error:
        raise InputError(
            f"{name}: {shown(error.object.strip())} has half a character (a lone surrogate); give the text without it"
        ) from None


def no_attribute(owner: object, name: str, instead: str) -> AttributeError:
    """What is raised for an attribute that there is not, with what there is instead."""
    return AttributeError(
        f"a {type(owner).__name__} has no attribute '{name}'; {instead}", name=name, obj=owner
    )


def refuse_idle_seed(seed: Any, sample: Any) -> None:
    """A seed where nothing is sampled.

    Raises:
        InputError: for one that would have no effect.
    """
    if seed is None:
        return
    count_of("seed", seed, most=MOST_SEED)
    if sample is None:
        raise InputError(
            f"seed = {seed!r} chooses the points of a sample, and nothing is sampled; give sample too, or leave seed out"
        )


def count_of(name: str, value: Any, least: int = 0, most: int = sys.maxsize) -> int:
    """A whole number of at least so much, and at most so much.

    Raises:
        InputError: for anything else; it names the argument and its value.
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


def switch_of(name: str, value: Any, instead: str = "") -> bool:
    """Whether something is switched on: True or False, NumPy's too; `instead` says what else is taken.

    Raises:
        InputError: for anything else, which is not guessed at: ``overwrite="no"`` must not replace a file.
    """
    if not isinstance(value, (bool, np.bool_)):
        raise InputError(
            f"{name} = {shown(value)}; expected True or False{f', or {instead}' if instead else ''}"
        )
    return bool(value)


def one_name(name: str, value: Any, several: str) -> str:
    """One name; `several` says what takes more.

    Raises:
        InputError: for anything else.
    """
    if not isinstance(value, str):
        raise InputError(
            f"{name} is {kind_of(value)}; expected one name, as in {name}='carry'; {several}"
        )
    with whole_characters(name):
        value.encode()
    return value


def path_of(name: str, value: Any, what: str = "file") -> str:
    """The name of a file or a folder.

    Raises:
        InputError: for anything else; `what` says what is expected.
    """
    if not isinstance(value, (str, os.PathLike)):
        raise InputError(f"{name} is {kind_of(value)}; expected the name of a {what}")
    with whole_characters(name):
        os.fsencode(value)
    return os.fsdecode(value)
