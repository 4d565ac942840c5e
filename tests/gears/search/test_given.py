"""Given teeth keep the constraints exactly where the complete search lists them."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import pytest

from tmmcalc.gears.search.blocks import numbers
from tmmcalc.gears.search.search import synthesise
from tmmcalc.gears.tables.tasks.train import to_train
from tmmcalc.project import load_spec

CONFIGS = Path(__file__).parents[3] / "configs"
NAMES = ("coaxial", "unfolded", "three-centrals", "radial-planets", "double-planets", "single-planets")


@pytest.mark.parametrize("more", [(), ("train.constraints.coprime=true",)])
@pytest.mark.parametrize("name", NAMES)
def test_as_in_the_complete_search(name: str, more: tuple[str, ...]) -> None:
    task = to_train(load_spec(CONFIGS / f"gears-{name}.toml", more))[0].task
    found = synthesise(task).sets
    rows = {(*teeth, *parts) for teeth, parts in zip(found.teeth.tolist(), found.modules.tolist(), strict=True)}
    limits = numbers(task)
    chance, kept, refused = random.Random(7), 0, 0
    for _ in range(300):
        teeth = list(found.teeth[chance.randrange(len(found))].tolist())
        for _ in range(chance.choice((0, 1, 2))):
            teeth[chance.randrange(len(teeth))] += chance.choice((-2, -1, 1, 2))
        if not all(z in wheel for z, wheel in zip(teeth, limits.values(), strict=True)):
            continue
        if not task.scheme.branched and any(z > task.limits.largest_pinion for z in teeth[::2]):
            continue
        given = synthesise(replace(task, teeth=tuple(teeth))).sets
        listed = {row for row in rows if row[: len(teeth)] == tuple(teeth)}
        assert {(*teeth, *parts) for parts in given.modules.tolist()} == listed, teeth
        kept, refused = kept + bool(listed), refused + (not listed)
    assert kept > 20
    assert refused > 20 or more == ()
