"""Writes the tables of this folder: python3 -m venv v && v/bin/pip install pyarrow==26.0.1
duckdb==2.0.1 && v/bin/python make.py"""

import duckdb
import pyarrow as pa
import pyarrow.feather as feather
import pyarrow.parquet as parquet

# the values of each column; Python prints enough decimals to determine a value exactly
ROWS = 11
COLUMNS = {
    "club.loft": [0.1 + 0.017 * i for i in range(ROWS)],
    "swing.speed": [40.0 + 1.3 * i for i in range(ROWS)],
    "swing.attack_angle": [-0.05 + 0.01 * i for i in range(ROWS)],
}
points = pa.table(COLUMNS)

with open("points.csv", "w") as file:
    print(*COLUMNS, sep=",", file=file)
    for row in zip(*COLUMNS.values()):
        print(*map(repr, row), sep=",", file=file)
parquet.write_table(points, "points.parquet", row_group_size=4)


def write(name, table, new=pa.ipc.new_file, rows=None, **options):
    with new(name, table.schema, options=pa.ipc.IpcWriteOptions(**options)) as writer:
        writer.write_table(table, max_chunksize=rows)


write("points.arrow", points, rows=4)
write("points.arrows", points, new=pa.ipc.new_stream, rows=4)
write("legacy.arrows", points, new=pa.ipc.new_stream, rows=4, use_legacy_format=True)
write("version4.arrow", points, rows=4, metadata_version=pa.ipc.MetadataVersion.V4)
feather.write_feather(points, "zstd.feather", compression="zstd", chunksize=4)
feather.write_feather(points, "lz4.feather", chunksize=4)
# long and repetitive enough to be compressible
write(
    "long_zstd.arrows",
    pa.table({"club.loft": [0.2] * 4000}),
    new=pa.ipc.new_stream,
    rows=1500,
    compression="zstd",
)

# an empty batch between others
with pa.ipc.new_stream("gaps.arrows", points.schema) as writer:
    for part in [
        points.slice(0, 0),
        points.slice(0, 5),
        points.slice(5, 0),
        points.slice(5, 1),
        points.slice(6),
    ]:
        for batch in part.to_batches() or [
            pa.RecordBatch.from_arrays([[]] * 3, schema=points.schema)
        ]:
            writer.write_batch(batch)

# the ends of every kind of number
kinds = {"swing.speed": pa.float64(), "air.density": pa.float32()}
ends = {"swing.speed": [0.1, -1e300], "air.density": [0.1, -1.5]}
integers = {
    "swing.path": 8, "swing.face_angle": 16, "swing.shaft_lean": 32, "swing.attack_angle": 64
}
for name, bits in integers.items():
    kinds[name] = getattr(pa, f"int{bits}")()
    ends[name] = [-(2 ** (bits - 1)), 2 ** (bits - 1) - 1]
for (name, bits) in zip(["club.loft", "club.mass", "strike.high", "strike.toe"], integers.values()):
    kinds[name] = getattr(pa, f"uint{bits}")()
    ends[name] = [0, 2**bits - 1]
write("kinds.arrow", pa.table({name: pa.array(ends[name], kind) for name, kind in kinds.items()}))

# refused tables, and two tables with a row that has no drive ("null" and "nan")
loft = COLUMNS["club.loft"][:4]
refused = {
    "null": {"club.loft": loft, "air.density": [1.2, 1.2, None, 1.2]},
    "nan": {"club.loft": loft, "air.density": [1.2, 1.2, 1.2, float("nan")]},
    "text": {"club.loft": loft, "air.density": ["1.2", "1.2", "1.2", "1.2"]},
    "dictionary": {"club.loft": loft, "air.density": pa.array([1.2] * 4).dictionary_encode()},
    "nested": {"club.loft": [[value] for value in loft]},
    "time": {"club.loft": pa.array([1, 2], pa.timestamp("s"))},
    "only_null": {"club.loft": pa.nulls(4)},
    "unknown": {"club.loft": loft, "club.lofft": loft},
    "unit": {"club.loft [deg]": loft},
    "no_columns": {},
}
for name, columns in refused.items():
    write(f"{name}.arrow", pa.table(columns), rows=2)
write("twice.arrow", pa.Table.from_arrays([pa.array(loft)] * 2, ["club.loft", "club.loft"]))
write("no_rows.arrow", points.slice(0, 0))
write("no_rows.arrows", points.slice(0, 0), new=pa.ipc.new_stream)

# DuckDB writes number literals as decimals: integers with a scale
duckdb.sql(
    """
    copy (
        select * from (values
            (51.4, 0.175, 1.184123456789, 255::utinyint, 4294967295::uinteger),
            (-2.5, 0.5, null, 0, 7)
        ) as t("swing.speed", "club.loft", "air.density", "club.mass", "strike.high")
    ) to 'duckdb.parquet'
    """
)
duckdb.sql("copy (select date '2026-01-02' as \"swing.speed\") to 'date.parquet'")
duckdb.sql(
    "copy (select 2.5::decimal(38, 1) as \"swing.speed\") to 'long_decimal.parquet'"
)
nanoseconds = pa.table({"swing.speed": pa.array([51], pa.timestamp("ns"))})
parquet.write_table(nanoseconds, "nanoseconds.parquet")
