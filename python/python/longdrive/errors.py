"""Exceptions and warnings."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .reply import Reply
    from .table import Table

__all__ = [
    "Error",
    "InputError",
    "InternalError",
    "Interrupted",
    "LongdriveWarning",
    "NoAnswerError",
    "UnknownKeyError",
]


class Error(Exception):
    """Base class of the exceptions of longdrive, except :class:`Interrupted`."""


class InputError(Error, ValueError):
    """Bad input: an unknown name, a value outside its range, an array of the wrong shape.

    The message has the name, its value, the allowed range, and what to type.
    """


class UnknownKeyError(InputError, KeyError):
    """An unknown key of a setup, a drive or a table. The message names the nearest known key."""

    def __str__(self) -> str:
        # a KeyError would quote its message
        return str(self.args[0])


class NoAnswerError(Error):
    """A valid request without an answer: the ball does not fly, a search does not converge.

    ``status`` is the reason in one word, as in the JSON of the program: ``no-flight``,
    ``aloft``, ``diverged``, ``undefined``, or the end of a search.
    """

    status: str

    def __init__(self, message: str, status: str) -> None:
        super().__init__(message)
        self.status = status

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (str(self), self.status))


class InternalError(Error, RuntimeError):
    """A bug in longdrive. Please report it."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C ended the work. The message has the progress, the best result and how to continue.

    ``except KeyboardInterrupt`` catches it; ``except Exception`` does not.
    """

    table: Table | None
    """The rows that ``batch`` (or ``sweep`` without a file) had computed before the interruption;
    None for other functions."""
    answer: Reply | None
    """The partial result of a function that runs a command; None if there was no result yet."""

    def __init__(
        self, message: str, table: Table | None = None, answer: Reply | None = None
    ) -> None:
        super().__init__(message)
        self.table = table
        self.answer = answer

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (str(self), self.table, self.answer))


class LongdriveWarning(UserWarning):
    """A warning about a request or its answer, such as a flight beyond the range of its law.

    If warnings are raised as errors, ``answer`` has the result of the function.
    """

    answer: Any
    """The result: a :class:`Drive`, a :class:`Table`, an :class:`Optimum` or another
    :class:`Reply`, a :class:`Picture`, a :class:`Setup`, derivatives, a function."""

    def __init__(self, message: str, answer: Any = None) -> None:
        super().__init__(message)
        self.answer = answer

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (str(self), self.answer))


@contextmanager
def interruptible(message: str) -> Iterator[None]:
    """Turns Ctrl-C within the block into :class:`Interrupted` with this message."""
    try:
        yield
    except Interrupted:
        raise
    except KeyboardInterrupt as raised:
        raise Interrupted(message) from raised


def warn_of(texts: Sequence[str], answer: Any) -> None:
    """Issues one warning with these texts, at the line that called longdrive."""
    if not texts:
        return
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        frame, level = frame.f_back, level + 1
    warnings.warn(LongdriveWarning("\n".join(texts), answer), stacklevel=level)
