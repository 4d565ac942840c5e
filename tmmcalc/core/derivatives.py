"""Derivatives of a stage's result by the numbers that it reads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record

Values = NDArray[np.floating[Any]]


@record
class Derivative:
    """Derivatives along K directions: of a column (K, n), of a number (K,); and what each may be off by, (K,)."""

    value: Values
    error: Values


@record
class Derivatives:
    """What of a result is given exactly: columns by header, facts by their key with unit."""

    columns: Mapping[str, Derivative]
    facts: Mapping[str, Derivative]
