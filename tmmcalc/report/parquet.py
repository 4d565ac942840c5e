"""Tables of many rows as Parquet: numbers by columns, with unit and meaning in the metadata of each field.

pyarrow is needed only here. Equal tables give equal bytes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError

COMPRESSION = "zstd"


class Field(NamedTuple):
    """A column: its header, its values, what is told of it.

    Values are texts, or an array of numbers in which NaN stands where there is none; of ``truths`` 1 is yes.
    """

    header: str
    values: Sequence[str] | NDArray[np.float64]
    told: Mapping[str, str] = {}
    truths: bool = False

    @property
    def plain(self) -> Sequence[str] | NDArray[Any]:
        """The values, as truth values where all are such."""
        whole = self.truths and not np.isnan(np.asarray(self.values, float)).any()
        return np.asarray(self.values, float) != 0 if whole else self.values


def check_pyarrow() -> None:
    """Raise `UsageError` where pyarrow is not installed."""
    if find_spec("pyarrow") is None:
        from tmmcalc.core.installation import install

        raise UsageError("Parquet needs pyarrow, which is not installed", where="-o", remedy=install("parquet"))


def parquet_bytes(fields: Sequence[Field]) -> bytes:
    """The bytes of a table; where a number has none the cell is null."""
    check_pyarrow()
    import pyarrow as pa
    from pyarrow import parquet

    columns, types = [], []
    for each in fields:
        if isinstance(each.values, np.ndarray):
            absent = np.isnan(each.values)
            values = np.where(absent, 0.0, each.values) != 0 if each.truths else each.values
            columns.append(pa.array(values, mask=absent))
        else:
            columns.append(pa.array(each.values, pa.string()))
        told = {key: text for key, text in each.told.items() if text}
        types.append(pa.field(each.header, columns[-1].type, metadata=told))
    texts = [each.name for each in types if pa.types.is_string(each.type)]
    sink = pa.BufferOutputStream()
    parquet.write_table(
        pa.Table.from_arrays(columns, schema=pa.schema(types)), sink, compression=COMPRESSION, use_dictionary=texts
    )
    data: bytes = sink.getvalue().to_pybytes()
    return data


def read_parquet(data: bytes) -> dict[str, list[str] | NDArray[np.float64]]:
    """The columns of a table by their headers: texts, or numbers with NaN where there is none.

    Raises ValueError if this is no Parquet.
    """
    check_pyarrow()
    import pyarrow as pa
    from pyarrow import parquet

    table = parquet.read_table(pa.BufferReader(data))
    found: dict[str, list[str] | NDArray[np.float64]] = {}
    for header, column in zip(table.column_names, table.columns, strict=True):
        if pa.types.is_string(column.type):
            found[header] = column.to_pylist()
        else:
            found[header] = np.asarray(column.cast(pa.float64()).to_numpy(), float)
    return found
