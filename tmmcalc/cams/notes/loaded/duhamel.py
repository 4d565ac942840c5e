"""The integrals of Duhamel of a phase in closed form: what each end of a piece of the law leaves of free vibration."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import degrees

import numpy as np

from tmmcalc.cams.laws.law import Law
from tmmcalc.cams.response import Share, shares
from tmmcalc.report.formula.digits import Given, significant
from tmmcalc.report.formula.syntax import read
from tmmcalc.report.language import tr, tr_number
from tmmcalc.report.manuscript import Block, Display, Lexicon, Paragraph, Place
from tmmcalc.report.telling import filled, lines, named, tabulated

EQUATION = "w'' + 2*zeta*Omega*w' + Omega**2*w = -s''"
RATES = {"Omega_<p> = omega_0*t_<p>": False, "Omega_d<p> = omega_d*t_<p>": True}  # the second where there is damping
RATIO = "r = n_s/Omega_<p>", "N = (1 - r**2)**2 + (2*zeta*r)**2"
WAVE = (
    "w_{0,i} = -B_s*((1 - r**2)*sin(alpha) - 2*zeta*r*cos(alpha))/(Omega_<p>**2*N)",
    "w_{1,i} = -B_s*n_s*((1 - r**2)*cos(alpha) + 2*zeta*r*sin(alpha))/(Omega_<p>**2*N)",
)
STATE = "u_i = w_{1,i} + zeta*Omega_<p>*w_{0,i}", "v_i = <W>*w_{0,i}"
TURNED = (
    "beta_i = <W>*(1 - k_i)",
    "p_i = <s><E>(u_i*cos(beta_i) - v_i*sin(beta_i))",
    "q_i = <s><E>(u_i*sin(beta_i) + v_i*cos(beta_i))",
)
FADED = "exp(-zeta*Omega_<p>*(1 - k_i))*"
LAST = "p_i = -u_i", "q_i = -v_i"  # at the end of the phase
INTEGRALS = "a_c<p> = <h>*sum(p_i, i)/t_<p>", "a_s<p> = <h>*sum(q_i, i)/t_<p>"
MOST = 12  # ends of pieces whose shares are told
WORKED = 2  # of these are worked out, where the law has more pieces
CLOSE = 1e-11  # of the largest share: what the sum of the shares may differ from the integral


def integrals(
    law: Law, phase: str, damping: float, known: Lexicon, letter: str, *, back: bool, first: bool
) -> Iterator[Block]:
    """The closed form of the integrals a_c, a_s of a phase, ``known`` with its time, the frequencies and the stroke.

    ``first``: the equation is not told yet.

    Nothing where a piece of the law is no polynomial and no harmonic alone, or where shares are so large against their
    sum that it has too few digits: near resonance, and where the phase is a small part of a natural period.
    """
    rate = _value(known, "omega_0") * _value(known, f"t_{phase}")
    found = shares(law, rate, damping, back=back)
    if len(found) > MOST or not _alone(law) or not _close(found, phase, known, letter):
        return
    if first:
        yield from _said()
    scene = known | named(_rates(rate, phase, damping))
    words = {"p": phase, "h": letter, "W": f"Omega_{'d' if damping else ''}{phase}"}
    rates = [text for text, damped in RATES.items() if damping or not damped]
    yield from lines(rates, [Place("", scene)], words)
    whole = len(found) == WORKED
    places = [_place(each, i, scene, whole=whole) for i, each in enumerate(found, 1)]
    shown = places[:WORKED]
    yield from _forced(found, shown, words)
    yield from lines(STATE, shown, words)
    for texts, own in _left(found, shown, damping):
        yield from lines(texts, own, words) if own else ()
    if not whole:
        yield from _table(found, phase)
    sums = named({"p_i": Given([each.left.real for each in found]), "q_i": Given([each.left.imag for each in found])})
    yield from lines(INTEGRALS, [Place("", scene | sums)], words)


def _said() -> Iterator[Block]:
    """The equation of the deflection, and how its free part follows."""
    yield Paragraph(
        tr(
            "By the part $k$ of the phase from its beginning on, in parts of the stroke, the deflection $w$ of the "
            "train obeys the equation"
        )
    )
    yield Display(read(EQUATION))
    yield Paragraph(
        tr(
            "On each piece of the law it has a forced part, which follows from $s''$, and a free one. An end $i$ of a "
            "piece, with the forced deflection $w_{0,i}$ and its derivative $w_{1,i}$, leaves the parts $p_i$, $q_i$ "
            "of the free vibration at the end of the phase; the integrals are their sums."
        )
    )


def _value(known: Lexicon, name: str) -> float:
    value = known[name].value
    assert isinstance(value, float)
    return value


def _alone(law: Law) -> bool:
    """Whether each piece is a polynomial or a harmonic beside a straight line."""
    return not np.any(law.coefficients[:, 2:].any(axis=1) & (law.amplitude != 0))


def _close(found: Sequence[Share], phase: str, known: Lexicon, letter: str) -> bool:
    """Whether the shares add up to the integrals to all digits that are checked."""
    factor = _value(known, letter) / _value(known, f"t_{phase}")
    wanted = complex(_value(known, f"a_c{phase}"), _value(known, f"a_s{phase}"))
    largest = max(abs(each.left) for each in found)
    return abs(factor * sum(each.left for each in found) - wanted) <= CLOSE * factor * largest


def _rates(rate: float, phase: str, damping: float) -> Lexicon:
    return {
        f"Omega_{phase}": Given(rate, "", tr("natural angular frequency times the time of the phase")),
        f"Omega_d{phase}": Given(
            rate * (1 - damping**2) ** 0.5,
            "",
            tr("angular frequency of the damped vibration times the time of the phase"),
        ),
    }


def _place(each: Share, i: int, scene: Lexicon, *, whole: bool) -> Place:
    """An end of a piece with all that stands in its formulas."""
    k = tr_number(significant(each.k, 5))
    name = tr("at k = {value}", value=k) if whole else tr("end {number}, k = {value}", number=i, value=k)
    found = {
        f"w_{{{n},i}}": Given(value, "", tr("derivative of order {number} of the forced deflection by k", number=n))
        for n, value in enumerate(each.forced)
    }
    found["w_{0,i}"] = Given(each.forced[0], "", tr("forced deflection in parts of the stroke"))
    found |= {
        f"s_{{{n},i}}": Given(value, "", tr("derivative of order {number} of the law by k", number=n))
        for n, value in enumerate(each.law, 2)
    }
    found |= {
        "k_i": Given(each.k, "", tr("part of the phase at the end i of a piece")),
        "u_i": Given(each.state.real, "", tr("component of the forced motion")),
        "v_i": Given(each.state.imag, "", tr("component of the forced motion")),
        "beta_i": Given(each.fading.imag, "rad", tr("angle of the free vibration up to the end of the phase")),
        "p_i": Given(each.left.real, "", tr("part of the free vibration at the end of the phase")),
        "q_i": Given(each.left.imag, "", tr("part of the free vibration at the end of the phase")),
        "alpha": Given(degrees(each.angle), "deg", tr("angle of the harmonic of the law")),
    }
    return Place(name, scene | named(found), str(i))


def _forced(found: Sequence[Share], places: Sequence[Place], words: Mapping[str, str]) -> Iterator[Block]:
    """The forced deflection and its derivatives at the ends of the piece with which the phase begins."""
    first = found[0]
    if first.harmonic:
        own = named(_harmonic(first))
        yield Paragraph(tr("The acceleration of the law is there a harmonic, $s'' = B_s*sin(alpha)$:"))
        worked = [place._replace(lexicon=place.lexicon | own) for place in places]
        yield from lines(RATIO, [worked[0]._replace(name="", index="")], words)
        yield from lines(WAVE, worked, words)
        return
    top = len(first.law) - 1
    for n in range(top, -1, -1):
        terms = [f"s_{{{n + 2},i}}"]
        terms += [f"2*zeta*Omega_<p>*w_{{{n + 1},i}}"] * (n < top) + [f"w_{{{n + 2},i}}"] * (n < top - 1)
        right = f"-{terms[0]}" if n == top else f"-({' + '.join(terms)})"
        yield from lines([f"w_{{{n},i}} = {right}/Omega_<p>**2"], places, words)


def _left(
    found: Sequence[Share], places: Sequence[Place], damping: float
) -> Iterator[tuple[Sequence[str], list[Place]]]:
    """The formulas of what ends of pieces leave, with the places at which they hold."""
    ends = list(zip(found, places, strict=False))
    for begins, sign in ((True, ""), (False, "-")):
        words = {"E": FADED if damping else "", "s": sign}
        yield (
            [filled(text, words) for text in TURNED],
            [place for each, place in ends if each.begins == begins and each.k < 1],
        )
    yield LAST, [place for each, place in ends if each.k == 1]


def _harmonic(share: Share) -> Lexicon:
    """The harmonic of a piece."""
    assert share.harmonic is not None
    size, speed, ratio, apart = share.harmonic
    return {
        "B_s": Given(size, "", tr("largest acceleration of the harmonic of the law")),
        "n_s": Given(speed, "", tr("derivative of its angle by k")),
        "r": Given(ratio, "", tr("its frequency over the natural one")),
        "N": Given(apart, "", tr("denominator of the forced vibration")),
    }


def _table(found: Sequence[Share], phase: str) -> Iterator[Block]:
    """All ends of pieces."""
    key = f"cam_shares_{phase}"
    yield Paragraph(tr("All ends of the pieces are in table {tab}.", tab=f"{{tab:{key}}}"))
    columns = {
        "$k_i$": [each.k for each in found],
        "$w_{0,i}$": [each.forced[0] for each in found],
        "$w_{1,i}$": [each.forced[1] for each in found],
        "$p_i$": [each.left.real for each in found],
        "$q_i$": [each.left.imag for each in found],
    }
    labels = [str(i) for i in range(1, len(found) + 1)]
    yield tabulated(tr("Parts of the free vibration"), columns, labels, head="$i$", key=key)
