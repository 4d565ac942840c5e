"""How far paths are from wanted ones: against closed forms, dense samples and mpmath, alone and many together."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from sparing import sparing
from storing import assert_stored_as_found

import tmmcalc
from tmmcalc.batch import points, stacked
from tmmcalc.batch.reading import task_of
from tmmcalc.batch.stacked_columns import Columns
from tmmcalc.batch.stacked_inputs import Inputs
from tmmcalc.batch.stacked_results import Results
from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Grid, Input, Joint, Link, Mechanism
from tmmcalc.linkage.paths.results import Paths
from tmmcalc.linkage.paths.solve import solve_paths
from tmmcalc.linkage.paths.task import WantedPath
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
from tmmcalc.project.loader import parse_spec

from .scenes import four_bar

CONFIGS = Path(__file__).parents[2] / "configs"
LINE = CONFIGS / "wanted-path.toml"
Plane = np.ndarray[Any, Any]


def coupler(l1: float, l2: float, l3: float, c: complex, p: complex) -> Mechanism:
    """A four-bar whose coupler has the point P."""
    bare = four_bar(l1, l2, l3, c)
    links = tuple(replace(link, points={**link.points, "P": p}) if link.id == 2 else link for link in bare.links)
    return replace(bare, links=links)


def found(mechanism: Mechanism, *paths: WantedPath) -> Paths:
    return solve_paths(mechanism, paths, solve_kinematics(mechanism))


def wanted(points: Any, point: str = "P", at: Any = ()) -> WantedPath:
    return WantedPath("w", point, tuple(complex(z) for z in points), tuple(at))


def distances(result: Paths) -> Plane:
    return np.abs(result.reached - result.wanted)


def curve(l1: Any, l2: Any, l3: Any, c: Any, p: Any, x: Any) -> Any:
    """The coupler point by the two circles about A and C: nothing of it is the program's."""
    a = l1 * np.exp(1j * x)
    way = c - a
    far = np.abs(way)
    along = (l2**2 - l3**2 + far**2) / (2 * far)
    b = (along + 1j * np.sqrt(l2**2 - along**2)) * way / far
    return a + p * b / l2


def sampled(r: Plane, w: complex) -> float:
    """The least distance of a closed curve by its samples: the parabola of the squares through the nearest three."""
    squares = np.abs(r - w) ** 2
    k = int(np.argmin(squares))
    low, mid, high = squares[k - 1], squares[k], squares[(k + 1) % len(r)]
    bend = low - 2 * mid + high
    return math.sqrt(max(mid - (low - high) ** 2 / (8 * bend), 0.0)) if bend else math.sqrt(mid)


BARS = (0.1, 0.6, 0.3, 0.7 + 0j, 0.3 + 0.2j)


def test_a_circle_is_as_far_as_the_radius_tells() -> None:
    rng = np.random.default_rng(1)
    w = rng.normal(size=30) * 0.2 + 1j * rng.normal(size=30) * 0.2
    result = found(coupler(*BARS), wanted(w, "A"))
    np.testing.assert_allclose(distances(result), np.abs(np.abs(w) - 0.1), rtol=1e-15, atol=1e-16)
    np.testing.assert_allclose(result.reached, 0.1 * w / np.abs(w), atol=1e-16)
    np.testing.assert_allclose(np.exp(1j * result.phi), w / np.abs(w), atol=1e-14)
    (told,) = result.paths
    off = np.abs(np.abs(w) - 0.1)
    assert told.total == pytest.approx(np.sum(off**2), rel=1e-14)
    assert told.rms == pytest.approx(np.sqrt(np.mean(off**2)), rel=1e-14)
    assert (told.largest, told.worst) == (pytest.approx(off.max(), rel=1e-14), int(np.argmax(off)) + 1)


def test_the_middle_of_a_circle_is_everywhere_as_near() -> None:
    result = found(coupler(*BARS), wanted([0, 0.05], "A"))
    np.testing.assert_allclose(distances(result), [0.1, 0.05], rtol=1e-15)
    np.testing.assert_array_equal(result.phi, [0, 0])


