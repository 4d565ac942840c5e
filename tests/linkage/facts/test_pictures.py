"""Pictures of the stages, and what they show: vector polygons, dense curves, hodographs, free bodies."""

import json
import subprocess
import sys
from dataclasses import replace
from functools import cache
from importlib.util import find_spec as real_find_spec
from pathlib import Path

import numpy as np
import pytest
from drawing import draw_forces, draw_kinematics, drawn
from loaded import anything, press, ready, statics
from ready import LINKAGES
from sparing import sparing

from tmmcalc.core.errors import UsageError
from tmmcalc.core.installation import install
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.loading import Load, Loading
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.model import Grid, Input, Joint, Link, Mechanism, Output
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.polygons import polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.vectors import VectorPolygons
from tmmcalc.machine.reduction.solve import solve_reduction

ROOT = Path(__file__).parents[3]
CASES = {case["id"]: case for case in json.loads((ROOT / "tests/cases/kinematics.json").read_text())}


@cache
def solved(name: str) -> tuple[Mechanism, Kinematics]:
    mechanism = ready(name)
    return mechanism, solve_kinematics(mechanism)


@pytest.fixture(scope="module")
def shaper() -> tuple[Mechanism, Kinematics]:
    return solved("shaper")


def test_polygons_of_the_textbook(shaper: tuple[Mechanism, Kinematics]) -> None:
    """KIN-S04: shaper, position 21, to the crank scale."""
    case = CASES["KIN-S04"]
    mechanism, result = shaper
    found = polygons(mechanism, result, case["inputs"]["position"])
    unit = result.crank_length * result.speed
    for polygon, name, scale in (
        (found.velocity, "velocity_polygon", unit),
        (found.acceleration, "acceleration_polygon", unit * result.speed),
    ):
        for vertex, (x, y) in case["expected"][name].items():
            assert polygon.vertices[vertex] / scale == pytest.approx(complex(x, y), abs=case["tolerance"]["abs"])


@sparing("name", LINKAGES, every=4)
@pytest.mark.parametrize("k", [1, 5])
def test_vectors_obey_both_theorems(name: str, k: int) -> None:
    mechanism, result = solved(name)
    found = polygons(mechanism, result, k)
    size = max(map(abs, found.acceleration.vertices.values()))
    for vector in found.acceleration.vectors:
        value = found.acceleration.value(vector)
        if vector.kind == "normal":
            (tangential,) = [v for v in found.acceleration.vectors if v.kind == "tangential" and v.link == vector.link]
            across = value * np.conj(found.acceleration.value(tangential))
            assert across.real == pytest.approx(0, abs=1e-9 * size**2)
        if vector.kind == "coriolis":
            check_coriolis(mechanism, found, vector.tail, vector.link, value, size)


def check_coriolis(mechanism: Mechanism, found: VectorPolygons, k: str, slider: int, value: complex, size: float):
    """a^K = 2 omega x v, at right angles to the sliding velocity."""
    guides = {j.links[0]: j.links[1] for j in mechanism.joints if j.kind == "prismatic" and 0 not in j.links}
    (sliding,) = [v for v in found.velocity.vectors if v.kind == "sliding" and v.link == slider]
    relative = found.velocity.value(sliding)
    assert value == pytest.approx(2j * found.omega[guides[slider]] * relative, abs=1e-9 * size)


@sparing("name", LINKAGES, every=4)
def test_vertices_are_the_points_of_the_result(name: str) -> None:
    mechanism, result = solved(name)
    found = polygons(mechanism, result, 2)
    v, a = result.in_time(result.trace.dr, result.trace.ddr)
    for row, point in enumerate(result.trace.point_names):
        for polygon, values in ((found.velocity, v), (found.acceleration, a)):
            tips = np.array(list(polygon.vertices.values()))
            assert np.min(np.abs(tips - values[row, 2])) <= 1e-9 * (1 + np.max(np.abs(tips)))
        assert point


