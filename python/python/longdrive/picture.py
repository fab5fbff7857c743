"""What plots answer."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from .reply import Reply
from .types import PathLike

__all__ = ["Picture", "picture", "written_plot"]


class Picture(Reply):
    """A plot: notebooks show it, ``save`` writes it. ``svg`` is its text; a plot that was written as PNG or CSV has its bytes in ``data``."""

    @property
    def svg(self) -> str:
        """The picture as SVG."""
        text: str = self["data"].decode("utf-8") if self["form"] == ".svg" else ""
        return text

    def save(self, path: str | Path) -> Path:
        """Writes the picture, in the form that it was made in (SVG, unless ``output`` named another)."""
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


def written_plot(output: PathLike | None) -> tuple[str, Callable[[Path], Any]]:
    """What is kept of a plot: its own file, or the one in the folder of the question."""

    def read(folder: Path) -> tuple[str, bytes]:
        path = folder / "plot.svg" if output is None else Path(output)
        return path.suffix.lower(), path.read_bytes()

    return "written", read


def picture(reply: Reply) -> Picture:
    """The answer of a plot with what was written. A file of its own is gone with its folder: it is not named."""
    form, data = reply.pop("written")
    if not Path(reply["file"]).exists():
        reply["file"] = None
    return Picture(reply, form=form, data=data)
