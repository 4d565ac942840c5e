"""Why a plan is as it is: what a decision looked at, what would change it, and that the watching changes nothing."""

from __future__ import annotations

import pytest

from tmmcalc.core.plan import plan
from tmmcalc.pipeline.hashing import content_hash, stage_hash
from tmmcalc.pipeline.settling import outlook, planned
from tmmcalc.pipeline.watch import watched
from tmmcalc.pipeline.why import Why, explain, in_toml
from tmmcalc.project import Spec, load_spec, parse_spec, templates
from tmmcalc.rooms import STAGES

from . import toy

CONFIGS = templates.folder()
SOME = ("shaper", "press", "gears-pairs", "cam-translating", "elastic-drive", "rotor", "manipulator", "feasibility")


def reasons(spec: object, target: str | None = None) -> dict[str, Why]:
    return {why.step.stage: why for why in explain(spec, plan(spec, target))}


def ready(name: str, *overrides: str) -> Spec:
    return load_spec(CONFIGS / f"{name}.toml", overrides)


@pytest.mark.parametrize("name", SOME)
def test_a_watched_spec_gives_the_same_inputs_and_decisions(name: str) -> None:
    spec = ready(name)
    for stage in STAGES.values():
        for decision in (stage.unwanted, stage.used):
            assert watched(decision, spec)[0] == decision(spec)
    for name in plan(spec).running:
        inputs = STAGES[name].inputs
        assert content_hash(watched(inputs, spec)[0]) == content_hash(inputs(spec))


def test_the_toy_pipeline() -> None:
    spec = toy.Spec(speed=None)
    told = {why.step.stage: why for why in explain(spec, plan(spec, stages=toy.STAGES), toy.STAGES)}
    assert told["energy"].brings == ("speed",)
    assert (told["spare"].brings, told["spare"].after) == ((), "energy")
    assert told["geometry"].readers == ("path",)
    assert told["path"].reads == ("geometry",)


@pytest.mark.parametrize(
    ("name", "stage", "key", "given"),
    [
        ("four-bar", "forces", "loads", 'loads=[{link = 2, moment = "5 N*m"}]'),
        ("four-bar", "forces", "mechanism.links.mass", "mechanism.links[id=2].mass=3"),
        ("rotor", "reduction", "torque", 'torque={speed = "20 rad/s", formula = "100*sin(theta)"}'),
        ("scotch-yoke", "flywheel", "flywheel", "flywheel={delta = 0.02}"),
        ("scotch-yoke", "motion", "motion", "motion={}"),
        (
            "scotch-yoke",
            "transient",
            "transients",
            'transients=[{duration = "1 s", motor = "off", start_speed = "5 rad/s"}]',
        ),
        ("press", "balance", None, "engine={}"),
        ("rotor", "bearing", "bearing", None),
        ("cam", "cam_elastic", "cam.elastic", None),
        ("cam-oscillating", "cam_optimum", "cam.optimum", None),
    ],
)
def test_the_key_that_is_named_brings_a_stage_in(name: str, stage: str, key: str | None, given: str | None) -> None:
    told = reasons(ready(name))[stage]
    assert told.step.runs is (key is None)
    assert key is None or key in told.brings
    if key is not None and given is not None:
        assert plan(ready(name, given)).step(stage).runs


def test_absent_keys_that_would_change_nothing_are_not_named() -> None:
    told = reasons(ready("rotor"))
    assert told["flywheel"].brings == ("flywheel",)  # it asked for the mechanism before
    assert told["structure"].brings == ("mechanism",)
    assert set(told["reduction"].brings) == {"mechanism", "torque"}
    assert set(reasons(ready("four-bar"))["forces"].brings) == {
        "mechanism.links.mass", "mechanism.links.inertia", "loads", "springs"
    }  # fmt: skip


def test_a_value_that_bars_a_stage_is_named() -> None:
    told = reasons(ready("gears-pairs"))["drive"]
    assert (told.brings, told.change) == ((), "train.ratio")


def test_keys_are_called_as_in_the_file() -> None:
    assert "transients.from" in reasons(ready("elastic-drive", "flywheel.delta=0.1"))["motion"].decided


def test_stages_that_the_target_does_not_need_say_no_more() -> None:
    told = reasons(ready("shaper"), "kinematics")["transient"]
    assert (told.step.reason, told.brings, told.change, told.after) == ("not needed by kinematics", (), None, None)
    assert told.omits == told.packages == told.tables == ()


def test_results_that_the_spec_gives_itself_are_not_read() -> None:
    spec = ready("geared-pump")
    assert "the result of criteria is not read: the spec gives it" not in reasons(spec)["power"].omits
    ratio, inertia, efficiency = (
        "transmission.ratio=10",
        'transmission.inertia="0.1 kg*m^2"',
        "transmission.efficiency=1",
    )
    assert "criteria" in reasons(ready("geared-pump", ratio, inertia))["power"].reads
    given = ready("geared-pump", ratio, inertia, efficiency)
    assert "the result of criteria is not read: the spec gives it" in reasons(given)["power"].omits
    assert "criteria" not in reasons(given)["power"].reads


@pytest.mark.parametrize(
    ("name", "override"),
    [("shaper", "flywheel.delta=0.03"), ("shaper", "loads[0].factor=0.5"), ("shaper", 'project.title="other"')],
)
def test_a_stage_depends_on_no_table_that_it_is_not_said_to_read(name: str, override: str) -> None:
    before, after = ready(name), ready(name, override)
    table = override.partition(".")[0].partition("[")[0]
    for stage, why in reasons(before).items():
        if why.step.runs:
            one, two = (stage_hash(STAGES[stage], STAGES[stage].inputs(spec), {}, {}) for spec in (before, after))
            assert (one == two) or any(read == table or read.startswith(f"{table}.") for read in why.tables), stage


def test_keys_as_they_stand_in_the_file() -> None:
    spec = parse_spec('[torque]\nspeed = "20 rad/s"\nformula = "100*sin(theta)"\n')
    assert in_toml("cam.optimum", spec) == "optimum in [cam]"
    assert in_toml("mechanism.links.mass", spec) == "mass in [[mechanism.links]]"
    assert in_toml("shafts.ratio", spec) == "ratio in [[shafts]]"


def test_what_a_linkage_to_be_found_would_tell_is_not_made_up() -> None:
    """A load on link 3, which the crank of the outlook has not; and the dyads that the linkage of class IV has not."""
    spec = load_spec(CONFIGS / "synth-dwell-rocker.toml", ['loads=[{link = 3, point = "B", force = "5 N"}]'])
    scene = planned(spec, None, STAGES)
    seen = outlook(spec, None, STAGES)
    told = {why.step.stage: why for why in explain(seen, scene, supposed=("mechanism",))}
    assert (told["forces"].step.runs, told["forces"].tables) == (True, None)
    assert (told["kinematics"].tables, told["kinematics"].omits) == (None, ())
    assert told["synthesis"].tables == ("synthesis.dwell", "synthesis", "project")
