"""Mistakes in cams, worked out again from the closed form of the sine law and the equations of the follower."""

from __future__ import annotations

import math

import pytest
from mistakes import right, wrong

H, RISE, RETURN, N = 0.030, math.radians(60), math.radians(60), 120.0
W = N * math.pi / 30
SIZES = (
    *('cam.start_distance="60 mm"', 'cam.offset="12 mm"', 'cam.roller_radius="14 mm"'),
    *('cam.return_angle="70 deg"', 'cam.loads.gravity="-9.81 m/s^2"'),
)


def motion(degrees: float, rise: float = RISE) -> tuple[float, float, float]:
    """Displacement and its derivatives by the angle of the cam during the rise, by the sine law [m]."""
    k = math.radians(degrees) / rise
    turn = 2 * math.pi * k
    return (
        H * (k - math.sin(turn) / (2 * math.pi)),
        H / rise * (1 - math.cos(turn)),
        2 * math.pi * H / rise**2 * math.sin(turn),
    )


def test_without_a_mistake() -> None:
    _, s1, s2 = motion(20)
    asked = "cam_law.S1[phi=20 deg] m", "cam_law.a[phi=20 deg] m/s^2"
    assert right("cam", *asked, sets=SIZES) == pytest.approx([s1, s2 * W * W])


@pytest.mark.parametrize(
    ("mistake", "asked", "value"),
    [
        ("cam_analogue_given", "cam_law.v[phi=20 deg] m/s", motion(20)[1]),
        ("cam_analogue_given", "cam_law.a[phi=20 deg] m/s^2", motion(20)[2]),
        ("cam_rate_given", "cam_law.S1[phi=20 deg] m", motion(20)[1] * W),
        ("cam_per_degree", "cam_law.S2[phi=20 deg] m", motion(20)[2] * (math.pi / 180) ** 2),
        ("cam_speed_in_rpm", "cam_law.a[phi=20 deg] m/s^2", motion(20)[2] * N * N),
        ("phases_swapped", "cam_law.S1[phi=20 deg] m", motion(20, math.radians(70))[1]),
    ],
)
def test_the_law(mistake: str, asked: str, value: float) -> None:
    assert wrong("cam", f"cams.{mistake}", asked, sets=SIZES) == pytest.approx([value], rel=1e-9)


def test_offset() -> None:
    """tan theta = (S' -+ e)/(S0 + S): the two sides and none lie one after another."""
    asked = "cam_pressure.theta[phi=20 deg] deg"
    own = math.tan(math.radians(right("cam", asked, sets=SIZES)[0]))
    other, none = (
        math.tan(math.radians(wrong("cam", f"cams.{mistake}", asked, sets=SIZES)[0]))
        for mistake in ("offset_reversed", "offset_left_out")
    )
    s, s1, _ = motion(20)
    assert none == pytest.approx(s1 / (0.060 + s))
    assert {round(own, 9), round(other, 9)} == {round((s1 - e) / (0.060 + s), 9) for e in (0.012, -0.012)}


def test_profile() -> None:
    base = math.hypot(0.060, 0.012)
    assert right("cam", "cam_profile.R0 mm", "cam_profile.r_min mm", sets=SIZES) == pytest.approx(
        [1000 * base, 1000 * base - 14]
    )
    assert wrong("cam", "cams.pitch_for_working", "cam_profile.r_min mm", sets=SIZES) == pytest.approx([1000 * base])
    assert wrong("cam", "cams.working_for_pitch", "cam_profile.R0 mm", sets=SIZES) == pytest.approx([1000 * base - 14])
    assert wrong("cam", "cams.roller_diameter", "cam_profile.r_min mm", sets=SIZES) == pytest.approx([1000 * base - 28])


def test_turned_back() -> None:
    """The profile is that of the mirror; where the offset is zero the radii stay and the directions are mirrored."""
    central = (*SIZES, "cam.offset=0")
    asked = "cam_profile.x_c[phi=30 deg] mm", "cam_profile.y_c[phi=30 deg] mm"
    own, turned = right("cam", *asked, sets=central), wrong("cam", "cams.cam_turned_back", *asked, sets=central)
    assert math.hypot(*own) == pytest.approx(60 + 1000 * motion(30)[0])
    assert sorted(map(abs, own)) == pytest.approx(sorted(map(abs, turned)))
    assert own != pytest.approx(turned)


def test_forces_on_the_follower() -> None:
    """P_in = -m S'' w^2 is all that the mass adds beside the weight; the useful force is 200 N on the rise."""
    asked = "cam_forces.P_in[phi=20 deg] N", "cam_forces.Q[phi=20 deg] N", "cam_forces.P_c[phi=20 deg] N"
    inertia, useful, total = right("cam", *asked, sets=SIZES)
    assert inertia == pytest.approx(-0.4 * motion(20)[2] * W * W)
    given = 'cam.spring={stiffness = "2 N/mm", preload = "60 N"}'
    massless = wrong("cam", "cams.cam_inertia_left_out", asked[0], asked[2], sets=(*SIZES, given))
    assert massless == pytest.approx([0.0, right("cam", asked[2], sets=(*SIZES, given))[0] - inertia], abs=1e-12)
    whole, less, other = (
        found[0]
        for found in (
            right("cam", asked[2], sets=(*SIZES, given)),
            wrong("cam", "cams.cam_force_left_out", asked[2], sets=(*SIZES, given)),
            wrong("cam", "cams.cam_force_reversed", asked[2], sets=(*SIZES, given)),
        )
    )
    assert (whole - less, less - other) == pytest.approx((-200, -200))
    weightless = wrong("cam", "cams.cam_weight_left_out", asked[2], sets=(*SIZES, given))[0]
    assert whole - weightless == pytest.approx(-0.4 * 9.81)
    assert useful < 0 > total


def test_friction_of_the_guide() -> None:
    friction = "cam_forces.W_friction J"
    assert right("cam-translating", friction)[0] > 0
    assert wrong("cam-translating", "cams.cam_friction_left_out", friction) == [0.0]


def test_a_cam_on_the_crank_turns_against_it() -> None:
    """Without `rotation` it turns with the crank: turned back its offset is on the other side."""
    asked = "cam_profile.x_c[phi=30 deg] mm", "cam_profile.y_c[phi=30 deg] mm"
    own = right("course-project", *asked)
    assert right("course-project", *asked, sets=('cam.rotation="counter-clockwise"',)) == own
    turned = right("course-project", *asked, sets=('cam.rotation="clockwise"',))
    assert wrong("course-project", "cams.cam_turned_back", *asked) == pytest.approx(turned)
    assert turned != pytest.approx(own)
