"""The bytes of the data files: npz for the next stage, csv for people. Equal data give equal bytes."""

from __future__ import annotations

import io
import math
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from tmmcalc.core.stored import Table

_EPOCH = (1980, 1, 1, 0, 0, 0)  # zip cannot do without a time; this is its zero
BLOCK = 4096  # rows of a CSV that are written at once
_UNIX = 3  # the system named in a zip entry
_SIZED = 10  # bytes of an array up to its header, of whose length the last two tell


def npz_bytes(arrays: Mapping[str, Any]) -> bytes:
    """Return an uncompressed npz archive for ``numpy.load``: no clock time, no trace of the system."""
    import zipfile

    from numpy.lib.format import write_array

    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, array in arrays.items():
            entry = zipfile.ZipInfo(f"{name}.npy", _EPOCH)
            entry.create_system = _UNIX
            with archive.open(entry, "w", force_zip64=True) as file:
                write_array(file, array, allow_pickle=False)
    return buffer.getvalue()


def npz_arrays(data: bytes) -> dict[str, Any]:
    """Return the arrays of an npz archive as `npz_bytes` makes it, read-only; raises ValueError if it is none."""
    import zipfile

    try:
        return _unpacked(data)
    except (zipfile.BadZipFile, NotImplementedError, EOFError) as error:
        raise ValueError(f"no archive of arrays: {error}") from None


def _unpacked(data: bytes) -> dict[str, Any]:
    import zipfile

    import numpy as np

    arrays = {}
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        for name in archive.namelist():
            held = archive.read(name)
            begin = _SIZED + int.from_bytes(held[_SIZED - 2 : _SIZED], "little")
            shape, columns, dtype = _header(held[:begin])
            values = np.frombuffer(held, dtype, math.prod(shape), begin)
            arrays[name.removesuffix(".npy")] = values.reshape(shape, order="F" if columns else "C")
    return arrays


@cache
def _header(held: bytes) -> tuple[tuple[int, ...], bool, Any]:
    """Shape, order of memory and type in the header of an array; the hundreds of a project have a few of them."""
    from numpy.lib.format import read_array_header_1_0, read_magic

    file = io.BytesIO(held)
    read_magic(file)
    found: tuple[tuple[int, ...], bool, Any] = read_array_header_1_0(file)
    return found


def csv_bytes(table: Table) -> bytes:
    """Return the table as CSV: one header line, one line a row, every number at full round-trip precision.

    Raises ValueError if the header and the columns do not match.
    """
    columns = list(table.columns)
    lengths = [len(column) for column in columns]
    if len(columns) != len(table.header) or len(set(lengths)) > 1:
        raise ValueError(f"{len(table.header)} headers over columns of {lengths} rows")
    text = io.BytesIO()  # grows in place, and hands out what it holds without a copy
    text.write(",".join(_cell(name) for name in table.header).encode() + b"\n")
    for at in range(0, lengths[0] if lengths else 0, BLOCK):
        text.write(_lines([c[at : at + BLOCK] for c in columns]) + b"\n")
    return text.getvalue()


def _lines(columns: Sequence[Any]) -> bytes:
    """The rows of a block, so that no more than a block of numbers is held as Python's own; no value: an empty cell."""
    values = [column.tolist() for column in columns]
    written = [[_cell(v) for v in c] if c and isinstance(c[0], str) else map(repr, c) for c in values]
    for k, column in enumerate(columns):
        if column.dtype.kind == "f" and (column != column).any():  # NaN, of columns by choice alone
            written[k] = ["" if v != v else repr(v) for v in values[k]]
    return "\n".join([",".join(row) for row in zip(*written, strict=True)]).encode()


def _cell(text: str) -> str:
    """Quote a header that holds a comma, a quote or a line break."""
    if any(sign in text for sign in ',"\r\n'):
        return '"' + text.replace('"', '""') + '"'
    return text
