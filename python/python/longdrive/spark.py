"""A sweep in parts on a cluster of Spark: ``mapInArrow`` over the numbers of the parts.

Every row of the result is a row of the manifest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from .arguments import kind_of
from .errors import InputError
from .parts import PartError, Parts, SweepPlan, plan_of

if TYPE_CHECKING:
    import pyarrow
    from pyspark.sql import DataFrame, SparkSession

    from .types import SetupLike

__all__ = ["manifests", "sweep"]

_COLUMNS = "part long, file string, rows long, bytes long, sha256 string, manifest string"


def _writer(
    plan: SweepPlan,
) -> Callable[[Iterable[pyarrow.RecordBatch]], Iterable[pyarrow.RecordBatch]]:
    def write(batches: Iterable[pyarrow.RecordBatch]) -> Iterable[pyarrow.RecordBatch]:
        import json

        import pyarrow

        for batch in batches:
            for part in batch.column(0).to_numpy().tolist():
                row = plan._written(part)
                of_row = {name: [row[name]] for name in ("part", "file", "rows", "bytes", "sha256")}
                yield pyarrow.RecordBatch.from_pydict({**of_row, "manifest": [json.dumps(row)]})

    return write


def manifests(spark: SparkSession, plan: SweepPlan) -> DataFrame:
    """The parts as a DataFrame, which writes them when it is computed.

    Its columns are `part`, `file`, `rows`, `bytes`, `sha256`, and the row of the manifest as JSON.

    Parameters
    ----------
    spark : SparkSession
        The session. Every executor must have longdrive, and the folder under the same name.
    plan : SweepPlan
        The sweep.

    Returns
    -------
    DataFrame
        The DataFrame.
    """
    # a partition for each part: a task that fails loses one part
    return spark.range(1, plan.parts + 1, 1, plan.parts).mapInArrow(_writer(plan), _COLUMNS)


def sweep(spark: SparkSession, setup: SetupLike = None, **arguments: Any) -> Parts:
    """Computes all parts on a cluster of Spark.

    Spark tries a part ``spark.task.maxFailures`` times.

    Parameters
    ----------
    spark : SparkSession
        The session. Every executor must have longdrive, pandas and pyarrow in its Python, which
        ``PYSPARK_PYTHON`` names (without it the ``python3`` of its path), and the folder `output`
        under the same name.
    setup : SetupLike
        A setup, the name of a preset, or a dict.
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
        For another kind of session, and for bad arguments, before any part is sent.
    PartError
        For a part that could not be written.

    Examples
    --------
    >>> import longdrive.spark
    >>> longdrive.spark.sweep(None)  # doctest: +SKIP
    Traceback (most recent call last):
    longdrive.errors.InputError: spark is a NoneType; expected a SparkSession ...
    """
    try:
        import pandas  # noqa: F401
        import pyarrow  # noqa: F401
        from pyspark.errors import PySparkException
    except ImportError as error:
        raise ImportError(
            "longdrive.spark needs Spark, pandas and Arrow: pip install pyspark pandas pyarrow"
        ) from error
    import json

    from py4j.protocol import Py4JError

    if not callable(getattr(spark, "range", None)):
        raise InputError(
            f"spark is {kind_of(spark)}; expected a SparkSession, as "
            "SparkSession.builder.getOrCreate() gives it"
        )
    plan = plan_of(setup, arguments)
    try:
        rows = manifests(spark, plan).select("manifest").collect()
    except (PySparkException, Py4JError) as error:
        raise _named(plan, error) from error
    return Parts.of(plan, (json.loads(row.manifest) for row in rows))


def _named(plan: SweepPlan, error: Exception) -> PartError:
    """Converts the error of a worker to a PartError, whose part is 0 if it is unknown.

    Spark keeps only the text of an error; the text names the part.
    """
    mark = f" of {plan.parts}: "
    line = next((line for line in str(error).splitlines() if "part " in line and mark in line), "")
    number = line.partition(mark)[0].rpartition(" ")[2]
    if number.isdigit():
        return PartError(line[line.index(f"part {number}{mark}") :], int(number))
    return PartError(f"a part of {plan.output}: {error}", 0)
