"""Runs a command of the program, and returns its answer as an object."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from . import _longdrive
from .errors import InputError, Interrupted, NoAnswerError, interruptible, warn_of
from .progress import follower
from .reply import COMMON_KEYS, Reply

if TYPE_CHECKING:
    from .request import Request

__all__ = ["run_command"]

T = TypeVar("T")


def run_command(
    command: str, arguments: Mapping[str, Any], answer_of: Callable[[Reply, Request], T]
) -> T:
    """Runs a command.

    Parameters
    ----------
    command : str
        The command, as ``optimize`` or ``plot contour``.
    arguments : Mapping[str, Any]
        The arguments of the Python function, by name.
    answer_of : Callable[[Reply, Request], T]
        Makes the result of the function from the reply of the command.

    Raises
    ------
    InputError
        For bad input.
    NoAnswerError
        For a valid request without an answer.
    Interrupted
        After Ctrl-C, with the result so far.
    """
    function = "longdrive." + command.replace("-", "_").replace(" ", ".")
    with interruptible(f"{function} was interrupted before it began"):
        # imported here: `import longdrive` does not need it
        from .request import Request

        request = Request(command, arguments)
        reply = _reply_to(function, request, arguments, answer_of)
        with interruptible(_too_late(function)):
            reply["warnings"] = [*request.warnings, *reply["warnings"]]
            answer = answer_of(reply, request)
            warn_of(reply["warnings"], answer)
        return answer


def _too_late(function: str) -> str:
    return (
        f"{function} was interrupted after its work, before it returned; its files are written, "
        "and the same call begins again"
    )


def _reply_to(
    function: str,
    request: Request,
    arguments: Mapping[str, Any],
    answer_of: Callable[[Reply, Request], Any],
) -> Reply:
    notes: list[str] = []

    def say(kind: str, text: str) -> None:
        # log only notes: the answer contains the warnings and errors
        if kind == "note":
            import logging

            notes.append(text)
            logging.getLogger("longdrive").info(text)

    with follower(request.command, arguments.get("progress", False)) as show:
        status, answer, outputs, raised = _longdrive.command(
            request.command,
            request.values,
            request.setup_text,
            request.files,
            [request.output] if request.output else [],
            say,
            show,
            request.stated,
        )
    if raised is not None and not isinstance(raised, KeyboardInterrupt):
        raise raised
    with interruptible(_too_late(function)):
        request.content = outputs.get(request.output)
        if request.output and isinstance(answer, dict) and answer.get("file") == request.output:
            answer["file"] = None
        if raised is None:
            return _checked(status, answer)
    from .interruption import interruption

    # a search that was interrupted before its first point has no result
    has_result = (
        isinstance(answer, dict)
        and answer.keys() - COMMON_KEYS
        and answer.get("optimum", answer) is not None
    )
    result = answer_of(Reply(answer), request) if has_result else None
    message = interruption(function, answer, notes, _how_to_continue(request.command, arguments))
    raise Interrupted(message, answer=result) from raised


def _how_to_continue(command: str, arguments: Mapping[str, Any]) -> str:
    from .options import options_of

    checkpoint = arguments.get("checkpoint")
    if checkpoint is not None:
        return f"the same call goes on from the checkpoint '{checkpoint}'"
    options = options_of(command)
    if "checkpoint" in options:
        return (
            "the same call begins again; a call with checkpoint=FILE saves every iteration, and "
            "goes on from there"
        )
    if "resume" in options:
        without = " in place of overwrite=True" if arguments.get("overwrite") else ""
        return f"the rows so far are kept, and the same call with resume=True{without} goes on"
    return "the same call begins again"


def _checked(status: int | None, answer: Any) -> Reply:
    if not isinstance(answer, dict):
        raise InputError("the command has no answer" if answer is None else str(answer))
    if status == 2 or (status == 1 and not answer.keys() - COMMON_KEYS):
        message = answer["message"] or answer["status"]
        if answer["status"] == "error":
            raise InputError(message)
        raise NoAnswerError(message, answer["status"])
    return Reply(answer)