@pytest.mark.parametrize("seed", range(6))
def test_coupler_curves_against_200_000_samples(seed: int) -> None:
    """Crank-rockers drawn at random; curves with loops and cusps are among them."""
    rng = np.random.default_rng(seed)
    l2, l3, far = rng.uniform(0.5, 1.0, 3)
    least = 0.9 * min(l2 + l3 - far, far + l3 - l2, far + l2 - l3, 1.0)
    bars = (0.5 * least, l2, l3, complex(far), complex(*rng.uniform(-1.5, 1.5, 2)))
    r = curve(*bars, np.linspace(0, 2 * np.pi, 200_000, endpoint=False))
    middle, size = np.mean(r), np.max(np.abs(r - np.mean(r)))
    w = middle + size * (rng.normal(size=25) + 1j * rng.normal(size=25))
    w = np.append(w, r[::40_000])  # and points of the curve
    result = found(coupler(*bars), wanted(w))
    np.testing.assert_allclose(distances(result), [sampled(r, z) for z in w], rtol=0, atol=1e-9)
    assert np.max(distances(result)[25:]) < 1e-15 * (size + abs(middle)) * 10


@pytest.mark.parametrize("beside", [0, 1e-4 + 1e-4j, 1e-5j, -1e-3])
@pytest.mark.parametrize("far", [1e-2, 1e-3, 1e-4, 1e-6])
def test_places_near_a_cusp_and_within_a_narrow_loop(beside: complex, far: float) -> None:
    """A coupler point in the pole has a cusp, one beside it a loop narrower than a step of the survey.

    Samples are dense about the cusp, as a place on its other branch would be missed by far more than they tell.
    """
    p = _pole(BARS[:4], 1.0) + beside
    about = np.concatenate([1 + s * np.geomspace(1e-6, 1.5, 100_000) for s in (-1, 1)])
    x = np.sort(np.concatenate((about, np.linspace(2, 2 * np.pi, 20_000))))
    r = curve(*BARS[:4], p, x)
    w = complex(curve(*BARS[:4], p, 1.0)) + far * np.exp(1j * np.linspace(0, 6, 25))
    result = found(coupler(*BARS[:4], p), wanted(w))
    nearest = np.array([np.min(np.abs(r - z)) for z in w])
    assert np.max(distances(result) - nearest) < 1e-15
    assert np.max(nearest - distances(result)) < 1e-7


def test_a_centre_of_curvature_within_a_narrow_loop() -> None:
    """D' and D'' nearly vanish together there, and D' turns back within parts of parts of a step."""
    bars, w = (0.65, 0.87, 0.88, 0.79 + 0j, 1.05 + 0.08j), 1.496606 + 0.81272j
    r = curve(*bars, np.linspace(0.45, 0.55, 1_000_001))
    assert distances(found(coupler(*bars), wanted([w])))[0] == pytest.approx(np.min(np.abs(r - w)), abs=1e-10)


def _pole(bars: Any, x: float) -> complex:
    """The point of the coupler that stands at a crank angle, in its axes: where crank and rocker meet."""
    l1, l2, l3, c = bars
    a, b = l1 * np.exp(1j * x), curve(l1, l2, l3, c, l2, x)
    t = ((c * np.conj(b - c)).imag) / ((a * np.conj(b - c)).imag)
    return complex((t * a - a) / ((b - a) / l2))


LOW, HIGH = math.radians(37.5), math.pi / 2  # at 36.87 deg coupler and rocker are in line


def chebyshev(span: float = HIGH - LOW) -> Mechanism:
    """Frame 4, levers 5, coupler 2: the middle of the coupler goes along y = 4 between x = 0 and 4."""
    bare = coupler(5, 2, 5, 4 + 0j, 1)
    drive, other = replace(bare.input, start=LOW), replace(bare.assembly, variants={(2, 3): -1})
    return replace(bare, input=drive, assembly=other, grid=Grid(span=span))


