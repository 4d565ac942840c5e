"""Pictures of gear trains: what is drawn against geometry, closed forms and the results that it shows."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from itertools import combinations
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray
from paper import curves, data, diagram, inside, of_words, on_sheet, written
from sparing import sparing

from tmmcalc.api import run
from tmmcalc.cli.plot import ordered, picture_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.plan import plan
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.pictures.cloud import MANY, evenly
from tmmcalc.gears.pictures.criteria import criteria_drawing
from tmmcalc.gears.pictures.criteria import figure as figure_of_criteria
from tmmcalc.gears.pictures.endview import PITCH, extent
from tmmcalc.gears.pictures.front import CLOUD, EDGE, FRONT, SHADE, WINNER
from tmmcalc.gears.pictures.graphs import PERMITTED, POINT, SURE
from tmmcalc.gears.pictures.placed import PlacedTrain, placed
from tmmcalc.gears.pictures.scheme import scheme_sheet
from tmmcalc.gears.pictures.sideview import WHEELS
from tmmcalc.gears.pictures.solutions import BARS, COPRIME, OTHER
from tmmcalc.gears.pictures.train import chosen_rows, figure, numbered_rows, train_drawing
from tmmcalc.gears.scheme import layout_of
from tmmcalc.gears.selection.results import MEASURES
from tmmcalc.gears.trains import Trains
from tmmcalc.project import load_spec, parse_spec
from tmmcalc.project.templates import folder, names
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.field import Board, Field
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import Pen
from tmmcalc.report.drawing.shapes import Arc, Area, Drawing


class Ordered(NamedTuple):
    spec: Any
    results: Any


RACK = math.radians(20)
RAISED = math.acos(math.cos(RACK) * 132 / 138)  # closes Z1 + 2 Z2 + Z3 = 132 against Z3 + Z4 = 138

TRAINS = {
    "unfolded2": ((17, 59, 17, 40), (0, 0), 1),
    "unfolded3": ((17, 59, 17, 44, 17, 35), (0, 0, 0), 1),
    "coaxial": ((17, 64, 17, 37), (2, 3), 3),
    "AIbar": ((18, 48, 114), (1,), 3),
    "AI": ((22, 118, 17, 97), (4, 7), 2),
    "AA": ((17, 64, 17, 37), (2, 3), 1),
    "II": ((60, 20, 25, 65), (1, 1), 3),
    "AII": ((20, 25, 28, 70, 73), (1, 1), 3),
    "2A-AA": ((18, 24, 66, 72), (1,), 3),
}
SPEC = """
[train]
layout = ["AIbar", "AI"]
ratio = "7.29"
tolerance = "0.1"
tolerance_kind = "absolute"
module_ratios = [[1, 1]]
z_max = 60
sum_max = 100

[strength]
torque = "75 N*m"
face_width = 0.6
permissible_contact = "600 MPa"
permissible_bending = "200 MPa"

