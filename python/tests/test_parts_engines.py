"""Sweeps in parts on Dask, Ray and Spark, with killed workers, failing parts and full disks."""

from __future__ import annotations

import os
import pickle
import resource
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from test_parts import ARGUMENTS, sha256_of_the_set

from longdrive import parts
from longdrive.parts import PartError, SweepPlan

# ignore warnings: the engines issue their own
pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture(scope="module")
def many(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, Any], str]:
    """A sweep in more parts, and the SHA-256 of the set that one worker writes."""
    arguments = {
        **ARGUMENTS, "over": {**ARGUMENTS["over"], "club.loft": "-4deg..15deg:205"}, "parts": 40
    }
    folder = tmp_path_factory.mktemp("many")
    requested = SweepPlan.of(**arguments, output=folder)
    for part in range(requested.parts, 0, -1):
        requested.write(part)
    return arguments, sha256_of_the_set(folder)


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    """Two worker processes of Dask."""
    distributed = pytest.importorskip("distributed")
    import dask

    # a worker is a copy of a process that has imported Dask already
    dask.config.set({"distributed.worker.multiprocessing-method": "forkserver"})
    # on a busy machine the processes of Dask answer late
    dask.config.set(
        {"distributed.admin.tick.limit": "1h", "distributed.comm.timeouts.connect": "1h"}
    )
    with (
        distributed.LocalCluster(
            n_workers=2,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            silence_logs=50,
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


def is_first(file: Path) -> bool:
    """True for the first process that calls it."""
    try:
        file.touch(exist_ok=False)
    except FileExistsError:
        return False
    return True


class Mortal(SweepPlan):
    """A sweep in which one process dies while it writes a part, after three parts are complete."""

    def _written(self, part: int) -> dict[str, Any]:
        folder = Path(self.output)
        if len(list(folder.glob("part-*"))) >= 3 and is_first(folder.parent / "killed"):
            (folder.parent / "killed").write_text(str(os.getpid()))
            os.kill(os.getpid(), signal.SIGKILL)
        return super()._written(part)


class Troubled(Mortal):
    """A sweep in which a part fails and a disk is full, before the process dies."""

    def _written(self, part: int) -> dict[str, Any]:
        place = Path(self.output).parent
        if is_first(place / "poisoned"):
            raise RuntimeError("poisoned once")
        if is_first(place / "full"):
            fill_the_disk(2000)
            try:
                return super()._written(part)
            except PartError as error:
                (place / "full").write_text(str(error))
                raise
            finally:
                empty_the_disk()
        return super()._written(part)


def fill_the_disk(bytes_left: int) -> None:
    """Limits the size of files in this process: writing more fails as on a full disk."""
    # Python ignores the signal of a file that is too large
    _, most = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (bytes_left, most))


def empty_the_disk() -> None:
    _, most = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))


