"""The pressure angle against the geometry of the pitch curve, dense samples and the worked cases."""

import json
from dataclasses import replace
from math import degrees, pi, radians
from pathlib import Path

import numpy as np
import pytest
from sparing import sparing

from cams.turns import task_of, turn
from tmmcalc.cams.follower import Follower, contact_path
from tmmcalc.cams.laws.law import polynomial
from tmmcalc.cams.pressure.angle import pressure_angle
from tmmcalc.cams.pressure.solve import Pressure, pressure_columns, solve_pressure
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.task import AngleLimits
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import SingularityError

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases" / "cams.json").read_text())}
FOLLOWERS = [
    Follower("translating", 0.03, 0.006),
    Follower("translating", 0.05, -0.011),
    Follower("oscillating", 0.5, centres=0.09, rocker=0.07, assembly=1),
    Follower("oscillating", 0.8, centres=0.08, rocker=0.07, assembly=-1),
]


def program_of(follower, law="sine", back="shun"):
    stroke = 0.35 if follower.kind == "oscillating" else 0.02
    return turn(law, back, rise=80, high=30, back=100, stroke=stroke)


@pytest.mark.parametrize(("cam", "sign"), [("cw,right", 1), ("cw,left", -1), ("ccw,right", -1), ("ccw,left", 1)])
def test_worked_case_of_all_senses(cam, sign):
    case = CASES["cams-s10"]
    follower = Follower("translating", 0.055, sign * 0.008, sense=1 if cam.startswith("cw") else -1)
    phi = np.radians(case["inputs"]["phi_deg"])
    theta = pressure_angle(follower, phi, program_of(follower).at(phi))
    assert np.degrees(theta) == pytest.approx(case["expected"][cam]["theta_deg"], rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("follower", FOLLOWERS)
def test_it_is_the_angle_between_normal_and_velocity(follower):
    program = program_of(follower)
    phi = np.linspace(0.01, 2 * pi - 0.01, 777)
    motion = program.at(phi)
    path = contact_path(follower, phi, motion)
    normal = -1j * path[1] / np.abs(path[1])  # outwards
    if follower.kind == "translating":
        lift = 1j * np.exp(1j * phi)
    else:
        to_roller = path[0] - follower.centres * np.exp(1j * phi)
        lift = -1j * follower.assembly * to_roller / np.abs(to_roller)
    turned = -np.angle(normal / lift)  # positive as the cam turns: clockwise
    theta = pressure_angle(follower, phi, motion)
    expected = turned if follower.kind == "translating" else -follower.assembly * turned
    assert theta == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("follower", FOLLOWERS)
@sparing("law", ["const", "sine", "modified_trapezoid"], every=3, first=1)
def test_extremes_are_those_of_a_dense_sample(follower, law):
    program = program_of(follower, law, "cosine")
    found = solve_pressure(task_of(program, follower.kind), follower)
    for k, on in ((0, found.rise), (2, found.back)):
        phi = np.linspace(program.starts[k], program.starts[k + 1], 200001)
        theta = pressure_angle(follower, phi, program.at(phi))
        for extreme, value in ((on.least, theta.min()), (on.largest, theta.max())):
            assert extreme.value == pytest.approx(value, abs=1e-9)
            there = np.array([extreme.phi])
            assert pressure_angle(follower, there, program.at(there))[0] == pytest.approx(extreme.value, abs=1e-13)
        assert on.largest.value >= theta.max() - 1e-15
        assert on.least.value <= theta.min() + 1e-15


def test_where_the_limit_is_exceeded():
    follower = FOLLOWERS[0]
    program = program_of(follower)
    limits = AngleLimits(radians(25), radians(12))
    found = solve_pressure(task_of(program, limits=limits), follower)
    assert found.verdict == "pressure_angle_exceeded"
    assert len(found.notes) == 2
    phi = np.linspace(0, program.starts[-1], 100001)
    theta = np.abs(pressure_angle(follower, phi, program.at(phi)))
    for k, on in ((0, found.rise), (2, found.back)):
        moving = (phi > program.starts[k]) & (phi < program.starts[k + 1])
        inside = np.zeros(len(phi), bool)
        for low, high in on.exceeded:
            inside |= (phi > low) & (phi < high)
            for end in (low, high):
                value = abs(pressure_angle(follower, np.array([end]), program.at(np.array([end])))[0])
                at_end_of_phase = min(abs(end - program.starts)) < 1e-12
                assert value == pytest.approx(on.limit, abs=1e-13) or (at_end_of_phase and value > on.limit)
        assert np.array_equal(inside[moving], (theta > on.limit)[moving])


def test_a_limit_that_is_just_reached_is_kept():
    follower = FOLLOWERS[0]
    task = task_of(program_of(follower))
    top = solve_pressure(task, follower).rise.largest.value
    for limit, verdict in ((top, "ok"), (top + 1e-12, "ok"), (top - 1e-6, "pressure_angle_exceeded")):
        assert solve_pressure(replace(task, limits=AngleLimits(limit, None)), follower).verdict == verdict


def test_a_jump_of_velocity_has_two_limits():
    straight = polynomial("straight", (0.0, [0, 1]))
    phases = (
        Phase("rise", 1.0, 0.0, 0.01, straight),
        Phase("high dwell", 1.0, 0.01, 0.01),
        Phase("return", 1.0, 0.01, 0.0, straight),
        Phase("low dwell", 2 * pi - 3, 0.0, 0.0),
    )
    found = solve_pressure(task_of(Program(phases)), Follower("translating", 0.02))
    assert found.rise.largest.value == pytest.approx(np.arctan(0.01 / 0.02), rel=1e-14)
    assert found.rise.least.value == pytest.approx(np.arctan(0.01 / 0.03), rel=1e-14)
    assert found.labels[:1] == ("0",)


def test_a_flat_face_has_none():
    found = solve_pressure(task_of(turn(), "flat"), Follower("flat", 0.04))
    assert not found.theta.any()
    assert found.verdict == "ok"


def test_arrays_of_sizes_are_broadcast():
    program, follower = turn(), FOLLOWERS[0]
    phi = np.linspace(0.1, 1.0, 5)
    starts, offsets = np.array([0.02, 0.03, 0.04])[:, None], np.array([0.0, 0.006, -0.01])[:, None]
    every = pressure_angle(follower, phi, program.at(phi), start=starts, offset=offsets)
    assert every.shape == (3, 5)
    for row, start, e in zip(every, starts[:, 0], offsets[:, 0], strict=True):
        alone = pressure_angle(Follower("translating", start, e), phi, program.at(phi))
        assert np.array_equal(row, alone)


@pytest.mark.parametrize(
    "follower",
    [Follower("translating", 0.0), Follower("flat", -0.01), Follower("oscillating", 3.0, centres=1, rocker=1)],
)
def test_a_follower_on_the_axis_is_refused(follower):
    with pytest.raises(SingularityError):
        solve_pressure(task_of(program_of(follower), follower.kind), follower)


def test_columns_and_record():
    task = task_of(program_of(FOLLOWERS[2]), "oscillating", steps=8)
    found = solve_pressure(task, FOLLOWERS[2])
    columns = pressure_columns(found)
    assert set(columns) == {"i", "phi[deg]", "theta[deg]", "gamma[deg]"}
    assert columns["gamma[deg]"] == pytest.approx(90 - np.abs(columns["theta[deg]"]))
    again = from_record(Pressure, to_record(found))
    assert again.rise == found.rise
    assert again.back == found.back
    assert again.follower == found.follower
    assert again.labels == found.labels
    assert np.array_equal(again.theta, found.theta)
    assert degrees(abs(found.rise.worst.value)) == pytest.approx(np.degrees(np.abs(found.theta[:9]).max()), abs=1.0)
