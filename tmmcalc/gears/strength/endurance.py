"""Permissible stresses of a wheel by its material: endurance limits, safety and load factors (steps 2 to 5 of 9.1).

    sigma_HP = sigma_Hlim / S_H                       D.4.4, D.4.5
    sigma_FP = sigma_Flim^0 K_FC / (S_F' S_F'')       D.4.3, D.4.7, D.4.6

Long life: K_HL = K_FL = 1. A hardness outside the rows of all tables that give a limit is an error; outside one of
two it is a warning.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import NamedTuple

from tmmcalc.core.errors import UsageError
from tmmcalc.core.notes import Note, Phrase
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.letters import filled
from tmmcalc.gears.strength.material import Hardness, Material
from tmmcalc.gears.strength.steels import check_steel, known, latin, steel_key
from tmmcalc.gears.strength.tables import (
    ANY,
    BendingRow,
    BlankSafety,
    ContactRow,
    ContactSafety,
    LoadSides,
    table,
)

MPA = 1e6  # [Pa]
GIVEN = "given"
USUAL_SAFETY = 1.75  # S_F' of most rows of D.4.3, for a limit that is given


@record
class Coefficient:
    """A number of the calculation with the place that it is taken from: every one can be shown with its origin."""

    of: str = quantity("of", 'what it belongs to, such as "wheel 2\'", "stage 1", "mesh 1-2"')
    symbol: str = quantity("symbol", "symbol of the textbook")
    value: float = quantity("value", "its value")
    unit: str = quantity("unit", "its SI unit; - without dimension")
    source: str = quantity("source", "table and row, formula, or given")


@record
class Factor:
    """A coefficient with the cell of the table that it is read from, or the formula that it follows from."""

    told: Coefficient
    table: str = quantity("table", "table of the textbook that it is read from; empty: computed or given", default="")
    row: str = quantity("row", "row of the table", default="")
    column: str = quantity("column", "column of the table", default="")
    formula: str = quantity("formula", "how it is computed, in letters; empty: read or given", default="")
    formula_unit: str = quantity("formula_unit", "unit of what the formula gives, such as MPa or mm", default="")
    letters: Mapping[str, float] = field(default_factory=dict)  # of the formula, in the units that it is written for

    @derived("numbers", "the formula with numbers")
    def numbers(self) -> str:
        """The formula with the numbers of its letters."""
        return filled(self.formula, self.letters)


@record
class NamedFactor:
    """A coefficient as it is told by name: by what it belongs to and its symbol."""

    of: str
    symbol: str
    unit: str  # empty: without dimension
    letter: str  # what the symbol stands for
    place: str  # what it belongs to, in words
    value: float = quantity("value[{unit}]", "{letter}, {place}")

    @property
    def name(self) -> str:
        """What it belongs to and its symbol."""
        return f"{self.of}.{self.symbol}"


@record
class Endurance:
    """Permissible stresses of one wheel."""

    permissible_contact: float  # [Pa]
    permissible_bending: float  # [Pa]
    factors: tuple[Factor, ...] = ()
    warnings: tuple[Note, ...] = ()

    @property
    def coefficients(self) -> tuple[Coefficient, ...]:
        """The factors without their cells and formulas."""
        return tuple(factor.told for factor in self.factors)


def made(told: Coefficient, formula: str, letters: Mapping[str, float], unit: str = "") -> Factor:
    """A coefficient by a formula; ``letters`` are numbers in the units that it is written for."""
    return Factor(told, formula=formula, formula_unit=unit, letters=letters)


class _Limit(NamedTuple):
    value: float  # [Pa]
    source: str
    row: BendingRow | ContactRow | None = None
    at: Hardness | None = None  # that the row's slope is of

    def factor(self, told: Coefficient, column: str) -> Factor:
        """The limit as its row of the table gives it."""
        if self.row is None or told.source == GIVEN:
            return Factor(told)
        contact, formula, letters = isinstance(self.row, ContactRow), "", {}
        if self.at is not None and self.row.slope_mpa:
            base = self.value / MPA - self.row.slope_mpa * self.at.value
            formula = f"{self.row.slope_mpa:g}*{self.at.scale}{f' + {base:.6g}' if abs(base) > 1e-6 else ''}"
            letters = {self.at.scale: self.at.value}
        name = f"{', '.join(self.row.treatments)}{f'; {_range(self.row)}' if self.row.scale else ''}"
        if isinstance(self.row, BendingRow):
            name = f"{self.row.row}: {name}"
        unit = "MPa" if formula else ""
        return Factor(told, "D.4.4" if contact else "D.4.3", name, column, formula, unit, letters)


def endurance(material: Material, load: str, of: str) -> Endurance:
    """Permissible stresses of a wheel that is loaded "one-sided" or "two-sided"; ``of`` names it in messages.

    Raises `UsageError` for a steel, treatment or hardness that the tables do not have. Textbook D.4.3 to D.4.7.

    >>> from tmmcalc.gears.strength.material import Hardness
    >>> found = endurance(Material("improved", Hardness(300, "HB"), "40Kh"), "two-sided", "wheel 1")
    >>> round(found.permissible_contact / 1e6, 1), round(found.permissible_bending / 1e6, 1)
    (609.1, 200.6)
    """
    contact, bending = _contact_limit(material, of), _bending_limit(material, of)
    warnings = _check_range(material, [contact.row, bending.row], of)
    safety = next(row for row in table(ContactSafety) if row.structure == material.built)
    s_H = safety.severe if material.failure == "severe" else safety.ordinary
    s_F1, s_F1_source = _first_safety(material, bending)
    blank = next(row for row in table(BlankSafety) if (row.blank, row.wear) == (material.blank, material.wear))
    sides = next(r for r in table(LoadSides) if r.load == load and (ANY in r.treatments or _treated(r, material)))
    sigma_HP = contact.value / s_H
    sigma_FP = bending.value * sides.factor / (s_F1 * blank.high)
    widest = f"; the largest of {blank.low:g} to {blank.high:g}" if blank.low < blank.high else ""
    guarded = "with measures against decarburisation" if material.protected else "without measures"
    letters = {
        "sigma_Hlim": contact.value / MPA,
        "S_H": s_H,
        "sigma_Flim0": bending.value / MPA,
        "K_FC": sides.factor,
        "S_F'": s_F1,
        "S_F''": blank.high,
    }
    factors = (
        contact.factor(Coefficient(of, "sigma_Hlim", contact.value, "Pa", contact.source), "sigma_Hlim"),
        Factor(
            Coefficient(of, "S_H", s_H, "-", f"{safety.source}: {material.built}, {material.failure} consequences"),
            "D.4.5",
            material.built,
            f"{material.failure} consequences",
        ),
        made(Coefficient(of, "sigma_HP", sigma_HP, "Pa", "sigma_Hlim/S_H"), "sigma_Hlim/S_H", letters, "MPa"),
        bending.factor(
            Coefficient(of, "sigma_Flim^0", bending.value, "Pa", bending.source), f"sigma_Flim^0, {guarded}"
        ),
        Factor(Coefficient(of, "S_F'", s_F1, "-", s_F1_source), "D.4.3", _bending_name(bending), f"S_F', {guarded}"),
        Factor(
            Coefficient(of, "S_F''", blank.high, "-", f"{blank.source}: {blank.blank}, wear {blank.wear}{widest}"),
            "D.4.6",
            blank.blank,
            f"wear {blank.wear}{widest}",
        ),
        Factor(
            Coefficient(of, "K_FC", sides.factor, "-", f"{sides.source}: {load} load"),
            "D.4.7",
            f"{load}, {'any treatment' if ANY in sides.treatments else ', '.join(sides.treatments)}",
            "K_FC",
        ),
        made(
            Coefficient(of, "sigma_FP", sigma_FP, "Pa", "sigma_Flim^0 K_FC/(S_F' S_F'')"),
            "sigma_Flim0*K_FC/(S_F'*S_F'')",
            letters,
            "MPa",
        ),
    )
    return Endurance(sigma_HP, sigma_FP, factors, warnings)


def _bending_name(bending: _Limit) -> str:
    """The row of D.4.3 of a limit; of one that is given the value of most rows stands."""
    if isinstance(bending.row, BendingRow):
        return f"{bending.row.row}: {', '.join(bending.row.treatments)}"
    return "most rows"


def _treated(row: BendingRow | ContactRow | LoadSides, material: Material) -> bool:
    return material.treatment in row.treatments


def _contact_limit(material: Material, of: str) -> _Limit:
    if material.contact_limit is not None:
        return _Limit(material.contact_limit, GIVEN)
    row = next((row for row in table(ContactRow) if _treated(row, material)), None)
    if row is None:
        raise UsageError(
            f"Table D.4.4 has no contact limit for {material.treatment} wheels",
            where=of,
            remedy="give contact_limit (sigma_Hlim)",
        )
    value = row.slope_mpa * _on(material.hardness, row.scale, material.treatment, of) + row.offset_mpa
    return _Limit(value * MPA, f"{row.source} at {material.hardness}", row, material.hardness)


def _bending_limit(material: Material, of: str) -> _Limit:
    if material.bending_limit is not None:
        return _Limit(material.bending_limit, GIVEN)
    row = _bending_row(material, of)
    value = row.base_protected_mpa if material.protected else row.base_mpa
    at, hardness = "", None
    if row.slope_of == "surface":
        value += row.slope_mpa * _on(material.hardness, row.scale, material.treatment, of)
        at, hardness = f" at {material.hardness}", material.hardness
    elif row.slope_of == "core":
        if material.core is None:
            raise UsageError(
                "the bending limit of a nitrided wheel depends on the hardness of its core",
                where=of,
                remedy='give core, such as "30 HRC"',
            )
        value += row.slope_mpa * _on(material.core, "HRC", "the core of nitrided", of)
        at, hardness = f" with a core of {material.core}", material.core
    return _Limit(value * MPA, f"{row.source}, row {row.row}{at}", row, hardness)


def _bending_row(material: Material, of: str) -> BendingRow:
    """The row of D.4.3 that is named, or that has the steel; raises `UsageError` if there is none."""
    rows = [row for row in table(BendingRow) if _treated(row, material)]
    if material.row is not None:
        named = next((row for row in rows if row.row == material.row), None)
        if named is None:
            said = ", ".join(row.row for row in rows) or "none"
            what = f"{material.row!r} is not a row of Table D.4.3 for {material.treatment} wheels"
            raise UsageError(what, where=of, remedy=f"rows: {said}")
        return named
    if any(row.steels == (ANY,) for row in rows):
        return rows[0]
    key = check_steel(material.steel, of, "name a row of the table, or give bending_limit (sigma_Flim^0)")
    found = next((row for row in rows if key in row.steels), None)
    if found is None:
        steels = ", ".join(latin(steel) for row in rows for steel in row.steels) or "none"
        raise UsageError(
            f"Table D.4.3 has no bending limit of {latin(key)} for {material.treatment} wheels",
            where=of,
            remedy=f"{latin(key)} is {_either(known()[key])} there; {material.treatment} are {steels}; "
            "or give bending_limit (sigma_Flim^0)",
        )
    return found


def _first_safety(material: Material, bending: _Limit) -> tuple[float, str]:
    if isinstance(bending.row, BendingRow):
        row = bending.row
        return (row.safety_protected if material.protected else row.safety), f"{row.source}, row {row.row}"
    return USUAL_SAFETY, "of most rows of Table D.4.3, for a limit that is given"


def _on(hardness: Hardness, scale: str, what: str, of: str) -> float:
    """The number on the scale of a row; raises `UsageError` for another scale."""
    if hardness.scale != scale:
        raise UsageError(
            f"the hardness of {what} wheels is told in {scale}; {hardness} is given",
            where=of,
            remedy=f"give it in {scale}",
        )
    return hardness.value


def _check_range(material: Material, rows: list[BendingRow | ContactRow | None], of: str) -> tuple[Note, ...]:
    """Warnings for a row that the hardness is out of; an error if it is out of all of them."""
    ranged = [row for row in rows if row is not None and row.scale]
    out = [row for row in ranged if not _in_range(material, row, of)]
    if out and len(out) == len(ranged):
        raise UsageError(
            f"a hardness of {material.hardness} is outside the tables: {material.treatment} wheels have "
            f"{_either([*dict.fromkeys(map(_range, out))])}",
            where=of,
            value=material.hardness.value,
            remedy="change the hardness or the treatment, or give contact_limit and bending_limit",
        )
    told = [_out_of_row(material, row, of) for row in out]
    for row in ranged:
        if isinstance(row, BendingRow) and material.row is None and steel_key(material.steel) in row.doubtful:
            designation = latin(steel_key(material.steel))
            text = Phrase(
                "the designation {designation} is doubtful in the print of Table D.4.3", designation=designation
            )
            told.append(Note("warning", text, of))
    return tuple(told)


def _out_of_row(material: Material, row: BendingRow | ContactRow, of: str) -> Note:
    """The hardness against the end of the row that it passes."""
    value = _on(material.hardness, row.scale, material.treatment, of)
    limit = row.low if row.low is not None and value < row.low else row.high
    text = Phrase(
        "a hardness of {hardness} is out of {range} ({source})",
        hardness=material.hardness,
        range=_range(row),
        source=row.source,
    )
    return Note("warning", text, of, value, limit, row.scale, "hardness")


def _either(words: Sequence[str]) -> str:
    return " or ".join(words)


def _in_range(material: Material, row: BendingRow | ContactRow, of: str) -> bool:
    value = _on(material.hardness, row.scale, material.treatment, of)
    return (row.low is None or row.low <= value) and (row.high is None or value <= row.high)


def _range(row: BendingRow | ContactRow) -> str:
    if row.low is None:
        return Phrase("{scale} {high:g} at most", scale=row.scale, high=row.high)
    return (
        Phrase("{scale} {low:g} to {high:g}", scale=row.scale, low=row.low, high=row.high)
        if row.high is not None
        else Phrase("{scale} {low:g} at least", scale=row.scale, low=row.low)
    )
