"""Checks of what a spec is about (a mechanism, a torque diagram, gears, a cam, an arm), and what belongs to each."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline
from tmmcalc.spec.phrases import either

SUBJECTS = (
    "mechanism",
    "synthesis",
    "torque",
    "engine",
    "rotor",
    "train",
    "gearing",
    "pair",
    "cam",
    "indexing",
    "vibrator",
    "pendulum",
    "manipulator",
    "contact",
    "reliability",
    "tie_down",
    "falling_ball",
    "bearing",
)

# Tables that say nothing without a mechanism, and why.
NEEDS_MECHANISM = {
    "loads": "loads act on the links of a mechanism",
    "springs": "springs join the links of a mechanism",
    "drive": "it drives the crank of a mechanism",
    "reduction": "forces and masses are those of a mechanism",
    "balance": "the masses are those of a mechanism",
    "unsteady": "it is the motion of a mechanism",
}
# Tables that a torque diagram serves as well.
NEEDS_MACHINE = {
    "motor": "there is nothing that it drives",
    "transmission": "there is nothing that it drives",
    "shafts": "there is nothing that they drive",
    "motion": "there is nothing that moves",
    "transients": "there is nothing that moves",
    "flywheel": "there is nothing whose speed it evens out",
}
# Tables that say nothing without a gear train, and why.
NEEDS_TRAIN = {
    "strength": "it is that of the wheels of a gear train",
    "criteria": "they choose one of the gear trains",
}
_ARRAYS = ("loads", "springs", "shafts", "transients")


def check_subject(outline: Outline) -> Iterator[Finding]:
    """A spec has a mechanism, or what stands in its place or beside it; a crank's moment has one source."""
    document = outline.document
    if not {*SUBJECTS} & {*document}:
        yield Finding(
            ("mechanism",),
            "missing key: a spec describes a mechanism, or else a linkage to be found, a torque diagram, an engine, "
            "a rotor, gears, cams, a vibratory device, a pendulum-rotor or an arm",
            f"add [mechanism.input], [[mechanism.links]], [[mechanism.joints]]; {either(map(_header, SUBJECTS[1:]))}",
        )
    if "mechanism" in document and "torque" in document:
        yield Finding(
            ("torque",),
            "torque together with mechanism: a torque diagram stands in place of a mechanism",
            "remove one of them; a moment on a link of the mechanism is a load, [[loads]]",
        )


def check_needs(outline: Outline) -> Iterator[Finding]:
    """Tables of a machine, and of a gear train, have one that they belong to."""
    document = outline.document
    for table, why in NEEDS_TRAIN.items():
        if table in document and "train" not in document:
            yield Finding((table,), f"{_header(table)} without [train]: {why}", "add [train], or remove it")
    if "mechanism" in document or not {*SUBJECTS} & {*document}:
        return  # without any subject that is the fault
    for table, why in NEEDS_MECHANISM.items():
        if table in document:
            yield Finding((table,), f"{_header(table)} without [mechanism]: {why}", "add [mechanism], or remove it")
    for table, why in NEEDS_MACHINE.items():
        if table in document and "torque" not in document and not (table == "motor" and "vibrator" in document):
            rule = f"{_header(table)} without [mechanism] or [torque]: {why}"
            yield Finding((table,), rule, "add [mechanism] or [torque], or remove it")


def check_criteria(outline: Outline) -> Iterator[Finding]:
    """Trains are compared by the sizes that strength gives."""
    document = outline.document
    if "criteria" in document and "train" in document and "strength" not in document:
        rule = "[criteria] without [strength]: trains are compared by their sizes"
        yield Finding(("criteria",), rule, "add [strength] with torque and material, or remove it")


def _header(table: str) -> str:
    return f"[[{table}]]" if table in _ARRAYS else f"[{table}]"
