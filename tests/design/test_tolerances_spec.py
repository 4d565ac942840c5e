"""The table ``[[tolerances]]`` and ``tmmcalc tolerance``: one message a fault, what it makes, what it prints."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from tmmcalc.batch.reading import frame_of
from tmmcalc.cli.app import app
from tmmcalc.core.errors import SpecError, UsageError
from tmmcalc.design.tolerance.linear import ends_of
from tmmcalc.design.tolerance.sources import Sources
from tmmcalc.design.tolerance.task import sources_of, varying
from tmmcalc.design.tolerance.worst import Box
from tmmcalc.project.loader import Variants, parse_spec

SHAPER = (Path(__file__).parents[2] / "configs" / "shaper.toml").read_text(encoding="utf-8")
CRANK = 'of = "mechanism.links[id=1].points.A[0]"'
AGAIN = 'of = "mechanism.links[0].points.A[0]"'  # the same number


def sources(tmp_path: Path, *tables: str, text: str = SHAPER) -> Sources:
    file = tmp_path / "s.toml"
    text = text + "".join(f"\n[[tolerances]]\n{table}\n" for table in tables)
    file.write_text(text, encoding="utf-8")
    variants = Variants(text, str(file), tmp_path, ())
    spec = variants.spec()
    frame = frame_of(file, (), varying(spec.tolerances, variants.data), ["kinematics.stroke_D"])
    return sources_of(spec.tolerances, variants.data, frame.axes)


def arms(tmp_path: Path, table: str, which: str = "FG") -> Sources:
    """Of points of the slotted link at 300 mm to both sides."""
    text = SHAPER.replace("points = { B = [0, 0], C", 'points = { F = ["300 mm", 0], G = ["-300 mm", 0], B = [0, 0], C')
    keys = [f"mechanism.links[id=3].points.{point}[0]" for point in which]
    return sources(tmp_path, f"of = {json.dumps(keys)}\n{table}", text=text)


@pytest.mark.parametrize(
    ("tolerance", "low", "high"),
    [  # of a crank of 200 mm, in mm
        ('"0.1 mm"', -0.1, 0.1), ("1e-4", -0.1, 0.1), ('["-0.02 mm", "50 um"]', -0.02, 0.05), ('"1 %"', -2.0, 2.0),
        ('"h7"', -0.046, 0.0), ('"IT7"', -0.023, 0.023), ('"H8"', 0.0, 0.072), ('"ISO 2768-m"', -0.5, 0.5),
        ('"c"', -1.2, 1.2),
    ],
)  # fmt: skip
def test_tolerances_are_read_in_the_unit_of_the_key(tmp_path: Path, tolerance: str, low: float, high: float) -> None:
    (found,) = sources(tmp_path, f"{CRANK}\ntolerance = {tolerance}").dimensions
    assert (found.low, found.high) == pytest.approx((low, high), abs=1e-9)


def test_wildcards_groups_measured_and_clearances(tmp_path: Path) -> None:
    found = sources(
        tmp_path,
        'of = "mechanism.links[*].points.*"\ntolerance = "js9"\nalike = "all"\ncorrelation = 0.5',
        'of = "mechanism.fixed.O[1]"\nmeasured = ["-0.01 mm", "0.02 mm"]',
        'joint = "C"\nclearance = "0.04 mm"',
        'joint = "D0"\nclearance = "0.1 mm"',
        'of = "mechanism.joints[name=D0].guide.angle"\ntolerance = "m"\nside = "400 mm"',
    )
    named = [each.name for each in found.dimensions]
    assert named[:3] == [
        f"mechanism.links[id={link}].points.{point}[0]" for link, point in ((1, "A"), (3, "C"), (4, "D"))
    ]
    assert found.names == (
        "all", "mechanism.fixed.O[1]", "mechanism.joints[name=D0].guide.angle", "clearance of C", "clearance of D0",
    )  # fmt: skip
    assert found.dimensions[3].measured == (-0.01, 0.02)
    assert found.dimensions[4].high == pytest.approx(1 / 6)  # 10 minutes, in degrees
    pin, guide = found.clearances
    assert pin.largest == pytest.approx(2e-5)
    assert pin.scale == (1000.0, 1.0)
    assert guide.sides
    assert guide.along == pytest.approx((0.0, 1.0))


def test_a_number_under_two_names_is_one(tmp_path: Path) -> None:
    """A pin and a dimension move the same coordinate, each by its own change."""
    found = sources(
        tmp_path,
        'of = "mechanism.links[2].points.C[0]"\ntolerance = "0.1 mm"',
        'joint = "C"\nclearance = "0.2 mm"\ndirection = "0 deg"',
    )
    assert found.keys == 2
    assert found.dimensions[0].key == found.clearances[0].keys[0]
    moved = found.parts(np.full((1, found.count), 0.5))[0]
    assert moved.sum(axis=0) == pytest.approx([0.1, 0.0])


@pytest.mark.parametrize(
    ("table", "said"),
    [
        (CRANK, "missing key: tolerance"),
        ('tolerance = "h7"', "missing key: of"),
        (f'{CRANK}\ntolerance = "7"', "is no tolerance"),
        (f'{CRANK}\ntolerance = "-0.1 mm"', "above 0"),
        (f'{CRANK}\ntolerance = ["0.1 mm", "-0.1 mm"]', "exchange"),
        (f'{CRANK}\ntolerance = ["0.1 mm"]', "two deviations"),
        (f'{CRANK}\ntolerance = "0 %"', "out of range"),
        (f'{CRANK}\ntolerance = "h7"\ndistribution = "normall"', "did you mean"),
        (f'{CRANK}\ndistribution = "measured"', "missing key: measured"),
        (f'{CRANK}\ntolerance = "h7"\nmeasured = [1e-5]', "measured"),
        (f'{CRANK}\ntolerance = "h7"\ncorrelation = 0.5', "alike"),
        (f'{CRANK}\ntolerance = "h7"\nside = "80 mm"', "side"),
        (f'{CRANK}\ntolerance = "h7"\njoint = "A"', "together with of"),
        ('of = "mechanism.links[id=1].points.Z[0]"\ntolerance = "h7"', "Z"),
        ('of = "mechanism.nothing.*"\ntolerance = "h7"', "no number of the spec"),
        ('joint = "Z"\nclearance = "0.1 mm"', "no joint"),
        ('joint = "A"', "missing key: clearance"),
        ('joint = "A"\nclearance = "0.1 mm"\nlink = 4', "no joint of link 4"),
        ('joint = "A3"\nclearance = "0.1 mm"', "named point"),
        (f'{CRANK}\ntolerance = "h7"\nalike = "mechanism.links[0].points.A[0]"', "the name of a number"),
        (f'{CRANK}\ntolerance = "h7"\nalike = "clearance of A"', "the name of a clearance"),
        (
            'joint = "C"\nclearance = "0.1 mm"\n[[tolerances]]\njoint = "C"\nclearance = "0.1 mm"\nlink = 4',
            "two clearances",
        ),
    ],
)
def test_a_fault_is_one_message(table: str, said: str) -> None:
    with pytest.raises(SpecError) as error:
        parse_spec(f"{SHAPER}\n[[tolerances]]\n{table}\n")
    (fault,) = error.value.faults
    assert said in f"{fault}"


GUIDE = 'joint = "D"\nclearance = "0.1 mm"'
OWN = ('name = "D"\nkind = "revolute"\nlinks = [4, 5]', 'name = "D"\nkind = "revolute"\nlinks = [4, 5]\n')


@pytest.mark.parametrize(
    ("changes", "table", "users", "remedy"),
    [
        ([], 'joint = "B"\nclearance = "0.1 mm"', 'guide.through of joint "A3"', "guide.through of joint"),
        ([], f"{GUIDE}\nlink = 5", "load 'Q5'", 'points = ["D", "D_1"]'),
        ([], f"{GUIDE}\nlink = 4", "", ""),  # the load and the output are those of the ram, which stays
        (
            [('D = ["290 mm", 0]', 'D4 = ["290 mm", 0]'), (OWN[0], OWN[1] + 'points = ["D4", "D"]'),
             ('point = "D"\ndirection = "0 deg"', 'point = "D4"')],
            GUIDE, "the output of 'D4'", 'points = ["D4_1", "D"]',
        ),
        (
            [('points = { C = [0, 0]', 'points = { E = ["0.1 m", 0], C = [0, 0]'),
             ("[motor]", '[[springs]]\nlinks = [0, 4]\npoints = ["O", "C"]\nstiffness = 10\n[motor]')],
            'joint = "C"\nclearance = "0.1 mm"\nlink = 4', "spring number 1", 'points = ["C", "C_1"]',
        ),
        (
            [("[motor]", '[[mechanism.links]]\nid = 6\npoints = { C = [0, 0], F = ["0.3 m", 0] }\n'
              '[[mechanism.joints]]\nname = "C6"\nkind = "revolute"\nlinks = [3, 6]\npoint = "C"\n[motor]')],
            'joint = "C"\nclearance = "0.1 mm"', 'joint "C6"', 'points = ["C_1", "C"]',
        ),
    ],
)  # fmt: skip
def test_a_pin_that_others_have_too_is_refused(
    changes: list[tuple[str, str]], table: str, users: str, remedy: str
) -> None:
    text = SHAPER
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    try:
        parse_spec(f"{text}\n[[tolerances]]\n{table}\n")
        told = []
    except SpecError as error:
        told = [f"{fault}" for fault in error.faults if "tolerances" in f"{fault}"]
    assert len(told) == bool(users)
    for fault in told:
        assert users in fault
        assert "would move along" in fault
        assert remedy in fault


@pytest.mark.parametrize(
    ("tables", "said"),
    [
        ((f'{CRANK}\ntolerance = "1 deg"',), "is no tolerance of it"),
        ((f'{CRANK}\ntolerance = "h19"',), "no grade"),
        (('of = "mechanism.links[id=3].mass"\ntolerance = "h7"',), "is a tolerance of lengths"),
        ((f'{CRANK}\ntolerance = "h7"', f'{CRANK}\ntolerance = "h8"'), "two tolerances"),
        ((f'{CRANK}\ntolerance = "h7"', f'{AGAIN}\ntolerance = "h8"'), "two tolerances, as mechanism.links.id=1"),
        (('of = "mechanism.joints[name=D0].guide.angle"\ntolerance = "m"',), "shorter side"),
    ],
)
def test_what_does_not_fit_its_size_is_told(tmp_path: Path, tables: tuple[str, ...], said: str) -> None:
    with pytest.raises(UsageError, match=said):
        sources(tmp_path, *tables)


def test_the_command_tells_all_and_goes_on_where_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    text = f"""{SHAPER}
[[tolerances]]
{CRANK}
tolerance = "js9"