def line(inclination: float) -> complex:
    """The middle of the coupler of Chebyshev's linkage by the inclination of the coupler; 2 + 4 i in the middle."""
    c, s = math.cos(inclination), math.sin(inclination)
    return 2 + complex(-s, 2 + c) * math.sqrt((20 - 4 * c) / (5 + 4 * c))


def test_the_straight_line_of_chebyshev() -> None:
    """It meets y = 4 in the middle and where the coupler is upright; between it is the highest at cos = 5/8."""
    top = math.acos(5 / 8)
    assert line(math.pi / 2) == pytest.approx(4j)
    highest = 2.625 * math.sqrt(7 / 3) - 4
    across = [line(-top).real, 2, line(top).real, 0]
    result = found(chebyshev(), wanted([x + 4j for x in across]))
    np.testing.assert_allclose(distances(result), [highest, 0, highest, 0], rtol=0, atol=1e-14)
    (told,) = result.paths
    assert (told.order, told.worst in (1, 3), result.closed) == ("along", True, False)
    assert told.largest == pytest.approx(highest, abs=1e-14)
    assert told.covered == pytest.approx(math.pi / 2 - np.angle(line(-top) + np.exp(-1j * top)), abs=1e-7)


def test_the_ends_of_a_path_are_places_too() -> None:
    """A double rocker does not turn: what lies beyond its path is nearest to the ends, on which a note is made."""
    kinematics = solve_kinematics(chebyshev())
    end = kinematics.trace.r[kinematics.trace.point_names.index("P"), 0]
    result = found(chebyshev(), wanted([end + 0.5, 2 + 4j, -1 + 4j]))
    np.testing.assert_allclose(distances(result), [0.5, 0, 1], rtol=0, atol=1e-14)
    np.testing.assert_allclose(result.phi[[0, 2]], [0, HIGH - LOW], rtol=0, atol=1e-15)
    assert [str(grade) for grade in result.grades] == ["note: path w: nearest to an end of the path: points 1, 3"]


def moved(mechanism: Mechanism, by: Callable[[complex], complex], turn: float) -> Mechanism:
    """The linkage carried to another place of the plane."""
    frame = Link(0, {name: by(at) for name, at in mechanism.frame.points.items()})

    def carried(joint: Joint) -> Joint:
        return replace(
            joint, points=tuple(by(p) if k == 0 else p for p, k in zip(joint.points, joint.links, strict=True))
        )

    drive: Input = replace(mechanism.input, start=(mechanism.input.start or 0.0) + turn)
    return replace(mechanism, frame=frame, joints=tuple(map(carried, mechanism.joints)), input=drive)


def test_it_does_not_matter_where_the_scene_stands() -> None:
    turn, shift = 1.234, 0.4 - 0.7j

    def by(z: complex) -> complex:
        return complex(z * np.exp(1j * turn) + shift)

    w = [0.2 + 0.3j, 0.3 + 0.35j, 0.4 + 0.4j, 0.1 + 0.1j]
    one = found(coupler(*BARS), wanted(w))
    other = found(moved(coupler(*BARS), by, turn), wanted([by(z) for z in w]))
    np.testing.assert_allclose(distances(other), distances(one), rtol=0, atol=2e-15)
    np.testing.assert_allclose(other.phi, one.phi, atol=1e-12)
    assert other.paths[0].total == pytest.approx(one.paths[0].total, rel=1e-13)


def test_one_point_and_points_that_coincide() -> None:
    w = 0.3 + 0.1j
    (one,) = found(coupler(*BARS), wanted([w])).paths
    (three,) = found(coupler(*BARS), wanted([w, w, w])).paths
    for told in (one, three):
        assert (told.order, told.worst) == ("along", 1)
        assert told.covered == pytest.approx(0, abs=2e-15)
        assert told.rms == told.largest == pytest.approx(math.sqrt(one.total), rel=1e-15)
    assert three.total == pytest.approx(3 * one.total, rel=1e-15)


