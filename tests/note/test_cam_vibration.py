"""The note on what laws leave of vibration, in closed form over every law and follower; mean efficiencies; mutants."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from pathlib import Path

import numpy as np
import pytest

from note.scenes import told, written
from note.test_cam_loads import GUIDE, NEEDS, loads, of_text, rocker, stem, values
from note.test_lines import mutants, wrong
from tmmcalc.cams.laws.catalogue import LAWS, NAMES
from tmmcalc.cams.laws.law import Law
from tmmcalc.cams.response import residual, shares
from tmmcalc.note.assembled import Assembler
from tmmcalc.note.plaintext import text
from tmmcalc.report.formula.digits import EXACT
from tmmcalc.report.manuscript import Block, Figure, Line, Paragraph

DAMPED = '[cam.elastic]\nstiffness = "400 N/mm"\ndamping = 0.05\n'
FREE = '[cam.elastic]\nstiffness = "733 N/mm"\n'
OWN = "law = { acceleration = [[0, 0], [0.2, 1], [0.5, 1], [0.5, -1], [0.8, -1], [1, 0]] }\n"
QUICK = ("sine", "const", "modified_trapezoid")


def pair(name: str) -> str:
    """A stem that rises by a law and returns by the one after it."""
    others = dict(zip(NAMES, (*NAMES[1:], NAMES[0]), strict=True))
    return stem().replace('law = "cosine"', f'rise_law = "{name}"\nreturn_law = "{others[name]}"') + loads()


def blocks(said: str, folder: Path) -> Iterator[Block]:
    for chapter in of_text(said, folder):
        yield from chapter.blocks


@pytest.mark.parametrize("train", [DAMPED, FREE], ids=["damped", "free"])
@pytest.mark.parametrize("law", [pytest.param(n, marks=() if n in QUICK else pytest.mark.slow) for n in NAMES])
def test_integrals_follow_from_the_ends_of_pieces(law: str, train: str, tmp_path: Path) -> None:
    found = Assembler()
    said = text(found.written(of_text(pair(law) + train, tmp_path)))
    for line in found.lines:
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)
    assert "a_cy = (h (∑_i p_i))/t_y" in said
    assert "a_sc = (h (∑_i q_i))/t_c" in said


@pytest.mark.parametrize(
    "said",
    [
        rocker(turn="against", law="shun")
        + loads(mass=None, inertia='"1e-4 kg*m^2"')
        + '[cam.elastic]\nstiffness = "900 N*m/rad"\ndamping = 0.02\n',
        stem().replace('law = "cosine"\n', OWN) + loads() + DAMPED,
    ],
    ids=["rocker", "own acceleration"],
)
def test_rockers_and_own_laws_too(said: str, tmp_path: Path) -> None:
    found = Assembler()
    assert "∑_i p_i" in text(found.written(of_text(said, tmp_path)))
    assert max(line.found.error for line in found.lines) <= EXACT


def test_a_law_of_many_pieces_has_the_values_of_its_integrals_alone(tmp_path: Path) -> None:
    points = ", ".join(f"[{k / 20}, {(k / 20) ** 2 * (3 - k / 10)}]" for k in range(21))
    said = stem().replace('law = "cosine"\n', f"law = {{ points = [{points}] }}\n") + loads() + DAMPED
    note = text(Assembler().written(of_text(said, tmp_path)))
    assert "integrals over the phase" in note
    assert "p_i" not in note


@pytest.mark.parametrize("stiffness", ["0.4 N/mm", "40 N/mm", "90000 N/mm"])
def test_slow_and_stiff_trains_are_exact(stiffness: str, tmp_path: Path) -> None:
    """Shares that are far larger than their sum have more digits, or are left out."""
    found = Assembler()
    said = stem(law="poly5") + loads() + f'[cam.elastic]\nstiffness = "{stiffness}"\n'
    found.written(of_text(said, tmp_path))
    for line in found.lines:
        assert line.found.error <= EXACT, (line.formula, line.place, line.found.error)
        assert line.found.off <= 0.5 + 1e-6, (line.formula, line.place, line.found)


@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize("damping", [0.0, 0.1])
@pytest.mark.parametrize("name", NAMES)
def test_shares_are_the_integral(name: str, damping: float, back: bool) -> None:
    """Against the quadrature of the residual vibration; a law that runs back against its mirror image."""
    law, ratio = LAWS[name], 2.3
    found = shares(law, 2 * pi * ratio, damping, back=back)
    if back:
        law = mirrored(law)
    amplitude = abs(sum(each.left for each in found)) / (2 * pi * ratio * (1 - damping**2) ** 0.5)
    assert amplitude == pytest.approx(residual(law, np.array([ratio]), damping)[0], rel=1e-9, abs=1e-12)


def mirrored(law: Law) -> Law:
    """1 - s(1 - k), which has the acceleration of a return with the other sign: pieces by their values at points."""
    breaks = 1 - law.breaks[::-1]
    size = law.coefficients.shape[1]
    rows = np.zeros((law.count, size))
    waves = np.zeros((3, law.count))
    for k in range(law.count):
        old = law.count - 1 - k
        width = law.breaks[old + 1] - law.breaks[old]
        turned = np.polynomial.Polynomial(law.coefficients[old])(np.polynomial.Polynomial([width, -1.0]))
        rows[k, : len(turned.coef)] = -turned.coef
        waves[:, k] = (
            -law.amplitude[old],
            -law.frequency[old],
            law.frequency[old] * width + law.phase[old],
        )
    rows[:, 0] += 1.0
    return Law("mirrored", breaks, rows, *waves)


@pytest.mark.slow
def test_mutants_of_the_closed_form_are_caught(tmp_path: Path) -> None:
    """All formulas of a harmonic and of a polynomial, with damping."""
    caught: dict[object, bool] = {}
    for law in ("cosine", "linear", "sine", "modified_sine"):
        for block in blocks(pair(law) + DAMPED, tmp_path):
            if isinstance(block, Line):
                for mutant in mutants(block.formula):
                    seen = any(wrong(mutant, place.lexicon) for place in block.places)
                    caught[mutant] = caught.get(mutant, False) or seen
    missed = [mutant for mutant, seen in caught.items() if not seen]
    assert len(caught) > 180
    assert len(missed) <= 0.01 * len(caught), missed


def test_the_mean_efficiency_is_useful_over_given_work(tmp_path: Path) -> None:
    """Of a stem with friction that lifts 50 N by 20 mm and lets 20 N down: W_Q = -0.6 J."""
    said = stem() + loads(friction=0.1, force='"-50 N"', force_return='"-20 N"') + GUIDE + NEEDS
    found = values(of_text(said, tmp_path))
    assert found["W_d", ""] - found["W_f", ""] == pytest.approx(0.6, rel=1e-4)
    assert found["η_m", ""] == pytest.approx(0.6 / found["W_d", ""], rel=1e-4)
    free = values(of_text(stem() + loads(friction=0.1) + GUIDE + NEEDS, tmp_path))
    assert ("η_m", "") not in free
    assert free["W_f", ""] == pytest.approx(free["W_d", ""], rel=1e-9)


def test_means_of_a_step_are_sums_over_both_flanks() -> None:
    """Against the mean of the momentary efficiencies, by the trapezoid over the rows."""
    found = values(told("cam-lantern", None, ("cams",)))
    assert 0 < found["η_2m", ""] < found["η_1m", ""] < 1
    assert found["η_2m", ""] < found["η_12", ""] < found["η_1m", ""]


def test_jerk_and_phase_portrait_are_told_with_their_figures() -> None:
    chapters = told("cam-oscillating", None, ("cams",))
    figures = {block.key: block.caption for block in chapters[0].blocks if isinstance(block, Figure)}
    assert "psi'''" in figures["cam_law"]
    assert figures["cam_portrait"].startswith("Phase portrait")


@pytest.mark.parametrize("name", ["cam-oscillating", "cam-translating", "cam-flat", "cam-groove", "cam-lantern"])
def test_every_figure_and_table_is_named_by_a_text(name: str) -> None:
    chapters = told(name, None, ("cams",))
    said = " ".join(block.text for block in chapters[0].blocks if isinstance(block, Paragraph))
    for block in chapters[0].blocks:
        key = getattr(block, "key", "")
        if isinstance(block, Figure):
            assert f"{{fig:{key}}}" in said, key
        elif hasattr(block, "head"):
            assert f"{{tab:{key}}}" in said, key


@pytest.mark.slow
def test_a_concave_radius_is_warned_of_once() -> None:
    said = text(written("cam-oscillating"))
    assert said[said.index("Conclusions") :].count("23.884") == 2  # in the table, in one sentence
