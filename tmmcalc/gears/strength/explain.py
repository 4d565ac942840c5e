"""Every number of one train in words: coefficients of its meshes with their sources, its outcome, its warnings."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.strength.basis import Basis, basis_of
from tmmcalc.gears.strength.coefficient import Coefficient
from tmmcalc.gears.strength.demand import K_D, K_M, LEAST_TEETH, form_factors
from tmmcalc.gears.strength.loads import MeshLoads, mesh_loads
from tmmcalc.gears.strength.results import Strength
from tmmcalc.gears.strength.series import Outcome
from tmmcalc.gears.strength.solve import NARROWEST, WIDEST
from tmmcalc.gears.strength.task import StrengthTask
from tmmcalc.records import record


def coefficients(sets: ToothSets, task: StrengthTask, at: int) -> tuple[Coefficient, ...]:
    """All coefficients of train ``at``: of the train, of its wheels, stages and meshes, each with its source."""
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
    return (*train, *basis.coefficients, *meshes)


def _mesh(one: ToothSets, task: StrengthTask, basis: Basis, loads: MeshLoads, k: int) -> Iterator[Coefficient]:
    mesh = one.scheme.meshes[k]
    of = f"mesh {mesh.first}-{mesh.second}"
    stage = basis.stages[mesh.stage]
    pinion, wheel = (basis.wheels[int(columns[0, k])] for columns in (loads.pinion, loads.wheel))
    name = one.scheme.wheels[int(loads.pinion[0, k])]
    u, q = float(loads.u[0, k]), float(loads.q[0, k])
    sign = "-" if mesh.internal else "+"
    sigma_HP = min(pinion.permissible_contact, wheel.permissible_contact)
    # of the mesh's own pinion, as the textbook tells them, were the width told of it
    share = task.torque / (one.planets * stage.psi_bd)
    A_H = K_D * np.cbrt(share * (1 + stage.beta_contact * stage.psi_bd) / (sigma_HP / 1e6) ** 2) / 1000
    A_F = K_M * np.cbrt(share * (1 + stage.beta_bending * stage.psi_bd) / (pinion.permissible_bending / 1e6)) / 1000
    form = float(form_factors(one, one.scheme)[0, loads.pinion[0, k]])
    yield Coefficient(of, "Z", float(loads.teeth[0, k]), "-", f"teeth of the pinion, wheel {name}")
    yield Coefficient(of, "u", u, "-", "teeth of the larger wheel over those of the smaller")
    yield Coefficient(of, f"(u {sign} 1)/u", float(loads.factor[0, k]), "-", "(4.38), (4.39)")
    yield Coefficient(of, "q", q, "-", "torque on the pinion over T1")
    yield Coefficient(of, "T", task.torque * q / one.planets, "N*m", f"on wheel {name} in one branch")
    yield Coefficient(of, "Y_F", form, "-", f"3.568 + 201.95/Z^2 of wheel {name}")
    yield Coefficient(of, "A_H", float(A_H), "m", "(4.40): K_d cbrt(T1 K_Hbeta/(K psi_bd sigma_HP^2))")
    yield Coefficient(of, "A_F", float(A_F), "m", "(4.40): K_m cbrt(T1 K_Fbeta/(K psi_bd sigma_FP))")


@record
class Remark:
    """Something to know about one train."""

    of: str  # "train" or the stage
    message: str

    def __str__(self) -> str:
        return f"{self.of}: {self.message}"


def reason(result: Strength, at: int) -> str:
    """Why train ``at`` is accepted or not, with the modules that are required and those there are."""
    outcome = Outcome(int(result.outcome[at]))
    text = _REASONS[outcome]
    if outcome is Outcome.ACCEPTED:
        return text
    required, there = (_in_mm(values[at]) for values in (result.required, result.module))
    if outcome is Outcome.OVERLOADED:
        stages = _stages_overloaded(result, at)
        return f"{text.format(stages=stages)}: {required} required, {there} there"
    return f"{text}: {required} required" + (f", {there} given" if result.checked else "")


_REASONS = {
    Outcome.ACCEPTED: "strong enough",
    Outcome.NO_MODULE: "no standard module is large enough; lower the torque, or take harder steel, more branches",
    Outcome.NO_PAIR: "no standard modules stand in this proportion; take another m1 : m2",
    Outcome.OVERLOADED: "strength of {stages} is not satisfied",
    Outcome.PROPORTION: "the given modules do not stand in the proportion that coaxiality asks for",
}


def _stages_overloaded(result: Strength, at: int) -> str:
    over = np.minimum(result.contact_margin[at], result.bending_margin[at]) < -1e-9
    if not result.checked:
        over = result.module[at] < result.required[at]
    return " and ".join(f"stage {k + 1}" for k in np.flatnonzero(over))


def _in_mm(modules: np.ndarray) -> str:
    return ", ".join(f"{1000 * float(module):.4g}" for module in modules) + " mm"


def remarks(result: Strength, at: int) -> tuple[Remark, ...]:
    """Warnings on train ``at``: widths outside the usual, stresses above the limit, few teeth."""
    return tuple(_remarks(result, at))


def _remarks(result: Strength, at: int) -> Iterator[Remark]:
    if result.few_teeth[at]:
        yield Remark("train", f"a wheel has fewer than {LEAST_TEETH} teeth, for which Y_F is not known")
    for k in range(result.module.shape[1]):
        of = f"stage {k + 1}"
        if result.psi_unusual[at, k]:
            yield Remark(of, f"psi* = {result.psi[at, k]:.3g} is outside Table D.4.2")
        if result.width_unusual[at, k]:
            ratio = result.width[at, k] / result.module[at, k]
            side = f"narrow, below {NARROWEST:g}" if ratio < NARROWEST else f"wide, above {WIDEST:g}"
            yield Remark(of, f"b/m = {ratio:.3g} is {side}")
        for what, margin in (("contact", result.contact_margin), ("bending", result.bending_margin)):
            if margin[at, k] < -1e-9:
                yield Remark(of, f"the {what} stress is {-100 * margin[at, k]:.2g} % above the permissible one")
