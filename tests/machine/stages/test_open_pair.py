"""An open pair between the reducer and the crank: ratio, losses, inertia, load of its teeth, force in the bearing."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from faults import faults_of
from project.scenes import CONFIGS

import tmmcalc
from tmmcalc.core.plan import plan
from tmmcalc.gears.facts.open_pair import document
from tmmcalc.machine.facts.power import summary
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.runner import run
from tmmcalc.project import Spec

TEXT = (CONFIGS / "geared-press.toml").read_text(encoding="utf-8")
U = 60 / 18
PAIR = "[open_pair]                             # on the crankshaft\nteeth = [18, 60]\n"
TRAIN = TEXT[TEXT.index("[train]") : TEXT.index("[open_pair]")]
OPEN = TEXT[TEXT.index("[open_pair]") : TEXT.index("[strength]")]
STRENGTH = TEXT[TEXT.index("[strength]") : TEXT.index("[flywheel]")]
RPM = math.pi / 30


def spec(*overrides: str, text: str = TEXT) -> Spec:
    return tmmcalc.parse_spec(text, overrides=overrides)


@cache
def done(target: str, *overrides: str, text: str = TEXT) -> RunResult:
    return run(spec(*overrides, text=text), target=target)


def test_the_train_has_what_the_pair_leaves() -> None:
    results = done("power").results
    request, winner = results["train"].variants[0].request, results["criteria"].winner
    assert float(request.nominal) == pytest.approx(1395 / 60 / U, abs=1e-6)
    assert request.origin == "1395 rpm of motor AIR90L4 over 60 rpm of the crank, over 3.33333 of the open pair 18/60"
    assert results["power"].duty.ratio == pytest.approx(float(winner.ratio) * U, rel=1e-15)


def test_inertia_by_hand() -> None:
    """Solid pinion, webbed wheel (4.43, 4.44): steel of 7820 kg/m^3, alpha1 = 0.434, alpha2 = 1.21; b = 70 mm."""
    results = done("power").results
    r_a, r_b = 0.007 * 18 / 2, 0.007 * 60 / 2
    disc = math.pi * 7820 * 0.07 / 2
    pinion, gear = disc * r_a**4, 0.434 * 1.21 * disc * r_b**4
    line, winner = results["power"].line, results["criteria"].winner
    assert line.parts[1].inertia == pytest.approx(pinion * U**2 + gear, rel=1e-14)
    assert line.inertia == pytest.approx(winner.inertia * U**2 + pinion * U**2 + gear, rel=1e-14)


def test_a_ring_on_the_crank() -> None:
    """A cylinder of 3.75 modules outward from its reference circle, drawn to the pinion by the radial force."""
    text = TEXT.replace("x1 = 0.3 ", "").replace('strategy = "equal_shift"', 'kind = "internal"')
    found, r = done("open_pair", text=text).results["open_pair"], 0.21
    outer = r + 3.75 * 0.007
    assert found.gear_inertia == pytest.approx(math.pi * 7820 * 0.07 * (outer**4 - r**4) / 2, rel=1e-14)
    ring = spec(text=text).drive
    assert ring is not None
    assert (ring.internal, ring.radius) == (True, pytest.approx(r, rel=1e-12))


def test_energy_over_the_cycle() -> None:
    """Work of the motor on its own shaft, by Kloss's formula, less what both gears lose is the work of the loads."""
    results = done("motion", "mechanism.grid.positions=720").results
    power, motion = results["power"], results["motion"]
    motor, u = power.duty.motor, power.duty.ratio
    slip = (motor.synchronous - u * motion.omega) / motor.synchronous
    nominal = (motor.synchronous - motor.speed) / motor.synchronous
    k = motor.overload
    critical = nominal * (k + math.sqrt(k**2 - 1))
    moment = 2 * k * motor.power / motor.speed / (slip / critical + critical / slip)
    theta = np.linspace(0, 2 * math.pi, 721)
    rows = slice(None) if len(moment) == 721 else np.unique(np.round(motion.theta, 9), return_index=True)[1]
    work = np.trapezoid(u * moment[rows], theta)  # of the motor
    train = results["criteria"].winner.values["efficiency"]
    assert power.line.efficiency == pytest.approx(train * 0.96, rel=1e-15)
    assert work * train * 0.96 == pytest.approx(-sum(part.work for part in power.parts), rel=1e-6)


