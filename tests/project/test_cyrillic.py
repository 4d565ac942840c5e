"""Keys and units in Cyrillic letters, and quantities without quotes: the message says what was meant."""

from __future__ import annotations

import pytest
from faults import Faults

from tmmcalc.spec.cyrillic import _FOLDED, _KEYS, _UNITS, latin_key, latin_units
from tmmcalc.spec.units import UnitError, dimension_of, parse

UNITS = {
    "12 кг": ("mass", '"12 kg"'),
    "55 об/хв": ("angular speed", '"55 rpm"'),
    "55 об/мин": ("angular speed", '"55 rpm"'),
    "620 мм": ("length", '"620 mm"'),
    "0,62 м": ("length", '"0.62 m"'),
    "0.5 с": ("time", '"0.5 s"'),
    "1.5 кН": ("force", '"1.5 kN"'),
    "15 Н": ("force", '"15 N"'),
    "5,5 кВт": ("power", '"5.5 kW"'),
    "5 рад/с": ("angular speed", '"5 rad/s"'),
    "5 рад/с²": ("angular acceleration", '"5 rad/s²"'),
    "40 Н·м": ("moment", '"40 N·m"'),
    "40 Нм": ("moment", '"40 N*m"'),
    "4 кг*м^2": ("inertia", '"4 kg*m^2"'),
    "30 град": ("angle", '"30 deg"'),
    "9.81 м/с^2": ("acceleration", '"9.81 m/s^2"'),
    "600 МПа": ("pressure", '"600 MPa"'),
    "600 мпа": ("pressure", '"600 MPa"'),
    "50 Гц": ("frequency", '"50 Hz"'),
    "30 Н/мм": ("stiffness", '"30 N/mm"'),
    "5 \u043c\u043c": ("length", '"5 mm"'),
    "5 m\u043c": ("length", '"5 mm"'),
}


@pytest.mark.parametrize("text", UNITS)
def test_a_unit_in_cyrillic_is_told_in_latin(text: str) -> None:
    dimension, remedy = UNITS[text]
    with pytest.raises(UnitError) as caught:
        parse(text, dimension)
    assert remedy in caught.value.remedy
    parse(remedy.strip('"'), dimension)


def test_one_of_another_dimension_is_told_so() -> None:
    with pytest.raises(UnitError, match="'12 кг' is a mass, a length is needed"):
        parse("12 кг", "length")


@pytest.mark.parametrize("unit", [*_UNITS.values(), *_FOLDED.values()])
def test_every_unit_is_known_or_a_part_of_one(unit: str) -> None:
    whole = {"kgf": "kgf*m^2", "rev": "rev/min"}.get(unit, unit)
    assert dimension_of(f"1 {whole}") is not None


@pytest.mark.parametrize(
    ("old", "new", "line", "column", "fragment", "remedy"),
    [
        ("mass = 12", "mass = 12 kg", 59, 11, "expected newline", '"12 kg"'),
        ("mass = 12", "mass = 12 кг", 59, 11, "expected newline", '"12 kg"'),
        ("mass = 12", "mass = 12,5 кг", 59, 10, "expected newline", '"12.5 kg"'),
        ('"55 rpm"', "55 об/хв", 26, 12, "expected newline", '"55 rpm"'),
        ("B = [0, 0]", "B = [0, 100 mm]", 35, 13, "unclosed array", '"100 mm"'),
        ("B = [0, 0]", "B = [100 мм, 0]", 35, 10, "unclosed array", '"100 mm"'),
        ('"Shaper"', "My project", 16, 9, "invalid value", '"My project"'),
        ('"Shaper"', "Мій проєкт # 1", 16, 9, "invalid value", '"Мій проєкт"'),
        ("mass = 12", "маса = 12", 59, 1, "the key 'маса' is not Latin: it holds Cyrillic small letter em", "mass"),
        ("mass = 12", "m\u0430ss = 12", 59, 1, "it holds Cyrillic small letter a", "Latin letters: mass"),
        ("mass = 12", "шатун = 12", 59, 1, "it holds Cyrillic small letter sha", "keys of a spec are in Latin"),
        ("[mechanism.grid]", "[mechanism.сітка]", 21, 2, "'mechanism.сітка' is not Latin", "in Latin"),
        ("mass = 12", 'точки."A" = 12', 59, 1, "the key 'точки' is not", "Latin"),
    ],
)
def test_what_is_no_toml(
    shaper: str, faults_of: Faults, old: str, new: str, line: int, column: int, fragment: str, remedy: str
) -> None:
    assert old in shaper
    (fault,) = faults_of(shaper.replace(old, new, 1))
    assert (fault.line, fault.column) == (line, column)
    assert fragment in fault.message
    assert remedy in fault.remedy


@pytest.mark.parametrize("key", ["маса", "m\u0430ss", "Масса"])
def test_a_key_in_quotes(shaper: str, faults_of: Faults, key: str) -> None:
    fault = faults_of(shaper.replace("mass = 12", f'"{key}" = 12', 1))[0]
    assert "unknown key" in fault.message
    assert "it holds Cyrillic" in fault.message
    assert fault.remedy == 'did you mean "mass"?'


def test_a_word_with_a_letter_that_looks_latin(shaper: str, faults_of: Faults) -> None:
    (fault,) = faults_of(shaper.replace('kind = "revolute"', 'kind = "rev\u043elute"', 1))
    assert fault.message.startswith("'revоlute' is not a kind of joint: it holds Cyrillic small letter o")


def test_latin_words_stay() -> None:
    for word in _KEYS.values():
        assert latin_key(word) == latin_units(word) == word
