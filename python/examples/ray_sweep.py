"""A million drives with gradients in 20 parts, as tasks of Ray: on this machine, or on a cluster.

    python ray_sweep.py drives
    python ray_sweep.py /shared/drives ray://head:10001
"""

import sys

import ray

import longdrive.ray


def main(output: str, cluster: str | None = None) -> None:
    ray.init(cluster, log_to_driver=False)
    found = longdrive.ray.sweep(
        "tour-average",
        over={"club.loft": "5deg..15deg:1000", "swing.speed": "80mph..130mph:1000"},
        of=["carry", "lateral"],
        wrt=["club.loft", "swing.speed"],
        output=output,
        parts=20,
    )
    carry = found.summary["moments"]["carry"]
    print(f"{found.rows} drives in {len(found.manifests)} files; carry {carry['mean']:.1f} m on average")


if __name__ == "__main__":
    main(*sys.argv[1:])
