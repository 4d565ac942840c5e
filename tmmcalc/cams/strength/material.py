"""Allowed contact stress of a cam by the treatment and hardness of its steel, by the tables of gears."""

from __future__ import annotations

from tmmcalc.gears.strength.endurance import Endurance, endurance
from tmmcalc.gears.strength.material import Material, parse_hardness

TREATMENTS = (  # those with a row in D.4.4
    *("annealed", "normalised", "improved"),
    *("surface-hardened", "carburised", "nitrocarburised", "nitrided"),
)
UNBENT = 1.0  # [Pa]: stands for the limit of bending teeth, which a cam has none of


def allowed_contact(treatment: str, hardness: str, failure: str) -> tuple[float, str]:
    """[sigma_H] = sigma_Hlim/S_H [Pa] for long life (D.4.4, D.4.5), and what it is made of.

    Raises `UsageError` for a hardness that the treatment does not give.

    >>> allowed, source = allowed_contact("improved", "300 HB", "ordinary")
    >>> round(allowed / 1e6, 1), source.partition(", ")[0]
    (609.1, 'sigma_Hlim/S_H = 670 MPa/1.1')
    """
    found = contact_endurance(treatment, hardness, failure)
    limit, safety, *_ = found.coefficients
    made = f"sigma_Hlim/S_H = {limit.value / 1e6:g} MPa/{safety.value:g}, {limit.source}, {safety.source}"
    return found.permissible_contact, made


def contact_endurance(treatment: str, hardness: str, failure: str) -> Endurance:
    """The limit of endurance and the safety of a steel with the tables that they are read from; raises as above."""
    steel = Material(treatment, parse_hardness(hardness), failure=failure, bending_limit=UNBENT)
    return endurance(steel, "one-sided", "the cam")