def test_torques_of_the_teeth() -> None:
    """The largest reduced moment loads the gear, that over the ratios pinion and wheel 1; losses do not enter."""
    results = done("open_pair").results
    found, reduction = results["open_pair"], results["reduction"]
    largest = np.abs(reduction.parts.sum(axis=0)).max()
    assert found.torque == pytest.approx(largest, rel=1e-3)  # between the points of the panels
    assert found.pinion_torque == found.torque / U
    wheel = done("power").results["strength"].variants[0].torque
    assert wheel.value == pytest.approx(found.torque / U / (1395 / 60 / U), rel=1e-12)
    given = done("open_pair", 'strength.moment="2 kN*m"').results["open_pair"]
    assert given.torque == 2000


def test_stresses_by_hand() -> None:
    """(4.38) sigma_H^2 = K_d^3 T K_H (u + 1)/u / (b d^2), (4.41) sigma_F = K_m^3 T K_F Y_F / (b d m); N*m, mm, MPa."""
    found = done("open_pair").results["open_pair"]
    psi, d, b, T = 70 / 126, 126, 70, found.pinion_torque
    contact = math.sqrt(770**3 * T * (1 + 0.5 * psi) * (U + 1) / U / (b * d**2))
    bending = 14**3 * T * (1 + 1.08 * psi) * (3.568 + 201.95 / 18**2) / (b * d * 7)
    assert found.strength.contact_stress[0, 0] == pytest.approx(contact * 1e6, rel=1e-12)
    assert found.strength.bending_stress[0, 0] == pytest.approx(bending * 1e6, rel=1e-12)
    assert found.strength.accepted[0]


def test_force_in_the_mesh_and_in_the_bearing() -> None:
    """Reactions are those with pitch radius and pressure angle typed; the mesh force is M/(r_w cos alpha_w)."""
    typed = TEXT.replace(OPEN, "").replace('kind = "gear"', 'kind = "gear"\nradius = "210 mm"\nmesh_angle = "20 deg"')
    found, by_hand = done("forces").results["forces"], done("forces", text=typed).results["forces"]
    assert found.gear.open == "open pair 18/60"
    assert by_hand.gear.open == ""
    assert np.abs(found.reaction - by_hand.reaction).max() < 1e-9 * np.abs(found.reaction).max()
    force = np.abs(found.drive) / (0.21 * math.cos(math.radians(20)))
    assert np.abs(found.mesh) == pytest.approx(force, rel=1e-12)
    load = done("open_pair").results["open_pair"]
    assert load.across == pytest.approx(load.torque / (0.21 * math.cos(math.radians(20))), rel=1e-12)
    coupled = done("forces", text=TEXT.replace('kind = "gear"', "").replace('pinion = "180 deg"', ""))
    assert np.abs(found.reaction - coupled.results["forces"].reaction).max() > 1e3


def test_shifted_and_helical_pairs() -> None:
    """r_w = a_w z_b/(z_a + z_b); the axial force is that of the helix on the operating circle."""
    overrides = ("open_pair.x1=0.5", "open_pair.x2=0.4", 'open_pair.strategy="given"', 'open_pair.helix_angle="12 deg"')
    results = done("open_pair", *overrides).results
    found, pair = results["open_pair"], results["pair"].pairs[-1]
    assert found.radius == pytest.approx(pair.distance * 60 / 78, rel=1e-12)
    assert found.radius > 0.211
    gear = spec(*overrides).drive
    assert gear is not None
    assert (gear.radius, gear.mesh_angle) == (found.radius, found.angle)
    tangent = math.tan(math.radians(12)) * found.radius / (0.007 * 60 / 2 / math.cos(math.radians(12)))
    assert found.axial == pytest.approx(found.torque / found.radius * tangent, rel=1e-12)


def test_pairs_of_the_train_and_the_open_pair() -> None:
    results = done("profile").results
    assert [found.task.name for found in results["pair"].pairs] == ["1-2", "2-3", "open pair"]
    assert [wheel.wheel for wheel in results["profile"].wheels] == ["1", "2", "3", "a", "b"]
    assert [area.name for area in done("blocking").results["blocking"].pairs] == ["1-2", "open pair"]
    alone = done("profile", text=TEXT.replace(TEXT[TEXT.index("[pair]") : TEXT.index("[flywheel]")], ""))
    assert [found.task.name for found in alone.results["pair"].pairs] == ["open pair"]


