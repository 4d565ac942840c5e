"""Pictures of the kinematics stage, and the vector polygons that they show."""

import json
import subprocess
import sys
from dataclasses import replace
from importlib.util import find_spec as real_find_spec
from pathlib import Path

import numpy as np
import pytest

from tmmcalc.errors import UsageError
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Grid, Input, Joint, Link, Mechanism, Output
from tmmcalc.linkage.pins import find_pins
from tmmcalc.linkage.polygons import VectorPolygons, polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.pictures import draw_kinematics
from tmmcalc.spec import load_spec
from tmmcalc.spec.linkage import to_linkage

ROOT = Path(__file__).parents[2]
CONFIGS = sorted(path.stem for path in (ROOT / "configs").glob("*.toml"))
CASES = {case["id"]: case for case in json.loads((ROOT / "tests/cases/kinematics.json").read_text())}


def solved(name: str) -> tuple[Mechanism, Kinematics]:
    mechanism = to_linkage(load_spec(ROOT / "configs" / f"{name}.toml").mechanism)
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


@pytest.mark.parametrize("name", CONFIGS)
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


@pytest.mark.parametrize("name", CONFIGS)
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


@pytest.mark.parametrize("name", CONFIGS)
def test_every_ready_spec_is_drawn(name: str, tmp_path: Path) -> None:
    file = tmp_path / "picture.svg"
    draw_kinematics(*solved(name), file, polygons=3)
    assert file.read_bytes().startswith(b"<?xml")


@pytest.mark.parametrize(
    ("suffix", "magic"), [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF"), ("SVG", b"<?xml")]
)
def test_equal_inputs_give_equal_bytes(shaper, suffix: str, magic: bytes, tmp_path: Path) -> None:
    first, second = tmp_path / f"a.{suffix}", tmp_path / f"b.{suffix}"
    for file in (first, second):
        draw_kinematics(*shaper, file, positions=[21, 0, 3], polygons=21)
    assert first.read_bytes().startswith(magic)
    assert first.read_bytes() == second.read_bytes()
    assert b"Date" not in first.read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == [first.name, second.name]


def test_bytes_do_not_depend_on_the_process_or_its_settings(shaper, tmp_path: Path) -> None:
    script = (
        "import sys, pathlib, matplotlib; matplotlib.rcParams['font.size'] = 20\n"
        "sys.path.insert(0, str(pathlib.Path(sys.argv[1]).parent))\n"
        "from test_pictures import solved, draw_kinematics\n"
        "draw_kinematics(*solved('shaper'), pathlib.Path(sys.argv[2]))\n"
        "assert 'matplotlib.pyplot' not in sys.modules\n"
        "assert matplotlib.rcParams['font.size'] == 20\n"
    )
    other, own = tmp_path / "other.svg", tmp_path / "own.svg"
    subprocess.run([sys.executable, "-c", script, __file__, str(other)], check=True, cwd=ROOT)
    draw_kinematics(*shaper, own)
    assert other.read_bytes() == own.read_bytes()


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


def test_a_missing_matplotlib_gets_one_sentence(shaper, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "tmmcalc.report.pictures.find_spec", lambda name: None if name == "matplotlib" else real_find_spec(name)
    )
    with pytest.raises(UsageError) as caught:
        draw_kinematics(*shaper, tmp_path / "a.svg")
    assert str(caught.value) == 'pictures need matplotlib: pip install "tmmcalc[plot]"'


def test_a_missing_folder_is_the_users_fault(shaper, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="cannot be written"):
        draw_kinematics(*shaper, tmp_path / "nowhere" / "a.svg")


def test_the_package_alone_does_not_load_matplotlib() -> None:
    code = "import sys, tmmcalc.report.pictures; assert 'matplotlib' not in sys.modules"
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


@pytest.mark.parametrize("speed", [2.0, -2.0])
@pytest.mark.parametrize("guide_on_frame", [True, False])
def test_clockwise_cranks_and_fixed_blocks(speed: float, guide_on_frame: bool, tmp_path: Path) -> None:
    mechanism = quick_return(speed, guide_on_frame)
    draw_kinematics(mechanism, solve_kinematics(mechanism), tmp_path / "a.svg", polygons=2)
    assert (tmp_path / "a.svg").stat().st_size > 10_000
