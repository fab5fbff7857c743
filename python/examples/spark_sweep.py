"""A million drives with gradients in 20 parts, on Spark. Submit it to a cluster, or run it on this machine:

    python spark_sweep.py drives
    spark-submit spark_sweep.py /shared/drives

Its workers take the python3 of their path, or the Python that PYSPARK_PYTHON names.
"""

import sys

from pyspark.sql import SparkSession

import longdrive.spark


def main(output: str) -> None:
    spark = SparkSession.builder.appName("drives").getOrCreate()
    found = longdrive.spark.sweep(
        spark,
        "tour-average",
        over={"club.loft": "5deg..15deg:1000", "swing.speed": "80mph..130mph:1000"},
        of=["carry", "lateral"],
        wrt=["club.loft", "swing.speed"],
        output=output,
        parts=20,
    )
    print(f"{found.rows} drives in {len(found.manifests)} files")
    # the files are a table like any other
    spark.read.parquet(f"{output}/part-*.parquet").groupBy("status").count().show()
    spark.stop()


if __name__ == "__main__":
    main(*sys.argv[1:])
