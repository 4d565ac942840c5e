"""The rows of a result of the forces stage with what it was computed from, solved once more where that is asked for."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics


class Rows:
    """A result with its mechanism, its loading and its kinematics; each part is found when it is first asked for."""

    def __init__(self, mechanism: Mechanism, loading: Loading, kinematics: Kinematics, result: Forces) -> None:
        self.mechanism, self.loading, self.kinematics, self.result = mechanism, loading, kinematics, result

    @cached_property
    def statics(self) -> Statics:
        """The force analysis of the result."""
        return compile_statics(compile_scene(self.mechanism, self.loading, self.kinematics))

    @cached_property
    def side(self) -> Real:
        """The side (n,) from which each row is taken: -1 the limit before a jump and the very end, else +1."""
        before = np.array([label.endswith("-") for label in self.result.labels])
        return np.where(before, -1.0, self.statics.scene.travel.sides(self.result.theta))
