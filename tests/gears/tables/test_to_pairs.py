"""From [pair] to the pairs that are solved: every key, what [[pair.meshes]] take from it, defaults, the ready specs."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from project.scenes import CONFIGS

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.internal.ring import Cutter
from tmmcalc.gears.involute.quality.verdicts import QualityLimits
from tmmcalc.gears.involute.rack import RACKS, Rack
from tmmcalc.gears.meshing.choice import sum_asked
from tmmcalc.gears.meshing.task import Measuring, PairTask
from tmmcalc.gears.tables.pair import PairKeys
from tmmcalc.gears.tables.tasks.pair import profile_points, to_pairs
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project import load_spec, parse_spec

DOCS = CONFIGS.parent / "docs" / "spec.md"
DEGREE = math.pi / 180
STEEL = 'material = { steel = "40Kh", treatment = "improved", hardness = "300 HB" }\n'
TRAIN = f'[train]\nlayout = "AI"\nratio = "31.29"\n[strength]\ntorque = "75 N*m"\n{STEEL}[pair]\n'


def one(lines: str, teeth: str = "[14, 27]") -> PairTask:
    (found,) = to_pairs(parse_spec(f'[pair]\nteeth = {teeth}\nmodule = "5 mm"\n{lines}\n')).pairs
    return found


PLAIN = PairTask((14, 27), 0.005)

# key: lines of a spec with it, what is read from its task, and the value
KEYS: dict[str, tuple[str, Callable[[PairTask], Any], Any]] = {
    "name": ('name = "first stage"', lambda task: task.name, "first stage"),
    "kind": ('kind = "internal"', lambda task: (task.kind, task.strategy), ("internal", "zero")),
    "teeth": ("", lambda task: task.teeth, (14, 27)),
    "module": ("", lambda task: task.module, 0.005),
    "helix_angle": ('helix_angle = "-16 deg"', lambda task: task.helix, 16 * DEGREE),
    "rack": ('rack = "ISO 53 D"', lambda task: task.rack, Rack(20 * DEGREE, 1.0, 0.4, 0.39)),
    "pressure_angle": ('pressure_angle = "16 deg"', lambda task: task.rack, Rack(16 * DEGREE)),
    "addendum": ("addendum = 0.9", lambda task: task.rack, Rack(addendum=0.9)),
    "clearance": ("clearance = 0.2", lambda task: task.rack, Rack(clearance=0.2)),
    "tip_radius": ("tip_radius = 0.3", lambda task: task.rack, Rack(tip_radius=0.3)),
    "strategy": ('strategy = "equal_strength"', lambda task: task.strategy, "equal_strength"),
    "x1": ("x1 = 0.5\nx2 = 0.2", lambda task: (task.strategy, task.shifts[0]), ("given", 0.5)),
    "x2": ("x1 = 0.5\nx2 = 0.2", lambda task: task.shifts[1], 0.2),
    "centre_distance": (
        'centre_distance = "110 mm"\nx2 = 0.3',
        lambda task: (task.strategy, task.distance, task.shifts),
        ("given_aw", 0.11, (None, 0.3)),
    ),
    "split": ('centre_distance = "110 mm"\nsplit = "middle"', lambda task: task.split, "middle"),
    "desired_contact_ratio": (
        'strategy = "equal_sliding"\ndesired_contact_ratio = 1.3',
        lambda task: (task.strategy, task.desired),
        ("equal_sliding", 1.3),
    ),
    "contact_ratio_min": ("contact_ratio_min = 1.1", lambda task: task.limits, QualityLimits(contact_ratio=1.1)),
    "contact_ratio_wanted": (
        "contact_ratio_wanted = 1.4",
        lambda task: task.limits,
        QualityLimits(contact_ratio_wanted=1.4),
    ),
    "tip_thickness_min": ("tip_thickness_min = 0.2", lambda task: task.limits, QualityLimits(tip_thickness=0.2)),
    "tip_thickness_wanted": (
        "tip_thickness_wanted = 0.4",
        lambda task: task.limits,
        QualityLimits(tip_thickness_wanted=0.4),
    ),
    "sliding_max": ("sliding_max = 2", lambda task: task.limits, QualityLimits(sliding=2.0)),
    "pressure_max": ("pressure_max = 1.8", lambda task: task.limits, QualityLimits(pressure=1.8)),
    "angle_range": (
        'angle_range = ["18 deg", "28 deg"]',
        lambda task: task.limits,
        QualityLimits(angles=(18 * DEGREE, 28 * DEGREE)),
    ),
    "undercut": (
        'undercut = "none"',
        lambda task: (task.strict, task.limits),
        (True, QualityLimits(undercut=False)),
    ),
    "face_width": ('face_width = "40 mm"', lambda task: task.face_width, 0.04),
    "fillet": ('fillet = "circle"', lambda task: task.fillet, "circle"),
    "tip_diameters": ('tip_diameters = ["80 mm", "150 mm"]', lambda task: task.tips, (0.04, 0.075)),
    "cutter": (
        'kind = "internal"\ncutter = { teeth = 20, shift = 0.1, rounding = 0.2, tip_diameter = "112 mm" }',
        lambda task: task.cutter,
        Cutter(20, 0.1, 0.2, 11.2),
    ),
    "span_teeth": ("span_teeth = [2, 4]", lambda task: task.measuring, Measuring(span_teeth=(2, 4))),
    "ball_diameters": ("ball_diameters = [0.0085, 0.009]", lambda task: task.measuring.balls, (0.0085, 0.009)),
    "measure_over": ('measure_over = "pins"', lambda task: task.measuring, Measuring(body="pins")),
    "face_width_rule": ('face_width_rule = "exact"', lambda task: task.measuring, Measuring(rule="exact")),
}


def test_all_keys_are_tried() -> None:
    assert KEYS.keys() == PairKeys.model_fields.keys()


@pytest.mark.parametrize("key", KEYS)
def test_a_key_reaches_the_task(key: str) -> None:
    lines, read, value = KEYS[key]
    assert read(one(lines)) == value
    if lines:
        assert read(PLAIN) != value


@pytest.mark.parametrize("key", KEYS)
def test_a_key_of_a_mesh_does_the_same(key: str) -> None:
    lines, read, value = KEYS[key]
    text = f'[pair]\n[[pair.meshes]]\nteeth = [14, 27]\nmodule = "5 mm"\n{lines}\n'
    (found,) = to_pairs(parse_spec(text)).pairs
    assert read(found) == value
    assert found == one(lines)


def test_nothing_but_teeth_and_module() -> None:
    assert one("") == PLAIN
    assert one("").limits.undercut
    assert profile_points(parse_spec("[pair]\nteeth = [14, 27]\nmodule = 0.005")) == 50
    assert profile_points(parse_spec("[pair]\nteeth = [14, 27]\nmodule = 0.005\npoints = 9")) == 9


def test_a_rack_has_one_wheel() -> None:
    task = one('kind = "rack"\nx1 = 0.4\nspan_teeth = [3]\nball_diameters = [0.008]\ntip_diameters = [0.08]', "[14]")
    assert (task.teeth, task.kind, task.strategy, task.shifts) == ((14, 0), "rack", "given", (0.4, None))
    assert task.measuring == Measuring(span_teeth=(3, None), balls=(0.008, None))
    assert task.tips == (0.04, None)
    assert one('kind = "rack"', "[14]").strategy == "zero"


@pytest.mark.parametrize("value", ["none", "tolerated", None])
def test_undercut(value: str | None) -> None:
    task = one("" if value is None else f'undercut = "{value}"')
    assert (task.strict, task.limits.undercut) == (value != "tolerated", value != "none")


@pytest.mark.parametrize("name", RACKS)
def test_racks_by_name(name: str) -> None:
    assert one(f'rack = "{name}"').rack == RACKS[name]
    assert one(f'rack = "{name}"\nclearance = 0.2').rack.addendum == RACKS[name].addendum


def test_several_pairs_take_from_the_table_what_they_do_not_say() -> None:
    found = to_pairs(
        parse_spec(
            '[pair]\nteeth = [14, 17]\nmodule = "5 mm"\nhelix_angle = "16 deg"\nrefuse = false\nrack = "ISO 53 A"\n'
            '[[pair.meshes]]\ncentre_distance = "85 mm"\nx1 = 0.6\n'
            '[[pair.meshes]]\nname = "ring"\nkind = "internal"\nteeth = [14, 60]\naddendum = 0.9\n'
        )
    )
    assert (found.usual, found.own) == (None, {})
    first, ring = found.pairs
    assert (first.name, first.teeth, first.helix, first.distance) == ("pair 1", (14, 17), 16 * DEGREE, 0.085)
    assert (ring.name, ring.teeth, ring.helix, ring.strategy) == ("ring", (14, 60), 16 * DEGREE, "zero")
    assert ring.rack == Rack(20 * DEGREE, 0.9, 0.25, 0.38)
    assert not first.refuse
    assert not ring.refuse


def test_pairs_of_a_train() -> None:
    found = to_pairs(
        parse_spec(
            f'{TRAIN}clearance = 0.2\nrefuse = false\n[[pair.meshes]]\nmesh = "1-2"\nstrategy = "balanced"\n'
            '[[pair.meshes]]\nmesh = "2\'-3"\nface_width = "30 mm"\ncutter = { teeth = 25 }\n'
        )
    )
    assert found.pairs == ()
    assert found.usual is not None
    assert (found.usual.strategy, found.usual.distance, found.usual.refuse) == ("given_aw", None, False)
    assert found.own.keys() == {"1-2", "2'-3"}
    assert found.own["1-2"].strategy == "balanced"
    last = found.own["2'-3"]
    assert (last.strategy, last.face_width, last.cutter) == ("given_aw", 0.03, Cutter(25))
    assert {task.rack for task in (found.usual, *found.own.values())} == {Rack(clearance=0.2)}


def test_the_rack_of_a_train_is_that_of_its_teeth() -> None:
    stub = TRAIN.replace("ratio =", 'pressure_angle = "22 deg"\naddendum = 0.8\nratio =')
    usual = to_pairs(parse_spec(stub)).usual
    assert usual is not None
    assert usual.rack == Rack(22 * DEGREE, 0.8)


def test_pairs_beside_a_train() -> None:
    text = TRAIN + 'teeth = [14, 27]\nmodule = "5 mm"\n'
    assert to_pairs(parse_spec(text)).pairs == (PLAIN,)
    assert not parse_spec(text).pair.of_train
    assert parse_spec(TRAIN).pair.of_train


def test_without_pairs(shaper: str) -> None:
    with pytest.raises(UsageError, match=r"no \[pair\]"):
        to_pairs(parse_spec(shaper))


def test_the_task_has_a_hash_that_knows_its_values() -> None:
    tasks = [to_pairs(parse_spec(TRAIN + lines)) for lines in ("", "sliding_max = 2\n", "refuse = false\n")]
    assert len({content_hash(task) for task in tasks}) == 3
    assert content_hash(tasks[0]) == content_hash(to_pairs(parse_spec(f"{TRAIN}\nsliding_max = 3\n")))


def test_examples_of_the_reference() -> None:
    section = DOCS.read_text(encoding="utf-8").split("## `[pair]`")[1].split("\n## ")[0]
    examples = re.findall(r"```toml\n(.*?)```", section, re.DOTALL)
    alone, train = (to_pairs(parse_spec(text)) for text in examples)
    assert [task.title for task in alone.pairs] == ["at 85 mm: z = 14/17", "strongest: z = 14/17"]
    assert train.own["2'-3"].split == "middle"


def test_the_helical_spec_is_the_example_of_the_textbook() -> None:
    """x1 + x2 = 1.122194 at a_w = 85 mm, eps_beta = 0.659077 of b = 40 mm."""
    (task,) = to_pairs(load_spec(CONFIGS / "pair-helical.toml")).pairs
    assert sum_asked(task) == pytest.approx(1.122194, abs=1e-6)
    assert task.width * math.sin(task.helix) / math.pi == pytest.approx(0.659077, abs=1e-6)


def test_values_from_the_command_line() -> None:
    text = f'{TRAIN}[[pair.meshes]]\nmesh = "2\'-3"\n'
    spec = parse_spec(text, overrides=["pair.meshes[mesh=\"2'-3\"].split='middle'", "pair.meshes[0].sliding_max=2"])
    own = to_pairs(spec).own["2'-3"]
    assert (own.split, own.limits.sliding) == ("middle", 2.0)


READY = {
    "pair": [("z = 17/40", "balanced")],
    "pair-spur": [("z = 14/27", "equal_sliding")],
    "pair-helical": [("z = 14/17", "given_aw")],
    "pair-internal": [("z = 18/57 (ring)", "given")],
    "pair-rack": [("z = 12/rack", "given")],
    "pair-blocking": [
        ("no undercut: z = 9/13", "max_contact_strength"),
        ("tolerated undercut: z = 9/13", "max_contact_ratio"),
    ],
}


def test_ready_specs() -> None:
    assert {file.stem for file in Path(CONFIGS).glob("pair*.toml")} == READY.keys()
    for name, pairs in READY.items():
        found = to_pairs(load_spec(CONFIGS / f"{name}.toml"))
        assert [(task.title, task.strategy) for task in found.pairs] == pairs
    whole = to_pairs(load_spec(CONFIGS / "gears-pairs.toml"))
    assert whole.own.keys() == {"1-2"}


def test_the_template_is_right_with_its_comments_taken_away() -> None:
    text = (CONFIGS / "pair.toml").read_text(encoding="utf-8")
    lines = [line.removeprefix("# ") if re.match("# [a-z_0-9]+ = ", line) else line for line in text.splitlines()]
    spurred = [line for line in lines if not re.match("strategy|x2|kind", line)]
    (task,) = to_pairs(parse_spec("\n".join(spurred))).pairs
    assert (task.strategy, task.shifts, task.distance) == ("given_aw", (0.5, None), 0.116)
    assert (task.rack, task.tips) == (RACKS["ISO 53 A"], (0.042, 0.088))
