"""The room's formulas as the note has them, ``Z2'*m_1`` as ``z_{2'}*m_{1}``; the letters of teeth and speeds."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from tmmcalc.gears.letters import LETTER
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.network.model import Network
from tmmcalc.gears.pictures.words import KINDS, layout_word, teeth_text
from tmmcalc.report.formula.digits import Given
from tmmcalc.report.formula.tree import CONSTANTS, FUNCTIONS
from tmmcalc.report.language import tr, tr_name
from tmmcalc.report.manuscript import Lexicon

TEETH = re.compile(r"Z_?(?P<wheel>.+)")
NOTED = {  # letters of the room that have another form in the note
    "h_a": "h_a^{*}",
    "gap": "c_g",
    "d_min": "Deltaz_{min}",
    "z_pinion_max": "z_{p,max}",
    "ring_min": "z_{r,min}",
    "ring_max": "z_{r,max}",
    "sum_max": "z_{S,max}",
    "i_1H_min": "i_{1H,min}",
    "i_1H_max": "i_{1H,max}",
    "i_H1_min": "i_{H1,min}",
    "i_H1_max": "i_{H1,max}",
    "i_14_min": "i_{14,min}",
    "i_14_max": "i_{14,max}",
    "T1": "T_1",
    "S_F'": "S'_F",
    "S_F''": "S''_F",
    "sigma_Flim^0": "sigma_{Flim}^{0}",
    "psi*": "psi^{*}",
    "psi_low": "psi_{min}",
    "psi_high": "psi_{max}",
    "Z_1": "z_{min}",
    "sigma_Flim0": "sigma_{Flim}^{0}",
    "psi_star": "psi^{*}",
    "K_Hbeta": "K_{Hβ}",
    "K_Fbeta": "K_{Fβ}",
    "m_req": "m_{r}",
    "Z": "z",
    "Z_w": "z_w",
}


def noted(formula: str) -> str:
    """A formula of the room in the letters of the note.

    >>> noted("(Z2*Z3 + Z1*Z2')/(K*gcd(Z2, Z2'))")
    "(z_{2}*z_{3} + z_{1}*z_{2'})/(K*gcd(z_{2}, z_{2'}))"
    """
    return LETTER.sub(lambda found: letter(found[0]), formula)


def letter(name: str) -> str:
    """One letter of the room in the note; names of functions stay."""
    if name in FUNCTIONS or name in CONSTANTS:
        return name
    if name in NOTED:
        return NOTED[name]
    if teeth := TEETH.fullmatch(name):
        return teeth_of(teeth["wheel"])
    base, _, index = name.partition("_")
    return f"{base}_{{{index}}}" if index else base


def teeth_of(wheel: str) -> str:
    """The number of teeth of a wheel."""
    return f"z_{{{wheel}}}"


def joined(names: Sequence[str]) -> str:
    """Names as one index, with a stroke between long ones.

    >>> joined(("2'", "3")), joined(("sun", "planet"))
    ("2'3", 'sun–planet')
    """
    return ("" if all(len(name.rstrip("'")) == 1 for name in names) else "–").join(names)


def lowered(text: str) -> str:
    """A title as it stands within a sentence."""
    return text[0].lower() + text[1:]


def teeth(numbers: Mapping[str, float]) -> Lexicon:
    """The numbers of teeth of wheels."""
    said = {wheel: tr("number of teeth of wheel {wheel}", wheel=wheel) for wheel in numbers}
    return {teeth_of(wheel): Given(float(z), "", said[wheel]) for wheel, z in numbers.items()}


def speed_of(member: str) -> str:
    """The angular velocity of a member."""
    return f"omega_{{{member}}}"


def member_name(network: Network, member: str) -> str:
    """A member in words: a carrier, a wheel; one that the spec names by a word is called so."""
    if any(network.bearer(name) == member for name in network.members):
        return tr("carrier {member}", member=member)
    return tr("wheel {wheel}", wheel=member) if member[0].isdigit() else member


def short_train(sets: ToothSets) -> str:
    """A train by its layout, a planetary one by its designation, and its teeth."""
    scheme = sets.scheme
    word = layout_word(scheme.key) if scheme.planetary else lowered(tr_name(scheme.title))
    return f"{word} {teeth_text(sets.teeth[0].tolist())}"


def asked_ratio(kind: str) -> str:
    """The letter of a ratio as it is asked for, beside that which the numbers of teeth give.

    >>> asked_ratio("i_1H")
    'i_{1H,0}'
    """
    return "U_0" if kind == "u" else f"{KINDS[kind][:-1]},0}}"
