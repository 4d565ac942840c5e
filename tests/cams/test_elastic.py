"""The elastic follower: closed forms of the residual vibration, an integrator, the machine's varying speed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sparing import sparing

import tmmcalc
from cams.optimum_scene import roller_task
from tmmcalc.cams.elastic import ElasticResult, solve_elastic
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.catalogue import LAWS
from tmmcalc.cams.program import Phase, Program
from tmmcalc.cams.response import residual, steady
from tmmcalc.cams.speed import Speed, constant_speed
from tmmcalc.cams.task import Elastic, Spring
from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.errors import AccuracyError, SingularityError, UsageError
from tmmcalc.core.numerics.panels import panels

ROLLER = Follower("translating", 0.06)
RATIOS = np.array([0.05, 0.3, 0.77, 1.31, 2.25, 4.6, 11.9, 25.3])


def test_residual_of_the_sine_law() -> None:
    exact = np.abs(np.sin(np.pi * RATIOS) / (np.pi * RATIOS * (1 - RATIOS**2)))
    assert residual(LAWS["sine"], RATIOS) == pytest.approx(exact, rel=1e-11, abs=1e-15)


def test_residual_of_the_cosine_law() -> None:
    """s'' = pi^2/2 cos(pi k): amplitude |cos(pi r)|/|1 - 4 r^2|."""
    exact = np.abs(np.cos(np.pi * RATIOS) / (1 - 4 * RATIOS**2))
    assert residual(LAWS["cosine"], RATIOS) == pytest.approx(exact, rel=1e-11, abs=1e-14)


def test_residual_of_constant_acceleration() -> None:
    """Three steps of s'': 4 |1 - 2 e^(-ia/2) + e^(-ia)|/a^2 = 16 sin^2(a/4)/a^2, a = 2 pi r."""
    a = 2 * np.pi * RATIOS
    assert residual(LAWS["const"], RATIOS) == pytest.approx(16 * np.sin(a / 4) ** 2 / a**2, rel=1e-11, abs=1e-15)


def test_slow_and_stiff_limits() -> None:
    """Of a very soft spring the mass stays: the amplitude is the stroke; doubled damping cannot raise a residual."""
    for law in LAWS.values():
        assert residual(law, np.array([1e-4]))[0] == pytest.approx(1.0, rel=1e-6)
        assert residual(law, np.array([7.3]), 0.2)[0] < 0.2


def marched(program: Program, speed: Speed, w: float, zeta: float, first: list[float], ends: Any) -> list[Any]:
    """z, z' at the end of every piece by an integrator over phi."""
    found, state = [], first
    for number, (a, b) in enumerate(zip(program.edges, program.edges[1:], strict=False)):
        if a >= ends:
            break

        def slope(x: float, y: Any, number: int = number) -> Any:
            at = np.array([x])
            omega = float(speed.at(at)[0][0])
            pull = float(speed.acceleration(at, program.at(at, np.array([number])))[0])
            return [y[1] / omega, (-2 * zeta * w * y[1] - w * w * y[0] - pull) / omega]

        done = solve_ivp(slope, (a, b), state, rtol=1e-12, atol=1e-15, method="DOP853", max_step=0.2)
        state = done.y[:, -1]
        found.append(state)
    return found


def varying(program: Program) -> Speed:
    on = panels(0.0, 2 * np.pi, program.edges.tolist())
    phi = on.x
    omega = 100 * (1 + 0.08 * np.cos(phi) + 0.03 * np.sin(2 * phi))
    return Speed(on, omega, omega * 100 * (-0.08 * np.sin(phi) + 0.06 * np.cos(2 * phi)))


