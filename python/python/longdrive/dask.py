"""A sweep in parts on a cluster of Dask.

Every part is a task that writes its own file and returns its row of the manifest.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .arguments import count_of, kind_of
from .errors import InputError
from .parts import PartError, Parts, plan_of

if TYPE_CHECKING:
    from distributed import Client

    from .types import SetupLike

__all__ = ["sweep"]


def sweep(client: Client, setup: SetupLike = None, *, retries: int = 3, **arguments: Any) -> Parts:
    """Computes all parts on the workers of a cluster.

    A worker receives a number and returns a row of the manifest: the memory of the scheduler grows
    with the parts, not with the rows. The death of a worker, or an error, loses one part only.

    Parameters
    ----------
    client : Client
        The client of the cluster. Every worker must have longdrive, and the folder `output` under
        the same name.
    setup : SetupLike
        A setup, the name of a preset, or a dict.
    retries : int
        How often a part that fails is tried again.
    arguments : Any
        As :meth:`longdrive.parts.SweepPlan.of`: `output`, `parts`, `over` or `sample`, `of`, `wrt`,
        `instructions`, …

    Returns
    -------
    Parts
        The parts.

    Raises
    ------
    InputError
        For another kind of client, and for bad arguments, before any part is sent.
    PartError
        For a part that could not be written.

    Examples
    --------
    >>> import longdrive.dask
    >>> longdrive.dask.sweep(None)
    Traceback (most recent call last):
    longdrive.errors.InputError: client is a NoneType; expected a distributed.Client ...
    """
    try:
        from distributed import Client, as_completed
    except ImportError as error:
        raise ImportError("longdrive.dask needs Dask: pip install 'dask[distributed]'") from error
    if not isinstance(client, Client):
        raise InputError(
            f"client is {kind_of(client)}; expected a distributed.Client of the cluster, as in "
            "longdrive.dask.sweep(Client(), 'tour-average', …)"
        )
    count_of("retries", retries)
    plan = plan_of(setup, arguments)
    # pure=False: otherwise Dask would reuse the results of an earlier sweep, although the folder
    # may have changed
    futures = client.map(plan._written, range(1, plan.parts + 1), pure=False, retries=retries)
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
                    f"part {part} of {plan.parts}: {type(failure).__name__}: {failure}", part
                ) from failure
            # free the result on the cluster: this process has a copy of the manifest row
            future.release()
    finally:
        client.cancel(futures)
    return Parts.of(plan, manifests)
