"""The laws of loads as the package finds them: each is whole, and the spec has the keys of all."""

from __future__ import annotations

from pathlib import Path

import pytest

from tmmcalc.linkage import loadlaws
from tmmcalc.linkage.loadlaws.law import Law
from tmmcalc.linkage.loadlaws.placed import Placed
from tmmcalc.linkage.loadlaws.resistance import Resistance
from tmmcalc.linkage.tables.loads import LoadTable

BASES = {"__init__", "law", "placed", "resistance"}


def test_every_module_is_a_law() -> None:
    files = {file.stem for file in Path(loadlaws.__file__).parent.glob("*.py")} - BASES
    assert {law.__module__.rpartition(".")[2] for law in loadlaws.laws().values()} == files


def test_the_spec_has_the_keys_of_all_in_their_order() -> None:
    fields = [name for name in LoadTable.model_fields if name in loadlaws.laws()]
    assert fields == [*loadlaws.laws()]


@pytest.mark.parametrize("law", dict.fromkeys(loadlaws.laws().values()))
def test_a_law_is_placed_or_a_resistance(law: type[Law]) -> None:
    assert issubclass(law, Placed) != issubclass(law, Resistance)
    needed = "along" if issubclass(law, Placed) else "against"
    assert needed in vars(law)


@pytest.mark.parametrize("law", dict.fromkeys(loadlaws.laws().values()))
def test_a_law_tells_what_is_given_of_it(law: type[Law]) -> None:
    assert law.given is not Law.given
