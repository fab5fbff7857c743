"""Pictures: the results of the plots."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .arguments import path_of, switch_of
from .errors import InputError
from .reply import Reply

if TYPE_CHECKING:
    from pathlib import Path

    from .request import Request
    from .types import PathLike

__all__ = ["Picture", "picture"]

_FORMATS = (".svg", ".png", ".csv")


class Picture(Reply):
    """A plot. Notebooks show it, :meth:`save` writes it."""

    title: str
    """Title of the plot."""
    subtitle: str
    """Line below the title with the constant parameters; may be empty."""
    note: str
    """Note below the plot."""
    form: str
    """The format: ``.svg``, ``.png`` or ``.csv``."""
    data: bytes
    """The content of its file."""

    @property
    def svg(self) -> str:
        """The picture as SVG; an empty text if it has another format."""
        text: str = self["data"].decode("utf-8") if self["form"] == ".svg" else ""
        return text

    def save(self, path: PathLike, *, overwrite: bool = False) -> Path:
        """Writes the picture in its format: SVG, unless ``output`` named another.

        Parameters
        ----------
        path : str or path
            The file, with the extension of the format.
        overwrite : bool
            Replace a file that exists.

        Returns
        -------
        pathlib.Path
            The file.

        Raises
        ------
        InputError
            For another extension, a file that exists, and a folder that does not exist.

        Examples
        --------
        >>> import longdrive, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     longdrive.plot.trajectory().save(f"{folder}/drive.svg").name
        'drive.svg'
        """
        from pathlib import Path

        path, form = Path(path_of("path", path)), self["form"]
        if path.suffix.lower() != form:
            advice = (
                f", or make the plot with output='{path}' to have it in that format"
                if path.suffix.lower() in _FORMATS
                else ""
            )
            raise InputError(
                f"path = '{path}': this plot is {form[1:].upper()}; name a file that ends in "
                f"{form}{advice}"
            )
        try:
            # mode "x" refuses a file that another process creates meanwhile
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


def picture(reply: Reply, request: Request) -> Picture:
    """The picture of a plot, from memory or from its file."""
    from pathlib import Path

    path = Path(reply["file"] or request.output)
    data = request.content or b"" if reply["file"] is None else path.read_bytes()
    if request.axes is not None:
        from .axes import draw

        lines = [reply["title"], reply["subtitle"]]
        draw(request.axes, data, reply["name"], "\n".join(filter(None, lines)))
    return Picture(reply, form=path.suffix.lower(), data=data)
