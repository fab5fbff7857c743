"""A sweep in parts as tasks of Ray.

Every task writes its own file and returns its row of the manifest.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .arguments import count_of
from .parts import PartError, Parts, SweepPlan, plan_of

if TYPE_CHECKING:
    from .types import SetupLike

__all__ = ["sweep"]

# number of running and waiting tasks for each processor of the cluster
_AHEAD = 4


def sweep(setup: SetupLike = None, *, retries: int = 3, **arguments: Any) -> Parts:
    """Computes all parts on the cluster of ``ray.init``.

    Parameters
    ----------
    setup : SetupLike
        A setup, the name of a preset, or a dict.
    retries : int
        How often a part is tried again, after an error or the death of its worker.
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
        For bad arguments, before any part is sent.
    PartError
        For a part that could not be written.

    Examples
    --------
    >>> import longdrive.ray
    >>> longdrive.ray.sweep(over={"club.loft": "5deg..15deg:3000"}, parts=2)  # doctest: +SKIP
    Traceback (most recent call last):
    longdrive.errors.InputError: a sweep in parts needs output: the folder of the files ...
    """
    try:
        import ray
    except ImportError as error:
        raise ImportError("longdrive.ray needs Ray: pip install ray") from error
    count_of("retries", retries)
    plan = plan_of(setup, arguments)
    write = ray.remote(num_cpus=plan.threads, max_retries=retries, retry_exceptions=True)(
        SweepPlan._written
    )
    shared = ray.put(plan)
    waiting = iter(range(1, plan.parts + 1))
    ahead = _AHEAD * max(1, int(ray.cluster_resources().get("CPU", 1)))
    running: dict[Any, int] = {}
    manifests: list[dict[str, Any]] = []
    while True:
        while len(running) < ahead and (part := next(waiting, None)) is not None:
            running[write.remote(shared, part)] = part
        if not running:
            return Parts.of(plan, manifests)
        for done in ray.wait(list(running))[0]:
            part = running.pop(done)
            try:
                manifests.append(ray.get(done))
            except ray.exceptions.RayError as error:
                for task in running:
                    ray.cancel(task)
                cause = error.cause if isinstance(error, ray.exceptions.RayTaskError) else error
                text = (
                    str(cause)
                    if isinstance(cause, PartError)
                    else f"part {part} of {plan.parts}: {cause}"
                )
                raise PartError(text, part) from error
