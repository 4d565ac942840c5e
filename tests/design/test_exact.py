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
from tmmcalc.design.gradient import Gradients
from tmmcalc.design.ladders import Ladders
from tmmcalc.design.model import Model
from tmmcalc.design.sensitivity import sensitivity
from tmmcalc.design.sizes import scales, varied
from tmmcalc.naming.keys import chosen
from tmmcalc.project.loader import Variants

CONFIGS = Path(__file__).parents[2] / "configs"
AIM = 1e-6

# config, results, how many of the pairs of a result and a key have to be given exactly
SCENES = [
    ("shaper", ["kinematics.stroke_D", "kinematics.K_D", "kinematics.aS_D_max", "kinematics.rms(vS_D)"], 1.0),
    (
        "shaper",
        [
            "forces.max(R_A)",
            "forces.rms(M_drive)",
            "forces.R_C@6",
            "forces.range(M_drive)",
            "forces.R_A_max",
            "forces.P_drive_min",
        ],
        0.9,
    ),
    ("four-bar", ["kinematics.stroke_3", "kinematics.x_B@3", "kinematics.at_max(vS_3)", "kinematics.mean(y_B)"], 1.0),
    ("crank-slider", ["kinematics.stroke_B", "kinematics.aS_B_min", "kinematics.integral(vS_B)"], 1.0),
    ("class-three", ["kinematics.max(omega_3)", "kinematics.first(eps_3)", "kinematics.size(eps_3)"], 1.0),
    ("press", ["forces.min(M_drive)", "kinematics.last(S_B)"], 0.9),
]
LARGE = [  # of which each variant takes long: some keys
    (
        "scissor-lift",
        ["kinematics.max(vS_P)", "forces.max(F_drive)"],
        ["mechanism.fixed.O[0]", "mechanism.links[id=1].points.A[0]", "mechanism.input.speed"],
    ),
]

SPRUNG = ["forces.max(M_drive)", "forces.rms(R_A)", "forces.R_B@5", "forces.M_drive_max", "forces.R_C_max"]
QUICK = [
    pytest.param("sprung.toml", SPRUNG, ["springs*", "loads[name=turn]*moment*"], marks=pytest.mark.slow),
    (
        "shaper",
        [*SCENES[0][1], *SCENES[1][1]],
        ["mechanism.links[id=1]*", "mechanism.links[id=3].mass", "mechanism.input*"],
    ),
]


def both_ways(
    config: str, names: list[str], keys: list[str]
) -> tuple[Model, list[list[Slope | None]], list[list[Slope]]]:
    """The model of keys of a spec (none: of all), its exact derivatives, and those by differences alone."""
    file = CONFIGS / f"{config}.toml" if "." not in config else Path(__file__).parent / config
    data = Variants(file.read_text(encoding="utf-8"), str(file), CONFIGS).data
    frame = frame_of(file, (), chosen(data, keys), names)
    sizes, reasons = scales(frame.axes), varied(frame, scales(frame.axes))
    kept = [k for k, reason in enumerate(reasons) if not reason]
    frame, sizes = replace(frame, axes=tuple(frame.axes[k] for k in kept)), [sizes[k] for k in kept]
    model = Model(frame)
    given = Exact(frame, model.names, sizes).at(model.nominal.tolist(), model.run)
    nothing: Any = [[None] * len(model.names) for _ in kept]
    return model, given, Ladders(model, np.array(sizes), nothing, lambda done, count: None).slopes


def check(config: str, names: list[str], keys: list[str], part: float) -> None:
    """What is given exactly is what differences of the whole program go to."""
    model, given, found = both_ways(config, names, keys)
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
                most = max(AIM * abs(one.value), rounding) + one.error + other.error
                assert abs(one.value - other.value) <= most, (key, name)


@pytest.mark.slow
@pytest.mark.parametrize(("config", "names", "keys"), QUICK)
def test_exact_derivatives_are_those_of_differences(config: str, names: list[str], keys: list[str]) -> None:
    check(config, names, keys, 1.0)


