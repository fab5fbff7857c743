"""The answers of the commands."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from .request import Request

__all__ = ["COMMON_KEYS", "Reply", "as_reply", "with_rows"]

COMMON_KEYS = {"command", "status", "message", "warnings"}
"""Keys of every answer; an answer without a result has no other keys."""


class Reply(dict[str, Any]):
    """The answer of a command: the content of its ``--json``, with attributes for the keys.

    Numbers are SI; None is a missing value. ``docs/json.md`` describes the keys of each command.
    """

    command: str
    """The name of the command."""
    status: Any
    """The end of the work in one word, such as ``done`` or ``converged``."""
    message: Any
    """The end of the work in a sentence; None if there is nothing to say."""
    warnings: list[str]
    """Warnings about the request or the answer."""
    if not TYPE_CHECKING:  # type checkers know the attributes of each answer

        def __getattr__(self, name: str) -> Any:
            try:
                return self[name]
            except KeyError:
                kind, keys = type(self).__name__, ", ".join(self)
                raise AttributeError(f"this {kind} has no {name!r}; it has {keys}") from None

    @property
    def held(self) -> list[str]:
        """Parameters that a search would vary, but keeps at the stated values."""
        held: list[str] = self.get("held", [])
        return held

    @property
    def advice(self) -> str:
        """Advice on the setup; empty if there is none."""
        advice: str = self.get("advice", "")
        return advice

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def __repr__(self) -> str:
        def shown(value: Any) -> str:
            if isinstance(value, Mapping) and value:
                return f"{{{len(value)} keys}}"
            if isinstance(value, list) and value:
                return f"[{len(value)} items]"
            return repr(value)

        lines = "".join(f"\n  {key}: {shown(value)}" for key, value in self.items())
        return f"<{type(self).__name__}{lines}>"

    def _repr_html_(self) -> str:
        from .notebook import html_of_reply

        return html_of_reply(self)


R = TypeVar("R", bound=Reply)


def as_reply(kind: type[R]) -> Callable[[Reply, object], R]:
    """The function that makes an answer of this class."""
    return lambda reply, _request: kind(reply)


def with_rows(kind: type[R]) -> Callable[[Reply, Request], R]:
    """The function that makes an answer of this class with the rows that stay in memory.

    The answer of ``fly`` without a file has these rows under ``shots``: a dict for each row, SI.
    """

    def answer(reply: Reply, request: Request) -> R:
        if reply["file"] is None and request.content:
            import json

            reply["shots"] = [json.loads(line) for line in request.content.splitlines()]
        return kind(reply)

    return answer