@sparing("kind", ["constant", "varying"], every=2)
@sparing("zeta", [0.05, 0.4], every=2, first=1)
def test_steady_response_is_periodic_by_an_integrator(kind: str, zeta: float) -> None:
    task = roller_task()
    program = task.program
    speed = constant_speed(100.0) if kind == "constant" else varying(program)
    w = 1400.0
    course = steady(program, speed, w, zeta)
    q, free = course.edges, w * np.sqrt(1 - zeta**2)
    z, rate = q.imag / free, q.real - zeta * w * q.imag / free
    states = marched(program, speed, w, zeta, [float(z[0]), float(rate[0])], 7.0)
    assert states[-1] == pytest.approx([z[0], rate[0]], rel=1e-9, abs=1e-12)
    peak = float(np.max(np.abs(course.stretch)))
    for edge, state in zip(program.edges[1:], states, strict=True):
        at = int(np.argmin(np.abs(course.panels.edges - edge)))
        assert z[at] == pytest.approx(state[0], abs=1e-10 * peak)


def test_mass_follows_the_equation() -> None:
    """x'' is y'' + z'' with z'' the slope in time of the slope of z."""
    task = roller_task()
    course = steady(task.program, constant_speed(100.0), 1400.0, 0.05)
    on = course.panels
    curved = 100.0**2 * on.slope(on.slope(course.stretch))
    assert course.given + curved == pytest.approx(course.mass, abs=1e-6 * float(np.max(np.abs(course.mass))))


@pytest.mark.slow
def test_rigid_limit() -> None:
    """A very stiff, damped train carries the cam's own acceleration where nothing jumps."""
    program = Program(
        (Phase("rise", 2.0, 0.0, 0.01, LAWS["poly4567"]), Phase("return", 2 * np.pi - 2, 0.01, 0.0, LAWS["poly4567"]))
    )
    course = steady(program, constant_speed(10.0), 2e4, 0.3)
    assert course.mass == pytest.approx(course.given, abs=2e-3 * float(np.max(np.abs(course.given))))


def test_varying_speed_in_time() -> None:
    """Velocity and acceleration against differences in time."""
    program, step = roller_task().program, 1e-6
    speed = varying(program)
    phi = np.array([0.3, 0.9, 2.0, 2.4])
    around = [phi - step, phi, phi + step]
    time = [-step / speed.at(phi - step / 2)[0], 0.0, step / speed.at(phi + step / 2)[0]]
    velocity = [program.at(each)[1] * speed.at(each)[0] for each in around]
    rise = (velocity[2] - velocity[0]) / (time[2] - time[0])
    assert speed.acceleration(phi, program.at(phi)) == pytest.approx(rise, rel=1e-7)


def test_resonance_and_missing_data_are_refused() -> None:
    task = roller_task()
    with pytest.raises(SingularityError, match="resonance"):
        steady(task.program, constant_speed(100.0), 1400.0, 0.0)
    with pytest.raises(UsageError, match="elastic"):
        solve_elastic(task, ROLLER)
    with pytest.raises(AccuracyError, match="rigid"):
        solve_elastic(replace(task, elastic=Elastic(1e15, 0.1)), ROLLER)


@pytest.mark.slow
def test_result_round_trip_document_and_picture(tmp_path: Path) -> None:
    from drawing import draw_cam

    from tmmcalc.cams.facts.cam_elastic import document as elastic_document
    from tmmcalc.report.plaintext import lines

    task = replace(roller_task(), elastic=Elastic(4e6, 0.03))
    result = solve_elastic(task, ROLLER)
    back = from_record(ElasticResult, to_record(result))
    assert np.array_equal(back.load, result.load)
    assert back.phases == result.phases
    assert back.contact == result.contact
    rise = result.phases[0]
    assert rise.relative == pytest.approx(float(residual(LAWS["cosine"], np.array([rise.ratio]), 0.03)[0]), rel=1e-10)
    assert result.train == pytest.approx(result.mass * result.peak_response)
    assert "natural frequency" in "\n".join(lines(elastic_document(result, "cam")))
    draw_cam("cam_elastic", task, result, tmp_path / "a.png")
    assert (tmp_path / "a.png").stat().st_size > 20_000


