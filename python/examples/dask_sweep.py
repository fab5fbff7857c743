"""A million drives with gradients in 20 parts, on a cluster of Dask.

The workers belong to this machine, or to a scheduler.

    python dask_sweep.py drives
    python dask_sweep.py /shared/drives tcp://scheduler:8786
"""

import sys
from typing import Any

from dask.distributed import Client, LocalCluster

import longdrive.dask


def main(output: str, scheduler: str | None = None) -> None:
    no_dashboard: Any = None
    cluster = scheduler or LocalCluster(threads_per_worker=1, dashboard_address=no_dashboard)
    with Client(cluster) as client:
        found = longdrive.dask.sweep(
            client,
            "tour-average",
            over={"club.loft": "5deg..15deg:1000", "swing.speed": "80mph..130mph:1000"},
            of=["carry", "lateral"],
            wrt=["club.loft", "swing.speed"],
            highest={"carry": 3},
            output=output,
            parts=20,
        )
    carry = found.summary["moments"]["carry"]
    print(f"{found.rows} drives in {len(found.manifests)} files; carry {carry['mean']:.1f} m on average")
    for row in found.summary["best"][0]["rows"]:
        print(f"  {row['value']:.2f} m with {row['point']}")


if __name__ == "__main__":
    main(*sys.argv[1:])
