"""Names, units and values of the columns; dimensionless results; selection by pattern."""

from __future__ import annotations

import numpy as np
import pytest
from transforms import scaled

from linkage.scenes import crank_slider, driven_rod, full_turn, shaper, slotted, with_input
from tmmcalc import Kinematics, UsageError, solve_kinematics
from tmmcalc.core.columns import Column, select
from tmmcalc.linkage.columns import columns


def table(result: Kinematics, dimensionless: bool = False) -> dict[str, Column]:
    return {column.name: column for column in columns(result, dimensionless=dimensionless)}


def test_units_of_a_crank_and_of_a_driven_slider() -> None:
    crank, slider = table(solve_kinematics(shaper())), table(solve_kinematics(driven_rod(1.0, 0.2, 0.5)))
    expected = {
        "phi": ("deg", "m"), "x_A": ("m", None), "x_B": (None, "m"), "vx_B": (None, "m/s"), "ddx_B": (None, "m/m^2"),
        "dx_C": ("m/rad", None), "ddx_C": ("m/rad^2", None), "angle_2": ("deg", "deg"), "omega_2": ("rad/s", "rad/s"),
        "eps_2": ("rad/s^2", "rad/s^2"), "dangle_2": ("rad/rad", "rad/m"), "ddangle_2": ("rad/rad^2", "rad/m^2"),
        "s_D0": ("m", None), "ds_D0": ("m/rad", None), "a_D0": ("m/s^2", None), "s_B0": (None, "m"),
        "S_D": ("m", None), "vS_D": ("m/s", None), "dS_D": ("m/rad", None), "ddS_D": ("m/rad^2", None),
    }  # fmt: skip
    for name, units in expected.items():
        for found, unit in zip((crank, slider), units, strict=True):
            if unit is not None:
                assert found[name].header == f"{name}[{unit}]"


def test_an_angular_output_is_in_degrees() -> None:
    found = table(solve_kinematics(slotted(0.1, 0.25)))
    assert [found[name].unit for name in ("S_3", "vS_3", "aS_3", "dS_3", "ddS_3")] == [
        "deg", "rad/s", "rad/s^2", "rad/rad", "rad/rad^2",
    ]  # fmt: skip
    assert found["S_3"].make()[-1] == pytest.approx(360.0, abs=1e-10)


def test_every_column_has_a_value_a_position_and_its_name_once() -> None:
    result = solve_kinematics(shaper())
    every = columns(result)
    assert len({column.name for column in every}) == len(every)
    for column in every:
        values = column.make()
        assert values.shape == result.x.shape
        assert values.dtype == np.float64
        assert np.all(np.isfinite(values))


def test_velocities_and_accelerations_in_time() -> None:
    result = solve_kinematics(with_input(full_turn(crank_slider(0.1, 0.3)), speed=-7.0, acceleration=3.0))
    found = {name: column.make() for name, column in table(result).items()}
    np.testing.assert_allclose(found["vx_B"], -7 * found["dx_B"], rtol=1e-15)
    np.testing.assert_allclose(found["ax_B"], 49 * found["ddx_B"] + 3 * found["dx_B"], atol=1e-13)
    np.testing.assert_allclose(found["eps_2"], 49 * found["ddangle_2"] + 3 * found["dangle_2"], atol=1e-13)


@pytest.mark.parametrize("speed", [1.0, -30.0])
@pytest.mark.parametrize("size", [1e-6, 1e3])
def test_dimensionless_values_depend_on_neither_speed_nor_size(speed: float, size: float) -> None:
    plain = table(solve_kinematics(with_input(shaper(), start=0.2)), dimensionless=True)
    mechanism = scaled(with_input(shaper(), start=0.2), size)
    other = table(solve_kinematics(with_input(mechanism, speed=speed)), dimensionless=True)
    order = slice(None, None, 1 if speed > 0 else -1)
    for name, column in plain.items():
        if name == "phi" or name.startswith(("angle_", "S_")):
            continue
        assert other[name].unit == column.unit
        np.testing.assert_allclose(other[name].make()[order], column.make(), atol=1e-11, err_msg=name)
    assert plain["aS_D"].unit == "l_1*omega_1^2"
    assert plain["x_C"].unit == "l_1"
    assert plain["omega_3"].unit == "omega_1"


def test_dimensionless_needs_a_crank() -> None:
    with pytest.raises(UsageError, match="the input link is a slider"):
        columns(solve_kinematics(driven_rod(1.0, 0.2, 0.5)), dimensionless=True)


def test_select_by_patterns_in_their_order() -> None:
    every = columns(solve_kinematics(shaper()))
    names = [column.name for column in select(every, ["omega_*", "x_D", "phi", "omega_3"])]
    assert names == ["omega_1", "omega_2", "omega_3", "omega_4", "omega_5", "x_D", "phi"]
    with pytest.raises(UsageError, match="no column is called 'omga_3'") as refused:
        select(every, ["phi", "omga_3"])
    assert "omega_3" in str(refused.value)
    with pytest.raises(UsageError):
        select(every, ["OMEGA_3"])
