"""A sweep in parts on a cluster of Dask: futures alone, no DataFrame. Every part is a task that writes its own file and returns a manifest row."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .arguments import count_of, kind_of
from .errors import InputError
from .parts import PartError, Parts, question_of
from .types import SetupLike

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["sweep"]


def sweep(client: Client, setup: SetupLike = None, *, retries: int = 3, **question: Any) -> Parts:
    """Computes all parts on the workers of a cluster.

    What travels is a number to a worker and a manifest row back: the memory of the scheduler grows with the parts, not with the rows. A worker that
    dies, and a part that fails, cost that part's work.

    Args:
        client: of the cluster. Every worker has longdrive and sees the folder `output` under its name.
        setup: a setup, the name of a preset, or a dict.
        retries: how often a part that fails is tried again.
        question: as :meth:`longdrive.parts.Question.of`: `output`, `parts`, `over` or `sample`, `of`, `wrt`, `instructions`, …

    Raises:
        InputError: for another kind of client, and for what is wrong with the question, before any part is sent.
        PartError: for a part that could not be written.
    """
    try:
        from distributed import Client, as_completed
    except ImportError as error:
        raise ImportError("longdrive.dask needs Dask: pip install 'dask[distributed]'") from error
    if not isinstance(client, Client):
        raise InputError(
            f"client is {kind_of(client)}; expected a distributed.Client of the cluster, as in longdrive.dask.sweep(Client(), 'tour-average', …)"
        )
    count_of("retries", retries)
    asked = question_of(setup, question)
    # not pure: what another sweep has written says nothing about this folder
    futures = client.map(asked.write, range(1, asked.parts + 1), pure=False, retries=retries)
    part_of = {future.key: part for part, future in enumerate(futures, start=1)}
    manifests: list[dict[str, Any]] = []
    try:
        for future in as_completed(futures):
            failure = future.exception()
            if failure is None:
                manifests.append(future.result())
            elif isinstance(failure, PartError):
                raise failure
            else:
                part = part_of[future.key]
                raise PartError(
                    f"part {part} of {asked.parts}: {type(failure).__name__}: {failure}", part
                ) from failure
            # its manifest row is here
            future.release()
    finally:
        client.cancel(futures)
    return Parts.of(asked, manifests)
