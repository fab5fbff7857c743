"""How a command of the program is asked, and its answer as an object.

The commands are the program's own, and so are their options, messages and answers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from . import _longdrive
from ._question import Question
from .errors import InputError, Interrupted, NoAnswerError, interruptible, warn_of
from .interruption import interruption
from .progress import follower
from .reply import Reply

__all__ = ["ask"]

T = TypeVar("T")


def ask(command: str, given: Mapping[str, Any], answered: Callable[[Reply, Question], T]) -> T:
    """Asks a command.

    `given` has the arguments of its function, by name: what the program says of its options tells how each is written. `answered` makes the
    answer of the function, of the program's and the question.
    """
    import tempfile
    from pathlib import Path

    function = "longdrive." + command.replace("-", "_").replace(" ", ".")
    with interruptible(f"{function} was interrupted before it began"), tempfile.TemporaryDirectory(
        prefix="longdrive-"
    ) as name:
        question = Question(command, Path(name))
        question.take(given)
        reply = asked(function, question, given, answered)
        with interruptible(_done(function)):
            answer = answered(reply, question)
            # at the line that asked: it called a function of commands.py, which called this one
            warn_of(reply["warnings"], answer, stacklevel=3)
        return answer


def _done(function: str) -> str:
    return f"{function} was interrupted when its work was done, before it could answer; what it was to write is written, and the same call begins again"


def asked(
    function: str,
    question: Question,
    given: Mapping[str, Any],
    answered: Callable[[Reply, Question], Any],
) -> Reply:
    """The program's answer to a question.

    Raises:
        Interrupted: after Ctrl-C; it has what was found so far.
    """
    notes: list[str] = []

    def said(kind: str, text: str) -> None:
        # the answer has warnings and errors
        if kind == "note":
            notes.append(question.shown(text))
            import logging

            logging.getLogger("longdrive").info(notes[-1])

    with follower(question.command, given.get("progress", False)) as shown:
        status, answer, raised = _longdrive.command(question.words, question.text, said, shown)
    if raised is not None and not isinstance(raised, KeyboardInterrupt):
        raise raised
    with interruptible(_done(function)):
        if isinstance(answer, dict):
            answer = question.shown(answer)
        if raised is None:
            return _reply(status, answer, question)
    # a search that had not finished one point has none
    has_answer = (
        isinstance(answer, dict)
        and answer.keys() - OF_EVERY
        and answer.get("optimum", answer) is not None
    )
    found = answered(Reply(answer), question) if has_answer else None
    message = interruption(function, answer, notes, question.continued(given))
    raise Interrupted(message, answer=found) from raised


OF_EVERY = {"command", "status", "message", "warnings"}
"""What every answer has; one that was not found has nothing else."""


def _reply(status: int | None, answer: Any, question: Question) -> Reply:
    if not isinstance(answer, dict):
        raise InputError("the command has no answer" if answer is None else str(answer))
    if status == 2 or (status == 1 and not answer.keys() - OF_EVERY):
        message = answer["message"] or answer["status"]
        raise InputError(question.meant(message)) if answer["status"] == "error" else NoAnswerError(
            message, answer["status"]
        )
    return Reply(answer)
