"""Tables as frames of pandas or polars, where these are installed; they are imported only here."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.report.numbers import counted_back

LIBRARIES = ("pandas", "polars")


def frame(columns: Mapping[str, Any], library: str | None = None) -> Any:
    """A frame of columns by their headers; of ``pandas`` or ``polars``, without a name of the first that is installed.

    Columns are arrays of numbers or texts; what is a text of a number becomes one, as in a CSV that is read.
    Raises `UsageError` for another library, and for one that is not installed.
    """
    module = import_module(_chosen(library))
    return module.DataFrame({header: _plain(column) for header, column in columns.items()})


def _chosen(library: str | None) -> str:
    if library is not None and library not in LIBRARIES:
        raise UsageError(
            f"there are no frames of {library!r}", where="to_frame", remedy=f"choose {' or '.join(LIBRARIES)}"
        )
    asked = LIBRARIES if library is None else (library,)
    found = next((name for name in asked if find_spec(name) is not None), None)
    if found is None:
        missing = "pandas or polars, and neither is" if library is None else f"{library}, which is not"
        raise UsageError(f"frames need {missing} installed", where="to_frame", remedy=f"pip install {asked[0]}")
    return found


def _plain(column: Any) -> Any:
    values = np.asarray(column)
    return values if values.dtype.kind in "fib" else counted_back(values.tolist())
