"""The worked cases of the small calculators, through the public API on specs."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmmcalc
from tmmcalc.extras.influence import influence

CASES: dict[str, Any] = {
    case["id"].removeprefix("c2008-"): case
    for case in json.loads((Path(__file__).parents[1] / "cases" / "collection-2008.json").read_text())
}


def parts(name: str) -> tuple[Any, Any, Any]:
    return tuple(CASES[name][key] for key in ("inputs", "expected", "tolerance"))


def spec(table: str, **keys: object) -> tmmcalc.Spec:
    return tmmcalc.parse_spec(written(table, keys))


def written(table: str, keys: Mapping[str, object]) -> str:
    return f"[{table}]\n" + "".join(f"{key} = {json.dumps(keys[key])}\n" for key in keys)


def test_contact() -> None:
    inputs, expected, tol = parts("contact-01")
    i, j = np.array(inputs["w_nodes"]).T
    assert influence(i, j) == pytest.approx(expected["w"], abs=tol["w_abs"])
    given = inputs["hertz"]
    for k, cells in enumerate(given["cells_per_radius"]):
        found = tmmcalc.solve_contact(
            spec(
                "contact",
                load=given["P"],
                modulus=given["E_star"],
                radii=f"{given['R']} m",
                size=f"{given['hexagon_radius_over_a'] * expected['a']} m",
                cells=cells,
            )
        )
        assert len(found.x) == expected["nodes"][k]
        assert found.hertz is not None
        assert found.hertz.along_x == pytest.approx(expected["a"], abs=1e-5)
        assert found.peak / found.hertz.peak == pytest.approx(expected["p_max_over_p0"][k], abs=tol["p_ratio_abs"])
        ratio = found.approach / found.hertz.along_x**2
        assert ratio == pytest.approx(expected["delta_over_a2R"][k], abs=tol["delta_ratio_abs"])


def test_reliability() -> None:
    inputs, expected, tol = parts("reliability-01")
    found = tmmcalc.solve_reliability(
        spec(
            "reliability",
            load=[inputs["a"], inputs["b"]],
            rate=inputs["h"],
            items=inputs["m"],
            least_life=inputs["t_min"],
            mean_life=inputs["t_mean"],
            times=[t for t, _ in expected["R_at"]],
        )
    )
    assert found.decay == pytest.approx(expected["beta"], rel=tol["beta_rel"])
    assert found.strength == pytest.approx(expected["r"], rel=tol["r_rel"])
    assert found.threshold == pytest.approx(expected["t0"], abs=tol["t0_abs"])
    assert [r for _, r in found.asked] == pytest.approx([r for _, r in expected["R_at"]], abs=tol["R_abs"])


def test_tie_down() -> None:
    inputs, expected, tol = parts("tiedown-01")
    text = f"""