def test_points_are_moved_as_a_figure() -> None:
    w, turn, shift = np.array([0.2 + 0.3j, 0.3 + 0.35j, 0.1 + 0.1j]), 1.234, 0.4 - 0.7j
    figure = replace(wanted(w * np.exp(-1j * turn) - shift * np.exp(-1j * turn)), turn=turn, shift=shift)
    one, other = found(coupler(*BARS), wanted(w)), found(coupler(*BARS), figure)
    np.testing.assert_allclose(other.wanted, w, rtol=0, atol=1e-15)
    np.testing.assert_allclose(distances(other), distances(one), rtol=0, atol=2e-15)


def test_the_order_of_the_points() -> None:
    w = curve(*BARS, np.array([0.5, 1.5, 3.0, 4.5, 6.0]))
    for points_, order in (
        (w, "along"),
        (np.roll(w, 2), "along"),
        (w[::-1], "against"),
        (w[[0, 2, 1, 3, 4]], "none"),
        (w[[0, 0, 1, 2, 3]], "along"),
    ):
        (told,) = found(coupler(*BARS), wanted(points_)).paths
        assert told.order == order
        assert told.ordered == (order != "none")
    (back,) = found(replace(coupler(*BARS), input=Input("O", -1.0, start=0.0)), wanted(w)).paths
    assert back.order == "against"
    assert back.covered == pytest.approx(2 * math.pi - 1.5, abs=1e-12)
    note = found(coupler(*BARS), wanted(w[[0, 2, 1, 3, 4]])).grades
    assert [grade.severity for grade in note] == ["note"]


def test_a_prescribed_timing() -> None:
    at = [0.0, 0.4, -1.0, 9.0]
    w = [0.2 + 0.3j, 0.1j, 0.3, 0.3 + 0.1j]
    for start in (0.0, 2.5, -9.0):  # the angle from which a timing counts is a number like others
        mechanism = replace(coupler(*BARS), input=Input("O", 1.0, start=start))
        result = found(mechanism, wanted(w, at=at))
        np.testing.assert_allclose(result.reached, curve(*BARS, start + np.array(at)), atol=2e-15)
        np.testing.assert_allclose(result.phi, at, rtol=0, atol=2e-15)
        assert result.paths[0].order is None
    with pytest.raises(UsageError, match="point 2 is prescribed for angle_1 = 90 deg, outside"):
        found(chebyshev(0.3), wanted([1, 2], at=[0, HIGH - LOW]))


def test_the_estimated_errors_are_no_less_than_the_true_ones() -> None:
    """The truth: the root of the derivative of the distance with forty digits, near a dead point too."""
    for bars in (BARS, (0.1, 0.6, 0.2000001, 0.7 + 0j, 0.3 + 0.2j)):
        w = [0.2 + 0.3j, 0.45 + 0.3j, complex(curve(*bars, 2.0)), 0.1 - 0.2j]
        result = found(coupler(*bars), wanted(w))
        size = max(np.max(np.abs(result.reached)), np.max(np.abs(w)))
        for k, z in enumerate(w):
            with mpmath.workdps(40):
                far, x = truth(bars, z, float(result.phi[k]))
                off = abs(far - mpmath.mpf(float(distances(result)[k])))
                assert off <= result.error.distance * size
                assert abs(x - mpmath.mpf(float(result.phi[k]))) <= result.error.place * 2 * mpmath.pi
        assert result.error.distance < 1e-13


def truth(bars: Any, w: complex, near: float) -> tuple[Any, Any]:
    l1, l2, l3, c, p = (mpmath.mpmathify(each) for each in bars)

    def at(x: Any) -> Any:
        a = l1 * mpmath.expj(x)
        far = abs(c - a)
        along = (l2**2 - l3**2 + far**2) / (2 * far)
        return a + p * (along + 1j * mpmath.sqrt(l2**2 - along**2)) * (c - a) / far / l2

    def slope(x: Any) -> Any:
        return mpmath.diff(lambda y: abs(at(y) - w) ** 2, x)

    x = mpmath.findroot(slope, mpmath.mpf(near))
    return abs(at(x) - w), x


