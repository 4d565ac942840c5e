"""From [train] to tasks of synthesis: exact ratios of every kind, defaults by layout, modules."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from project.scenes import TRAIN

from tmmcalc.gears.model import Interval
from tmmcalc.gears.tables.tasks.train import to_train
from tmmcalc.gears.trains import Request
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project import parse_spec


def requests(text: str) -> tuple[Request, ...]:
    return to_train(parse_spec(f"[train]\n{text}"))


def request(text: str) -> Request:
    (found,) = requests(text)
    return found


def test_no_train(shaper: str) -> None:
    assert to_train(parse_spec(shaper)) == ()


@pytest.mark.parametrize(
    ("text", "nominal", "low", "high"),
    [
        ('layout = "AI"\nratio = "31.29"\ntolerance = 0.5\ntolerance_kind = "absolute"', "30.29", "29.79", "30.79"),
        ('layout = "AI"\nratio = "1/8"\nratio_kind = "i_H1"\ntolerance = 0', "7", "7", "7"),
        ('layout = "AI"\nratio = 6.2\nratio_kind = "u"\ntolerance = "1e-9"', "6.2", "6.1999999938", "6.2000000062"),
        ('layout = "AA"\nratio = -4\ntolerance = "10 %"', "5", "4.6", "5.4"),
        ('layout = "AA"\nratio = 0.01\ntolerance = "50 %"', "0.99", "0.985", "0.995"),
        ('layout = "coaxial"\nratio = 8', "8", "7.92", "8.08"),
        ('layout = "unfolded3"\nratio = 30', "30", "29.4", "30.6"),
        ('layout = "AII"\nratio = -60', "-60", "-60.6", "-59.4"),
    ],
)
def test_ratios_are_exact_tooth_ratios(text: str, nominal: str, low: str, high: str) -> None:
    task = request(text).task
    assert task.nominal == Fraction(nominal)
    assert task.ratio == Interval(Fraction(low), Fraction(high))


def test_a_driving_carrier_has_its_tolerance_on_its_own_ratio() -> None:
    found = request('layout = "AA"\nratio = 10000\nratio_kind = "i_H1"\ntolerance = "1 %"')
    assert found.admitted == Interval(Fraction(9900), Fraction(10100))
    assert found.task.ratio == Interval(1 - Fraction(1, 9900), 1 - Fraction(1, 10100))


def test_ratio_of_speeds() -> None:
    speeds = 'input_speed = "1450 rpm"\noutput_speed = '
    assert request(f'layout = "coaxial"\n{speeds}"178 rpm"').nominal == Fraction(1450, 178)
    assert request(f'layout = "unfolded3"\n{speeds}"-50 rpm"').nominal == 29
    assert request(f'layout = "AA"\n{speeds}"-290 rpm"').task.nominal == 6
    assert request('layout = "AI"\ninput_speed = "20 rad/s"\noutput_speed = "5 rad/s"').task.nominal == 3


def test_a_ratio_that_reaches_zero_ends_above_it() -> None:
    low = request('layout = "AI"\nratio = 1.005\ntolerance = "1 %"').task.ratio.low
    assert 0 < low < Fraction(17 * 17, 350 * 350)


def test_defaults_by_layout() -> None:
    unfolded = request('layout = "unfolded2"\nratio = 8').task
    assert (unfolded.planets, unfolded.proportions) == (1, ((),))
    assert (unfolded.demands.stage_ratio, unfolded.demands.diameter_band) == (6, Fraction(1, 20))
    coaxial = request('layout = "coaxial"\nratio = 8').task
    assert (coaxial.planets, coaxial.demands.stage_ratio, coaxial.demands.largest_angle) == (1, None, None)
    single = request('layout = "AIbar"\nratio = 7').task
    assert (single.planets, single.proportions, single.demands.undercut) == (3, ((1,),), 17)
    radial = request('layout = "2A-AA"\nratio = 5').task
    assert radial.demands.largest_angle == pytest.approx(math.radians(26), rel=1e-15)
    off = request('layout = "2A-AA"\nratio = 5\nconstraints = { mesh_angle_max = false, adjacency_gap = false }').task
    assert (off.demands.largest_angle, off.demands.gap) == (None, None)


def test_one_request_a_layout_and_number_of_planets() -> None:
    found = requests('layout = ["unfolded2", "coaxial", "AI"]\nratio = 8\nplanets = [2, 3]')
    assert [r.title for r in found] == [
        "unfolded2",
        "coaxial with 2 layshafts",
        "coaxial with 3 layshafts",
        "AI with 2 planets",
        "AI with 3 planets",
    ]
    assert [r.kind for r in found] == ["u", "u", "u", "i_1H", "i_1H"]


def test_proportions_of_modules() -> None:
    head = 'layout = "AI"\nratio = 8\n'
    assert request(head + "module_ratios = [[4, 6], [2, 3], [1, 1.75]]").task.proportions == ((2, 3), (4, 7))
    given = request(head + 'modules = ["2 mm", "3.5 mm"]').task
    assert (given.proportions, given.module) == (((4, 7),), 0.002)
    standard = request(head).task.proportions
    ratios = [Fraction(second, first) for first, second in standard]
    assert ratios == sorted(set(ratios))
    assert {(1, 1), (2, 3), (4, 7), (2, 5)} <= set(standard)
    assert all(
        1 <= ratio <= Fraction(5, 2) and math.gcd(*pair) == 1 for ratio, pair in zip(ratios, standard, strict=True)
    )
    assert request(head + "module_ratio_range = [1, 1]").task.proportions == ((1, 1),)


def test_standard_ratios() -> None:
    """For mu* = 1.7 the textbook takes 2 : 3 and 4 : 7, that is 2 with 3.0 or 3.5 mm."""
    found = request('layout = "AI"\nratio = 8\nmodule_ratio_range = [1.445, 1.955]\n').task.proportions
    assert {(2, 3), (4, 7)} <= set(found)
    assert all(math.gcd(*pair) == 1 and abs(pair[1] / pair[0] / 1.7 - 1) <= 0.15 for pair in found)


def test_undercut_gives_way_to_a_lower_z_min_and_is_said() -> None:
    lower = request('layout = "AIbar"\nratio = 7\nz_min = 16')
    assert lower.task.demands.undercut is None
    assert "slight undercut: z_min = 16" in lower.remarks[0]
    much = request('layout = "AIbar"\nratio = 7\nz_min = 12')
    assert much.remarks[0].startswith("undercut:")
    kept = request('layout = "AIbar"\nratio = 7\nz_min = 16\nconstraints = { undercut = true }')
    assert (kept.task.demands.undercut, kept.remarks) == (17, ())
    steep = request('layout = "AIbar"\nratio = 7\npressure_angle = "25 deg"').task
    assert steep.demands.undercut == math.floor(2 / math.sin(math.radians(25)) ** 2)


def test_ratios_beyond_custom_are_said() -> None:
    assert "usual up to 20" in request('layout = "unfolded2"\nratio = 24').remarks[0]
    assert request('layout = "unfolded2"\nratio = 20').remarks == ()


def test_requests_are_hashed_by_what_they_ask() -> None:
    texts = [TRAIN, TRAIN.replace("7.29", "7.290000001"), TRAIN.replace("0.5", "0.25"), TRAIN.replace("500", "501")]
    assert len({content_hash(to_train(parse_spec(text))) for text in texts}) == len(texts)
    assert content_hash(to_train(parse_spec(TRAIN))) == content_hash(
        to_train(parse_spec(TRAIN.replace("7.29", "7.290")))
    )
