"""The name of a quantity taken apart as it is typeset: a letter with an index, an upper index, primes."""

from __future__ import annotations

import re
from typing import NamedTuple

GREEK = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "delta": "δ",
    "eps": "ε",
    "zeta": "ζ",
    "eta": "η",
    "theta": "θ",
    "vartheta": "ϑ",
    "kappa": "κ",
    "lambda": "λ",
    "mu": "μ",
    "nu": "ν",
    "xi": "ξ",
    "pi": "π",
    "rho": "ρ",
    "sigma": "σ",
    "tau": "τ",
    "phi": "φ",
    "chi": "χ",
    "psi": "ψ",
    "omega": "ω",
    "Gamma": "Γ",
    "Delta": "Δ",
    "Theta": "Θ",
    "Lambda": "Λ",
    "Sigma": "Σ",
    "Phi": "Φ",
    "Psi": "Ψ",
    "Omega": "Ω",
}
LETTER = re.compile(rf"(?<![^\W_])(?:{'|'.join(GREEK)})(?![a-z])")  # its name within a sentence
NAME = re.compile(r"(?P<base>[A-Za-z]+)(?P<primes>'*)(?:_(?:\{(?P<index>[^{}]*)\}|(?P<sub>\w+)))?"
                  r"(?:\^(?:\{(?P<upper>[^{}]*)\}|(?P<sup>[A-Za-z]+)))?")  # fmt: skip


BRACES = re.compile(r"(_)\{(\w+)\}|(\^)\{([A-Za-z]+)\}")


class Symbol(NamedTuple):
    """``a_{BA}^n``: base ``a``, index ``BA``, upper index ``n``. A base of several letters is a word or Greek."""

    base: str
    lower: str = ""
    upper: str = ""
    primes: int = 0


def symbol_of(key: str) -> Symbol:
    """The parts of a name.

    >>> symbol_of("phi_3"), symbol_of("S''"), symbol_of("a_{BA}^n")
    (Symbol(base='φ', lower='3', upper='', primes=0), Symbol(base='S', lower='', upper='', primes=2), \
Symbol(base='a', lower='BA', upper='n', primes=0))
    """
    found = NAME.fullmatch(key)
    if found is None:
        raise ValueError(f"{key!r} is no name of a quantity")
    base = _letters(found["base"])
    index = found["index"] if found["index"] is not None else found["sub"] or ""
    upper = found["upper"] if found["upper"] is not None else found["sup"] or ""
    return Symbol(base, _words(index), _words(upper), len(found["primes"]))


def with_letters(sentence: str) -> str:
    """A sentence in which Greek letters stand for their names.

    >>> with_letters("eps_alpha is below 1.2 at phi = 0, delta_0 of the alphabet")
    'ε_α is below 1.2 at φ = 0, δ_0 of the alphabet'
    """
    return LETTER.sub(lambda name: GREEK[name[0]], sentence)


def canonical(key: str) -> str:
    """The one way in which a name is written: without braces where it needs none.

    >>> canonical("M_{4}^{D}"), canonical("l_{BA}"), canonical("N_{10,9}")
    ('M_4^D', 'l_BA', 'N_{10,9}')
    """
    return BRACES.sub(lambda found: (found[1] or found[3]) + (found[2] or found[4]), key)


def _letters(base: str) -> str:
    """A Greek letter of its name, also after Delta: ``Deltaphi``."""
    if base in GREEK:
        return GREEK[base]
    if base.startswith("Delta"):
        return "Δ" + _letters(base.removeprefix("Delta"))
    return base


def _words(index: str) -> str:
    """An index with Greek letters for names that stand alone in it."""
    return re.sub(r"[A-Za-z]+", lambda word: GREEK.get(word[0], word[0]), index)