[tie_down]
weight = "{inputs["G2_N"]} N"
factor = {inputs["k"]}
elevation = "{inputs["alpha_deg"]} deg"
plan_angle = "{inputs["beta_deg"]} deg"
friction = {inputs["mu_fixed"]}
PRELOAD
[tie_down.support]
weight = "{inputs["G_o_N"]} N"
friction = {inputs["mu_sliding_support"]}
base = "{inputs["L_mm"]} mm"
cradle_arm = "{inputs["a_mm"]} mm"
arm = "{inputs["b_mm"]} mm"
diameter = "{inputs["D_mm"]} mm"
"""
    found = tmmcalc.solve_tie_down(tmmcalc.parse_spec(text.replace("PRELOAD", f'preload = "{inputs["P0_N"]} N"')))
    for value, key in (
        (found.force, "R_N"),
        (found.change, "delta_R_N"),
        (found.opposite, "R34_N"),
        (found.vertical, "vertical_load_N"),
    ):
        assert value == pytest.approx(expected[key], abs=tol["R_N"])
    thread = inputs["thread"]
    keys = f'moment = "{thread["M_Nmm"]} N*mm", diameter = "{thread["d2_mm"]} mm"'
    angles = f'lead_angle = "{thread["lambda_rad"]} rad", friction_angle = "{thread["rho_rad"]} rad"'
    found = tmmcalc.solve_tie_down(tmmcalc.parse_spec(text.replace("PRELOAD", f"thread = {{ {keys}, {angles} }}")))
    assert found.preload == pytest.approx(expected["P0_from_thread_N"], abs=tol["P0_N"])


def ball(inputs: Any, **more: object) -> Any:
    keys = {"radius": inputs["r0"], "drag": inputs["alpha"], "decay": inputs["lambda_"]}
    return tmmcalc.solve_falling_ball(spec("falling_ball", **keys, **more))


def test_ball_that_stops() -> None:
    inputs, expected, tol = parts("ball-01")
    for k, v0 in enumerate(inputs["v0"]):
        found = ball(inputs, relative_speed=inputs["v_r"], initial_speed=v0, gravity=inputs["g"])
        assert found.argument == pytest.approx(expected["tau0"], rel=tol["rel"])
        assert found.stop_argument == pytest.approx(expected["tau_star"][k], rel=tol["rel"])
        assert found.stop.t == pytest.approx(expected["t_star"][k], rel=tol["rel"])
        assert found.stop.way == pytest.approx(expected["S_max"][k], rel=tol["rel"])


def test_ball_that_is_driven_and_ball_in_balance() -> None:
    inputs, expected, tol = parts("ball-02")
    given = inputs["case_a"]
    times = given["t"]
    found = ball(given, relative_speed=given["v_r"], initial_speed=given["v0"], times=times)
    assert [at.v for at in found.asked] == pytest.approx(expected["a_v"], rel=tol["rel"])
    assert found.fastest.v == pytest.approx(expected["a_vmax"], rel=tol["rel"])
    assert found.fastest.t == pytest.approx(expected["a_t_at_vmax"], abs=tol["t_abs"])
    given = inputs["case_b"]
    balanced = 9.81 / (3 * given["lambda_"])
    found = ball(given, relative_speed=balanced, initial_speed=given["v0"], times=[given["t"]])
    assert found.asked[0].way == pytest.approx(expected["b_S"], rel=tol["rel"])
    assert found.total == pytest.approx(expected["b_S_max"], rel=tol["rel"])


@pytest.mark.parametrize("reaction", ["accelerating", "braking"])
def test_ball_whose_lost_mass_rests(reaction: str) -> None:
    inputs, expected, tol = parts("ball-03")
    found = ball(inputs, relative_speed="own", reaction=reaction, initial_speed=inputs["v0"], times=inputs["t"])
    assert [at.v for at in found.asked] == pytest.approx(expected[f"{reaction}_v"], rel=tol["rel"])
    assert found.fastest.v == pytest.approx(expected[f"{reaction}_vmax"], rel=tol["rel"])
    assert found.fastest.t == pytest.approx(expected[f"{reaction}_t_vmax"], abs=tol["t_abs"])


def test_bearing() -> None:
    inputs, expected, tol = parts("bearing-01")
    found = tmmcalc.solve_bearing(
        spec(
            "bearing",
            wheel_speed=inputs["v"],
            wheel_diameter=inputs["D_wheel"],
            inner=inputs["d_inner"],
            outer=inputs["d_outer"],
            roller=inputs["d_roller"],
            count=inputs["z"],
            contact_angle=inputs["contact_angle_deg"],
        )
    )
    for value, key in (
        (found.omega, "omega"),
        (found.turns, "n"),
        (found.width, "R_n"),
        (found.half, "half"),
        (found.mean_radius, "R_mean"),
        (found.cage, "FTF"),
        (found.outer_race, "BPFO"),
        (found.inner_race, "BPFI"),
        (found.roller, "BSF"),
    ):
        assert value == pytest.approx(expected[key], rel=tol["rel"])


def test_liner() -> None:
    inputs, expected, tol = parts("liner-01")
    clamp = inputs["clamp"]
    text = f"""
