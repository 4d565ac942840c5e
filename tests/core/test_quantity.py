"""What a record gives out is said on its fields: keys, headers, units for people, records within records."""

from __future__ import annotations

import math

import pytest

from tmmcalc.core.quantity import Quantity, derived, given_out, keyed, quantities, quantity, table
from tmmcalc.core.records import record


@record
class Ball:
    """Inside, in metres."""

    diameter: float = quantity("D_{wheel}[m]", "diameter of the ball of wheel {wheel}", header="D[m]")
    inside: float
    angle: float | None = quantity("alpha[rad]", "pressure angle", source="(4.66)", default=None)

    @derived("V[m^3]", "volume")
    def volume(self) -> float:
        """That of a sphere."""
        return math.pi * self.diameter**3 / 6


@record
class Wheel:
    name: str
    balls: tuple[Ball, ...]
    spare: Ball | None = None
    by_size: dict[str, Ball] | None = None
    teeth: int = quantity("z", "number of teeth", default=17)


def test_only_what_is_given_out_is_told() -> None:
    told = quantities(Ball)
    assert list(told) == ["diameter", "angle", "volume"]
    assert told["angle"] == Quantity("alpha[rad]", "pressure angle", source="(4.66)")
    assert (told["volume"].name, told["volume"].unit) == ("V", "m^3")


def test_keys_take_the_names_of_the_scene() -> None:
    ball = Ball(0.5, 1.0)
    assert keyed(ball, wheel="2'") == {"D_2'[m]": 0.5, "alpha[rad]": None, "V[m^3]": ball.volume}
    assert list(keyed(ball, "volume", "diameter", wheel=1)) == ["V[m^3]", "D_1[m]"]


def test_fields_with_a_quantity_are_filled_as_others_are() -> None:
    assert Ball(0.5, 1.0).angle is None
    with pytest.raises(TypeError, match="diameter"):
        Ball(inside=1.0)
    assert Wheel("a", ()).teeth == 17


def test_tables_have_headers_and_units_for_people() -> None:
    rows = [Ball(0.25, 0, math.pi / 2), Ball(0.5, 0)]
    assert table(rows, Ball, "diameter[mm]", "angle[deg]") == {"D[mm]": [250.0, 500.0], "alpha[deg]": [90.0, None]}
    assert list(table(rows, Ball)) == ["D[m]", "alpha[rad]", "V[m^3]"]
    assert table([], Ball, "angle") == {"alpha[rad]": []}


def test_a_unit_that_no_person_uses_is_refused() -> None:
    with pytest.raises(KeyError):
        table([], Ball, "diameter[ft]")


def test_records_within_records_are_found_once() -> None:
    told = [each.key for each in given_out(Wheel)]
    assert told == ["z", "D_{wheel}[m]", "alpha[rad]", "V[m^3]"]
    assert [each.key for each in given_out(tuple[Wheel, ...])] == told
