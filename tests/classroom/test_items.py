"""What is asked, with the units that the results have, and scenes without a linkage and with files beside them."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tmmcalc.classroom.items import asked_now, items_of
from tmmcalc.classroom.making import make_class
from tmmcalc.classroom.model import Item
from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec
from tmmcalc.project.loader import parse_spec

from .test_draws import MECHANISM

CONFIGS = Path(__file__).parents[2] / "configs"
DRAWN = '[[class.drawn]]\nof = "mechanism.links[id=1].points.A[0]"\namong = ["90 mm", "100 mm"]\n'


def test_items_have_what_the_table_says_and_else_what_all_have() -> None:
    spec = parse_spec(
        f"""{MECHANISM}name = "w"
also = ["omega"]
unit = "rpm"
within = "0.1 rad/s"
tolerance = "2 %"
weight = 2
digits = 3
either_sense = true
[[class.asked]]
result = "kinematics.eps_3@1"
after = ["Omega"]
{DRAWN}
[class]
plans = "4 %"
"""
    )
    first, second = items_of(spec)
    assert first == Item(
        "w", ("omega",), "kinematics.omega_3@1", "rpm", 0.02, pytest.approx(0.954929658551372), 0.04, 2, 3, (), True
    )
    assert second == Item(
        "kinematics.eps_3@1", (), "kinematics.eps_3@1", "rad/s^2", 0.01, 0.0, 0.04, 1, 4, (0,), False, (0.0,)
    )


@pytest.mark.parametrize(
    ("rest", "message"),
    [
        ('unit = "mm"', "kinematics.omega_3@1 is in rad/s, which is no mm"),
        ('within = "1 mm"', "is no number in rad/s"),
    ],
)
def test_units_of_another_kind(rest: str, message: str) -> None:
    with pytest.raises(SpecError, match=message):
        items_of(parse_spec(f"{MECHANISM}{rest}\n{DRAWN}"))


def test_all_faults_of_what_is_asked_are_told_at_once_with_their_lines() -> None:
    more = "".join(f"[[class.asked]]\nresult = {each}\n" for each in ('"kinematics.omega_9@1"', '"kinematics.eps_3@1"'))
    text = f'{MECHANISM}unit = "mm"\n{more}within = "2 kg"\n'
    lines = text.splitlines()
    with pytest.raises(SpecError) as raised:
        items_of(parse_spec(text, "my.toml"))
    found = [(each.path, each.line) for each in raised.value.faults]
    assert found == [
        ("class.asked[0].unit", lines.index('unit = "mm"') + 1),
        ("class.asked[1].result", lines.index('result = "kinematics.omega_9@1"') + 1),
        ("class.asked[2].within", lines.index('within = "2 kg"') + 1),
    ]
    assert str(raised.value).startswith("my.toml: 3 faults")


def test_all_results_that_the_keys_have_not_are_told_at_once() -> None:
    more = '[[class.asked]]\nresult = "kinematics.eps_3@1"\n'
    keys = items_of(parse_spec(f"{MECHANISM}{more}"))
    now = parse_spec(f"{MECHANISM}{more}".replace("omega_3", "omega_2").replace("eps_3@1", "eps_3@2"))
    with pytest.raises(SpecError) as raised:
        asked_now(now, keys)
    assert [each.path for each in raised.value.faults] == ["class.asked[0].result", "class.asked[1].result"]
    assert all("class keys" in each.remedy for each in raised.value.faults)


def test_nothing_is_asked() -> None:
    with pytest.raises(UsageError, match="nothing is asked"):
        items_of(parse_spec(MECHANISM.partition("[[class")[0]))


def test_a_cam_by_measured_points(tmp_path: Path) -> None:
    """No linkage, and a file: variants stand a folder deeper and still find it."""
    shutil.copy(CONFIGS / "cam-law.csv", tmp_path)
    text = (CONFIGS / "cam-own-law.toml").read_text(encoding="utf-8")
    asked = '[[class.asked]]\nresult = "cam_law.velocity_max"\nname = "v"\n'
    drawn = '[[class.drawn]]\nof = "cam.stroke"\nat_least = "20 mm"\nat_most = "30 mm"\nstep = "1 mm"\n'
    file = tmp_path / "cam.toml"
    file.write_text(f"{text}\n{drawn}{asked.replace('velocity_max', 'S1_max')}", encoding="utf-8")
    made = make_class(file, tmp_path / "class", 4, 2, jobs=1)
    found = {load_spec(path).cam.stroke for path in (tmp_path / "class" / "variants").iterdir()}  # type: ignore[union-attr]
    assert len(found) == 4
    own = load_spec(file).cam
    assert own is not None
    # S' is in proportion to the stroke
    for each, variant in zip(made.fresh, made.own.variants, strict=True):
        stroke = load_spec(tmp_path / "class" / "variants" / f"{variant.stem}.toml").cam.stroke  # type: ignore[union-attr]
        assert each.values[0] / stroke == pytest.approx(made.fresh[0].values[0] / _stroke(made.fresh[0].assignments))


def _stroke(assignments: tuple[str, ...]) -> float:
    return float(assignments[0].partition('="')[2].removesuffix(' mm"')) / 1000


@pytest.mark.slow
def test_a_linkage_of_class_three(tmp_path: Path) -> None:
    """Many of it cannot be solved together, and it is judged all the same, near to its dead points too."""
    text = (CONFIGS / "class-three.toml").read_text(encoding="utf-8")
    drawn = (
        '[[class.drawn]]\nof = "mechanism.links[id=1].points.A[0]"\nat_least = "40 mm"\nat_most = "90 mm"\n'
        'step = "5 mm"\n[[class.drawn]]\nof = "mechanism.links[id=3].mass"\namong = [1, 2, 3, 4]\n'
    )
    asked = '[[class.asked]]\nresult = "kinematics.omega_3@3"\n[[class.asked]]\nresult = "forces.R_A@3"\n'
    file = tmp_path / "three.toml"
    file.write_text(f"{text}\n[class]\nspread = 100\n{drawn}{asked}", encoding="utf-8")
    made = make_class(file, tmp_path / "class", 5, 2, jobs=1)
    assert len({each.assignments for each in made.own.variants}) == 5
    for each in made.own.variants:
        found = run(load_spec(tmp_path / "class" / "variants" / f"{each.stem}.toml"))
        quality = found.results["kinematics"].qualities[0]
        assert quality.amplification <= 10.0
