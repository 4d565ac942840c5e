"""Every number of one train in words: coefficients of its meshes with their sources, its outcome, its warnings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tmmcalc.core.notes import Note, Phrase, listed
from tmmcalc.core.records import record
from tmmcalc.gears.letters import teeth_of
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.strength.basis import Basis, basis_of
from tmmcalc.gears.strength.demand import K_D, K_M, LEAST_TEETH, form_factors
from tmmcalc.gears.strength.endurance import Coefficient, Factor, made
from tmmcalc.gears.strength.loads import MeshLoads, mesh_loads, torque_letters
from tmmcalc.gears.strength.results import Strength
from tmmcalc.gears.strength.series import Outcome
from tmmcalc.gears.strength.solve import NARROWEST, PER_MM, SLACK, WIDEST, solve_strength
from tmmcalc.gears.strength.task import StrengthTask

SPREADS = ("K_Hbeta", "K_Fbeta")


def coefficients(sets: ToothSets, task: StrengthTask, at: int) -> tuple[Coefficient, ...]:
    """All coefficients of train ``at``: of the train, of its wheels, stages and meshes, each with its source."""
    return tuple(each.told for each in factors(sets, task, at))


def factors(sets: ToothSets, task: StrengthTask, at: int) -> tuple[Factor, ...]:
    """The same with the cells of the tables that they are read from, and the formulas of the others."""
    one = ToothSets(
        sets.layout, sets.teeth[at : at + 1], sets.modules[at : at + 1], sets.angles[at : at + 1], sets.planets
    )
    basis = basis_of(one.scheme, task)
    train = (
        Coefficient("train", "T1", task.torque, "N*m", "on wheel 1, of all branches"),
        Coefficient("train", "K", float(sets.planets), "-", "branches that share the power"),
        Coefficient("train", "K_d", K_D, "-", "(4.40), for N*m, MPa and mm"),
        Coefficient("train", "K_m", K_M, "-", "(4.40), for N*m, MPa and mm"),
    )
    loads = mesh_loads(one)
    meshes = (c for k in range(len(one.scheme.meshes)) for c in _mesh(one, task, basis, loads, k))
    return (*map(Factor, train), *_of_real_width(one, task, basis.factors), *meshes)


def real_width(task: StrengthTask) -> bool:
    """Whether the stresses have the K_beta of the real width in place of that of psi_bd."""
    return bool(task.widths) or task.iterate


def _of_real_width(one: ToothSets, task: StrengthTask, told: tuple[Factor, ...]) -> Iterator[Factor]:
    """K_beta as the stresses have it, with the ratio b/d_1 that it follows from."""
    if not real_width(task):
        yield from told
        return
    found = solve_strength(one, task)
    reference = mesh_loads(one).reference
    for factor in told:
        each = factor.told
        k = int(each.of.removeprefix("stage ")) - 1 if each.of.startswith("stage") else 0
        width, module, teeth = (float(values[0, k]) for values in (found.width, found.module, reference))
        psi = width / (module * teeth)
        if each.symbol == "psi_bd":
            text = f"b/d_1 of the real width, {1e3 * width:g} mm / ({1e3 * module:g} mm * {teeth:g})"
            yield replace(factor, told=replace(each, source=f"{each.source}; for the modules that are required"))
            letters = {"b": 1e3 * width, "m": 1e3 * module, "Z_1": teeth}
            yield made(Coefficient(each.of, "psi", psi, "-", text), "b/(m*Z_1)", letters)
        elif each.symbol in SPREADS:
            spread = found.contact_spread if each.symbol == "K_Hbeta" else found.bending_spread
            beta = each.symbol.replace("K_", "beta_")[:6]
            own = replace(each, value=float(spread[0, k]), source=f"1 + {beta} psi, of the real width")
            yield made(own, f"1 + {beta}*psi", {**factor.letters, "psi": psi})
        else:
            yield factor


def _mesh(one: ToothSets, task: StrengthTask, basis: Basis, loads: MeshLoads, k: int) -> Iterator[Factor]:
    mesh = one.scheme.meshes[k]
    of = f"mesh {mesh.first}-{mesh.second}"
    stage = basis.stages[mesh.stage]
    pinion, wheel = (basis.wheels[int(columns[0, k])] for columns in (loads.pinion, loads.wheel))
    names = [one.scheme.wheels[int(columns[0, k])] for columns in (loads.pinion, loads.wheel)]
    name = names[0]
    u, q, sign = float(loads.u[0, k]), float(loads.q[0, k]), "-" if mesh.internal else "+"
    Z, other = (float(one.of(wheel)[0]) for wheel in names)
    sigma_HP = min(pinion.permissible_contact, wheel.permissible_contact)
    at_psi = ", K_beta at psi_bd" if real_width(task) else ""
    K_H, K_F = 1 + stage.beta_contact * stage.psi_bd, 1 + stage.beta_bending * stage.psi_bd
    letters = {"T1": task.torque, "K": float(one.planets), "K_d": K_D, "K_m": K_M, "psi_bd": stage.psi_bd, "u": u}
    letters |= {"Z": Z, "Z_w": other, "q": q, "K_Hbeta": K_H, "K_Fbeta": K_F, "sigma_HP": sigma_HP / 1e6}
    # of the mesh's own pinion, as the textbook tells them, were the width told of it
    share = task.torque / (one.planets * stage.psi_bd)
    A_H = K_D * np.cbrt(share * K_H / (sigma_HP / 1e6) ** 2) / 1000

    def by(symbol: str, value: float, unit: str, source: str, formula: str, formula_unit: str = "") -> Factor:
        return made(Coefficient(of, symbol, value, unit, source), formula, letters, formula_unit)

    yield Factor(Coefficient(of, "Z", Z, "-", f"teeth of the pinion, wheel {name}"))
    yield by("u", u, "-", "teeth of the larger wheel over those of the smaller", "Z_w/Z")
    yield by(f"(u {sign} 1)/u", float(loads.factor[0, k]), "-", "(4.38), (4.39)", f"(u {sign} 1)/u")
    yield _torque(one, loads, k, Coefficient(of, "q", q, "-", "torque on the pinion over T1"))
    yield by("T", task.torque * q / one.planets, "N*m", f"on wheel {name} in one branch", "T1*q/K", "N*m")
    text = f"(4.40): K_d cbrt(T1 K_Hbeta/(K psi_bd sigma_HP^2)){at_psi}"
    yield by("A_H", float(A_H), "m", text, "K_d*(T1*K_Hbeta/(K*psi_bd*sigma_HP**2))**(1/3)", "mm")
    forms = [float(form_factors(one, one.scheme)[0, columns[0, k]]) for columns in (loads.pinion, loads.wheel)]
    limits = [pinion.permissible_bending, wheel.permissible_bending]
    weaker = 0 if forms[0] / limits[0] >= forms[1] / limits[1] else 1
    for own in (weaker, 1 - weaker):
        symbol = "" if own == weaker else f" of wheel {names[own]}"
        which = f"wheel {names[own]}, which {'governs' if own == weaker else 'does not govern'} the bending"
        kind = "3.568 as of a rack" if names[own] in one.scheme.rings else "3.568 + 201.95/Z^2"
        A_F = K_M * np.cbrt(share * K_F / (limits[own] / 1e6)) / 1000
        form = Coefficient(of, f"Y_F{symbol}", forms[own], "-", f"{kind}, of {which}")
        ring = names[own] in one.scheme.rings
        yield Factor(form) if ring else made(form, "3.568 + 201.95/Z**2", {"Z": (Z, other)[own]})
        yield Factor(Coefficient(of, f"sigma_FP{symbol}", limits[own], "Pa", f"of {which}"))
        text = f"(4.40): K_m cbrt(T1 K_Fbeta/(K psi_bd sigma_FP)), of {which}{at_psi}"
        told = Coefficient(of, f"A_F{symbol}", float(A_F), "m", text)
        bending = {**letters, "sigma_FP": limits[own] / 1e6}
        yield made(told, "K_m*(T1*K_Fbeta/(K*psi_bd*sigma_FP))**(1/3)", bending, "mm")


def _torque(one: ToothSets, loads: MeshLoads, k: int, told: Coefficient) -> Factor:
    """The factor q with its formula; it is 1 where the pinion stands on the shaft of wheel 1."""
    scheme = one.scheme
    pinions = [scheme.wheels[int(column)] for column in loads.pinion[0]]
    formula = torque_letters(scheme, pinions)[k]
    if formula == "1":
        return Factor(told)
    letters = {teeth_of(wheel): float(z[0]) for wheel, z in one.by_wheel.items()}
    if scheme.three_centrals:
        numerator, denominator = scheme.tooth_ratio(one.by_wheel)
        letters["i_14"] = float(numerator[0] / denominator[0])
    return made(told, formula, letters)


@record
class Remark:
    """Something to know about one train."""

    of: str  # "train" or the stage
    message: str
    value: float | None = None  # that it is about, and the limit that it is held against
    limit: float | None = None
    unit: str = ""  # of both
    name: str = ""  # of the quantity

    def __str__(self) -> str:
        return f"{self.of}: {self.message}"

    @property
    def note(self) -> Note:
        """It as a warning of a document."""
        return Note("warning", self.message, self.of, self.value, self.limit, self.unit, self.name)


def reason(result: Strength, at: int) -> str:
    """Why train ``at`` is accepted or not, with the modules that are required and those there are."""
    outcome = Outcome(int(result.outcome[at]))
    text = _REASONS[outcome]
    if outcome is Outcome.ACCEPTED:
        return text
    required, there = (_in_mm(values[at]) for values in (result.required, result.module))
    if outcome is Outcome.OVERLOADED and result.checked:
        stages = _stages_overloaded(result, at)
        return listed((Phrase(text, stages=stages), listed([*_causes(result, at)], "; ")), ": ")
    if outcome is Outcome.OVERLOADED:
        stages = _stages_overloaded(result, at)
        return Phrase(
            "{text}: {required} required, {there} there",
            text=Phrase(text, stages=stages),
            required=required,
            there=there,
        )
    if result.checked:
        return Phrase("{text}: {required} required, {there} given", text=text, required=required, there=there)
    return Phrase("{text}: {required} required", text=text, required=required)


_REASONS = {
    Outcome.ACCEPTED: "strong enough",
    Outcome.NO_MODULE: "no standard module is large enough; lower the torque, or take harder steel, more branches",
    Outcome.NO_PAIR: "no standard modules stand in this proportion; take another m1 : m2",
    Outcome.OVERLOADED: "strength of {stages} is not satisfied",
    Outcome.PROPORTION: "the given modules do not stand in the proportion that coaxiality asks for",
}


def _causes(result: Strength, at: int) -> Iterator[str]:
    """What is too small in every overloaded stage: the width, if the module is enough at psi_bd; else the module.

    The share s of the permissible value goes as K_beta/b with K_beta = 1 + beta b/d_1, so it is 1 at the width
    b s/(K_beta - s (K_beta - 1)).
    """
    psi_bd = [each.value for each in result.coefficients if each.symbol == "psi_bd"]
    for k in _overloaded(result, at):
        module, required, width = (float(v[at, k]) for v in (result.module, result.required, result.width))
        if required > module * (1 + SLACK):
            yield Phrase(
                "stage {k} has the module {module:.4g} mm, {required:.4g} mm needed at psi_bd = {psi_bd:.4g}",
                k=k + 1,
                module=1000 * module,
                required=1000 * required,
                psi_bd=psi_bd[k],
            )
            continue
        contact = (1 - float(result.contact_margin[at, k])) ** 2, float(result.contact_spread[at, k])
        bending = 1 - float(result.bending_margin[at, k]), float(result.bending_spread[at, k])
        needed = max(width * share / (K - share * (K - 1)) for share, K in (contact, bending))
        whole = math.ceil(needed * PER_MM * (1 - SLACK))
        yield Phrase(
            "stage {k} has the width {width:.4g} mm, {whole} mm needed at this module",
            k=k + 1,
            width=1000 * width,
            whole=whole,
        )


def _overloaded(result: Strength, at: int) -> list[int]:
    over = np.minimum(result.contact_margin[at], result.bending_margin[at]) < -SLACK
    if not result.checked:
        over = result.module[at] < result.required[at]
    return [int(k) for k in np.flatnonzero(over)]


def _stages_overloaded(result: Strength, at: int) -> str:
    return listed([Phrase("stage {k}", k=k + 1) for k in _overloaded(result, at)], " and ")


def _in_mm(modules: np.ndarray) -> str:
    return ", ".join(f"{1000 * float(module):.4g}" for module in modules) + " mm"


def remarks(result: Strength, at: int) -> tuple[Remark, ...]:
    """Warnings on train ``at``: widths outside the usual, stresses above the limit, few teeth."""
    return tuple(_remarks(result, at))


def _remarks(result: Strength, at: int) -> Iterator[Remark]:
    if result.few_teeth[at]:
        few = Phrase("a wheel has fewer than {least_teeth} teeth, for which Y_F is not known", least_teeth=LEAST_TEETH)
        yield Remark("train", few, int(result.least_teeth[at]), LEAST_TEETH, name="teeth")
    for k in range(result.module.shape[1]):
        of = Phrase("stage {k}", k=k + 1)
        if result.psi_unusual[at, k]:
            yield Remark(of, Phrase("psi* = {psi:.3g} is outside Table D.4.2", psi=result.psi[at, k]))
        if result.width_unusual[at, k]:
            ratio = result.width[at, k] / result.module[at, k]
            text, limit = "b/m = {ratio:.3g} is wide, above {limit:g}", WIDEST
            if ratio < NARROWEST:
                text, limit = "b/m = {ratio:.3g} is narrow, below {limit:g}", NARROWEST
            yield Remark(of, Phrase(text, ratio=ratio, limit=limit), float(ratio), limit, name="b/m")
        for what, margin in (("contact", result.contact_margin), ("bending", result.bending_margin)):
            if margin[at, k] < -1e-9:
                over = -100 * float(margin[at, k])
                text = "the contact stress is {over:.2g} % above the permissible one"
                if what == "bending":
                    text = "the bending stress is {over:.2g} % above the permissible one"
                yield Remark(of, Phrase(text, over=over), over, 0.0, "%", f"{what} stress")
