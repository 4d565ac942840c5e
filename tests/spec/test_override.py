from __future__ import annotations

import tomllib
from typing import Any

import pytest
from project.scenes import MACHINE

from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.project import parse_spec
from tmmcalc.spec.override import apply


def value_at(data: Any, path: tuple[str | int, ...]) -> Any:
    for step in path:
        data = data[step]
    return data


@pytest.mark.parametrize(
    ("assignment", "path", "value"),
    [
        ("mechanism.grid.positions=36", ("mechanism", "grid", "positions"), 36),
        (" mechanism.grid.positions = 36 ".strip(), ("mechanism", "grid", "positions"), 36),
        ("mechanism.links[2].points.C=[1.0, 0]", ("mechanism", "links", 2, "points", "C"), [1.0, 0]),
        ("mechanism.links[2].points.C[1]=0.5", ("mechanism", "links", 2, "points", "C", 1), 0.5),
        ("mechanism.links[id=3].mass=50", ("mechanism", "links", 2, "mass"), 50),
        ('mechanism.links[id = 3].mass="50 kg"', ("mechanism", "links", 2, "mass"), "50 kg"),
        ("mechanism.joints[name=D0].guide.angle=1", ("mechanism", "joints", 6, "guide", "angle"), 1),
        ('mechanism.joints[name="D0"].name="E0"', ("mechanism", "joints", 6, "name"), "E0"),
        ('mechanism.fixed."B\'"=[0, 0]', ("mechanism", "fixed", "B'"), [0, 0]),
        ('mechanism.assembly.variants."2-3"=-1', ("mechanism", "assembly", "variants", "2-3"), -1),
        ('project.title="a=b [c]"', ("project", "title"), "a=b [c]"),
        ('loads[name=cut].force="2 kN"', ("loads", 0, "force"), "2 kN"),
        ("loads[2].viscous=0.4", ("loads", 2, "viscous"), 0.4),
        ("springs[name=T].links[1]=5", ("springs", 1, "links", 1), 5),
        ('flywheel.delta="1/30"', ("flywheel", "delta"), "1/30"),
        ('motor.table.speed=["0 rpm", 5]', ("motor", "table", "speed"), ["0 rpm", 5]),
    ],
)
def test_assignment(shaper: str, assignment: str, path: tuple[str | int, ...], value: object) -> None:
    data = tomllib.loads(shaper + MACHINE)
    changed, paths = apply(data, [assignment])
    assert paths == [path]
    assert value_at(changed, path) == value
    assert data == tomllib.loads(shaper + MACHINE)


@pytest.mark.parametrize(
    ("assignment", "path"),
    [
        ("loads[name=Q5].force=2", ("loads", 1, "force")),
        ('loads[name="Q5\'"].force=2', ("loads", 2, "force")),
        ("loads[name=cut].force=2", ("loads", 0, "force")),
        ('springs[name="spring 2"].stiffness=3', ("springs", 1, "stiffness")),
        ('shafts[name="shaft 1"].damping=3', ("shafts", 0, "damping")),
        ("transients[name=transient].duration=3", ("transients", 0, "duration")),
        ('transients[name="transient 2"].duration=3', ("transients", 1, "duration")),
    ],
)
def test_names_that_the_spec_leaves_out(assignment: str, path: tuple[str | int, ...]) -> None:
    data = {
        "loads": [{"name": "cut", "link": 5}, {"link": 5}, {"link": 5}],
        "springs": [{"name": "S"}, {}],
        "shafts": [{}],
        "transients": [{}, {}],
    }
    assert apply(data, [assignment])[1] == [path]


def test_the_names_of_overrides_are_those_of_the_results(shaper: str) -> None:
    """The load that is named by its default is the one of this name in the loading."""
    load = "\n[[loads]]\nlink = 5\npoint = [0, 0]\nforce = "
    spec = parse_spec(f"{shaper}{load}1{load}2", overrides=['loads[name="Q5\'"].force=7'])
    assert {load.name: load.law for load in to_loading(spec).loads} == {"Q5": Constant(1.0), "Q5'": Constant(7.0)}


def test_a_default_name_that_is_not_there(shaper: str) -> None:
    with pytest.raises(UsageError) as raised:
        apply({"loads": [{"link": 5}, {"link": 4}]}, ["loads[name=Q3].force=2"])
    assert "Q5" in str(raised.value.remedy)
    assert "Q4" in str(raised.value.remedy)


@pytest.mark.parametrize(
    ("assignment", "fragment"),
    [
        ("mechanism.grid.positions", "the path cannot be read"),
        ("=3", "the path cannot be read"),
        ("mechanism..grid=3", "the path cannot be read"),
        ("mechanism.links[=3", "the path cannot be read"),
        ("mechanism.input.speed=60 rpm", "'60 rpm' is not a TOML value"),
        ("mechanism.input.speed=", "is not a TOML value"),
        ("mechanism.grid.positions=1\nother = 2", "is not a TOML value"),
        ("mechanism.grid.positions=" + "[" * 5000, "nested too deeply, more than 16"),
        ("mechanism.grid.positions=" + "1" * 5000, "a number or key of 5000 signs, more than 300"),
        ("mechanism." + "a." * 3000 + "b=1", "the path has more than 16 parts"),
        ("mechanism.links" + "[0]" * 3000 + "=1", "the path has more than 16 parts"),
        ("mechanism.links[" + "1" * 5000 + "].mass=1", "the path cannot be read"),
        ("mechanism.links[id=" + "1" * 5000 + "].mass=1", "no element with id = '111"),
        ("mechanism.links[id=" + " " * 30000, "the path cannot be read"),
        ("mechanism.links[id=3" + " " * 30000, "the path cannot be read"),
        ("mechanism.links[id=" + "{a=" * 3000 + "].mass=1", "no element with id"),
        ("mechanism.links[9].mass=1", "mechanism.links has no element [9]"),
        ("mechanism.links[-1].mass=1", "mechanism.links has no element [-1]"),
        ("mechanism.links[id=9].mass=1", "mechanism.links has no element with id = 9"),
        ("mechanism.joints[kind=revolute].name=1", "5 elements with kind = 'revolute'"),
        ("mechanism.links.mass=1", "mechanism.links is not a table"),
        ("mechanism.grid[0]=1", "mechanism.grid is not a list"),
        ("project.title.sub=1", "project.title is not a table"),
    ],
)
def test_fault_names_the_assignment(shaper: str, assignment: str, fragment: str) -> None:
    with pytest.raises(UsageError) as caught:
        apply(tomllib.loads(shaper), [assignment])
    assert fragment in str(caught.value)
    assert "override '" in str(caught.value)
    assert caught.value.remedy


def test_loader_applies_overrides_and_says_so_in_faults(shaper: str) -> None:
    assert parse_spec(shaper, overrides=["mechanism.grid.positions=36"]).mechanism.grid.positions == 36
    with pytest.raises(SpecError) as caught:
        parse_spec(shaper, overrides=["mechanism.links[id=3].mass=-50"])
    (fault,) = caught.value.faults
    assert fault.line is None
    assert fault.message == "-50 is negative; a mass is at least 0 (link 3) (set by an override, not in the file)"


def test_a_new_table_is_made(shaper: str) -> None:
    spec = parse_spec(shaper, overrides=['mechanism.assembly.sketch.C=["330 mm", 0.965]'])
    assert spec.mechanism.assembly.sketch == {"C": [0.33, 0.965]}
