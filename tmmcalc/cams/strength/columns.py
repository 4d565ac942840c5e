"""What slip, shaft, stem, guide and contact are judged by at the rows, in SI; and the margins as a table."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.cams.strength.results import CamStrength
from tmmcalc.core.quantity import headed, keyed, keys

MARGIN = (
    *("name", "constraint", "verdict", "formula", "symbol", "value", "limit", "margin", "phi[deg]"),
    *("why", "advice"),
)


def strength_columns(result: CamStrength) -> dict[str, np.ndarray]:
    """Columns of all rows by their headers; D is empty where nothing presses the roller."""
    found = {"i": np.array(result.positions.labels), **headed(result.positions, "phi[deg]")}
    for name in ("curvature", "run", "slip", "stress", "reduced", "bending", "pressure"):
        if getattr(result, name) is not None:
            found |= headed(result, name)
    if result.slip is not None and not result.touching.all():
        found |= dict.fromkeys(keys(CamStrength, "slip"), _with_gaps(result.slip, result.touching))
    return found


def _with_gaps(values: np.ndarray, known: np.ndarray) -> np.ndarray:
    return np.array([value if there else "" for value, there in zip(values.tolist(), known, strict=True)], object)


def margin_rows(result: CamStrength) -> list[dict[str, Any]]:
    """The margins as plain values in SI; what is not known is left out."""
    unknown = (None, "", False)
    rows = (keyed(each, *MARGIN, unit=each.unit) for each in result.margins)
    return [{key: value for key, value in row.items() if not any(value is each for each in unknown)} for row in rows]
