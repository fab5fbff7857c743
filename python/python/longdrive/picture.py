"""What plots answer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._ask import Question
from .reply import Reply

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["Picture", "picture"]


class Picture(Reply):
    """A plot: notebooks show it, ``save`` writes it. ``svg`` is its text; a plot that was written as PNG or CSV has its bytes in ``data``."""

    @property
    def svg(self) -> str:
        """The picture as SVG."""
        text: str = self["data"].decode("utf-8") if self["form"] == ".svg" else ""
        return text

    def save(self, path: str | Path) -> Path:
        """Writes the picture, in the form that it was made in (SVG, unless ``output`` named another)."""
        from pathlib import Path

        path = Path(path)
        if path.suffix != self["form"]:
            raise ValueError(f"{path}: this plot is {self['form']}; give the plot itself output='{path}' to have it in another form")
        path.write_bytes(self["data"])
        return path

    def __repr__(self) -> str:
        return f"<Picture {self['title']!r}, {self['form']}, {len(self['data'])} bytes>"

    def _repr_html_(self) -> str:
        return self.svg or super()._repr_html_()

    def _repr_png_(self) -> bytes | None:
        return self["data"] if self["form"] == ".png" else None


def picture(reply: Reply, question: Question) -> Picture:
    """The answer of a plot, with what was written: into its own file, or into one that goes with the question."""
    from pathlib import Path

    path = question.scratch if reply["file"] is None else Path(reply["file"])
    assert path is not None
    return Picture(reply, form=path.suffix.lower(), data=path.read_bytes())