def test_what_is_stored_is_what_was_found(tmp_path: Path) -> None:
    assert_stored_as_found(tmmcalc.load_spec(LINE), "paths", tmp_path)


def test_the_ready_spec_by_hand() -> None:
    """The distances of the six points by the two circles, and their sum by its name."""
    result = tmmcalc.solve_paths(tmmcalc.load_spec(LINE))
    o, c = 0.049 + 0.005j, 0.0681 + 0.0372j
    r = o + curve(0.0272, 0.0416, 0.0484, c - o, 0.0564 - 0.0021j, np.linspace(0, 2 * np.pi, 200_000, endpoint=False))
    w = 0.02 + 1j * np.arange(0.02, 0.0451, 0.005)
    off = np.array([sampled(r, z) for z in w])
    np.testing.assert_allclose(distances(result), off, rtol=0, atol=1e-12)
    assert result.paths[0].rms == pytest.approx(np.sqrt(np.mean(off**2)), rel=1e-8)


HEAD = LINE.read_text(encoding="utf-8").partition("[[paths]]")[0]


@pytest.mark.parametrize(
    ("lines", "path", "said"),
    [
        ('point = "P"\nthrough = [[0, 0]]\nat = [0, 1]', "paths[0].at", "2 input coordinates, points: 1"),
        ('point = "Q"\nthrough = [[0, 0]]', "paths[0].point", "there is no point 'Q'"),
        ('point = "C"\nthrough = [[0, 0]]', "paths[0].point", "'C' is a point of the frame and does not move"),
        ('point = "P"\nthrough = [[0, 0]]\nat = ["3 mm"]', "paths[0].at[0]", "so an angle is needed"),
        ('point = "P"\nthrough = [[0, 0]]\nat = [20]', "paths[0].at[0]", "radians, more than a full turn"),
        ('point = "P"\nthrough = [[0, 0]]\nat = []', "paths[0].at", "0 input coordinates, points: 1"),
        ('point = "P"\nthrough = [[0, 0]]\nturn = 30', "paths[0].turn", "radians, more than a full turn"),
        ('point = "P"\nthrough = [[0, 0]]\nshift = [0]', "paths[0].shift", "the way by which all points are moved"),
        ('point = "P"\nthrough = [[0, nan]]', "paths[0].through[0][1]", "nan is not a finite number"),
        ('point = "P"\nthrough = []', "paths[0].through", "through"),
        ("through = [[0, 0]]", "paths[0].point", "a path is that of a point of a moving link"),
    ],
)
def test_faults(lines: str, path: str, said: str) -> None:
    with pytest.raises(tmmcalc.SpecError) as caught:
        parse_spec(f"{HEAD}[[paths]]\n{lines}\n")
    assert len(caught.value.faults) == 1
    assert path in str(caught.value)
    assert said in str(caught.value)


def test_two_paths_of_one_point_have_two_names() -> None:
    path = '[[paths]]\npoint = "P"\nthrough = [[0, 0], [0, 0.01]]\n'
    result = tmmcalc.solve_paths(parse_spec(f"{HEAD}{path}{path}"))
    assert [each.name for each in result.paths] == ["P", "P'"]
    assert result.labels == ("P:1", "P:2", "P':1", "P':2")
    with pytest.raises(tmmcalc.SpecError, match="already the name of another path"):
        parse_spec(f'{HEAD}{path}name = "a"\n{path}name = "a"\n')


