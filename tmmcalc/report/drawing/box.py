"""Rectangles of paper, and how they are divided."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane


class Box(NamedTuple):
    """A rectangle of paper [mm]."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """From left to right."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From bottom to top."""
        return self.top - self.bottom

    @property
    def middle(self) -> complex:
        """Its centre."""
        return complex(self.left + self.right, self.bottom + self.top) / 2

    @property
    def corners(self) -> Plane:
        """Its corners (4,), counter-clockwise from the lower left."""
        left, right = self.left + 0j, self.right + 0j
        return np.array([left, right, right, left]) + 1j * np.array([self.bottom] * 2 + [self.top] * 2)

    def inset(self, left: float, bottom: float, right: float, top: float) -> Box:
        """The rectangle without margins."""
        return Box(self.left + left, self.bottom + bottom, self.right - right, self.top - top)

    def split(self, *parts: float, gap: float = 0.0, across: bool = False) -> list[Box]:
        """Side by side (``across``) or one under another, in these proportions."""
        room = (self.width if across else self.height) - gap * (len(parts) - 1)
        sizes = [room * part / sum(parts) for part in parts]
        found, at = [], self.left if across else self.top
        for size in sizes:
            if across:
                found.append(Box(at, self.bottom, at + size, self.top))
                at += size + gap
            else:
                found.append(Box(self.left, at - size, self.right, at))
                at -= size + gap
        return found
