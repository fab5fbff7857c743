"""What plots answer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._question import Question
from .arguments import path_of, switch_of
from .errors import InputError
from .reply import Reply
from .types import PathLike

if TYPE_CHECKING:
    from pathlib import Path

__all__ = ["Picture", "picture"]

FORMS = (".svg", ".png", ".csv")
"""The forms that a plot may be made in."""


class Picture(Reply):
    """A plot: notebooks show it, ``save`` writes it. ``svg`` is its text; a plot that was written as PNG or CSV has its bytes in ``data``."""

    @property
    def svg(self) -> str:
        """The picture as SVG."""
        text: str = self["data"].decode("utf-8") if self["form"] == ".svg" else ""
        return text

    def save(self, path: PathLike, *, overwrite: bool = False) -> Path:
        """Writes the picture, in the form that it was made in (SVG, unless ``output`` named another).

        Args:
            path: the file; its ending is that of the form.
            overwrite: whether a file that exists is replaced.

        Raises:
            InputError: for another ending, a file that exists, and a place where no file can be made.
        """
        from pathlib import Path

        path, form = Path(path_of("path", path)), self["form"]
        if path.suffix.lower() != form:
            another = (
                f", or give the plot itself output='{path}', to have it in that form"
                if path.suffix.lower() in FORMS
                else ""
            )
            raise InputError(
                f"path = '{path}': this plot is {form[1:].upper()}; name a file that ends in {form}{another}"
            )
        try:
            # mode "x": another process may make the file meanwhile
            with path.open("wb" if switch_of("overwrite", overwrite) else "xb") as file:
                file.write(self["data"])
        except FileExistsError:
            raise InputError(
                f"the file '{path}': it already exists; use overwrite=True to replace it"
            ) from None
        except FileNotFoundError:
            raise InputError(
                f"the file '{path}': it cannot be written: there is no folder '{path.parent}'"
            ) from None
        except OSError as error:
            raise InputError(
                f"the file '{path}': it cannot be written ({error.strerror}); name another place"
            ) from error
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