def test_an_accelerated_crank_has_both_parts(shaper: tuple[Mechanism, Kinematics]) -> None:
    mechanism, result = shaper
    found = polygons(mechanism, replace(result, acceleration=10.0), 3)
    parts = [v for v in found.acceleration.vectors if v.link == 1 and v.kind in ("normal", "tangential")]
    assert [found.acceleration.value(v) for v in parts] == [
        pytest.approx(-(result.speed**2) * 0.2 * np.exp(1j * result.x[3])),
        pytest.approx(10j * 0.2 * np.exp(1j * result.x[3])),
    ]


def test_a_point_that_would_take_the_name_of_the_pole_keeps_its_capital() -> None:
    mechanism, result = solved("hydraulic-lift")
    vertices = polygons(mechanism, result, 0).velocity.vertices
    assert vertices["p"] == 0
    assert vertices["P"] != 0


def test_pins_are_shared_by_chains_of_joints() -> None:
    mechanism, _ = solved("inertial-conveyor")
    pin = next(pin for pin in find_pins(mechanism) if pin.name == "B")
    assert set(pin.at) == {2, 3, 4}
    assert set(pin.joints) == {"B", "B4"}


@sparing("name", LINKAGES, every=24)
def test_every_ready_spec_is_drawn(name: str, tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    draw_kinematics(*solved(name), file, polygons=3)
    assert file.read_bytes().startswith(b"<?xml")


@sparing(("suffix", "magic"), [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF"), ("SVG", b"<?xml")], every=4)
def test_equal_inputs_give_equal_bytes(shaper, suffix: str, magic: bytes, tmp_path: Path) -> None:
    first, second = tmp_path / f"a.{suffix}", tmp_path / f"b.{suffix}"
    for file in (first, second):
        draw_kinematics(*shaper, file, positions=[21, 0, 3], polygons=21)
    assert first.read_bytes().startswith(magic)
    assert first.read_bytes() == second.read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == [first.name, second.name]


@pytest.mark.slow
def test_bytes_do_not_depend_on_the_process_or_its_settings(shaper, tmp_path: Path) -> None:
    script = (
        "import sys, pathlib\n"
        "sys.path.insert(0, str(pathlib.Path(sys.argv[1]).parents[2]))\n"
        "from linkage.facts.test_pictures import solved, draw_kinematics\n"
        "draw_kinematics(*solved('shaper'), pathlib.Path(sys.argv[2]))\n"
        "assert not {'reportlab', 'pypdfium2', 'ezdxf'} & set(sys.modules)\n"
    )
    other, own = tmp_path / "other.svg", tmp_path / "own.svg"
    subprocess.run([sys.executable, "-c", script, __file__, str(other)], check=True, cwd=ROOT)
    draw_kinematics(*shaper, own)
    assert other.read_bytes() == own.read_bytes()


@pytest.mark.slow
def test_an_unchanged_picture_is_left_alone(shaper, tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    draw_kinematics(*shaper, file)
    before = file.stat().st_mtime_ns
    draw_kinematics(*shaper, file)
    assert file.stat().st_mtime_ns == before


@pytest.mark.parametrize("name", ["picture.jpg", "picture", "svg"])
def test_other_formats_are_refused(shaper, name: str, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"(?s)suffix.*svg, png, pdf"):
        draw_kinematics(*shaper, tmp_path / name)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("wrong", [{"positions": [25]}, {"positions": [0, -1]}, {"polygons": 99}])
def test_missing_positions_are_refused(shaper, wrong, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"(?s)no position.*0 to 24"):
        draw_kinematics(*shaper, tmp_path / "a.svg", **wrong)


def test_a_missing_package_gets_one_sentence(shaper, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "tmmcalc.report.drawing.find_spec", lambda name: None if name == "reportlab" else real_find_spec(name)
    )
    with pytest.raises(UsageError) as caught:
        draw_kinematics(*shaper, tmp_path / "a.pdf")
    said = "plot: pictures as pdf need reportlab, which is not installed"
    assert str(caught.value) == f"{said}\n  -> {install('plot')}; svg needs nothing"
    draw_kinematics(*shaper, tmp_path / "a.svg")
    assert [file.name for file in tmp_path.iterdir()] == ["a.svg"]


def test_a_missing_folder_is_the_users_fault(shaper, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="cannot be written"):
        draw_kinematics(*shaper, tmp_path / "nowhere" / "a.svg")


def test_the_package_alone_loads_no_writer() -> None:
    code = "import sys, tmmcalc.report.drawing; assert not {'numpy', 'reportlab', 'ezdxf'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)


def quick_return(speed: float, guide_on_frame: bool) -> Mechanism:
    """A crank whose pin's rod runs through a block fixed in the frame, or a crank-slider turned about."""
    links = (Link(1, {"O": 0j, "A": 0.1 + 0j}), Link(2, {"A": 0j, "B": 0.4 + 0j}), Link(3, {"B": 0j}))
    slide = (3, 0) if guide_on_frame else (0, 3)
    points = (0j, 0.02j) if guide_on_frame else (0.3 + 0.02j, 0j)
    return Mechanism(
        Link(0, {"O": 0j}),
        links,
        (
            Joint("O", "revolute", (0, 1), (0j, 0j)),
            Joint("A", "revolute", (1, 2), (0.1 + 0j, 0j)),
            Joint("B", "revolute", (2, 3), (0.4 + 0j, 0j)),
            Joint("B0", "prismatic", slide, points),
        ),
        Input("O", speed, start=0.3),
        (Output(point="B"), Output(link=2)),
        Grid(12),
    )


@pytest.mark.slow
@sparing("speed", [2.0, -2.0], every=2, first=1)
@sparing("guide_on_frame", [True, False], every=2)
def test_clockwise_cranks_and_fixed_blocks(speed: float, guide_on_frame: bool, tmp_path: Path) -> None:
    mechanism = quick_return(speed, guide_on_frame)
    draw_kinematics(mechanism, solve_kinematics(mechanism), tmp_path / "a.svg", polygons=2)
    assert (tmp_path / "a.svg").stat().st_size > 10_000


@pytest.fixture(scope="module")
def pressed() -> tuple[Mechanism, Loading, Kinematics, Forces]:
    given = press()
    return (*given, solve_forces(*given))


def forced(name: str) -> tuple[Mechanism, Loading, Kinematics, Forces]:
    mechanism, kinematics = solved(name)
    loading = anything(mechanism)
    return mechanism, loading, kinematics, solve_forces(mechanism, loading, kinematics)


@pytest.mark.slow
def test_forces_with_both_limits_are_drawn_alike_every_time(pressed, tmp_path: Path) -> None:
    first, second = tmp_path / "a.svg", tmp_path / "b.svg"
    for file in (first, second):
        draw_forces(*pressed, file, polygons=pressed[3].labels.index("6"))
    assert first.read_bytes().startswith(b"<?xml")
    assert first.read_bytes() == second.read_bytes()


@pytest.mark.slow
def test_a_driven_slider_is_drawn(tmp_path: Path) -> None:
    draw_forces(*forced("hydraulic-lift"), tmp_path / "a.png", polygons=1)
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
def test_a_crank_alone_is_drawn(tmp_path: Path) -> None:
    links = (Link(1, {"O": 0j, "A": 0.1 + 0j}),)
    joints = (Joint("O", "revolute", (0, 1), (0j, 0j)),)
    mechanism = Mechanism(Link(0, {"O": 0j}), links, joints, Input("O", -3.0, start=0.0), (), Grid(6))
    loading = Loading(loads=(Load("cutting_force", 1, "force", Constant(5.0), 0.1 + 0j, 1j),))
    kinematics = solve_kinematics(mechanism)
    result = solve_forces(mechanism, loading, kinematics)
    draw_forces(mechanism, loading, kinematics, result, tmp_path / "a.svg", polygons=2)
    drawn("reduction", "machine", tmp_path / "b.svg", solve_reduction(mechanism, loading, kinematics))
    assert (tmp_path / "a.svg").stat().st_size > 10_000
    assert (tmp_path / "b.svg").stat().st_size > 10_000


@pytest.mark.slow
def test_the_reduction_is_drawn(pressed, tmp_path: Path) -> None:
    drawn("reduction", "machine", tmp_path / "a.pdf", solve_reduction(*pressed[:3]))
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize("row", [-1, 99])
def test_missing_rows_of_forces_are_refused(pressed, row: int, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"(?s)no position.*0 to 15"):
        draw_forces(*pressed, tmp_path / "a.svg", polygons=row)


def test_other_formats_of_forces_and_reduction_are_refused(pressed, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="suffix"):
        draw_forces(*pressed, tmp_path / "a.jpg")
    with pytest.raises(UsageError, match="suffix"):
        drawn("reduction", "machine", tmp_path / "a.doc", solve_reduction(*pressed[:3]))


@pytest.mark.parametrize("name", ["press", "slotter", "engine-compressor"])
def test_dense_curves_go_through_the_rows(name: str) -> None:
    """At a position both limits stand side by side; a row is one of them."""
    from tmmcalc.linkage.pictures.course import course_of

    mechanism, loading, _, result = forced(name)
    course = course_of(statics(mechanism, loading))
    peak = np.max(np.abs(result.reaction))
    for k, phi in enumerate(result.phi):
        near = np.argsort(np.abs(course.phi - phi))[:2]
        found = course.reaction[:, near] if np.ptp(course.phi[near]) < 1e-12 else between(course, phi)
        off = np.max(np.abs(found - result.reaction[:, [k]]), axis=0)
        assert np.min(off) < 1e-5 * peak  # a kink of friction may lie inside a panel


def between(course, phi: float) -> np.ndarray:
    """Values where no edge stands, from the polynomial through the points of the panel."""
    rows = course.phi.reshape(course.panels, -1)
    k = next(i for i, row in enumerate(rows) if (row[0] - phi) * (row[-1] - phi) <= 0)
    values = course.reaction.reshape(len(course.reaction), course.panels, -1)[:, k]
    weights = [
        np.prod([(phi - other) / (x - other) for j, other in enumerate(rows[k]) if j != i])
        for i, x in enumerate(rows[k])
    ]
    return (values @ np.array(weights))[:, None]


def test_a_jump_of_friction_is_a_vertical_step(pressed) -> None:
    from tmmcalc.linkage.pictures.course import course_of

    mechanism, loading, _, result = pressed
    course = course_of(statics(mechanism, loading))
    before, after = (result.reaction[:, result.labels.index(label)] for label in ("6-", "6"))
    (k,) = np.flatnonzero((np.diff(course.phi) == 0) & (np.abs(course.phi[:-1] - np.pi) < 1e-9))
    np.testing.assert_allclose(course.reaction[:, k], before, rtol=1e-9)
    np.testing.assert_allclose(course.reaction[:, k + 1], after, rtol=1e-9)
    assert np.max(np.abs(before - after)) > 10


def test_hodographs_of_a_crank_and_of_a_driven_slider(pressed) -> None:
    from tmmcalc.linkage.pictures.hodographs import hodographs_of

    def shown(mechanism: Mechanism, result: Forces) -> list[tuple[list[str], bool]]:
        found = hodographs_of(mechanism, result)
        return [([result.pairs[j].joint for j in drawn.pairs], drawn.turning) for drawn in found]

    assert shown(pressed[0], pressed[3]) == [(["O", "A"], False), (["A"], True)]
    lift = forced("hydraulic-lift")
    assert shown(lift[0], lift[3]) == [(["A"], False), (["O"], False)]


def test_sheets_of_free_bodies(pressed) -> None:
    from tmmcalc.linkage.pictures.cutting import sheets_of

    mechanism, loading, kinematics, result = pressed
    scene, labels = statics(mechanism, loading), result.labels
    (jump,) = sheets_of(scene, kinematics, result, labels.index("6"))
    (before,) = sheets_of(scene, kinematics, result, labels.index("6-"))
    (smooth,) = sheets_of(scene, kinematics, result, labels.index("1"))
    (last,) = sheets_of(scene, kinematics, result, len(labels) - 1)
    assert [body.name for body in jump.bodies] == ["I(0,1)", "RRP(2,3)"]
    assert (jump.limits[0], before.limits[0], last.limits[0]) == ("just after", "just before", "just before")
    assert "Friction jumps" in jump.heading
    assert "Position 6," in before.heading
    assert smooth.others == ()
    assert len(last.others) == 2
    for label, sheet in (("6", jump), ("6-", before), ("12", last)):
        friction = next(f.value.real for f in sheet.bodies[1].forces if f.letter == "F")
        row = labels.index(label)
        assert friction == pytest.approx(result.friction[3, row], rel=1e-9)


@sparing(("name", "counts"), [("press", [2]), ("engine-compressor", [2, 2]), ("four-dyads", [2, 2, 1])], every=3)
def test_bodies_are_dealt_out_evenly(name: str, counts: list[int]) -> None:
    from tmmcalc.linkage.pictures.cutting import sheets_of

    mechanism, loading, kinematics, result = forced(name)
    found = sheets_of(statics(mechanism, loading), kinematics, result, 3)
    assert [len(sheet.bodies) for sheet in found] == counts


def test_arrows_keep_clear_of_what_is_drawn() -> None:
    from tmmcalc.report.drawing.box import Box
    from tmmcalc.report.drawing.field import Board
    from tmmcalc.report.drawing.shapes import Drawing

    board = Board(Drawing(100.0, 100.0), Box(0.0, 0.0, 100.0, 100.0), np.array([-1 - 1j, 1 + 1j]), 5.0)
    board.line((0j, 1 + 0j))
    along, across, beyond = (0.1 + 0j, 0.9 + 0j), (0.5 - 0.4j, 0.5 + 0.4j), (0j, 9j)
    clear = (-0.5 - 0.5j, -0.5 + 0.5j)
    costs = [board.labels.crowded(board.paper(line).tolist(), 1.2) for line in (along, across, clear, beyond)]
    assert costs[0] > costs[1] > costs[2] == 0
    assert costs[3] >= 60


@pytest.mark.parametrize(
    ("peak", "unit", "expected"),
    [
        (9_999.0, "N", (1.0, "N")),
        (1e4, "N", (1e-3, "kN")),
        (2e7, "W", (1e-6, "MW")),
        (5.0, "kg*m^2", (1.0, "kg·m²")),
        (0.0, "N*m", (1.0, "N·m")),
    ],
)
def test_units_suit_the_size(peak: float, unit: str, expected: tuple[float, str]) -> None:
    from tmmcalc.report.drawing.curves import suited

    assert suited(peak, unit) == expected


@pytest.mark.parametrize(
    ("letter", "index", "expected"),
    [
        ("R", "21", r"$R_{21}$"),
        ("R", "10,2", r"$R_{10,2}$"),
        ("Q5", "", "$Q_{5}$"),
        ("Q5'", "", "$Q_{5'}$"),
        ("T", "", "$T$"),
        ("cutting_force", "", "cutting_force"),
    ],
)
def test_signs_of_forces(letter: str, index: str, expected: str) -> None:
    from tmmcalc.report.drawing.lettering import symbol

    assert symbol(letter, index) == expected


@pytest.mark.slow
def test_names_with_underscores_are_drawn(tmp_path: Path) -> None:
    """Two in a row would be a fault in a formula."""
    mechanism = ready("four-bar")
    joints = tuple(replace(j, name="A__1") if j.name == "A" else j for j in mechanism.joints)
    renamed = replace(mechanism, joints=joints, outputs=(replace(mechanism.outputs[0], label="out__1"),))
    kinematics, loading = solve_kinematics(renamed), anything(renamed)
    draw_forces(renamed, loading, kinematics, solve_forces(renamed, loading, kinematics), tmp_path / "a.svg")
    draw_kinematics(renamed, kinematics, tmp_path / "b.svg")
    assert len(list(tmp_path.iterdir())) == 2