@pytest.mark.slow
@pytest.mark.parametrize(("config", "names", "part"), SCENES)
def test_of_every_key(config: str, names: list[str], part: float) -> None:
    check(config, names, [], part)


@pytest.mark.slow
@pytest.mark.parametrize(("config", "names", "keys"), LARGE)
def test_of_some_keys(config: str, names: list[str], keys: list[str]) -> None:
    check(config, names, keys, 0.9)


def test_a_gradient_at_a_place_is_that_of_the_results_beside_it() -> None:
    """Exact ones and one by differences (of the motion), at a place that is not that of the spec."""
    keys = ["mechanism.links[id=1].points.A[0]", "mechanism.fixed.O[1]", "mechanism.links[id=3].mass"]
    names = ["kinematics.stroke_D", "kinematics.max(vS_D)", "forces.max(R_A)", "motion.delta"]
    gradients = Gradients(frame_of(CONFIGS / "shaper.toml", (), keys, names))
    place = np.array([203.0, 621.0, 51.0])
    found = gradients(place)
    assert found.exact[:3].all()
    assert not found.exact[3].any()
    stroke = found.values[0]  # H = 2 l_3 l_1 / l_0
    assert found.slopes[0] == pytest.approx([stroke / 203, -stroke / 621, 0.0], rel=1e-12)
    direction = np.array([1e-3, 2e-3, -1e-3])
    step = (gradients.model(np.stack([place + direction, place - direction])).values * [[1], [-1]]).sum(axis=0) / 2
    assert found.along(direction) == pytest.approx(step, rel=1e-6)
    assert np.all(found.errors <= 1e-8 * np.abs(found.slopes) + 1e-9)


def test_a_gradient_tells_a_fact_that_is_an_extreme_in_two_rows_as_a_kink() -> None:
    """A slider-crank in line: both extremes of the rod, asin((r + e) / l) and asin((r - e) / l), as far to both sides.

    The pressure angle in the guide is the larger one, the transmission angle its complement: slopes of
    +-1 / (l cos asin(r/l)). The length of the crank has no kink there.
    """
    offset, crank = "mechanism.joints[name=B0].guide.through[1]", "mechanism.links[id=1].points.A[0]"
    names = ["kinematics.pressure_max_RRP(2,3)", "kinematics.transmission_min_RRP(2,3)", "kinematics.stroke_B"]
    frame = frame_of(
        CONFIGS / "crank-slider.toml", (f"{offset}=0", "mechanism.grid.positions=12"), [offset, crank], names
    )
    gradients = Gradients(frame)
    found = gradients(np.array([0.0, 100.0]))
    per = np.degrees(1 / 0.32 / np.sqrt(1 - (100 / 320) ** 2))  # deg/m
    for name, sign in (("kinematics.pressure_max", 1), ("kinematics.transmission_min", -1)):
        row = next(m for m, each in enumerate(gradients.names) if each.startswith(name))
        assert np.isnan(found.slopes[row, 0])
        assert (found.right[row, 0], found.left[row, 0]) == pytest.approx((sign * per, -sign * per), rel=1e-8)
        assert found.slopes[row, 1] == pytest.approx(sign * per / 1e3, rel=1e-12)
        assert found.exact[row].tolist() == [False, True]
    assert found.exact[gradients.names.index("kinematics.stroke_B[m]")].all()


def test_an_extreme_in_two_rows_is_a_kink_with_both_sides(tmp_path: Path) -> None:
    """A slider-crank without its offset: the connecting rod leans as far to both sides."""
    offset = "mechanism.joints[name=B0].guide.through[1]"
    result = sensitivity(CONFIGS / "crank-slider.toml", ["kinematics.size(angle_2)"], [offset], [f"{offset}=0"])
    (partial,) = result.partials
    assert partial.way == "exact"
    assert partial.slope.side == "kink"
    assert partial.slope.right == pytest.approx(-partial.slope.left, rel=1e-9)
