"""What acts on a linkage, from the tables of a spec to plain values."""

from __future__ import annotations

import math

import pytest
from project.scenes import CONFIGS, MACHINE

from tmmcalc.linkage.loading import Body, Coupling, GearDrive, Load, Loading, Pair, Spring, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.indicator import Indicator
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.tables.tasks.loading import to_loading
from tmmcalc.project import load_spec, parse_spec


def test_masses_and_gravity_of_the_shaper(shaper: str) -> None:
    assert to_loading(parse_spec(shaper)) == Loading(
        bodies=(Body(3, 55.0, 4.5, 0.5 + 0j), Body(4, 12.0, 0.1, 0.12 + 0j), Body(5, 190.0, 0.0, 0j)),
        gravity=-9.81j,
    )


def test_gravity_has_a_direction(shaper: str) -> None:
    text = shaper.replace('gravity = "9.81 m/s^2"', 'gravity = 2\ngravity_direction = "180 deg"')
    assert to_loading(parse_spec(text)).gravity == -2


def test_every_law(shaper: str) -> None:
    strokes = (((0.0, 0.1, 1.0), (5e6, 2e6, 1e5)), ((1.0, 0.0), (1e5, 1e5)))
    assert to_loading(parse_spec(shaper + MACHINE)).loads == (
        Load("cut", 5, "force", Constant(1500.0), 0j, -1 + 0j, window=Window(positions=("2", "12")), factor=1.2),
        Load(
            "Q5",
            5,
            "force",
            Polynomial((1.0, 2.5, 0.25)),
            0.01 + 0j,
            window=Window(angles=(5 * math.pi / 3, math.pi / 2)),
        ),
        Load("Q3", 3, "moment", Viscous(0.5), against=4),
        Load("Q3'", 3, "force", Quadratic(3.5), 0.5 + 0j, role="drive"),
        Load(
            "Q5'",
            5,
            "force",
            Tabulated("stroke", (0.0, 0.5, 1.0), (0.0, 1500.0, 100.0), "pchip"),
            1j,
            follows=3,
            window=Window(stroke="working", output="D"),
        ),
        Load("Q5''", 5, "force", Indicator(strokes, math.pi / 4 * 0.08**2, 1e5, math.pi / 2)),
    )


def test_springs_and_drive(shaper: str) -> None:
    loading = to_loading(parse_spec(shaper + MACHINE))
    assert loading.springs == (
        Spring("spring 1", "linear", (5, 0), (0j, 0.1 + 0.2j), 30e3, 0.2),
        Spring("T", "torsion", (3, 4), (0j, 0j), 100.0, math.pi / 2, 0.5),
    )
    assert loading.drive == GearDrive(0.15, math.pi / 9, math.pi / 2, True)
    assert to_loading(parse_spec(f"{shaper}\n[drive]\n")).drive == Coupling()


def test_pairs_that_have_a_size_or_friction(shaper: str) -> None:
    text = shaper.replace('name = "A"\n', 'name = "A"\nradius = "20 mm"\nfriction = 0.1\n')
    text = text.replace('name = "D0"\n', 'name = "D0"\nlength = "300 mm"\nfriction = 0.15\n')
    text = text.replace('name = "A3"\n', 'name = "A3"\nfriction = "1/8"\n')
    loading = to_loading(parse_spec(text))
    assert loading.pairs == (
        Pair("A", 0.1, radius=0.02),
        Pair("A3", 0.125),
        Pair("D0", 0.15, length=0.3),
    )
    assert loading.rubs


def law_of(shaper: str, table: str, more: str = "") -> Tabulated:
    spec = parse_spec(f'{shaper}\n[[loads]]\nlink = 5\npoint = "D"\n{more}[loads.table]\n{table}')
    law = to_loading(spec).loads[0].law
    assert isinstance(law, Tabulated)
    return law


@pytest.mark.parametrize(
    ("table", "x", "period"),
    [
        ("force = [1, 2, 3, 4]\n", (0.0, math.pi / 2, math.pi, 1.5 * math.pi), 2 * math.pi),
        ('period = "720 deg"\nforce = [1, 2, 3, 4]\n', (0.0, math.pi, 2 * math.pi, 3 * math.pi), 4 * math.pi),
        ('of = "position"\nforce = [1, 2, 3]\n', (0.0, 1.0, 2.0), None),
        ('of = "stroke"\nforce = [1, 2, 3, 4, 5]\n', (0.0, 0.25, 0.5, 0.75, 1.0), None),
        ('of = "position"\nx = [2, 12]\nforce = [1, 2]\n', (2.0, 12.0), None),
        ('of = "displacement"\nx = ["10 mm", 0.5]\nforce = [1, 2]\n', (0.01, 0.5), None),
    ],
)
def test_abscissae(shaper: str, table: str, x: tuple[float, ...], period: float | None) -> None:
    law = law_of(shaper, table)
    assert law.x == pytest.approx(x, rel=1e-15)
    assert law.period == period
    assert len(law.values) == len(x)


def test_the_output_of_a_table(shaper: str) -> None:
    law = law_of(shaper, 'of = "stroke"\noutput = "D"\nforce = [1, 2]\n')
    assert law.output == "D"


def test_the_area_of_a_piston(shaper: str) -> None:
    text = MACHINE.replace('diameter = "80 mm"', 'area = "50 cm^2"')
    law = to_loading(parse_spec(shaper + text)).loads[-1].law
    assert isinstance(law, Indicator)
    assert law.area == 0.005


def test_names_keep_clear_of_given_ones(shaper: str) -> None:
    load = "[[loads]]\nlink = 3\nmoment = 1\n{}"
    names = ["", 'name = "Q3\'"\n', "", 'name = "Q3"\n', ""]
    spec = parse_spec(shaper + "".join(load.format(name) for name in names))
    assert [load.name for load in to_loading(spec).loads] == ["Q3''", "Q3'", "Q3'''", "Q3", "Q3''''"]


def test_a_resistance_with_a_point_is_a_force(shaper: str) -> None:
    load = "[[loads]]\nlink = 3\nviscous = 2\n"
    spec = parse_spec(f'{shaper}\n{load}\n{load}point = "C"\n')
    assert [(load.kind, load.point) for load in to_loading(spec).loads] == [("moment", 0j), ("force", 1.02 + 0j)]


def test_every_ready_mechanism_has_a_loading() -> None:
    specs = [load_spec(file) for file in CONFIGS.glob("*.toml")]
    for spec in (spec for spec in specs if spec.mechanism is not None):
        heavy = [link for link in spec.linkage.links if link.mass is not None]
        assert [body.link for body in to_loading(spec).bodies] == [link.id for link in heavy]
