"""Exact derivatives of results by the keys of a spec: against differences of the whole program, kinks, dead points."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmmcalc.batch.reading import frame_of
from tmmcalc.design.differences import Slope
from tmmcalc.design.exact import Exact
from tmmcalc.design.keys import keys_of, scales, varied
from tmmcalc.design.ladders import Ladders
from tmmcalc.design.model import Model
from tmmcalc.design.sensitivity import sensitivity
from tmmcalc.project.loader import Variants

CONFIGS = Path(__file__).parents[2] / "configs"
AIM = 1e-6

# config, results, how many of the pairs of a result and a key have to be given exactly
SCENES = [
    ("shaper", ["kinematics.stroke_D", "kinematics.K_D", "kinematics.aS_D_max", "kinematics.rms(vS_D)"], 1.0),
    ("shaper", ["forces.max(R_A)", "forces.rms(M_drive)", "forces.R_C@6", "forces.range(M_drive)"], 0.9),
    ("four-bar", ["kinematics.stroke_3", "kinematics.x_B@3", "kinematics.at_max(vS_3)", "kinematics.mean(y_B)"], 1.0),
    ("crank-slider", ["kinematics.stroke_B", "kinematics.aS_B_min", "kinematics.integral(vS_B)"], 1.0),
    ("class-three", ["kinematics.max(omega_3)", "kinematics.first(eps_3)", "kinematics.size(eps_3)"], 1.0),
    ("press", ["forces.min(M_drive)", "kinematics.last(S_D)"], 0.9),
    ("scissor-lift", ["kinematics.max(s_B0)", "forces.max(F_drive)"], 0.9),
]


def both_ways(config: str, names: list[str]) -> tuple[Model, list[list[Slope | None]], list[list[Slope]]]:
    """The model of all keys of a spec, its exact derivatives, and those by differences alone."""
    file = CONFIGS / f"{config}.toml"
    frame = frame_of(file, (), keys_of(Variants(file.read_text(encoding="utf-8"), str(file), CONFIGS).data), names)
    sizes, reasons = scales(frame.axes), varied(frame, scales(frame.axes))
    kept = [k for k, reason in enumerate(reasons) if not reason]
    frame, sizes = replace(frame, axes=tuple(frame.axes[k] for k in kept)), [sizes[k] for k in kept]
    model = Model(frame)
    given = Exact(frame, model.names, sizes).at(model.nominal.tolist(), model.run)
    nothing: Any = [[None] * len(model.names) for _ in kept]
    return model, given, Ladders(model, np.array(sizes), nothing, lambda done, count: None).slopes


@pytest.mark.slow
@pytest.mark.parametrize(("config", "names", "part"), SCENES)
def test_exact_derivatives_are_those_of_differences(config: str, names: list[str], part: float) -> None:
    model, given, found = both_ways(config, names)
    assert len(model.names) == len(names)
    told = [each is not None for own in given for each in own]
    assert sum(told) >= part * len(told)
    for k, key in enumerate(model.keys):
        for m, name in enumerate(model.names):
            one, other = given[k][m], found[k][m]
            if one is None or other.side == "jump":
                continue
            assert other.side in (one.side, "none", "kink"), (key, name)
            if one.side == other.side == "both":
                rounding = 1e-12 * abs(model.found[m]) / (abs(model.nominal[k]) or 1.0)
                assert abs(one.value - other.value) <= max(AIM * abs(one.value), rounding) + other.error, (key, name)
