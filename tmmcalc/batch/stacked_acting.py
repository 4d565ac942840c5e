"""Which causes act on a linkage at all, of many variants by their numbers.

The rows of forces and the causes of reduced moments are those of one variant. A pair without friction has no position
at which its friction turns back, and a load, a spring or a weight that is nothing is no cause: where one of them is
nothing in some variants alone, these have other rows and causes than the rest.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

CAUSE = re.compile(r"1\.(pairs\.\d+\.friction|loads\.\d+\.factor|springs\.\d+\.(stiffness|damping))")
MASS = re.compile(r"1\.bodies\.\d+\.mass")
GRAVITY = "1.gravity"


class Acting:
    """Looks at the numbers of a tree with these ``paths``."""

    def __init__(self, paths: Sequence[str]) -> None:
        self._causes = [k for k, path in enumerate(paths) if CAUSE.fullmatch(path)]
        self._masses = [k for k, path in enumerate(paths) if MASS.fullmatch(path)]
        self._gravity = [k for k, path in enumerate(paths) if path == GRAVITY]

    def __call__(self, found: NDArray[np.complexfloating[Any, Any]]) -> NDArray[np.bool_]:
        """Which of the causes (v, c) act by the numbers (v, L); the weight of all links is one."""
        acts = found != 0
        weight = acts[:, self._gravity].any(axis=1) & acts[:, self._masses].any(axis=1)
        return np.column_stack((acts[:, self._causes], weight))
