"""The note on vibration: every device and rotor that a spec allows, its equations put together and solved by others."""

from __future__ import annotations

import math
import re
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

from note.naming import unnamed
from note.scenes import told
from note.test_lines import mutants, wrong
from tmmcalc.note.assembled import Assembler, Checked
from tmmcalc.note.conclusions import conclusions
from tmmcalc.note.plaintext import text
from tmmcalc.note.tree import Written
from tmmcalc.pipeline.chapters import chapters_of, stages_of, warnings_of
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.picturing import NONE
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.formula.tree import Name
from tmmcalc.report.language import speaking
from tmmcalc.report.manuscript import Block, Chapter, Line, Table

ONLY = ("vibration",)
HEAD = '[project]\ntitle = "t"\n\n'
RING = "[vibrator.ring]\nmass = 1.3\ninertia = 2.1e-3\n"
GRIPPER = "[vibrator.gripper]\nmass = 0.9\ndrop = 0.04\ninertia_x = 8e-4\ninertia_y = 7e-4\ninertia_z = 4e-4\n"
EXCITER = (
    "[vibrator.exciter]\nmass = 0.5\nradius = 0.06\narm = 0.05\narm_angle = 0.5\ninertia_hinge = 2.5e-4\n"
    "inertia_vertical = 3e-4\nstiffness = 60\n"
)
RODS = "[vibrator.rods]\nradius = 0.07\ndiameter = 0.003\nlength = 0.08\n"
FLATS = "[vibrator.flats]\nwidth = 0.012\nthickness = 8e-4\nlength = 0.03\noffset = 0.02\n"
UNBALANCE = (
    "[vibrator.unbalance]\nmoment = 2e-4\nrotor_inertia = 2e-4\ndistance = 0.055\narm = 0.045\narm_angle = 0.3\n"
)
BODIES = RING + GRIPPER + EXCITER
STIFF = "[vibrator.rods]\nradius = 0.07\nstiffness = 19000\n[vibrator.flats]\nvertical = 45000\ntilt = 130\n"
DAMPERS = "[vibrator.damping]\nx = 10\ny = 12\nphi = 0.02\ntilt_x = 0.01\ntilt_y = 0.02\nz = 5\ngamma = 0.004\n"
START = '[vibrator.start]\nacceleration = "300 rad/s^2"\nduration = "1.5 s"\nrows = 200\n'
DRIVE = "[vibrator.drive]\nduration = 0.5\nrows = 200\ndrag = 1e-5\n"
MOTOR = '[motor]\nkind = "shunt"\npower = "5 W"\nspeed = "1500 rpm"\nno_load_speed = "1800 rpm"\n'
DEVICE = "[vibrator]\n"
SPEED = '[vibrator]\nspeed = "1452 rpm"\n'
KINDS = {
    "free": DEVICE + BODIES + RODS + FLATS,
    "stiffnesses": SPEED + BODIES + STIFF + UNBALANCE + DAMPERS,
    "no damping": SPEED + BODIES + STIFF + UNBALANCE,
    "started": SPEED + BODIES + RODS + FLATS + UNBALANCE + DAMPERS + START + "tangential = false\n",
    "driven": DEVICE + BODIES + RODS + FLATS + UNBALANCE + "[vibrator.damping]\nratio = 0.02\n" + DRIVE + MOTOR,
    "clamped": '[pendulum]\nstiffness = "clamped"\nspin = "900 rpm"\n'
    + "[pendulum.rod]\nlength = 0.6\ndiameter = 0.01\nbore = 0.004\n"
    + "[pendulum.disc]\nmass = 2\ndiametral_inertia = 0.004\n[pendulum.speeds]\nto = 300\n",
    "at rest": "[pendulum]\n[pendulum.rod]\nlength = 0.9\nmass = 0.8\nbending_stiffness = 90\ntorsion_stiffness = 70\n"
    "section_radius = 0.003\n[pendulum.swing]\nduration = 2\ndeflection = 0.01\npush = 0.1\nrows = 50\n",
    "flat rod": "[pendulum]\nstiffness = 9\n[pendulum.rod]\nlength = 0.7\nwidth = 0.012\nthickness = 0.006\n"
    "[pendulum.disc]\nmass = 1.5\ngyration = [0.04, 0.06]\n",
    "square rod": "[pendulum]\nstiffness = 9\nspin = -40\n[pendulum.rod]\nlength = 0.7\n"
    "width = 0.008\nthickness = 0.008\n"
    "[pendulum.disc]\nmass = 1.5\ndiametral_inertia = 0.003\npolar_inertia = 0.005\neccentricity = 0.0003\n",
    "rod without inertia": "[pendulum]\nspin = 30\n[pendulum.rod]\nlength = 0.7\nmass = 0.3\nbending_stiffness = 12\n"
    "torsion_stiffness = 8\n[pendulum.disc]\nmass = 1.5\ngyration = 0.05\n"
    '[pendulum.swing]\nduration = 2\nrows = 50\ncarrier = { time = ["0 s", "1 s"], x = [0, "0.2 m/s"] }\n',
    "weak motor": DEVICE
    + BODIES
    + RODS
    + FLATS
    + UNBALANCE.replace("2e-4\nrotor", "8e-4\nrotor")
    + "[vibrator.damping]\nratio = 0.02\n"
    + DRIVE.replace("0.5", "3")
    + MOTOR.replace("5 W", "2 W"),
}