[[tolerances]]
of = "mechanism.fixed.O[1]"
tolerance = "0.05 mm"
distribution = "uniform"

[[constraints]]
name = "stroke"
value = "kinematics.stroke_D"
at_least = "657.9 mm"
"""
    Path("s.toml").write_text(text, encoding="utf-8")
    words = [
        "tolerance",
        "s.toml",
        "--samples",
        "64",
        "--band",
        "kinematics.x_D",
        "-o",
        "t.csv",
        "--format",
        "json",
        "-q",
    ]
    first = CliRunner().invoke(app, [*words, "--picture", "t.svg"])
    assert first.exit_code == 0, first.output
    told = json.loads(first.stdout)
    stroke = told["kinematics.stroke_D[m]"]
    assert stroke["worst"]["how"] == "signs"
    assert stroke["worst"]["least"] == pytest.approx(stroke["linear"]["least"], abs=1e-7)
    assert stroke["statistics"]["sigma"]["value"] == pytest.approx(stroke["linear"]["sigma"], rel=0.05)
    assert sum(stroke["linear"]["shares"].values()) == pytest.approx(1.0)
    assert 0.5 < told["yield"]["low"] <= told["yield"]["value"] <= told["yield"]["high"] < 1.0
    assert Path("t.svg").stat().st_size > 10_000
    before = Path("t.csv").stat().st_mtime_ns
    assert CliRunner().invoke(app, words).stdout == first.stdout
    assert Path("t.csv").stat().st_mtime_ns == before  # nothing was solved again
    none = CliRunner().invoke(app, ["tolerance", "s.toml", "--of", "kinematics.strok_D"])
    assert isinstance(none.exception, UsageError)


@pytest.mark.parametrize("tolerance", ['"h7"', '"1 %"', '"m"', '"js9"'])
def test_sizes_made_alike_become_larger_together(tmp_path: Path, tolerance: str) -> None:
    """A lever with two equal arms, one of which points along -x: what makes one longer makes the other one longer."""
    found = arms(tmp_path, f'tolerance = {tolerance}\nalike = "arms"')
    one, other = found.dimensions
    assert (one.sense, other.sense) == (1.0, -1.0)
    assert (one.low, one.high) == pytest.approx((-other.high, -other.low))
    moved = found.parts(np.linspace(0.01, 0.99, 9)[:, None])[:, 0, [one.key, other.key]]
    assert moved[:, 0] == pytest.approx(-moved[:, 1])
    assert (np.diff(moved[:, 0]) > 0).all()
    sums, differences = np.zeros((2, found.keys))
    sums[[one.key, other.key]], differences[[one.key, other.key]] = (1.0, 1.0), (1.0, -1.0)  # of coordinates
    assert ends_of(found, sums) == pytest.approx((0.0, 0.0), abs=1e-12)
    assert ends_of(found, differences) == pytest.approx((2 * one.low, 2 * one.high))
    assert sums @ found.covariances()[0] @ sums == pytest.approx(0.0, abs=1e-12)
    box = Box(found, np.array([300.0, -300.0]))
    assert np.abs(box.keys(np.array([[1.0]])))[0] == pytest.approx([300 + one.high] * 2)


@pytest.mark.parametrize("sign", ["", "-"])
def test_measured_sizes_of_a_negative_coordinate(tmp_path: Path, sign: str) -> None:
    sizes = (299.98, 300.01, 300.05)
    (tmp_path / "p.csv").write_text("A[mm]\n" + "".join(f"{sign}{each}\n" for each in sizes), encoding="utf-8")
    files = f'measurements = "{(tmp_path / "p.csv").as_posix()}"'
    (found,) = arms(tmp_path, files, "G").dimensions
    assert sorted(found.measured) == pytest.approx([-0.05, -0.01, 0.02])
    assert found.deviation(np.array([-3.0, 3.0])) == pytest.approx([0.02, -0.05])  # the largest size last


def test_deviations_are_of_the_coordinate_as_written(tmp_path: Path) -> None:
    one, other = arms(tmp_path, 'tolerance = ["0 mm", "0.1 mm"]\nalike = "arms"').dimensions
    assert (one.low, one.high, one.sense) == (other.low, other.high, other.sense) == (0.0, 0.1, 1.0)
