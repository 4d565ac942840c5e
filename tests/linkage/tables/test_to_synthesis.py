"""[synthesis]: from the table to the task, its faults, and the ready specs."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import numpy as np
import pytest
from faults import HOSTILE, Faults, check_lines
from sparing import sparing

import tmmcalc
from tmmcalc.core.errors import SpecError
from tmmcalc.linkage.synthesis.kinds import KINDS
from tmmcalc.linkage.synthesis.task import RotatingTask, SliderCrankTask
from tmmcalc.linkage.tables.synthesis import KINDS as NAMED
from tmmcalc.linkage.tables.synthesis import LinkSynthesisTable
from tmmcalc.linkage.tables.tasks.synthesis import TASKS, to_synthesis
from tmmcalc.project import parse_spec, templates

CONFIGS = templates.folder()
HEAD = "[synthesis.{}]\n"
SLIDER = '[synthesis.slider_crank]\nstroke = "200 mm"\npressure_working = "10 deg"\npressure_idle = "20 deg"\n'
SLOTTED = '[synthesis.slotted_link]\nstroke = "0.28 m"\ntime_ratio = 1.4\npressure_angle = "10 deg"\nguide = "0.6 m"\n'
TRAILING = '[synthesis.trailing_rod]\nv_angle = "45 deg"\ncrank = "70 mm"\nrod = "250 mm"\nlug = "60 mm"\n'
ROTATING = '[synthesis.rotating_slotted_link]\nstroke = "0.2 m"\ntime_ratio = 1.8\nrod = "0.4 m"\ncrank = "75 mm"\n'
FUNCTION = """[synthesis.function]
expression = "x^2"
range = [1, 2]
input_range = "90 deg"
output_range = "60 deg"
"""
PATH = '[synthesis.path]\npoints = [[0, 0], ["20 mm", "15 mm"], ["40 mm", 0]]\n'
MOTION = '[synthesis.motion]\npoints = [[0, 0], ["20 mm", 0]]\nangles = ["0 deg", "30 deg"]\n'


def test_every_kind_has_its_table_its_task_and_its_solver() -> None:
    assert {*NAMED} <= {*LinkSynthesisTable.model_fields}
    assert {*TASKS} <= {*NAMED}
    assert {*KINDS} >= {*TASKS}


def test_sizes_in_si() -> None:
    task = to_synthesis(parse_spec(SLIDER + 'working_speed = "72 m/min"\n'))
    assert task.asked == SliderCrankTask(stroke=0.2, pressure_working=math.radians(10), pressure_idle=math.radians(20))
    assert task.working_speed == pytest.approx(1.2, rel=1e-15)
    assert to_synthesis(parse_spec(ROTATING)).asked == RotatingTask(0.2, 1.8, rod=0.4, crank=0.075)


def test_precision_points_of_an_expression() -> None:
    asked = to_synthesis(parse_spec(FUNCTION)).asked
    x = 1.5 - 0.5 * np.cos(np.array([1, 3, 5]) * math.pi / 6)
    assert asked.inputs == pytest.approx((x - 1) * math.pi / 2)
    assert asked.outputs == pytest.approx((x**2 - 1) / 3 * math.pi / 3)
    equal = to_synthesis(parse_spec(FUNCTION + 'points = 5\nspacing = "equal"\n')).asked
    assert equal.inputs == pytest.approx(np.linspace(0, math.pi / 2, 5))


def test_a_table_and_plain_inputs_say_the_same() -> None:
    ranges = 'input_range = "90 deg"\noutput_range = "60 deg"\n'
    table = parse_spec(f"[synthesis.function]\ntable = [[0, 0], [0.5, 0.25], [1, 1]]\n{ranges}")
    plain = 'inputs = ["10 deg", "55 deg", "100 deg"]\noutputs = ["5 deg", "20 deg", "65 deg"]\n'
    one, two = (to_synthesis(spec).asked for spec in (table, parse_spec(HEAD.format("function") + plain)))
    assert one.inputs == pytest.approx(two.inputs)
    assert one.outputs == pytest.approx(two.outputs)


FAULTS = [
    (
        TRAILING.replace("70 mm", "250 mm"),
        "synthesis.trailing_rod.crank",
        "'250 mm' is not shorter than the master rod, '250 mm': the crank does not turn round",
    ),
    (
        TRAILING.replace("60 mm", "0.3 m"),
        "synthesis.trailing_rod.lug",
        "'0.3 m' is not shorter than the master rod, '250 mm': nothing is left for the trailing rod, l - l_C",
    ),
    (
        TRAILING.replace('v_angle = "45 deg"\n', ""),
        "synthesis.trailing_rod.v_angle",
        "missing key: a V-engine has the angle between its cylinders",
    ),
    ("[synthesis]\nseed = 2\n", "synthesis", "missing key: a synthesis has a kind"),
    (SLIDER + SLOTTED, "synthesis.slotted_link", "slotted_link together with slider_crank: a synthesis has one kind"),
    (
        SLIDER + "time_ratio = 1.1\n",
        "synthesis.slider_crank",
        "too many sizes: stroke, pressure_working, pressure_idle, time_ratio; "
        "a slider-crank has 3 that are independent",
    ),
    (
        SLIDER.replace('stroke = "200 mm"\n', "time_ratio = 1.1\n"),
        "synthesis.slider_crank",
        "no length gives the scale",
    ),
    (
        '[synthesis]\ncrank_speed = "60 rpm"\n' + SLIDER + 'working_speed = "1 m/s"\n',
        "synthesis.slider_crank.working_speed",
        "working_speed together with crank_speed: one follows from the other",
    ),
    (SLIDER + "working_speed = 72\n", "synthesis.slider_crank.working_speed", "72 without a unit is in m/s"),
    (
        SLOTTED.replace("1.4", "1"),
        "synthesis.slotted_link.time_ratio",
        "time_ratio = 1: a slotted link makes the strokes differ",
    ),
    (
        SLOTTED + 'rod = "0.4 m"\n',
        "synthesis.slotted_link.rod",
        "rod together with pressure_angle: one follows from the other",
    ),
    (
        ROTATING.replace('crank = "75 mm"\n', ""),
        "synthesis.rotating_slotted_link",
        "nothing settles the size of the crank: crank or centres",
    ),
    ('[synthesis.crank_rocker]\nswing = "40 deg"\n', "synthesis.crank_rocker", "no length gives the scale"),
    (FUNCTION.replace("[1, 2]", "[2, 1]"), "synthesis.function.range", "[2, 1] runs backwards"),
    (
        FUNCTION.replace("60 deg", "60 mm"),
        "synthesis.function.output_range",
        "'60 mm' is a length; the output of a four_bar is an angle",
    ),
    (
        FUNCTION.replace("x^2", "x^2 + y"),
        "synthesis.function.expression",
        "formula 'x**2 + y': unknown name 'y' at column 8",
    ),
    (
        FUNCTION.replace("x^2", "(x - 1.5)^2"),
        "synthesis.function.expression",
        "y is the same at both ends of the range: the output has no range",
    ),
    (PATH + 'timing = ["0 deg", "30 deg"]\n', "synthesis.path.timing", "2 angles for 3 points"),
    (
        '[synthesis.slider_crank]\nstroke = "0.2 m"\noffset = "20 mm"\noffset_part = 0.1\n',
        "synthesis.slider_crank.offset_part",
        "offset_part together with stroke and offset: it follows from them",
    ),
    (
        '[synthesis.slider_crank]\nstroke = "0.2 m"\noffset = 0\ntime_ratio = 1\n',
        "synthesis.slider_crank.time_ratio",
        "1 together with offset: both say that the guide passes the crank's pivot",
    ),
    (
        MOTION.replace('"20 mm", 0', "0, 0").replace("30 deg", "0 deg"),
        "synthesis.motion.points[1]",
        "pose 2 is the one before it",
    ),
    (
        PATH + 'timing = ["0 deg", "30 deg", "20 deg"]\n',
        "synthesis.path.timing",
        "the crank goes to and fro",
    ),
    (
        MOTION + "region = [[1, 1], [0, 0]]\n",
        "synthesis.motion.region",
        "the corners of the region are not the lower left and the upper right one",
    ),
    (PATH.replace('"20 mm", "15 mm"', "0, 0"), "synthesis.path.points[1]", "point 2 is the one before it"),
]


@pytest.mark.parametrize(("text", "path", "message"), FAULTS)
def test_one_slip_is_one_fault(faults_of: Faults, text: str, path: str, message: str) -> None:
    (fault,) = faults_of(text)
    assert (fault.path, fault.message) == (path, message)
    assert fault.remedy


KEYS = {
    "": "crank_speed solutions seed transmission positions",
    "slider_crank": "stroke working_speed pressure_working pressure_idle time_ratio crank_ratio offset_ratio "
    "offset_part crank rod offset",
    "slotted_link": "stroke working_speed time_ratio pressure_angle rod guide clearance crank centres",
    "rotating_slotted_link": "stroke working_speed time_ratio pressure_angle rod crank centres guide",
    "trailing_rod": "v_angle crank rod lug lug_angle length",
    "crank_rocker": "swing time_ratio crank coupler rocker frame transmission_angle largest_ratio",
    "function": "mechanism expression range points spacing table input_range output_range inputs outputs input_start "
    "output_start frame",
    "path": "mechanism points timing region full_turn largest_ratio",
    "motion": "mechanism points angles region full_turn largest_ratio",
}


@pytest.mark.parametrize(("table", "key"), [(table, key) for table, keys in KEYS.items() for key in keys.split()])
def test_no_value_breaks_the_checks(table: str, key: str) -> None:
    for value in HOSTILE:
        check_lines(f"[synthesis{'.' if table else ''}{table}]\n{key} = {value}\n")


def test_no_table_of_another_type_breaks_the_checks(faults_of: Faults) -> None:
    for value in HOSTILE:
        assert faults_of(f"synthesis = {value}\n")
        for kind in TASKS:
            assert faults_of(f"[synthesis]\n{kind} = {value}\n")


READY = (
    "slider-crank",
    "slotted-link",
    "rotating-slotted-link",
    "crank-rocker",
    "trailing-rod",
    "path",
    "function",
    "motion",
)


@sparing("name", READY, every=4)
def test_ready_specs_are_solved_and_write_ready_specs(name: str) -> None:
    file = Path(CONFIGS) / f"synth-{name}.toml"
    result = tmmcalc.solve_synthesis(tmmcalc.load_spec(file))
    assert result.kind == name.replace("-", "_")
    assert not result.best.defects
    assert result.residual < 1e-9
    for design in result.designs:
        spec = parse_spec(design.spec)
        assert spec.linkage.links
        assert tomllib.loads(design.spec)["mechanism"]["assembly"]["variants"]
    assert tmmcalc.solve_kinematics(parse_spec(result.best.spec)).labels


def test_a_ready_spec_is_the_mechanism_that_was_checked() -> None:
    from tmmcalc.linkage.model import Grid, Output
    from tmmcalc.linkage.synthesis.builders import FourBar, Operation, SliderCrank, four_bar, slider_crank, slotted_link
    from tmmcalc.linkage.synthesis.ready import ready_spec
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    scene = Operation(-1 / 3, 0.1, Grid(18, span=2.0, extra=(0.3, 1.1)), (Output("P", math.pi / 2, label="Py"),))
    plain = Operation(7.0, None, Grid(12, extremes=True), (Output("E", resistance="positive"),))
    made = (
        four_bar(FourBar(0.1 + 0.2j, 0.1, 0.3, 0.7 / 3, 0.4j, 1e-3 - 0.1j, -1), scene),
        slider_crank(SliderCrank(0j, 0.1, 0.3, 0.1 + 0.7j, 0.3, 0.1j), scene),
        slotted_link(0.1, 0.3, 0.5, 0.7, 0.6, plain),
    )
    for mechanism in made:
        assert to_linkage(parse_spec(ready_spec(mechanism, 'a "title"')).linkage) == mechanism


def test_without_a_kind_it_is_no_spec() -> None:
    with pytest.raises(SpecError):
        parse_spec("[synthesis]\n")
