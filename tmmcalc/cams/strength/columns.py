"""What slip, shaft, stem, guide and contact are judged by at the rows, in SI; and the margins as a table."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.cams.strength.results import CamStrength


def strength_columns(result: CamStrength) -> dict[str, np.ndarray]:
    """Columns of all rows by their headers; D is empty where nothing presses the roller."""
    columns = {
        "i": np.array(result.positions.labels),
        "phi[deg]": np.degrees(result.positions.phi),
        "kappa[1/m]": result.curvature,
    }
    if result.run is not None:
        columns["A[m]"] = result.run
    if result.slip is not None:
        columns["D"] = result.slip if result.touching.all() else _with_gaps(result.slip, result.touching)
    for header, values in (
        ("sigma_H[Pa]", result.stress),
        ("M_E[N*m]", result.reduced),
        ("sigma_F[Pa]", result.bending),
        ("p[Pa]", result.pressure),
    ):
        if values is not None:
            columns[header] = values
    return columns


def _with_gaps(values: np.ndarray, known: np.ndarray) -> np.ndarray:
    return np.array([value if there else "" for value, there in zip(values.tolist(), known, strict=True)], object)


def margin_rows(result: CamStrength) -> list[dict[str, Any]]:
    """The margins as plain values in SI; what is not known is left out."""
    rows = []
    for each in result.margins:
        row = {
            "requirement": each.name,
            "constraint": each.constraint,
            "verdict": each.verdict,
            "formula": each.formula,
            "symbol": each.symbol or None,
            "unit": each.unit or None,
            "value": each.value,
            "limit": each.limit,
            "margin": each.margin,
            "phi[deg]": None if each.phi is None else float(np.degrees(each.phi)),
            "why": each.why or None,
            "advice": each.advice or None,
        }
        rows.append({key: value for key, value in row.items() if value is not None})
    return rows
