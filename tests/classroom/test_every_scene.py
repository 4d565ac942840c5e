"""Every known mistake made in every ready spec: numbers or none, never a traceback; each is met where it has to be."""

from __future__ import annotations

import math
from functools import cache

import pytest
from mistakes import CONFIGS, item

from tmmcalc.classroom.keying import classes_of, key_of, mistakes_of
from tmmcalc.classroom.known import known
from tmmcalc.classroom.model import Item
from tmmcalc.core.plan import plan
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import Extent, listed, offered, one
from tmmcalc.pipeline.runner import run
from tmmcalc.pipeline.settling import outlook
from tmmcalc.project import Spec, load_spec
from tmmcalc.rooms import STAGES

TAKEN = (
    *("kinematics", "forces", "reduction", "power", "flywheel", "motion", "train", "criteria", "pair", "gearing"),
    *("cam_law", "cam_synthesis", "cam_profile", "cam_pressure", "cam_forces"),
)
QUICK = ("pair", "gears-double-planets", "reduced-machine")
LONG = ("shaper", "class-four", "cam-oscillating", "hydraulic-lift")
SPECS = sorted(file.stem for file in CONFIGS.glob("*.toml"))
EACH = 4  # results of a stage that are asked for
ROW = "3"
NAMED = (  # of which a mistake of their own is known
    *("power.P_mean", "power.P_required", "flywheel.J_own", "flywheel.rim_mass", "pair.a_w", "criteria.ratio"),
    *("gearing.omega@planet", "gearing.efficiency"),
    *("kinematics.working_D", "kinematics.vx_B@3", "pair.1.p_t", "pair.1.inv_alpha_t", "cam_profile.r_min"),
)


def asked(spec: Spec, stages: tuple[str, ...]) -> tuple[Item, ...]:
    """Some results of every stage, facts and columns, those by choice among them."""
    found = run(spec, target=stages, by_name=True)
    scene = Scene(found.spec, found.results)
    names = [name for name in NAMED if name.partition(".")[0] in stages]
    for stage in stages:
        own = [*listed(stage, found.results[stage]), *offered(stage, scene)]
        facts = [f"{stage}.{each.quantity}" for each in own if not isinstance(each, Extent)]
        rows = [f"{stage}.{each.quantity}@{ROW}" for each in own if isinstance(each, Extent)]
        for every in (facts, rows):
            names += every[:: max(1, len(every) // EACH)]
    return tuple(filter(None, (_item(name, scene) for name in names)))


def _item(name: str, scene: Scene) -> Item | None:
    try:
        told = one(parse(name), scene.results, scene)
    except Exception:  # a name with letters of the language, or a row that is not there
        return None
    return item(name, told.unit) if math.isfinite(told.value) else None


@cache
def met(name: str) -> dict[str, int]:
    """How many of the asked results of a spec each mistake changes."""
    spec = load_spec(CONFIGS / f"{name}.toml")
    running = plan(outlook(spec, None, STAGES), None, STAGES).running
    stages = tuple(stage for stage in TAKEN if stage in running)
    if not stages:
        return {}
    items, told = asked(spec, stages), mistakes_of(spec)
    found = key_of(1, "", spec, items, told)
    assert all(map(math.isfinite, found.values))
    assert all(not math.isinf(value) for values in found.mistaken for value in values)
    classes_of(found, items, told)
    return {each.name: sum(map(math.isfinite, values)) for each, values in zip(told, found.mistaken, strict=True)}


@pytest.mark.parametrize("name", [*QUICK, *(pytest.param(name, marks=pytest.mark.slow) for name in LONG)])
def test_all_mistakes_in_some_specs(name: str) -> None:
    assert sum(map(bool, met(name).values())) > 3


@pytest.mark.slow
def test_all_mistakes_in_all_specs() -> None:
    """Each is met somewhere, and in most scenes that list it."""
    seen: dict[str, list[str]] = {}
    for name in SPECS:
        for mistake, count in met(name).items():
            if count:
                seen.setdefault(mistake.partition(":")[0], []).append(name)
    assert {*known()} - {*seen} == set()
    assert {"shaper", "slotter", "slotted-link"} <= {*seen["linkage.coriolis_left_out"]}
    assert {"press", "crank-slider", "four-bar"}.isdisjoint(seen["linkage.coriolis_left_out"])
    assert "course-project" in seen["gears.chosen_ratio_without_one"]
