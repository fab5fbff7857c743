"""What longdrive raises.

Every exception is an ordinary class of Python: it pickles, so that a pool of processes hands it on as it is.
"""

from __future__ import annotations

from typing import Any

__all__ = ["Error", "InputError", "InternalError", "LongdriveWarning", "NoAnswerError"]


class Error(Exception):
    """What longdrive raises, whatever it is."""


class InputError(Error, ValueError):
    """Bad input: a name that nothing bears, a value outside its range, an array of the wrong shape.

    The message is that of the program: it names the thing, its value, what is allowed, and what to do.
    """


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


class LongdriveWarning(UserWarning):
    """What deserves a word about a question or its answer: a drive that leaves what a law of drag and lift was fitted to."""