def test_the_choice_of_the_train_is_its_own() -> None:
    """The same train is chosen for its own ratio under the torque that gets to it."""
    winner, torque = done("power").results["criteria"].winner, done("power").results["strength"].variants[0].torque
    alone = TRAIN + f'input_speed = "1395 rpm"\noutput_speed = "{60 * U!r} rpm"\n'
    alone += STRENGTH.replace("[strength.material]", f'torque = "{torque.value!r} N*m"\n[strength.material]')
    same = done("criteria", text=alone[: alone.index("[pair]")]).results["criteria"].winner
    assert (same.teeth, same.modules, same.widths, same.inertia) == (
        winner.teeth,
        winner.modules,
        winner.widths,
        winner.inertia,
    )


def test_a_given_reducer_ends_at_the_pinion() -> None:
    """[transmission] is the reducer alone, and shafts go on to the crank."""
    text = TEXT.replace(TRAIN, '[transmission]\nratio = 7\nefficiency = 0.95\ninertia = "0.02 kg*m^2"\n')
    text = text.replace(STRENGTH, "")
    line = done("power", text=text).results["power"].line
    assert line.ratio == pytest.approx(7 * U, rel=1e-15)
    assert line.efficiency == pytest.approx(0.95 * 0.96, rel=1e-15)
    assert line.inertia == pytest.approx(0.02 * U**2 + line.parts[1].inertia, rel=1e-15)
    assert [part.ratio for part in line.parts] == [pytest.approx(7), U]
    shafts = f'{text}\n[[shafts]]\nratio = 7\ninertia = 0.01\nstiffness = "5 kN*m/rad"\n[[shafts]]\nratio = {U!r}\n'
    assert done("power", text=shafts).results["power"].line.ratio == pytest.approx(7 * U, rel=1e-15)
    (fault,) = faults_of(shafts.replace(f"ratio = {U!r}", "ratio = 2"))
    assert fault.path == "transmission.ratio"
    assert "over 3.33333 of [open_pair], which is 4.2" in fault.message


@pytest.mark.slow
def test_a_motor_that_is_chosen_settles_with_both() -> None:
    results = done("power", 'motor.name="choose"', 'motor.synchronous_speed="1500 rpm"', text=without_rotor()).results
    power, winner = results["power"], results["criteria"].winner
    assert power.duty.rounds[-1].ratio == pytest.approx(power.duty.motor.speed / (60 * RPM))
    assert power.duty.rounds[-1].efficiency == pytest.approx(winner.values["efficiency"] * 0.96, rel=1e-2)
    assert power.duty.ratio == pytest.approx(float(winner.ratio) * U, rel=1e-15)


def without_rotor() -> str:
    return TEXT.replace("inertia = 0.0056                        # kg*m^2, of the rotor: the catalogue has none\n", "")


@pytest.mark.slow
def test_the_speed_by_the_motor_has_both_ratios() -> None:
    text = TEXT.replace('speed = "60 rpm"  ', 'speed = "by the motor"').replace("[train]", '[train]\nratio = "6.96"', 1)
    speed = spec(text=text).linkage.input.speed
    assert speed == pytest.approx(done("motion").results["motion"].regime.mean, rel=2e-3)


def test_what_is_told() -> None:
    told = "\n".join(fact.text for fact in summary(done("power").results["power"], "").facts)
    assert "reducer: u = 6.96, of gear train AIbar 25/62/149; efficiency 0.9660682, of gear train AIbar" in told
    assert "open pair 18/60: u = 3.333333, of its teeth; efficiency 0.96, as given" in told
    assert "together: u = 23.2, efficiency 0.9274255, inertia at the crank 1.309734 kg*m^2" in told
    assert "of gear train AIbar 25/62/149 and the open pair 18/60" in told
    usual = done("open_pair", text=TEXT.replace("efficiency = 0.96 ", "")).results["open_pair"]
    facts = {fact.label: fact.text for fact in document(usual, "").facts}
    assert facts["efficiency of the pair"] == "0.975, the general value of a mesh"
    rubbing = done("open_pair", "open_pair.friction=0.1", text=TEXT.replace("efficiency = 0.96 ", "")).results
    assert rubbing["open_pair"].efficiency == pytest.approx(1 - 0.23 * (1 / 18 + 1 / 60), rel=1e-14)
    coupled = TEXT.replace('kind = "gear"', "").replace('pinion = "180 deg"', "")
    assert (
        "reactions of the crank are those of a coupling"
        in document(done("open_pair", text=coupled).results["open_pair"], "").notes[-1]
    )
    weak = document(done("open_pair", 'open_pair.face_width="30 mm"').results["open_pair"], "")
    assert weak.notes[0].startswith("warning: the open pair: strength")


