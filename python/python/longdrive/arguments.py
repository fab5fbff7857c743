"""Arguments that are looked at before anything is computed."""

from __future__ import annotations

import operator
from typing import Any

from .errors import InputError

__all__ = ["count_of", "one_name"]


def count_of(name: str, value: Any, least: int = 0) -> int:
    """A whole number of at least so much.

    Raises:
        InputError: for anything else; it names the argument and its value.
    """
    try:
        number = operator.index(value)
    except TypeError:
        number = least - 1
    if isinstance(value, bool) or number < least:
        raise InputError(f"{name} = {value!r}; expected a whole number of {least} or more")
    return number


def one_name(name: str, value: Any, several: str) -> str:
    """One name; `several` says what takes more.

    Raises:
        InputError: for anything else.
    """
    if not isinstance(value, str):
        raise InputError(f"{name} is a {type(value).__name__}; expected one name, as in {name}='carry'; {several}")
    return value
