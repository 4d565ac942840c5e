"""Tolerances of whole scenes, where theory tells what samples have to show, and what the linear model misses."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import tmmcalc
from tmmcalc.core.errors import UsageError
from tmmcalc.design.tolerance.document import tolerance_document
from tmmcalc.design.tolerance.scene import Asked, tolerate
from tmmcalc.design.tolerance.study import Tolerated

CONFIGS = Path(__file__).parents[2] / "configs"
CRANK, AXIS, SLOTTED = (
    "mechanism.links[id=1].points.A[0]",
    "mechanism.fixed.O[1]",
    "mechanism.links[id=3].points.C[0]",
)
STROKE = "kinematics.stroke_D"


def of(
    folder: Path, *tables: str, scene: str = "shaper", of: str = STROKE, sets: tuple[str, ...] = (), samples: int = 4096
) -> Tolerated:
    text = (CONFIGS / f"{scene}.toml").read_text(encoding="utf-8")
    file = folder / "s.toml"
    file.write_text(text + "".join(f"\n[[tolerances]]\n{table}\n" for table in tables), encoding="utf-8")
    asked = Asked(file, ("mechanism.grid.positions=12", *sets), (of,), samples=samples)
    return tolerate(asked, warn=lambda said: None)


@pytest.mark.slow
def test_a_result_that_is_linear_is_so_in_every_sample(tmp_path: Path) -> None:
    """H = 2 l_3 l_1 / l_0 of l_3 alone: the samples are normal ones, with the sigma of the linear model."""
    found = of(tmp_path, f'of = "{SLOTTED}"\ntolerance = "0.6 mm"')
    told = found.statistics[0]
    assert told is not None
    sigma = 2 * 200 / 620 * 0.2e-3
    assert found.linear.sigma[0] == pytest.approx(sigma, rel=1e-9)
    assert found.worst[0].how == "signs"
    assert (found.worst[0].least, found.worst[0].largest) == pytest.approx(
        (found.linear.least[0], found.linear.largest[0]), abs=1e-15
    )
    assert told.sigma.value == pytest.approx(sigma, rel=2e-3)
    for q, estimate in zip((-3, -1.6448536, 0, 1.6448536, 3), told.quantiles, strict=True):
        assert estimate.value == pytest.approx(found.nominal[0] + q * sigma, abs=0.1 * sigma)


@pytest.mark.parametrize(("samples", "enough"), [(1024, False), (2048, True)])
def test_what_samples_tell_has_its_interval_and_outer_quantiles_need_enough(
    tmp_path: Path, samples: int, enough: bool
) -> None:
    """Of 1024 samples 1.4 are expected beyond 99.865 %, of 2048 nearly three."""
    found = of(tmp_path, *(f'of = "{key}"\ntolerance = "0.6 mm"' for key in (SLOTTED, CRANK)), samples=samples)
    document = tolerance_document(found, "t")
    assert document.table is not None
    (part,) = (each for each in document.parts if each.name == "intervals")
    assert part.table is not None
    names, told, *numbers = part.table.columns
    assert {*names} == {found.names[0]}
    outer = ["0.135 %", "99.865 %"] if enough else []
    assert sorted(told) == sorted(["mean", "sigma", "5 %", "50 %", "95 %", *outer])
    assert [*document.table.headers[-len(outer) :]] == outer if enough else "99.865 %" not in document.table.headers
    for value, low, high in zip(*(map(float, column) for column in numbers), strict=True):
        assert low <= value <= high
        assert low < high
    assert any("99.865 %" in note and "left out" in note for note in document.notes) is not enough
    assert any(note.startswith("normal: 3 sigma") for note in document.notes)


@pytest.mark.slow
def test_small_tolerances_are_linear(tmp_path: Path) -> None:
    """H = 2 l_3 l_1 / l_0: what sampled and linear sigmas differ by falls with the square of the tolerances."""
    off = []
    rng = np.random.default_rng(0)
    for tolerance in (20.0, 2.0):
        tables = [f'of = "{key}"\ntolerance = "{tolerance} mm"' for key in (CRANK, AXIS)]
        found = of(tmp_path, *tables)
        told = found.statistics[0]
        assert told is not None
        ratio = told.sigma.value / found.linear.sigma[0]
        lengths = [mean + tolerance / 3 * rng.standard_normal(1_000_000) for mean in (200, 620)]
        by_hand = float(np.std(2 * 1.02 * lengths[0] / lengths[1]))
        assert told.sigma.value == pytest.approx(by_hand, rel=5e-3)
        exact = np.hypot(2.04 / 620, 2.04 * 200 / 620**2) * tolerance / 3
        assert found.linear.sigma[0] == pytest.approx(exact, rel=1e-9)
        assert abs(told.mean.value - found.nominal[0] * (1 + (tolerance / 3 / 620) ** 2)) < 0.01 * exact
        off.append(abs(ratio - 1))
    assert off[1] < 2e-3


@pytest.mark.slow
def test_where_a_result_is_least_the_linear_model_sees_nothing(tmp_path: Path) -> None:
    """The stroke of a centric crank-slider by its offset e: H = 2 r + c e^2, chi-square of one degree of freedom."""
    r, l, e = 0.1, 0.32, 0.006
    found = of(
        tmp_path,
        f'of = "mechanism.joints[name=B0].guide.through[1]"\ntolerance = "{3 * e} m"',
        scene="crank-slider",
        of="kinematics.stroke_B",
        sets=("mechanism.joints[name=B0].guide.through[1]=0",),
        samples=16384,
    )
    told = found.statistics[0]
    assert told is not None
    c = (1 / (l - r) - 1 / (l + r)) / 2
    assert found.nominal[0] == pytest.approx(2 * r)
    assert found.linear.sigma[0] < 1e-9
    assert told.mean.value - 2 * r == pytest.approx(c * e**2, rel=5e-3)
    assert told.sigma.value == pytest.approx(math.sqrt(2) * c * e**2, rel=2e-2)
    assert told.skewness.value == pytest.approx(math.sqrt(8), rel=5e-2)
    assert told.quantiles[2].value - 2 * r == pytest.approx(0.4549364 * c * e**2, rel=1e-2)
    (worst,) = found.worst
    assert worst.how == "search"
    assert worst.least == pytest.approx(2 * r, abs=1e-12)
    exact = [math.sqrt((l + side * r) ** 2 - (3 * e) ** 2) for side in (1, -1)]
    assert worst.largest == pytest.approx(exact[0] - exact[1], rel=1e-10)
    assert any("linear model is no good" in note for note in tolerance_document(found, "t").notes)


@pytest.mark.slow
def test_a_guide_that_goes_up_to_the_limit_of_assembly(tmp_path: Path) -> None:
    """Offsets beyond l - r do not assemble: they are counted, named, and lost to the yield."""
    found = of(
        tmp_path,
        'of = "mechanism.joints[name=B0].guide.through[1]"\ntolerance = "40 mm"\ndistribution = "uniform"',
        scene="crank-slider",
        of="kinematics.stroke_B",
        sets=("mechanism.joints[name=B0].guide.through[1]=0.2",),
        samples=1024,
    )
    refused = sum(each.count for each in found.refusals)
    assert refused == pytest.approx(1024 * (240 - 220) / 80, abs=3)
    assert found.refusals[0].reason
    assert int(np.isnan(found.values[:, 0]).sum()) == refused


@pytest.mark.slow
def test_a_clearance_presses_where_the_force_is_largest(tmp_path: Path) -> None:
    """Against the run itself: the reaction in C on the slotted link, turned into its axes."""
    found = of(tmp_path, 'joint = "C"\nclearance = ["0.02 mm", "0.06 mm"]\ndirection = "force"')
    (pair,) = found.sources.clearances
    run = tmmcalc.run(tmmcalc.load_spec(CONFIGS / "shaper.toml", ["mechanism.grid.positions=12"]), target="forces")
    forces, motion = run.table("forces"), run.table("kinematics")

    def column(table: object, name: str) -> np.ndarray:
        return np.asarray(table.columns[table.header.index(name)], float)  # type: ignore[attr-defined]

    row = int(np.argmax(column(forces, "R_C[N]")))
    reaction = complex(column(forces, "R_C_x[N]")[row], column(forces, "R_C_y[N]")[row])  # of link 3 on link 4
    at = int(np.argmin(abs(column(motion, "phi[deg]") - column(forces, "phi[deg]")[row])))
    own = -reaction / abs(reaction) * np.exp(-1j * math.radians(column(motion, "angle_3[deg]")[at]))
    assert pair.along == pytest.approx((own.real, own.imag), abs=1e-9)
    told = found.statistics[0]
    assert told is not None
    # along the slotted link the stroke is 2 l_1/l_0 of it; across, one dead centre is higher and the other one lower by
    # the sine of the swing, which the slope of the connecting rod makes of the stroke
    sine, rise = 200 / 620, 1.0 - 1.02 * math.sqrt(1 - (200 / 620) ** 2)
    side = np.sign(column(motion, "x_D[m]")[at] - column(motion, "x_C[m]")[at])
    per = 2 * sine * (own.real + side * rise / math.sqrt(0.29**2 - rise**2) * own.imag)
    assert told.mean.value - found.nominal[0] == pytest.approx(per * 20e-6, rel=1e-2)
    assert told.sigma.value == pytest.approx(abs(per) * 10e-6 / 3, rel=1e-2)
    assert any("at all positions" in note for note in tolerance_document(found, "t").notes)


@pytest.mark.slow
def test_a_clearance_at_an_angle_and_a_slider_on_one_side(tmp_path: Path) -> None:
    found = of(
        tmp_path,
        'joint = "C"\nclearance = "0.04 mm"\ndirection = "0 deg"',
        'joint = "D0"\nclearance = ["0.1 mm", "0.2 mm"]\ndirection = "force"\ndistribution = "uniform"',
        samples=256,
    )
    pin, guide = found.sources.clearances
    assert pin.along == (1.0, 0.0)
    assert guide.along is not None
    assert abs(guide.along[1]) == pytest.approx(1.0)
    assert not guide.sides
    told = found.statistics[0]
    assert told is not None
    assert told.mean.value - found.nominal[0] == pytest.approx(2 * 200 / 620 * 20e-6, rel=1e-2)
    assert found.sources.count == 1


@pytest.mark.slow
def test_pieces_that_were_measured(tmp_path: Path) -> None:
    sizes = np.random.default_rng(5).normal(199.98, 0.02, 200)
    lines = "\n".join(f"{at};{size:.4f}" for at, size in enumerate(sizes))
    (tmp_path / "cranks.csv").write_text(f"# inspection\nnumber;A[mm]\n{lines}\n", encoding="utf-8")
    found = of(tmp_path, f'of = "{CRANK}"\nmeasurements = "cranks.csv"\ncolumn = "A"')
    (source,) = found.sources.dimensions
    assert source.kind == "measured"
    assert len(source.measured) == 200
    assert source.mean == pytest.approx(sizes.mean() - 200, abs=1e-4)
    told = found.statistics[0]
    assert told is not None
    assert told.mean.value == pytest.approx(2 * 1.02 * sizes.mean() / 620, rel=1e-6)
    assert told.sigma.value == pytest.approx(2 * 1.02 * sizes.std() / 620, rel=1e-2)


@pytest.mark.parametrize(
    ("content", "table", "said"),
    [
        ("A[mm]\n1\n2\n", 'column = "B"', "no column"),
        ("A[mm],B[mm]\n1,2\n3,4\n", "", "2 columns"),
        ("A[mm]\n1\nx\n", "", "line 3"),
        ("A[mm]\n1\n", "", "no distribution"),
        ("A[deg]\n1\n2\n", "", "in deg"),
        ("A[furlong]\n1\n2\n", "", "is no unit"),
    ],
)
def test_a_file_of_pieces_that_does_not_fit(tmp_path: Path, content: str, table: str, said: str) -> None:
    (tmp_path / "p.csv").write_text(content, encoding="utf-8")
    with pytest.raises(UsageError, match=said):
        of(tmp_path, f'of = "{CRANK}"\nmeasurements = "p.csv"\n{table}')


@pytest.mark.parametrize(
    ("band", "said"),
    [
        ("kinematics.*", "no column over"),
        ("kinematics.max(angle_3)", "no column over"),
        ("kinematics.x_D@1@2", "no column over"),
        ("kinematics.nothing", "no column is called"),
        ("kinematics.stroke_D", "no column is called"),
        ("kinematics.x_D[mm]", "no column is called"),
    ],
)
def test_a_band_that_is_no_column_is_told_as_such(tmp_path: Path, band: str, said: str) -> None:
    file = tmp_path / "s.toml"
    text = (CONFIGS / "shaper.toml").read_text(encoding="utf-8")
    file.write_text(f'{text}\n[[tolerances]]\nof = "{CRANK}"\ntolerance = "js9"\n', encoding="utf-8")
    with pytest.raises(UsageError, match=said) as error:
        tolerate(Asked(file, of=(STROKE,), band=band))
    assert error.value.where == "--band"
    assert "@0" not in f"{error.value}"


def test_a_direction_by_force_needs_forces(tmp_path: Path) -> None:
    lines = (CONFIGS / "shaper.toml").read_text(encoding="utf-8").partition("[[loads]]")[0].splitlines()
    text = "\n".join(line for line in lines if line.partition(" ")[0] not in ("mass", "inertia", "center", "gravity"))
    file = tmp_path / "s.toml"
    file.write_text(f'{text}\n[[tolerances]]\njoint = "C"\nclearance = 1e-5\ndirection = "force"\n', encoding="utf-8")
    with pytest.raises(UsageError, match="no force is known in C"):
        tolerate(Asked(file, of=(STROKE,)))
