"""A solved pair rebuilt in modules is the pair that was solved, to the last bit."""

from math import radians

import pytest

from gears.meshing.pairs import MM, M, book, given
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.meshing.geometry import external_pair, internal_pair, pinion_on_rack
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.meshing.solve import solve_pair
from tmmcalc.gears.meshing.task import PairTask


def stored(task: PairTask) -> tuple[MeshPair, MeshPair]:
    """The solved pair, and as it comes back from its record."""
    found = solve_pair(task)
    return found, from_record(MeshPair, to_record(found))


@pytest.mark.parametrize(
    "task",
    [
        given(14, 17, 0.6, 0.522),
        book(),
        book(helix=radians(-15)),
        book(tips=(43.0 * MM, None)),
        book(shifts=(None, 0.5)),
        PairTask((20, 41), M),
        given(14, 17, 1.8, 0.0, refuse=False),
    ],
)
def test_external(task):
    found, back = stored(task)
    pair = external_pair(found)
    assert repr(external_pair(back)) == repr(pair)
    assert (pair.first.shift, pair.second.shift) == found.shifts
    for wheel, tip, operating, size in zip(pair.wheels, pair.tips, pair.operating, found.sizes, strict=True):
        assert M * tip == pytest.approx(size.tip, rel=1e-15)
        assert M * operating == size.operating
        assert (M * wheel.reference, M * wheel.base, M * float(wheel.root)) == (size.reference, size.base, size.root)
    assert pair.angle == found.angle_w
    assert M * pair.distance == pytest.approx(found.distance, rel=1e-15)
    assert M * float(pair.length) == found.line.length
    assert float(pair.contact_ratio) == found.contact_ratio


@pytest.mark.parametrize(
    "more",
    [
        {"strategy": "zero"},
        {"strategy": "given", "shifts": (0.3, 0.1), "cutter": Cutter(20, 0.1, 0.2)},
        {"strategy": "given_aw", "distance": 0.1012},
        {"strategy": "given", "shifts": (0.3, 0.1), "tips": (None, 0.1462)},
    ],
)
def test_internal(more):
    found, back = stored(PairTask((20, 60), M, kind="internal", **more))
    pair = internal_pair(found)
    assert repr(internal_pair(back)) == repr(pair)
    assert (pair.pinion.shift, pair.ring.shift) == pytest.approx(found.shifts, abs=1e-15)
    assert [M * tip for tip in pair.tips] == pytest.approx([size.tip for size in found.sizes], rel=1e-15)
    assert pair.angle == found.angle_w
    assert -M * pair.length == found.line.length
    assert pair.contact_ratio == found.contact_ratio
    assert M * pair.ring.root == found.sizes[1].root


@pytest.mark.parametrize("tips", [(None, None), (58.0 * MM, 4.8 * MM)])
def test_rack(tips):
    task = PairTask((20, 0), M, kind="rack", strategy="given", shifts=(0.3, None), tips=tips, helix=radians(10))
    found, back = stored(task)
    pair = pinion_on_rack(found)
    assert repr(pinion_on_rack(back)) == repr(pair)
    assert M * pair.tip == pytest.approx(found.sizes[0].tip, rel=1e-15)
    assert pair.addendum == (1.0 if tips[1] is None else pytest.approx(0.96))
    assert M * pair.distance == found.distance
    assert pair.contact_ratio == found.contact_ratio