def test_loss_of_contact_by_vibration() -> None:
    """The places where the load passes zero; a rigid train keeps the contact."""
    result = solve_elastic(replace(roller_task(), elastic=Elastic(4e6, 0.03)), ROLLER)
    assert result.contact.lost
    assert np.max(result.rigid) < 0 < result.contact.largest
    inside = np.zeros(len(result.phi), bool)
    for begin, end in result.contact.lost:
        inside |= (result.phi > begin) & (result.phi < end)
    assert np.all(result.load[inside] > -1e-9)
    assert np.all(result.load[~inside] < 1e-9)


@pytest.mark.slow
def test_a_groove_is_changed_from_wall_to_wall() -> None:
    """Two walls hold the roller: no contact is lost; where the load changes its sign the other wall presses."""
    from paper import written

    from tmmcalc.cams.facts.cam_elastic import document as elastic_document
    from tmmcalc.cams.pictures.cam_elastic import elastic_drawing
    from tmmcalc.report.plaintext import lines

    given = roller_task(spring=Spring("none"))
    task = replace(given, asked=replace(given.asked, closure="groove"), elastic=Elastic(2e6, 0.03))
    result = solve_elastic(task, ROLLER)
    change = np.flatnonzero(np.diff(np.sign(result.load)))
    scanned = [float(x) for k in change for x in (result.phi[k], result.phi[k + 1])]
    assert len(result.contact.reversals) == len(change) > 20
    for phi, low, high in zip(result.contact.reversals, scanned[::2], scanned[1::2], strict=True):
        assert low <= phi <= high
    assert result.contact.lost == ()
    said = "\n".join(lines(elastic_document(result, "cam")))
    assert "two walls hold the roller" in said
    assert "leaves the cam" not in said
    assert "lost" not in said
    (note,) = result.notes
    assert f"{len(change)} times a turn" in note
    heading = next(text for text in written(elastic_drawing(task, result)) if text.startswith("Elastic follower"))
    assert "the outer wall of the groove presses" in heading


def test_vibration_asks_for_no_loads() -> None:
    """Stiffness, mass and speed are enough; what presses on the cam is then not known, and not judged."""
    motion = """[cam]
follower = "translating"
stroke = "20 mm"
rise = "80 deg"
return_angle = "90 deg"
law = "cosine"
speed = "100 rad/s"
start_distance = "50 mm"
roller_radius = "8 mm"
"""
    elastic = '[cam.elastic]\nstiffness = "200 N/mm"\ndamping = 0.05\n'
    alone = tmmcalc.solve_cam_elastic(tmmcalc.parse_spec(f'{motion}{elastic}mass = "0.2 kg"\n'))
    loaded = tmmcalc.solve_cam_elastic(tmmcalc.parse_spec(f'{motion}{elastic}[cam.loads]\nmass = "0.2 kg"\n'))
    assert alone.phases == loaded.phases
    assert np.array_equal(alone.response, loaded.response)
    assert (alone.contact.judged, alone.contact.lost) == (False, ())
    assert loaded.contact.judged
    assert any("contact is not judged" in note for note in alone.notes)
    with pytest.raises(UsageError, match="is rigid"):
        tmmcalc.solve_cam_elastic(tmmcalc.parse_spec(motion))


@pytest.mark.parametrize("stiffness", [2e4, 2e5, 2e8])
def test_the_curves_reach_their_peaks_and_both_ends(stiffness: float) -> None:
    """Straight lines between the points that are shown miss a peak by little; jumps show both limits."""
    result = solve_elastic(replace(roller_task(), elastic=Elastic(stiffness, 0.05)), ROLLER)
    assert (result.phi[0], result.phi[-1]) == (0.0, pytest.approx(2 * np.pi, rel=1e-15))
    for curve, peak in ((result.response, result.peak_response), (result.given, result.peak_given)):
        assert np.max(np.abs(curve)) == pytest.approx(peak, rel=8e-3)
    period = 2 * np.pi / result.multiple
    assert np.max(np.diff(result.phi)) < period / 12
    end = result.phi == result.phi[np.argmin(np.abs(result.phi - np.pi / 3))]
    assert result.given[end].tolist() == pytest.approx([-1e4 * 0.02 * np.pi**2 / 2 / (np.pi / 3) ** 2, 0.0], rel=1e-9)