def test_pairs_that_are_written_out_say_that_they_are_no_part() -> None:
    text = TEXT.replace(OPEN, "").replace('kind = "gear"', "").replace('pinion = "180 deg"', "")
    text = text.replace("[pair]", '[pair]\nteeth = [17, 51]\nmodule = "6 mm"\n')
    assert "[open_pair]" in done("pair", text=text).results["pair"].remarks[0]
    assert plan(spec(text=text)).step("open_pair").reason == "no [open_pair]: no gear on the crank"


FAULTS = [
    ((), 'kind = "gear"\nradius = "200 mm"', "drive.radius", "'200 mm' is not that of the open pair 18/60"),
    ((), 'kind = "gear"\nmesh_angle = "21 deg"', "drive.mesh_angle", 'which has mesh_angle = "20 deg"'),
    ((), 'kind = "gear"\ninternal = true', "drive.internal", "which has internal = false"),
    (('open_pair.kind="rack"',), "", "open_pair.kind", "the gear on the crank turns"),
    (("open_pair.friction=0.1",), "", "open_pair.friction", "friction together with efficiency"),
    (("strength.moment_ratio=20",), "", "strength.moment_ratio", "moment_ratio beside [open_pair]"),
    (
        ('open_pair.gear={ steel = "40Kh", treatment = "improved", hardness = "300 HB" }',),
        "",
        "open_pair.gear",
        "gear without pinion",
    ),
]


@pytest.mark.parametrize(("overrides", "drive", "path", "message"), FAULTS)
def test_faults(overrides: tuple[str, ...], drive: str, path: str, message: str) -> None:
    text = TEXT.replace('kind = "gear"', drive or 'kind = "gear"')
    with pytest.raises(tmmcalc.SpecError) as caught:
        spec(*overrides, text=text)
    found = {fault.path: fault.message for fault in caught.value.faults}
    assert message in found[path]
    assert caught.value.exit_code == 2


def test_needed_keys() -> None:
    (fault,) = faults_of(TEXT.replace('face_width = "70 mm"\n', ""))
    assert (fault.path, fault.remedy) == ("open_pair", 'add face_width = "60 mm"')
    (fault,) = faults_of(TEXT.replace("teeth = [18, 60]\n", ""))
    assert fault.message == "missing key: a pair of gears has its numbers of teeth"
    (fault,) = faults_of(f"{TRAIN}ratio = 7\n{OPEN}")
    assert fault.message.startswith("[open_pair] without [mechanism] or [torque]")


def test_one_fault_for_a_typed_ratio_of_the_moment() -> None:
    (fault,) = faults_of(TEXT.replace("[strength.material]", "moment_ratio = 20\n[strength.material]"))
    assert (fault.path, fault.remedy) == ("strength.moment_ratio", "remove it")


def test_a_torque_diagram() -> None:
    """The gear bears the largest moment of the diagram, there is no bearing whose reaction is asked for."""
    diagram = '[torque]\nformula = "-800 - 600*sin(theta)"\nspeed = "60 rpm"\ninertia = 3\n'
    found = done("open_pair", text=diagram + TEXT[TEXT.index("[motor]") : TEXT.index("[[transients]]")]).results
    assert found["open_pair"].torque == pytest.approx(1400, rel=1e-12)
    assert found["open_pair"].task.in_bearing is None
    assert not document(found["open_pair"], "").notes


def test_a_variant_without_such_a_pair_says_why() -> None:
    with pytest.raises(tmmcalc.NoSolutionError, match="pair open pair: z = 18/60"):
        spec("open_pair.x1=-1")


def test_a_rounded_radius_is_taken() -> None:
    drive = spec("drive.radius='210.05 mm'").drive
    assert drive is not None
    assert drive.radius == pytest.approx(0.21005)
