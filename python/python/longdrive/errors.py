"""What longdrive raises.

Every exception is an ordinary class of Python: it pickles, so that a pool of processes hands it on as it is.
"""

from __future__ import annotations

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
    """What longdrive raises, whatever it is."""


class InputError(Error, ValueError):
    """Bad input: a name that nothing bears, a value outside its range, an array of the wrong shape.

    The message is that of the program: it names the thing, its value, what is allowed, and what to do.
    """


class UnknownKeyError(InputError, KeyError):
    """A key that a setup, a drive or a table has not; the message has the nearest one that it has."""

    def __str__(self) -> str:
        # a KeyError would quote its message
        return str(self.args[0])


class NoAnswerError(Error):
    """A sound question without an answer: the ball does not fly, a search does not converge.

    `status` says why in a word, as the JSON of the program does: ``no-flight``, ``diverged``, ``undefined``, how a
    search ended.
    """

    status: str

    def __init__(self, message: str, status: str) -> None:
        super().__init__(message)
        self.status = status

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (str(self), self.status))


class InternalError(Error, RuntimeError):
    """A mistake in longdrive itself, which could not go on. Please report it."""


class Interrupted(KeyboardInterrupt):
    """Work that Ctrl-C has ended. The message says how far it was, what is the best so far, and how it can be gone on with.

    ``except KeyboardInterrupt`` catches it, and as any KeyboardInterrupt it is no ``Exception``.
    """

    table: Table | None
    """The rows that were done, of ``batch`` and of ``sweep`` without a file; None elsewhere."""
    answer: Reply | None
    """The answer with what was found so far, of the functions of commands; None where there was none yet."""

    def __init__(
        self, message: str, table: Table | None = None, answer: Reply | None = None
    ) -> None:
        super().__init__(message)
        self.table = table
        self.answer = answer

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (str(self), self.table, self.answer))


class LongdriveWarning(UserWarning):
    """What deserves a word about a question or its answer: a drive that leaves what a law of drag and lift was fitted to.

    Where warnings are errors the answer is not lost: it is in `answer`.
    """

    answer: Any
    """What the function would have returned: a :class:`Drive`, a :class:`Table`, an :class:`Optimum` or another :class:`Reply`, a
    :class:`Picture`."""

    def __init__(self, message: str, answer: Any = None) -> None:
        super().__init__(message)
        self.answer = answer

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (str(self), self.answer))


@contextmanager
def interruptible(message: str) -> Iterator[None]:
    """Ctrl-C within is :class:`Interrupted`, also where it comes before there is anything to show."""
    try:
        yield
    except Interrupted:
        raise
    except KeyboardInterrupt as raised:
        raise Interrupted(message) from raised


def warn_of(texts: Sequence[str], answer: Any, stacklevel: int) -> None:
    """Warns once of all that there is to say of an answer; ``stacklevel`` counts from the caller."""
    if texts:
        warnings.warn(LongdriveWarning("\n".join(texts), answer), stacklevel=stacklevel + 1)
