"""The task at the beginning of a note: the scheme, the data that the textbook gives, what is to be found."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from note.scenes import CONFIGS, written
from tmmcalc.note.plaintext import text
from tmmcalc.note.tree import Equation, Grid, Image, Title, plain_text
from tmmcalc.pipeline.chapters import task_of
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.manuscript import Datum


def given(name: str) -> dict[str, str]:
    """The values of the table by their designations."""
    (table,) = (each for each in written(name) if isinstance(each, Grid) and each.caption.key == "given")
    return {plain_text(row[1]): plain_text(row[2]) for row in table.rows}


def test_the_shaper_has_the_data_of_the_textbook() -> None:
    """Appendix 2: lengths, masses, moments of inertia, cutting force and where it acts, motor, flywheel."""
    wanted = {
        "n_1": "55 rpm",
        "x_O, y_O": "0; 0.62 m",
        "l_OA": "0.2 m",
        "l_BC": "1.02 m",
        "l_CD": "0.29 m",
        "l_BS3": "0.5 m",
        "l_CS4": "0.12 m",
        "m_3": "55 kg",
        "J_3": "4.5 kg·m²",
        "m_5": "190 kg",
        "Q_5": "7500 N",
        "φ": "30°; 180°",
        "f": "0.1",
        "P_N": "7500 W",
        "δ_0": "0.08",
        "J_f": "186 kg·m²",
    }
    found = given("shaper")
    assert {key: found[key] for key in wanted} == wanted


def quantities(name: str) -> dict[str, str]:
    """The values of the table by what they are."""
    (table,) = (each for each in written(name) if isinstance(each, Grid) and each.caption.key == "given")
    return {plain_text(row[0]): plain_text(row[2]) for row in table.rows}


def test_a_load_has_its_link_its_point_and_its_direction() -> None:
    """As the spec has them: the cutting force on the ram at D, along x; the ram's mass in the same pin."""
    found = quantities("shaper")
    assert found["where load “Q5” is applied"] == "link 5, point D"
    assert found["positive direction of load “Q5”, from axis x"] == "0°"
    assert found["centre of mass of link 5"] == "in point D"
    assert found["acceleration of gravity, directed against axis y"] == "9.81 m/s²"


@pytest.mark.parametrize(
    ("name", "drive"),
    [
        ("press", "constant moment, with which the work of the cycle is zero"),
        ("course-project", "motor, its characteristic by the formula of Kloss"),
    ],
)
def test_a_machine_has_its_drive_and_what_its_rim_is_made_of(name: str, drive: str) -> None:
    """The rim of cast iron carries nine tenths of the moment of inertia."""
    found = quantities(name)
    assert found["drive of the machine"] == drive
    assert found["what the rim is made of"] == "cast iron"
    assert found["share of the rim in the moment of inertia"] == "0.9"


def test_a_cam_has_the_numbers_of_its_positions_and_the_edges_of_its_guide() -> None:
    """Twelve steps of the rise have 13 ends, those of the return after the dwell 13 of their own."""
    found = quantities("assignment-cam")
    assert found["number of equal steps of each phase of motion"] == "12"
    assert found["positions of the rise"] == "0 at its beginning to 12 at its end"
    assert found["positions of the return"] == "13 at its beginning to 25 at its end"
    assert found["height of the lower edge of the guide above the axis of the cam"] == "S_0 + h + r_2"
    assert "as the cam turns" in found["where the pressure angle is positive"]


def test_a_pair_has_its_mesh_its_section_and_its_wheels() -> None:
    found = quantities("assignment-gears")
    assert found["kind of mesh"] == "external, of two wheels"
    assert found["module in the normal section"] == "4 mm"
    assert [found[f"number of teeth of wheel {k}"] for k in (1, 2)] == ["16", "30"]
    assert [found[f"shift coefficient of wheel {k}"] for k in (1, 2)] == ["0.4", "0.2"]
    assert found["tips of the teeth"].startswith("shortened")


def test_unequal_efficiencies_are_of_the_wheels_that_mesh(tmp_path: Path) -> None:
    """Not of the members, of which 2 meshes with both: its second wheel is 2'."""
    words = (CONFIGS / "assignment-train.toml").read_text(encoding="utf-8")
    spec = tmp_path / "train.toml"
    spec.write_text(words.replace("second_teeth = 66", "second_teeth = 66\nefficiency = 0.98"), encoding="utf-8")
    done = run(load_spec(spec), target="gearing")
    blocks = task_of(done.spec, done.results)
    found = [block for block in blocks if isinstance(block, Datum) and "efficiency" in block.what]
    assert [(each.what, each.keys) for each in found] == [
        ("efficiency of the mesh 1–2", ("eta_{12}",)),
        ("efficiency of the mesh 2'–3", ("eta_{2'3}",)),
    ]


def test_a_load_off_the_pins_has_its_place_and_turns_with_its_link(tmp_path: Path) -> None:
    """By its distance from A and its angle there from line AB, and the angle of its direction with AB."""
    words = (CONFIGS / "assignment-press.toml").read_text(encoding="utf-8")
    before, load, after = words.partition('link = 3\npoint = "B"\ndirection = "0 deg"\n')
    assert load
    spec = tmp_path / "press.toml"
    own = 'link = 2\npoint = ["96 mm", "21 mm"]\ndirection = "-90 deg"\naxes = 2\nagainst = 3\n'
    spec.write_text(before + own + after, encoding="utf-8")
    done = run(load_spec(spec), target="forces")
    found = {each.what: each for each in task_of(done.spec, done.results) if isinstance(each, Datum)}
    assert found["where load “Q3” is applied"].text == "link 2, point Q3"
    assert found["distance between points A and Q3"].values == pytest.approx([math.hypot(0.096, 0.021)])
    angle = found["angle of point Q3 on link 2 about A, from line AB"]
    assert angle.values == pytest.approx([math.degrees(math.atan2(0.021, 0.096))])
    assert found["positive direction of load “Q3”, from line AB, with which it turns"].values == pytest.approx([-90.0])
    assert found["link that takes the opposite of load “Q3”"].text == "link 3"


def test_a_train_is_given_by_its_layout_and_ratio() -> None:
    found = given("gears-pairs")
    assert found["i_1H,0"] == "6"
    assert found["T_1"] == "40 N·m"


@pytest.mark.parametrize("name", ["shaper", "gears-pairs"])
def test_the_task_stands_before_the_chapters(name: str) -> None:
    note = written(name)
    titles = [plain_text(each.text) for each in note if isinstance(each, Title) and each.level == 1]
    assert titles[0] == "Task"
    assert titles[-2:] == ["Conclusions", "Appendix A"]
    assert "To be found:" in text(note)


def test_numbers_of_tables_and_figures_are_found_once() -> None:
    for kind in (Grid, Image):
        numbers = [each.caption.number for each in written("shaper") if isinstance(each, kind)]
        assert len(numbers) == len(set(numbers))


def test_what_is_the_same_in_all_positions_stands_once() -> None:
    formulas = [each for each in written("shaper") if isinstance(each, Equation)]
    (line,) = (k for k, each in enumerate(formulas) if text([each]).strip().startswith("G_3 = "))
    assert text([formulas[line]]).strip().startswith("G_3 = m_3 g = 55·9.81 = 539.55 N")
    assert not formulas[line].lead
