"""Numbers of a page in one block: single floats, little-endian, in base64; what needs them holds place and length.

Coordinates of marks stand beside them in the JSON.
"""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

ERROR = 2.0**-24  # relative, of a number that is stored as a single float

Content = dict[str, Any]  # plain values for JSON
Ref = list[int]  # place of the first number, their count


class Block:
    """The block while it is filled; equal columns are stored once."""

    def __init__(self) -> None:
        self._parts: list[NDArray[np.float32]] = []
        self._places: dict[bytes, Ref] = {}
        self._size = 0

    def put(self, values: ArrayLike) -> Ref:
        """Store numbers (n,), where they are finite and no larger than single floats go; others as NaN."""
        with np.errstate(over="ignore"):
            part = np.ascontiguousarray(values, dtype="<f4")
        part = np.where(np.isfinite(part), part, np.float32(np.nan)) + np.float32(0.0)
        key = part.tobytes()
        if key not in self._places:
            self._places[key] = [self._size, part.size]
            self._parts.append(part)
            self._size += part.size
        return self._places[key]

    def text(self) -> str:
        """The block as base64."""
        whole: NDArray[Any] = np.concatenate(self._parts) if self._parts else np.empty(0)
        return base64.b64encode(whole.astype("<f4").tobytes()).decode("ascii")


def pair(z: complex) -> list[float]:
    """Coordinates to a nanometre."""
    return [round(z.real, 9) + 0.0, round(z.imag, 9) + 0.0]
