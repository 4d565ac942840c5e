"""The strength of one train step by step: its factors, the modules and widths that follow, the stresses beside limits.

    m_H = A_H cbrt((u +- 1)/u q/(Z_1 Z^2))       m_F = A_F cbrt(Y_F q/(Z_1 Z))                         (4.38), (4.41)
    sigma_H^2 = K_d^3 T K_Hbeta (u +- 1)/u/(b d^2)       sigma_F = K_m^3 T K_Fbeta Y_F/(b m d)

with Z_1 of the wheel that psi_bd is told of, in the textbook that of the pinion itself, and T on the pinion in one
branch. The last line is the first with psi = b/(m Z_1), so a stress is its factors times each other.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.strength.basis import Basis, basis_of
from tmmcalc.gears.strength.demand import K_D, K_M, form_factors
from tmmcalc.gears.strength.endurance import Coefficient, Factor, NamedFactor, made
from tmmcalc.gears.strength.explain import factors, real_width
from tmmcalc.gears.strength.letters import LETTERS
from tmmcalc.gears.strength.loads import MeshLoads, mesh_loads
from tmmcalc.gears.strength.results import Strength
from tmmcalc.gears.strength.solve import solve_strength
from tmmcalc.gears.strength.tables import StandardModule, table
from tmmcalc.gears.strength.task import StrengthTask

MM, MPA = 1e-3, 1e6
PLACES = {"wheel": "wheel {wheel}", "stage": "stage {stage}", "mesh": "mesh {mesh}"}  # what factors belong to
SAME = 1e-9  # relative difference of a module and its entry in the table


@record
class StrengthFactors:
    """Everything that the strength of one train is made of."""

    layout: str = quantity("layout", "key of the layout")
    planets: int = quantity("planets", "number of planets or layshafts")
    teeth: tuple[int, ...] = quantity("teeth", "numbers of teeth")
    accepted: bool = quantity("accepted", "whether it is strong enough")
    factors: tuple[Factor, ...]

    @property
    def named(self) -> NamedFactors:
        """The same for who asks by name."""
        factors = tuple(_by_name(each.told) for each in self.factors)
        return NamedFactors(self.planets, self.teeth, self.accepted, factors)


def _by_name(told: Coefficient) -> NamedFactor:
    """A coefficient without its source, which may be the number itself in other words."""
    letter, _, wheel = told.symbol.partition(" of wheel ")
    kind, _, which = told.of.partition(" ")
    if wheel:
        place: str = Phrase("wheel {wheel} in the mesh {mesh}", wheel=wheel, mesh=which)
    else:
        place = Phrase(PLACES[kind], **{kind: which}) if which else kind
    unit = told.unit.strip("-")
    return NamedFactor(told.of, told.symbol, unit, LETTERS.get(letter, letter), place, told.value)


@record
class NamedFactors:
    """What the strength of one train is made of, each by what it belongs to and its symbol."""

    planets: int = quantity("planets", "number of planets or layshafts")
    teeth: tuple[int, ...] = quantity("teeth", "numbers of teeth")
    accepted: bool = quantity("accepted", "whether it is strong enough")
    factors: tuple[NamedFactor, ...]


def strength_factors(sets: ToothSets, task: StrengthTask, at: int) -> StrengthFactors:
    """All factors of train ``at``, then modules, widths and stresses of its stages and meshes; raises as the strength.

    Textbook (4.38) to (4.42), Table D.4.9.
    """
    rows = slice(at, at + 1)
    one = ToothSets(sets.layout, sets.teeth[rows], sets.modules[rows], sets.angles[rows], sets.planets)
    chain = _Chain(one, task)
    told = (*factors(sets, task, at), *chain.required(), *chain.sizes(), *chain.stresses())
    return StrengthFactors(sets.layout, sets.planets, tuple(one.teeth[0].tolist()), bool(chain.found.accepted[0]), told)


class _Chain:
    """One train with its strength."""

    def __init__(self, one: ToothSets, task: StrengthTask) -> None:
        self.one, self.task, self.scheme = one, task, one.scheme
        self.basis: Basis = basis_of(self.scheme, task)
        self.loads: MeshLoads = mesh_loads(one)
        self.found: Strength = solve_strength(one, task)
        self.forms = form_factors(one, self.scheme)[0].tolist()

    def _letters(self, k: int) -> dict[str, float]:
        """Numbers of a mesh in N*m, mm and MPa; K_beta as the stresses have it."""
        stage, found = self.scheme.meshes[k].stage, self.found
        module, width = found.module[0, stage] / MM, found.width[0, stage] / MM
        teeth, q = float(self.loads.teeth[0, k]), float(self.loads.q[0, k])
        return {
            "T1": self.task.torque,
            "K": float(self.one.planets),
            "T": self.task.torque * q / self.one.planets,
            "q": q,
            "u": float(self.loads.u[0, k]),
            "Z": teeth,
            "Z_1": float(self.loads.reference[0, stage]),
            "m": float(module),
            "b": float(width),
            "d": float(module) * teeth,
            "K_d": K_D,
            "K_m": K_M,
            "K_Hbeta": float(found.contact_spread[0, stage]),
            "K_Fbeta": float(found.bending_spread[0, stage]),
        }

    def _wheels(self, k: int) -> tuple[tuple[str, float, float, float], ...]:
        """Pinion and wheel of a mesh: name, form factor, permissible contact and bending stress [MPa]."""
        both = [int(columns[0, k]) for columns in (self.loads.pinion, self.loads.wheel)]
        wheels = [self.basis.wheels[column] for column in both]
        limits = [(each.permissible_contact / MPA, each.permissible_bending / MPA) for each in wheels]
        return tuple(
            (self.scheme.wheels[column], self.forms[column], *limit) for column, limit in zip(both, limits, strict=True)
        )

    def _sign(self, k: int) -> str:
        return "-" if self.scheme.meshes[k].internal else "+"

    def required(self) -> Iterator[Factor]:
        """The modules that contact and bending of every mesh ask for, with K_beta at psi_bd."""
        for k, mesh in enumerate(self.scheme.meshes):
            stage, wheels, of = self.basis.stages[mesh.stage], self._wheels(k), f"mesh {mesh.first}-{mesh.second}"
            contact = min(limit for _, _, limit, _ in wheels)
            name, form, _, bending = max(wheels, key=lambda wheel: wheel[1] / wheel[3])
            share = self.task.torque / (self.one.planets * stage.psi_bd)
            letters = self._letters(k) | {
                "A_H": K_D * float(np.cbrt(share * (1 + stage.beta_contact * stage.psi_bd) / contact**2)),
                "A_F": K_M * float(np.cbrt(share * (1 + stage.beta_bending * stage.psi_bd) / bending)),
                "Y_F": form,
            }
            volume = letters["Z_1"] * letters["Z"]
            m_H = letters["A_H"] * np.cbrt(float(self.loads.factor[0, k]) * letters["q"] / (volume * letters["Z"]))
            m_F = letters["A_F"] * np.cbrt(form * letters["q"] / volume)
            told = Coefficient(of, "m_H", MM * float(m_H), "m", "(4.38), (4.39): module by contact")
            yield made(told, f"A_H*((u {self._sign(k)} 1)*q/(u*Z_1*Z**2))**(1/3)", letters, "mm")
            told = Coefficient(of, "m_F", MM * float(m_F), "m", f"(4.41): module by bending of wheel {name}")
            yield made(told, "A_F*(Y_F*q/(Z_1*Z))**(1/3)", letters, "mm")

    def sizes(self) -> Iterator[Factor]:
        """Module and face width of every stage."""
        found, task = self.found, self.task
        for s in range(self.scheme.stages):
            of, m_H, m_F = f"stage {s + 1}", found.contact_module[0, s] / MM, found.bending_module[0, s] / MM
            letters = {"m_H": float(m_H), "m_F": float(m_F), "m_req": float(max(m_H, m_F))}
            letters |= {"m": found.module[0, s] / MM, "b": found.width[0, s] / MM, "psi_star": float(found.psi[0, s])}
            letters |= {"Z_1": float(self.loads.reference[0, s]), "psi_bd": self.basis.stages[s].psi_bd}
            text = f"the larger one of its meshes; {'contact' if m_H >= m_F else 'bending'} governs"
            yield made(Coefficient(of, "m_req", MM * letters["m_req"], "m", text), "max(m_H, m_F)", letters, "mm")
            yield _module(Coefficient(of, "m", float(found.module[0, s]), "m", _whence(task)), letters["m"])
            width = Coefficient(of, "b", float(found.width[0, s]), "m", _rule(task))
            if task.checks:
                formula = "" if task.widths else "psi_bd*m*Z_1"
                yield made(width, formula, letters, "mm" if formula else "")
                continue
            star = Coefficient(of, "psi*", letters["psi_star"], "-", "(4.42)")
            yield Factor(star) if task.iterate else made(star, "psi_bd*(m_req/m)**3", letters)
            used = "m" if task.width_rule == "consistent" else "m_req"
            whole = "ceil(psi_star*{}*Z_1)" if task.rounding == "ceil" else "floor(psi_star*{}*Z_1) + 1"
            yield made(width, whole.format(used), letters, "mm")

    def stresses(self) -> Iterator[Factor]:
        """Contact and bending stresses of every mesh at the module and width of its stage."""
        at = ", K_beta of the real width" if real_width(self.task) else ", K_beta at psi_bd"
        for k, mesh in enumerate(self.scheme.meshes):
            letters, of = self._letters(k), f"mesh {mesh.first}-{mesh.second}"
            f = float(self.loads.factor[0, k])
            yield made(
                Coefficient(of, "d", MM * letters["d"], "m", "reference diameter of the pinion"), "m*Z", letters, "mm"
            )
            force = K_D**3 * letters["T"] * letters["K_Hbeta"] * f
            sigma_H = float(np.sqrt(force / (letters["b"] * letters["d"] ** 2)))
            told = Coefficient(of, "sigma_H", MPA * sigma_H, "Pa", f"contact stress{at}")
            formula = f"(K_d**3*T*K_Hbeta*(u {self._sign(k)} 1)/(u*b*d**2))**(1/2)"
            yield made(told, formula, letters, "MPa")
            limit = min(each for _, _, each, _ in self._wheels(k))
            yield Factor(Coefficient(of, "sigma_HP", MPA * limit, "Pa", "the smaller one of both wheels"))
            for name, form, _, bending in self._wheels(k):
                own = {**letters, "Y_F": form}
                area = letters["b"] * letters["m"] * letters["d"]
                sigma_F = K_M**3 * letters["T"] * letters["K_Fbeta"] * form / area
                told = Coefficient(of, f"sigma_F of wheel {name}", MPA * sigma_F, "Pa", f"bending stress{at}")
                yield made(told, "K_m**3*T*K_Fbeta*Y_F/(b*m*d)", own, "MPa")
                told = Coefficient(of, f"sigma_FP of wheel {name}", MPA * bending, "Pa", "permissible bending stress")
                yield Factor(told)


def _module(told: Coefficient, module: float) -> Factor:
    """A module with its row of D.4.8, if it stands there."""
    entry = next((each for each in table(StandardModule) if abs(each.module_mm - module) <= SAME * module), None)
    if entry is None:
        return Factor(told)
    return Factor(told, "D.4.8", f"{entry.row}", f"{entry.module_mm:g} mm")


def _whence(task: StrengthTask) -> str:
    if task.checks:
        return "given"
    return "the next standard module, of stages with a common axis in their proportion"


def _rule(task: StrengthTask) -> str:
    if task.checks:
        return "given" if task.widths else "of psi_bd"
    return "(4.42): by psi* and the module, in whole millimetres"