BOUNDS = {
    "mechanism.links[id=1].points.A[0]": (0.02, 0.03),
    "mechanism.links[id=2].points.P[0]": (0.04, 0.07),
    "mechanism.links[id=2].points.P[1]": (-0.01, 0.01),
    "mechanism.fixed.O[0]": (0.045, 0.052),
    "mechanism.fixed.O[1]": (-0.01, 0.01),
    "mechanism.links[id=3].points.B[0]": (0.045, 0.052),
    "mechanism.input.start": (-6, 6),
    "paths[0].through[2][0]": (0.019, 0.021),
    "paths[0].turn": (-0.1, 0.1),
    "paths[0].shift[1]": (-0.002, 0.002),
}


def drawn(file: Path, count: int) -> Path:
    rng = np.random.default_rng(1)
    with file.open("w") as stream:
        writer = csv.writer(stream)
        writer.writerow(BOUNDS)
        writer.writerows([repr(float(rng.uniform(*ends))) for ends in BOUNDS.values()] for _ in range(count))
    return file


MOVED = 'paths[0].shift=["1 mm", 0]'
TIMED = 'paths[0].at=["0 deg", "20 deg", "40 deg", "60 deg", "80 deg", "1 rad"]'


@sparing(
    ("asked", "sets", "way"),
    [
        (("paths.deviation_*_P", "paths.max(distance)", "paths.dx@3"), [], Columns),
        (
            ("paths.deviation_rms_P", "paths.rms(dy)"),
            [TIMED],
            Columns,
        ),
        (("paths.*",), ["mechanism.input.speed=-1"], Results),
    ],
    every=3,
)
def test_variants_together_are_those_alone(tmp_path: Path, asked: Any, sets: Any, way: type) -> None:
    """Some do not assemble over the whole turn: these are solved alone, which is told."""
    task = task_of(LINE, [MOVED, *sets], drawn(tmp_path / "points.csv", 40), (), asked)
    assert isinstance(stacked.prepared(task), way)
    rows = stacked.solve_points(task, range(40))
    apart = [row for row in rows if row.alone]
    assert 0 < len(apart) < 20
    assert all(row.alone == stacked.UNLIKE for row in apart)
    assert any(not row.ok for row in rows)
    for one, other in zip(rows, points.solve_points(task, range(40)), strict=True):
        assert (one.status, one.names) == (other.status, other.names)
        for name, a, b in zip(one.names, one.values, other.values, strict=True):
            assert a == pytest.approx(b, rel=1e-11, abs=1e-14 if "error" not in name else 1e-13), name


def test_specs_of_many_signs_are_read_a_few_times(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Sizes that go through zero answer the checks of a spec in few ways, and each way is read once."""
    task = task_of(LINE, [MOVED], drawn(tmp_path / "points.csv", 400), (), ("paths.deviation_rms_P",))
    inputs = Inputs(task, 0, loaded=False, driven=False, traced=True)
    read, own = [], Inputs._read

    def spy(self: Inputs, values: Any) -> Any:
        read.append(values)
        return own(self, values)

    monkeypatch.setattr(Inputs, "_read", spy)
    values = np.array([task.values(point) for point in range(400)])
    numbers, there = inputs.numbers(values)
    assert there.all()
    assert len(read) < 40
    for row in range(0, 400, 57):
        np.testing.assert_allclose(numbers[row], own(inputs, values[row]), rtol=1e-13, atol=1e-17)


def test_a_path_of_a_driven_slider() -> None:
    """The boom of the luffing gear: the path of C is a circle about O, from which points are as far as radii tell."""
    spec = tmmcalc.load_spec(CONFIGS / "crane-luffing.toml")
    mechanism = to_linkage(spec.linkage)
    kinematics = solve_kinematics(mechanism)
    path = kinematics.trace.r[kinematics.trace.point_names.index("C")]
    w = path[len(path) // 2] * np.array([0.9, 1.2])
    result = solve_paths(mechanism, (wanted(w, "C"),), kinematics)
    np.testing.assert_allclose(distances(result), np.abs(np.abs(w) - np.abs(path[0])), rtol=1e-12)
    assert not result.turns
    np.testing.assert_allclose(result.phi, kinematics.phi[len(path) // 2], atol=1e-12)