[criteria]
objectives = ["mass", "inertia", "size", "error"]
"""


def sets_of(layout: str) -> ToothSets:
    teeth, modules, planets = TRAINS[layout]
    angles = [RACK] * len(layout_of(layout).meshes)
    if layout == "2A-AA":
        angles = [RAISED, RAISED, RACK]
    return ToothSets(layout, np.array([teeth]), np.array([modules]), np.array([angles]), planets)


def train_of(layout: str, **more: Any) -> PlacedTrain:
    return placed(sets_of(layout), 0, **more)


def drawn(train: PlacedTrain) -> tuple[Drawing, Board]:
    drawing, (box,) = sheets(1)
    return drawing, scheme_sheet(drawing, box, train, "Train")


@cache
def sheet_of(layout: str) -> tuple[PlacedTrain, Drawing, Board]:
    train = train_of(layout)
    return train, *drawn(train)


def diagrams(drawing: Drawing, name: str) -> list[Diagram]:
    """All diagrams with an axis of this name."""
    return [each for each in drawing.fields if isinstance(each, Diagram) and name in (each.x.name, each.y.name)]


def circles(field: Field, pen: Pen) -> NDArray[np.complex128]:
    """Middles of the circles of a pen in a field, as data."""
    arcs = [each for each in field.drawing.shapes if isinstance(each, Arc) and each.pen == pen]
    return data(field, np.array([each.centre for each in arcs if inside(np.array([each.centre]), field.box)]))


def areas(field: Field, *fills: str) -> list[NDArray[np.complex128]]:
    """Corners of the areas of some colours in a field, as data, in the order in which they are drawn."""
    found = [each for each in field.drawing.shapes if isinstance(each, Area) and each.fill in fills]
    return [data(field, each.points) for each in found if inside(each.points, field.box)]


def marks(field: Field, pen: Pen) -> tuple[NDArray[np.complex128], list[str]]:
    """Middles of the filled signs of a pen in a field, on paper, with their colours."""
    found = [each for each in field.drawing.shapes if isinstance(each, Arc | Area) and each.pen == pen]
    found = [each for each in found if inside(each.points, field.box)]
    return np.array([each.points.mean() for each in found]), [each.fill for each in found]


def extents(corners: Sequence[NDArray[np.complex128]]) -> list[tuple[float, float]]:
    """Width and height of polygons."""
    return [(float(np.ptp(each.real)), float(np.ptp(each.imag))) for each in corners]


@sparing("layout", LAYOUTS, every=3)
class TestScheme:
    def test_circles_in_mesh_touch(self, layout: str) -> None:
        train = train_of(layout)
        for mesh in train.scheme.meshes:
            one, other = train.wheel(mesh.first), train.wheel(mesh.second)
            sign = 1 if not mesh.internal else -1
            for axis in one.axes if len(one.axes) > 1 else other.axes:
                other_axis = min(other.axes, key=lambda place: abs(place - axis)) if len(one.axes) > 1 else one.axes[0]
                apart = abs(axis - other_axis)
                sums = [abs(r + sign * q) for r, _ in one.pitch for q, _ in other.pitch]
                assert min(abs(total - apart) for total in sums) == pytest.approx(0, abs=1e-9 * train.height)

    def test_what_stands_on_the_sheet(self, layout: str) -> None:
        train, drawing, board = sheet_of(layout)
        said = written(drawing, board.box)
        for wheel in train.wheels:
            assert wheel.name in said
            assert f"$z_{{{wheel.name}}}$ = {wheel.teeth}" in said
        assert ("H" in said) is train.scheme.planetary
        beside = [each for each in of_words(drawing) if each.at.real > board.box.right]
        heights = sorted({each.at.imag for each in beside}, reverse=True)
        rows = [[each.text for each in beside if each.at.imag == height] for height in heights]
        assert rows[0][:2] == ["wheel", "$z$"]
        table = rows[1 : len(train.wheels) + 1]
        assert [row[:2] for row in table] == [[wheel.name, str(wheel.teeth)] for wheel in train.wheels]
        assert [float(row[3]) for row in table] == pytest.approx(
            [2 * wheel.reference for wheel in train.wheels], rel=1e-4
        )

    def test_both_directions_have_one_scale_and_all_is_inside(self, layout: str) -> None:
        _, drawing, board = sheet_of(layout)
        side = board.paper([0j, board.mu * 10, board.mu * 10j])
        assert abs(side[1] - side[0]) == pytest.approx(10) == abs(side[2] - side[0])
        assert not on_sheet(drawing)
        assert not board.labels.faults

    def test_circles_have_their_radii(self, layout: str) -> None:
        """Every pitch circle of the end view by its radius and its place, relative to the main axis."""
        train, drawing, board = sheet_of(layout)
        for k, pen in enumerate(PITCH):
            own = [each for each in drawing.shapes if isinstance(each, Arc) and each.pen == pen]
            radii = sorted(each.radius * board.mu for each in own)
            asked = [r for wheel in train.wheels for r, plane in wheel.pitch if plane == k for _ in wheel.axes]
            assert radii == pytest.approx(sorted(asked))

    def test_bars_of_the_side_view_reach_the_pitch_circles(self, layout: str) -> None:
        train, drawing, board = sheet_of(layout)
        bars = [each for each in drawing.shapes if isinstance(each, Area) and each.pen in WHEELS]
        sizes = extents([data(board, each.points) for each in bars])
        heights = [height if train.scheme.branched else width for width, height in sizes]
        for wheel in train.wheels:
            if not wheel.internal:
                assert min(abs(2 * wheel.rolling - height) for height in heights) < 1e-6


class TestPlaces:
    def test_gap_of_neighbours(self) -> None:
        gap = train_of("AIbar").gap
        assert gap is not None
        assert gap.size == pytest.approx(2 * 33 * math.sin(math.pi / 3) - 48 - 2)
        assert abs(gap.ends[0] - gap.ends[1]) == pytest.approx(gap.size)
        assert gap.ends[0].imag == pytest.approx(gap.ends[1].imag) == pytest.approx(-16.5)
        assert train_of("AI").gap is None

    def test_known_modules_are_metres(self) -> None:
        train = train_of("coaxial", module=np.array([0.002, 0.003]), width=np.array([0.03, 0.05]))
        assert train.distances == (pytest.approx(0.081), pytest.approx(0.081))
        assert 2 * train.wheel("3").reference == pytest.approx(0.111)
        drawing, board = drawn(train)
        (scale,) = [text for text in written(drawing) if text.startswith("$μ_l$")]
        part = float(scale.partition("(1:")[2].partition(")")[0])
        ends = board.data(complex(board.box.left)), board.data(complex(board.box.right))
        assert abs(ends[1] - ends[0]) / (1e-3 * board.box.width) == pytest.approx(part, rel=1e-9)

    def test_modules_that_are_not_chosen_grow_with_the_cube_root_of_the_ratio(self) -> None:
        train = train_of("unfolded3")
        assert train.estimated
        assert train.modules[1] ** 3 == pytest.approx(59 / 17)
        assert train.modules[2] ** 3 == pytest.approx(59 / 17 * 44 / 17)

    def test_planets_stand_on_rays_from_the_upward_one(self) -> None:
        axes = train_of("2A-AA").wheel("3").axes
        assert axes[0] == pytest.approx(69j)
        assert axes[1] / axes[0] == pytest.approx(np.exp(2j * np.pi / 3))

    def test_raised_pressure_angles_give_a_planet_in_two_planes_two_circles(self) -> None:
        wheel = train_of("2A-AA").wheel("3")
        assert [plane for _, plane in wheel.pitch] == [0, 1]
        assert wheel.pitch[0][0] == pytest.approx(33 * 138 / 132)
        assert wheel.pitch[1][0] == pytest.approx(33)

    def test_extent_of_a_ring(self) -> None:
        corners = extent(train_of("AIbar"))
        assert corners.real.max() == pytest.approx(57 + 2.5)


@pytest.fixture(scope="module")
def order(tmp_path_factory: pytest.TempPathFactory) -> Ordered:
    folder = tmp_path_factory.mktemp("gears")
    file = folder / "gears.toml"
    file.write_text(SPEC)
    spec = load_spec(file)
    return Ordered(spec, run(spec, target="criteria").results)


@pytest.fixture(scope="module")
def of_train(order: Ordered) -> Drawing:
    return train_drawing(order.results["train"], numbered_rows(order.results["train"], 2))


@pytest.fixture(scope="module")
def of_criteria(order: Ordered) -> Drawing:
    return criteria_drawing(order.results["criteria"], order.results["train"])


class TestTrain:
    @pytest.mark.slow
    def test_every_candidate_is_in_the_bars(self, order: Ordered, of_train: Drawing) -> None:
        panels = diagrams(of_train, "combinations of wheels")
        variants = order.results["train"].variants
        assert len(panels) == len(variants)
        for field, variant in zip(panels, variants, strict=True):
            ends = [round(float(bar.real.max())) for bar in areas(field, *BARS.values())]
            candidates, *removed, left = ends
            assert candidates == variant.synthesis.candidates == left + sum(removed)
            assert left == variant.synthesis.count
            assert field.x.log
            said = [text.replace("\N{NO-BREAK SPACE}", "") for text in written(of_train, field.box)]
            assert {str(left), str(candidates), *(f"\N{MINUS SIGN}{count}" for count in removed)} <= set(said)

    def test_every_set_is_a_point(self, order: Ordered, of_train: Drawing) -> None:
        panels = diagrams(of_train, "$z_1 + z_2$")
        for field, variant in zip(panels, order.results["train"].variants, strict=True):
            triangles = [each.mean() for each in curves(field, OTHER.pen)]
            points = np.concatenate((circles(field, COPRIME.pen), triangles))
            z = {wheel: variant.sets.of(wheel).astype(float) for wheel in variant.sets.scheme.wheels}
            ratio = 1 + (z["3"] / z["1"] if "2'" not in z else z["2"] * z["3"] / z["1"] / z["2'"])
            sets = z["1"] + z["2"] + 100j * (ratio / 7.29 - 1)
            # the middle of a triangle lies a little beside the place of its sign
            apart = np.abs(field.paper(sets)[:, None] - field.paper(points))
            assert variant.synthesis.count == len(sets) > 2
            assert apart.min(axis=1).max() < 0.3
            assert apart.min(axis=0).max() < 0.3
            teeth = "/".join(map(str, variant.sets.teeth[1]))
            assert f"set 2, drawn: {teeth}" in written(of_train)

    def test_points_of_the_task_lie_on_the_curves(self, of_train: Drawing) -> None:
        wheel = diagram(of_train, "$i_{1H}$")
        points = circles(wheel, POINT.pen)
        eta0 = 0.975 * 0.985
        assert points.tolist() == pytest.approx([complex(7.29, eta0 + (1 - eta0) / 7.29)] * 2)
        modules = diagram(of_train, "tooth ratio $U$")
        (point,) = circles(modules, POINT.pen)
        first = (point.imag**4 * 6.29) ** (1 / 3)  # mu*^4 = U1^2/U2 with U1 U2 = U, and coaxiality (4.21)
        assert first + 1 == pytest.approx(point.imag * (6.29 / first - 1), rel=1e-9)
        for field in (wheel, modules):
            places = field.paper(circles(field, POINT.pen))
            lines = np.concatenate([field.paper(line) for line in curves(field)])
            assert np.abs(places[:, None] - lines).min(axis=1).max() < 1.0

    def test_limits_by_the_number_of_planets(self, of_train: Drawing) -> None:
        field = diagram(of_train, "number of planets $K$")
        table = [13.92, 5.82, 3.85, 3.00, 2.53, 2.23], [11.29, 4.62, 2.99, 2.29, 1.91, 1.66]  # textbook 4.7, cut
        for colour, printed in zip((PERMITTED, SURE), table, strict=True):
            bars = areas(field, colour)
            assert [round(float(bar.real.mean())) for bar in bars] == list(range(3, 9))
            tops = [float(bar.imag.max()) for bar in bars]
            assert all(abs(top - value) < 0.011 for top, value in zip(tops, printed, strict=True))

    def test_a_set_that_there_is_not(self, order: Ordered) -> None:
        most = max(len(variant.sets) for variant in order.results["train"].variants)
        for choose in (0, most + 1):
            with pytest.raises(UsageError, match=f"no tooth set {choose}"):
                numbered_rows(order.results["train"], choose)

    def test_of_compared_trains_the_one_that_is_chosen(self, order: Ordered) -> None:
        """Every row of the trains compared, found among all sets of its variant by its teeth and modules."""
        result, selection = order.results["train"], order.results["criteria"]
        pool = selection.pool
        for choose in (None, *range(1, len(pool) + 1)):
            rows = chosen_rows(result, selection, choose)
            place = selection.winner.place if choose is None else choose - 1
            (at,) = [k for k, row in enumerate(rows) if row is not None]
            teeth = result.variants[at].sets.teeth[rows[at]]
            assert teeth.tolist() == selection.variants[at].sets.teeth[pool.row[place]].tolist()
        assert rows != chosen_rows(result, selection)
        with pytest.raises(UsageError, match="no row 0"):
            chosen_rows(result, selection, 0)


class TestCriteria:
    @pytest.mark.slow
    def test_front_and_winner(self, order: Ordered, of_criteria: Drawing) -> None:
        result = order.results["criteria"]
        field, pool = diagrams(of_criteria, "mass of moving wheels $M$, kg")[0], result.pool
        trains = pool.mass + 1j * pool.inertia
        edge, rings = curves(field, EDGE)[0], circles(field, FRONT.pen)
        beyond = [int(text.split()[-1]) for text in written(of_criteria) if "beyond the picture" in text]
        cloud, _ = marks(field, CLOUD.pen)
        assert len(cloud) + sum(beyond) == len(pool)
        assert rings == pytest.approx(trains[result.front])
        (star,) = curves(field, WINNER.pen)
        assert abs(field.paper(star).mean() - field.place(trains[np.argmin(pool.inertia)])) < 1e-6
        # nothing lies below and left of the border
        corners = edge[::2]
        for corner in corners:
            assert not np.any((pool.mass < corner.real * (1 - 1e-9)) & (pool.inertia < corner.imag * (1 - 1e-9)))
        assert np.all(np.diff(corners.real) >= -1e-12)
        assert np.all(np.diff(corners.imag) <= 1e-12)

    def test_shades_tell_the_size(self, order: Ordered, of_criteria: Drawing) -> None:
        """The colour of every train is that of the bar between whose numbers its size lies."""
        result = order.results["criteria"]
        field, pool = diagrams(of_criteria, "mass of moving wheels $M$, kg")[0], result.pool
        steps = [each for each in of_criteria.shapes if isinstance(each, Area) and each.pen == SHADE]
        beside = Box(field.box.right + 8, field.box.bottom - 1, of_criteria.width, field.box.top + 1)
        words = [each for each in of_words(of_criteria) if inside(np.array([each.at]), beside) and not each.turn]
        heights = np.array(sorted(each.at.imag for each in words))
        sizes = np.array(sorted(float(each.text) for each in words))
        trains = field.paper(pool.mass + 1j * pool.inertia)
        middles, fills = marks(field, CLOUD.pen)
        assert len(set(fills)) > 3
        for at, fill in zip(middles.tolist(), fills, strict=True):
            (step,) = [each.points.imag for each in steps if each.fill == fill]
            low, high = np.interp([step.min(), step.max()], heights, sizes)
            own = 1e3 * pool.size[np.abs(trains - at) < 0.3]
            assert np.any((low - 1e-6 <= own) & (own <= high + 1e-6))

    def test_all_pairs_of_four_criteria(self, order: Ordered, of_criteria: Drawing) -> None:
        fields = [each for each in of_criteria.fields if isinstance(each, Diagram)]
        pairs = [(each.x.name.split()[0].strip(","), each.y.name.split()[0].strip(",")) for each in fields[1:]]
        keys = order.results["criteria"].objectives
        assert len(fields) == 1 + 6
        assert pairs == [*combinations(keys, 2)]
        pool, front = order.results["criteria"].pool, order.results["criteria"].front
        last = fields[-1]
        assert circles(last, FRONT.pen) == pytest.approx(1e3 * pool.size[front] + 100j * pool.error[front], abs=1e-6)

    @pytest.mark.slow
    def test_pairs_of_many_criteria_take_more_sheets(self, order: Ordered) -> None:
        every = replace(order.results["criteria"], objectives=MEASURES)
        drawing = criteria_drawing(every, order.results["train"])
        fields = [each for each in drawing.fields if isinstance(each, Diagram)]
        assert drawing.height == (1 + 4 + 1) * 210
        assert len(fields) == 1 + 21 == 1 + len({(each.x.name, each.y.name) for each in fields[1:]})
        assert all(min(each.box.width, each.box.height) > 40 for each in fields)
        assert not on_sheet(drawing)

    def test_rows_are_numbered_from_1(self, order: Ordered, of_criteria: Drawing) -> None:
        """As in criteria.csv and in the text, of which the winner is row ``place + 1``."""
        result = order.results["criteria"]
        field, pool = diagrams(of_criteria, "mass of moving wheels $M$, kg")[0], result.pool
        size = f"$D$ = {1e3 * pool.size[result.winner.place]:.4g} mm"
        assert f"row {result.winner.place + 1}, chosen: {result.winner.name}, {size}" in written(of_criteria)
        seen = [words for words in of_words(of_criteria) if inside(np.array([words.at]), field.box)]
        numbers = {int(words.text): words.at for words in seen if words.colour == FRONT.pen.colour}
        assert numbers
        assert set(numbers) <= {row + 1 for row in result.front.tolist() if row != result.winner.place}
        for number, at in numbers.items():
            assert abs(at - field.place(complex(pool.mass[number - 1], pool.inertia[number - 1]))) < 12

    @pytest.mark.slow
    def test_the_train_that_is_drawn(self, order: Ordered) -> None:
        result = order.results["criteria"]
        for choose in (None, 1):
            drawing = criteria_drawing(result, order.results["train"], choose)
            place = result.winner.place if choose is None else choose - 1
            sets = result.variants[result.pool.variant[place]].sets
            words = list(of_words(drawing))
            (z,) = [each for each in words if each.text == "$z$"]
            column = sorted((each for each in words if each.at.real == z.at.real), key=lambda each: -each.at.imag)
            teeth = [int(each.text) for each in column[1:]]
            assert teeth == sets.teeth[result.pool.row[place]].tolist()
            assert "$b$, mm" in [each.text for each in words if each.at.imag == z.at.imag]

    def test_a_row_that_there_is_not(self, order: Ordered) -> None:
        result = order.results["criteria"]
        for choose in (0, len(result.pool) + 1):
            with pytest.raises(UsageError, match=f"no row {choose}"):
                criteria_drawing(result, order.results["train"], choose)


@pytest.mark.slow
@pytest.mark.parametrize("stage", ["train", "criteria"])
def test_equal_results_give_equal_bytes(order: Ordered, stage: str, tmp_path: Path) -> None:
    pictures = []
    results = dict(order.results) | {"train": Trains(order.results["train"].variants[:1])}
    for name in ("one.svg", "two.svg"):
        ordered(stage, order.spec, results, {"--choose": "1"}, tmp_path / name)
        pictures.append((tmp_path / name).read_bytes())
    assert pictures[0] == pictures[1]
    assert pictures[0].startswith(b"<?xml")


def test_choose_belongs_to_gears() -> None:
    with pytest.raises(UsageError, match="--choose cannot be used with the picture of kinematics"):
        picture_of("kinematics", {"--choose": "1"})


UNSOLVED = "extreme/no-tooth-set"
TRAINED = [name for name in names() if "[train" in (folder() / f"{name}.toml").read_text() and name != UNSOLVED]


@sparing("name", TRAINED, every=5, first=2)
@pytest.mark.parametrize("make", [figure, figure_of_criteria], ids=["train", "criteria"])
def test_ready_specs_on_paper(name: str, make: Callable[[Order], Drawing]) -> None:
    """Nothing over the edge of the sheets, hardly a name without a free place, no file of thousands of signs."""
    spec = load_spec(folder() / f"{name}.toml")
    target = "criteria" if "criteria" in plan(spec).running else "train"
    if make is figure_of_criteria and target == "train":
        pytest.skip("this scene chooses no train")
    results = run(spec, target=target).results
    drawing = make(Order(spec, results, {"--choose": None}, results.get, parse_spec))
    assert not on_sheet(drawing)
    named = sum(field.labels.count for field in drawing.fields)
    faults = [fault for field in drawing.fields for fault in field.labels.faults]
    assert len(faults) <= 0.01 * named
    for field in drawing.fields:
        signs = [each for each in drawing.shapes if isinstance(each, Arc | Area) and inside(each.points, field.box)]
        assert len(signs) < 1.1 * MANY
    assert all(1.6 <= words.height <= 3.5 for words in of_words(drawing))


def test_clouds_are_thinned_evenly() -> None:
    assert evenly(100_000).size == MANY
    assert set(np.diff(evenly(100_000))) == {33, 34}
