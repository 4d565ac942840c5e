"""The design game as a table: every option with the lowest mechanism of its own, and which of them buys most."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmmcalc.cams.optimum.results import CamOptimum, Option
from tmmcalc.report.document import Document, Fact, View
from tmmcalc.report.sizes import quantity

NOTHING = 1e-8  # [m] a difference of two least heights that is none


def game_facts(result: CamOptimum) -> Iterator[Fact]:
    """The option that lowers the mechanism most, against what is asked."""
    if not result.options:
        return
    base, best = result.options[0], _best_first(result)[0]
    values: dict[str, Any] = {"option": list(best.changes), "H2_least[m]": best.least}
    if base.refused:
        text = f"{best.name}: least H2 = {quantity(best.least, 'm')}; as asked there is no solution"
        yield Fact("option that buys most", text, values)
        return
    gain = base.least - best.least
    if gain > NOTHING:
        text = (
            f"{best.name}: least H2 = {quantity(best.least, 'm')} against {quantity(base.least, 'm')}, "
            f"{quantity(gain, 'm', 3)} lower"
        )
    else:
        text = f"none of {len(result.options) - 1} options is lower than what is asked"
    yield Fact("option that buys most", text, values | {"gain[m]": gain})


def game_document(result: CamOptimum) -> Document:
    """All options that have a solution, the lowest first; of the others why not."""
    refused = [Fact(each.name, each.refused) for each in result.options if each.refused]
    return Document("design game: options compared", tuple(refused), (), _view(result))


def _best_first(result: CamOptimum) -> list[Option]:
    return sorted((each for each in result.options if not each.refused), key=lambda each: each.least)


def _view(result: CamOptimum) -> View:
    rows, base = _best_first(result), result.options[0]
    lengths = {
        "H2_least[mm]": [each.least for each in rows],
        "gain[mm]": [base.least - each.least for each in rows],
        "H2[mm]": [each.height for each in rows],
        "S0[mm]": [each.start for each in rows],
        "r2[mm]": [each.roller for each in rows],
    }
    if base.refused:
        del lengths["gain[mm]"]
    columns: dict[str, list[Any]] = {
        "option": [each.name for each in rows],
        **{header: [round(1e3 * value, 6) for value in column] for header, column in lengths.items()},
        "active": [" ".join(map(str, each.active)) for each in rows],
        "sigma_H[MPa]": [round(each.stress * 1e-6, 4) for each in rows],
        "R_max[N]": [round(each.contact, 4) for each in rows],
        "T_max[N*m]": [round(each.torque, 6) for each in rows],
        "M_drive[N*m]": [round(each.driving, 6) for each in rows],
        "c[N/mm]": [round(1e-3 * each.stiffness, 6) for each in rows],
        "Q0[N]": [round(each.preload, 4) for each in rows],
    }
    return View(list(columns), list(columns.values()))


def option_values(each: Option) -> dict[str, Any]:
    """One option for programs, in SI."""
    kept = {"option": list(each.changes), "law": each.law, "K1": each.safety, "contact[Pa]": each.allowed}
    said = {key: value for key, value in (kept | {"roller_ratio": each.ratio}).items() if value is not None}
    if each.refused:
        return said | {"refused": each.refused}
    return said | {
        "H2[m]": each.height,
        "S0[m]": each.start,
        "r2[m]": each.roller,
        "H2_least[m]": each.least,
        "active": list(each.active),
        "sigma_H[Pa]": each.stress,
        "R_max[N]": each.contact,
        "T_max[N*m]": each.torque,
        "M_drive_max[N*m]": each.driving,
        "c[N/m]": each.stiffness,
        "Q0[N]": each.preload,
    }
