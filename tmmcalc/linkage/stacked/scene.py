"""The variants of a block: what is the same for all, and their constants at any rows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from tmmcalc.core.numerics.alike import Rows
from tmmcalc.core.numerics.alike import rows_of as at_rows
from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, compile_chain
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics, reversals
from tmmcalc.linkage.forces.solve import rows_of
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.loads.scene import Scene, compile_scene, scene_of
from tmmcalc.linkage.loads.travel import EDGE
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.stacked.survey import ROWS, Settled, settle
from tmmcalc.linkage.variants import given_variants, sketched_groups


class Same(NamedTuple):
    """What is the same for all variants: the results of one of them, and what they were compiled to."""

    kinematics: Kinematics
    scene: Scene | None  # None: nothing of the loads is asked for
    statics: Statics | None
    rows: tuple[Real, Real, tuple[str, ...]] | None  # theta, side and label of all rows of forces

    @property
    def rubbing(self) -> tuple[str, ...]:
        """Names of the joints with friction."""
        return tuple(joint.name for joint in self.statics.rubbing) if self.statics is not None else ()


def same_of(mechanism: Mechanism, loading: Loading | None, kinematics: Kinematics) -> Same:
    """What one solved variant tells of all."""
    if loading is None:
        return Same(kinematics, None, None, None)
    scene = compile_scene(mechanism, loading, kinematics)
    statics = compile_statics(scene)
    _, turning = scene.breaks(reversals(statics))
    return Same(kinematics, scene, statics, rows_of(scene, kinematics, np.sort(turning)))


def refusal(mechanism: Mechanism, loading: Loading | None, same: Same) -> str | None:
    """Why variants of this linkage cannot be taken together; None if they can."""
    grid, structure = mechanism.grid, same.kinematics.structure
    outputs = mechanism.outputs[:1]
    if not structure.dyads_only or structure.driven is not None:
        return "a group of class III or higher"
    if not same.kinematics.turns or grid.span is not None:
        return "the input does not go over one whole turn"
    if grid.working is not None or grid.extremes:
        return "positions that depend on the strokes"
    if sketched_groups(mechanism, structure, given_variants(mechanism, structure)):
        return "a sketch tells the assembly"
    if mechanism.input.start is None and (not outputs or outputs[0].link is not None):
        return "position 0 is a dead centre of a link that turns"
    if len(same.kinematics.x) > ROWS // 4:
        return "so many positions that one variant fills a block"
    return _loads_refusal(loading, same.scene) if loading is not None and same.scene is not None else None


def _loads_refusal(loading: Loading, scene: Scene) -> str | None:
    for load in loading.loads:
        if not load.law.alike or (load.window is not None and load.window.stroke):
            return f"load {load.name} depends on a stroke, or on the square of a speed"
    if any(spring.kind != "linear" for spring in loading.springs):
        return "a torsion spring"
    return None if abs(scene.travel.period - TURN) < EDGE else "loads that come back after several turns"


class Block(NamedTuple):
    """V variants: their constants (`Alike`), their survey, and which of them are clear so far."""

    same: Same
    size: int  # V
    loading: Rows[Loading | None]
    chain: Rows[Chain]
    settled: Settled

    @property
    def labels(self) -> int:
        """Number of positions of one variant."""
        return len(self.same.kinematics.x)

    @property
    def rows(self) -> tuple[Real, Real, tuple[str, ...]]:
        """theta, side and label of all rows of forces; a position where a rubbing pair turns back has two."""
        assert self.same.rows is not None
        return self.same.rows

    def parts(self, rows: int) -> Iterator[Indices]:
        """The numbers of the variants in parts that have some `ROWS` rows together, ``rows`` of each variant."""
        size = max(1, ROWS // rows)
        return (np.arange(at, min(at + size, self.size)) for at in range(0, self.size, size))

    def statics(self, rows: Indices) -> Statics:
        """The force analysis whose rows (m,) are of these variants."""
        same = self.same
        assert same.scene is not None
        assert same.statics is not None
        chain, loading = self.chain(rows), self.loading(rows)
        assert loading is not None
        drive = chain.mechanism.input
        start: Any = at_rows(self.settled.start, rows)
        travel = same.scene.travel._replace(start=start, speed=drive.speed, acceleration=drive.acceleration)
        scene = scene_of(chain, loading, travel, same.scene.survey, same.kinematics)
        return compile_statics(scene, scales=at_rows(self.settled.scales, rows))


def block_of(
    same: Same,
    count: int,
    mechanism: Mechanism,
    loading: Loading | None,
    tracked: bool,
    told: bool = False,
    placed: bool = False,
) -> Block:
    """The variants of a block from their stacked constants; ``tracked``: the turns of links are asked for.

    ``told``: so is all that the summary of kinematics tells. ``placed``: nothing is but where points are.
    """
    kinematics = same.kinematics
    chain = Rows(compile_chain(mechanism, kinematics.structure, kinematics.variants))
    return Block(same, count, Rows(loading), chain, settle(chain, count, same.rubbing, tracked, told, placed))