def test_same_set_from_dask_with_a_worker_killed_a_part_poisoned_and_a_disk_full(
    many: tuple[dict[str, Any], str], client: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import longdrive.dask

    arguments, whole = many
    folder = tmp_path / "drives"
    monkeypatch.setattr(parts, "SweepPlan", Troubled)
    pids = list(client.run(os.getpid).values())
    found = longdrive.dask.sweep(client, **arguments, output=folder)
    killed = int((tmp_path / "killed").read_text())
    assert killed in pids and killed not in client.run(os.getpid).values()
    assert (tmp_path / "poisoned").exists()
    assert "it cannot be written" in (tmp_path / "full").read_text()
    assert [row["part"] for row in found.manifests] == list(range(1, 41))
    assert found.rows == 205 * 200
    assert sha256_of_the_set(folder) == whole
    assert parts.check(folder, contents=True)["sha256"] == whole


def test_a_part_that_always_fails_is_named_by_dask(client: Any, tmp_path: Path) -> None:
    import longdrive.dask

    # an earlier test may have killed a worker: wait for its successor
    client.wait_for_workers(2)
    client.run(fill_the_disk, 2000)
    with pytest.raises(PartError, match="part . of 4: .*it cannot be written") as caught:
        longdrive.dask.sweep(client, **ARGUMENTS, output=tmp_path / "drives", retries=1)
    assert 1 <= caught.value.part <= 4
    assert not list((tmp_path / "drives").glob("part-*"))
    client.run(empty_the_disk)


def test_the_result_of_a_part_does_not_grow_with_its_rows(tmp_path: Path) -> None:
    sizes = []
    for rows in (2, 200):
        arguments = {
            **ARGUMENTS,
            "over": {"club.loft": f"5deg..15deg:{1024 * rows}"},
            "of": "carry",
            "parts": 2,
        }
        row = SweepPlan.of(**arguments, output=tmp_path / str(rows)).write(2)
        assert row["rows"] == 512 * rows
        sizes.append(len(pickle.dumps(row)))
    # the row of the longer sweep differs only in digits of its numbers
    assert abs(sizes[1] - sizes[0]) < 100 and max(sizes) < 5000, sizes


def test_same_set_from_processes_one_of_which_is_killed(
    many: tuple[dict[str, Any], str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    arguments, whole = many
    monkeypatch.setattr(parts, "SweepPlan", Mortal)
    found = parts.sweep(**arguments, output=tmp_path / "drives", processes=2)
    assert (tmp_path / "killed").exists()
    assert [row["part"] for row in found.manifests] == list(range(1, 41))
    assert sha256_of_the_set(tmp_path / "drives") == whole


def test_same_set_from_spark(many: tuple[dict[str, Any], str], tmp_path: Path) -> None:
    sql = pytest.importorskip("pyspark.sql")
    pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    import longdrive.spark

    os.environ["PYSPARK_PYTHON"] = sys.executable
    arguments, whole = many
    session = sql.SparkSession.builder.master("local[2, 4]").config(
        "spark.ui.enabled", "false"
    ).getOrCreate()
    session.sparkContext.setLogLevel("OFF")
    try:
        found = longdrive.spark.sweep(session, **arguments, output=tmp_path / "drives")
        assert [row["part"] for row in found.manifests] == list(range(1, 41))
        assert sha256_of_the_set(tmp_path / "drives") == whole
        with pytest.raises(PartError, match="part [0-9]+ of 40: .*different outcomes") as caught:
            longdrive.spark.sweep(
                session, **{**arguments, "of": "carry", "wrt": ()}, output=tmp_path / "drives"
            )
        assert 1 <= caught.value.part <= 40
    finally:
        session.stop()


def test_same_set_from_ray(many: tuple[dict[str, Any], str], tmp_path: Path) -> None:
    ray = pytest.importorskip("ray")
    import longdrive.ray

    arguments, whole = many
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        found = longdrive.ray.sweep(**arguments, output=tmp_path / "drives")
        assert [row["part"] for row in found.manifests] == list(range(1, 41))
        assert sha256_of_the_set(tmp_path / "drives") == whole
        with pytest.raises(PartError, match="different outcomes") as caught:
            longdrive.ray.sweep(
                **{**arguments, "of": "carry", "wrt": ()}, output=tmp_path / "drives", retries=0
            )
        assert 1 <= caught.value.part <= 40
    finally:
        ray.shutdown()


@pytest.mark.parametrize(
    ("module", "engine", "expected"),
    [
        ("dask", "distributed", "dask\\[distributed\\]"),
        ("ray", "ray", "pip install ray"),
        ("spark", "pyspark.errors", "pyspark pandas pyarrow"),
    ],
)
def test_the_message_on_a_missing_engine_has_the_command_to_install_it(
    module: str, engine: str, expected: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    import importlib

    monkeypatch.setitem(sys.modules, engine, None)
    sweep = importlib.import_module(f"longdrive.{module}").sweep
    first = () if module == "ray" else (None,)
    with pytest.raises(ImportError, match=expected):
        sweep(*first, **ARGUMENTS, output="drives")