[liner]
radius = "{inputs["r1_mm"]} mm"
thickness = "{inputs["h_mm"]} mm"
ring_outer = "{inputs["r2_mm"]} mm"
ring_width = "{inputs["b_mm"]} mm"
young = "{inputs["E_MPa"]} MPa"
poisson = {inputs["mu"]}
load = "{inputs["q_N_per_mm"]} N/mm"
continuity = "{inputs["continuity"]}"
LENGTH
[liner.clamp]
gas_pressure = "{clamp["p_max_MPa"]} MPa"
bore = "{clamp["bore_mm"]} mm"
arm = "{clamp["arm_mm"]} mm"
factor = {clamp["factor"]}
"""
    for length in ("", 'length = "1 m"\nrows = 100'):  # 61/alpha is long
        found = tmmcalc.solve_liner(tmmcalc.parse_spec(text.replace("LENGTH", length)))
        for value, key in (
            (found.alpha, "alpha_s"),
            (found.stiffness, "D"),
            (found.ring_area, "F_ring"),
            (found.ring_inertia, "I_ring"),
            (found.moment, "m"),
            (found.force, "Q0"),
            (found.couple, "M0"),
            (found.other_force, "Q0_edge"),
            (found.other_couple, "M0_edge"),
            (found.end, "w0"),
            (found.turn, "psi"),
            (found.centre, "u_ring"),
            (found.axial[0], "sigma_x_at_ring"),
        ):
            assert value == pytest.approx(expected[key], rel=tol["rel"]), key
    at = [x // 10 for x in inputs["x_mm"]]  # a row each 10 mm
    assert 1e3 * found.x[at] == pytest.approx(inputs["x_mm"])
    assert found.w[at] == pytest.approx(expected["w"], rel=tol["rel"])
    assert found.bend[at] == pytest.approx(expected["M"], rel=tol["rel"])


@pytest.mark.parametrize("blanks", ["without", "with"])
@pytest.mark.parametrize("factors", ["sum", "product"])
def test_transloader(factors: str, blanks: str) -> None:
    inputs, expected, tol = parts("transloader-01")
    part, trolley, hoist = inputs["part"], inputs["trolley"], inputs["hoist"]
    named = {"pressure": "q0", "area": "area", "height": "n", "shape": "c", "overload": "gamma", "dynamic": "beta"}
    tables = [
        written(f"transloader.{name}", {key: wind[symbol] for key, symbol in named.items()})
        for name, wind in inputs["winds"].items()
    ]
    tables.append(written("transloader.loads", {name: f"{size} kN" for name, size in inputs["loads_kN"].items()}))
    found = tmmcalc.solve_transloader(
        tmmcalc.parse_spec(f"""
[transloader]
capacity = "{inputs["capacity_t"]} t"
gravity = {inputs["g"]}
mass = "{inputs["mass_t"]} t"
factors = "{factors}"
blanks = "{blanks}"
trolley = {{ path = "{trolley["L0"]} m", acceleration = "{trolley["j"]} m/s^2" }}
hoist = {{ height = "{hoist["H"]} m", acceleration = "{hoist["j"]} m/s^2" }}
inertia = {{ weights = {json.dumps([f"{weight} kN" for weight in inputs["inertia"]["G_kN"]])} }}
{"".join(tables)}
[[transloader.parts]]
name = "jib"
mechanism = "{part["mechanism"]}"
duty = "{part["duty"]}"
making = "{part["making"]}"
area = "{part["area_cm2"]} cm^2"
strength = "{part["strength_MPa"]} MPa"
endurance = "{part["endurance_MPa"]} MPa"
{written("transloader.parts.influence", part["influence"])}
""")
    )
    for drive, what in zip(found.drives, ("trolley", "hoist"), strict=True):
        told = [expected[key] for key in (f"v_{what}_peak", f"v_{what}", f"t_{what}")]
        assert [drive.peak, drive.speed, drive.time] == pytest.approx(told, rel=tol["rel"])
    assert found.inertia == pytest.approx(expected["P"], rel=tol["rel"])
    assert {each.load: each.value for each in found.loads} == pytest.approx(expected["loads_N"], rel=tol["rel"])
    assert [mass / 1e3 for mass in found.masses] == pytest.approx(expected["masses_t"], rel=tol["rel"])
    acting = {"+", "?"} if blanks == "with" else {"+"}
    for each in found.loads:
        signs = zip(inputs["cases"], inputs["matrix"][each.load], strict=True)
        assert list(each.cases) == [case for case, sign in signs if sign in acting]
    other = "product" if factors == "sum" else "sum"
    strength = [check for check in found.checks if check.kind == "strength"]
    assert [check.case for check in strength] == inputs["cases"]
    assert [check.force for check in strength] == pytest.approx(expected[f"N_{blanks}"], rel=tol["rel"])
    assert [check.stress for check in strength] == pytest.approx(
        [force / (1e-4 * part["area_cm2"]) for force in expected[f"N_{blanks}"]], rel=tol["rel"]
    )
    (endurance,) = [check for check in found.checks if check.kind == "endurance"]
    for kind, checks in (("strength", strength), ("endurance", [endurance])):
        for values, by in (([check.allowed for check in checks], factors), ([check.other for check in checks], other)):
            limits = expected[f"{kind}_MPa_{by}"]
            limits = limits if kind == "strength" else [limits]
            assert [value / 1e6 for value in values] == pytest.approx(limits, rel=tol["rel"])