@cache
def solved(kind: str) -> RunResult:
    """What is found of a spec."""
    with TemporaryDirectory() as folder:
        spec = Path(folder) / "spec.toml"
        spec.write_text(HEAD + KINDS[kind], encoding="utf-8")
        return run(load_spec(spec), target=stages_of(ONLY))


def of_kind(kind: str) -> tuple[list[Block], list[Checked], list[Written]]:
    """The blocks of a spec, its lines, and what is written."""
    done = solved(kind)
    chapters = chapters_of({"vibration": "Vibration"}, done.spec, done.results, NONE)
    found = Assembler()
    note = found.written(chapters)
    return [block for chapter in chapters for block in chapter.blocks], found.lines, note


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_exact_and_works_out_as_printed(kind: str) -> None:
    blocks, found, note = of_kind(kind)
    assert not [*unnamed(blocks)]
    assert len(found) > 8
    for line in found:
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)
    assert not re.search(r"\bnan\b", text(note))


def rows(blocks: list[Block], caption: str) -> list[list[float]]:
    """The numbers of a table, without its first column."""
    table = next(block for block in blocks if isinstance(block, Table) and block.caption == caption)
    return [[float(cell.strip("$").replace("−", "-")) for cell in row[1:]] for row in table.rows]


def test_frequencies_of_the_device_by_another_way() -> None:
    """M and C of paper 15, written out, as a problem of eigenvalues without symmetry."""
    root = math.sqrt(0.5)
    mass = np.diag(
        [2.7, 2.7, 2.1e-3 + 4e-4 + 3e-4 + 0.5 * 0.06**2, 8e-4 + 0.9 * 0.04**2, 7e-4 + 0.9 * 0.04**2, 0.9, 0.0015]
    )
    for (k, j), value in {
        (0, 2): -0.5 * 0.06 * root,
        (1, 2): 0.5 * 0.06 * root,
        (0, 4): -0.9 * 0.04,
        (1, 3): 0.9 * 0.04,
        (0, 6): -0.5 * 0.05 * math.sin(0.5) * root,
        (1, 6): -0.5 * 0.05 * math.sin(0.5) * root,
    }.items():
        mass[k, j] = mass[j, k] = value
    stiffness = np.diag([4 * 19000, 4 * 19000, 4 * 19000 * 0.07**2, 130, 130, 4 * 45000, 60.0])
    expected = np.sort(np.sqrt(np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real))
    found = [row[0] for row in rows(of_kind("stiffnesses")[0], "Natural frequencies")]
    assert found == pytest.approx(expected.tolist(), rel=1e-4)


def test_the_rotor_by_another_way() -> None:
    """The rigid rotor by its quadratic equation, the first root of torsion by its frequency equation."""
    own = {
        line.formula.sides[0].key: float(line.found.result)
        for line in lines_of(told("pendulum-rotor", only=ONLY))
        if isinstance(line.formula.sides[0], Name)
    }
    spin = 50 * math.pi
    for omega in (own["omega_f"], -own["omega_b"]):
        terms = own["I_t"] * omega**2, own["I_p"] * spin * omega, own["K_t"]
        assert terms[0] - terms[1] - terms[2] == pytest.approx(0.0, abs=2e-4 * max(map(abs, terms)))
    root = own["omega_i"] * 0.8 * math.sqrt(own["j"] / own["C_p"])  # the last root, near 3 pi
    assert root * math.tan(root) == pytest.approx(own["j"] * 0.8 / own["J_p"], abs=2e-3)
    assert root == pytest.approx(3 * math.pi, rel=1e-4)


def lines_of(chapters: list[Chapter]) -> list[Checked]:
    assembler = Assembler()
    assembler.written(chapters)
    return assembler.lines


def test_a_rotor_that_is_stuck_is_told() -> None:
    said = text(of_kind("weak motor")[2])
    assert "The rotor is stuck at the resonance of mode" in said
    assert "is stuck" not in text(of_kind("driven")[2])


def test_what_a_device_lacks_leaves_no_trace() -> None:
    said = text(of_kind("free")[2])
    assert "Steady vibration" not in said
    assert "Static moment" not in said
    assert "The device has no damping." in said
    assert "Omega" not in text(of_kind("at rest")[2])
    assert "Critical speeds" not in text(of_kind("flat rod")[2])


def test_warnings_are_in_ukrainian() -> None:
    warnings = warnings_of(solved("weak motor"), stages_of(ONLY))
    assert warnings
    with speaking("uk"):
        said = text(Assembler().written([conclusions([], warnings, ())]))
    assert not re.search(r"[A-Za-z]{3,}", said)


@pytest.mark.slow
def test_mutants_of_all_kinds_are_caught() -> None:
    caught, missed = 0, []
    for kind in KINDS:
        for block in of_kind(kind)[0]:
            if isinstance(block, Line):
                for mutant in mutants(block.formula):
                    if any(wrong(mutant, place.lexicon) for place in block.places):
                        caught += 1
                    else:
                        missed.append((kind, mutant))
    assert len(missed) <= 0.01 * (caught + len(missed)), (caught, missed)
