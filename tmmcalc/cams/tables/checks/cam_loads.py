"""Checks of loads, spring, guide and requirements in ``[cam]``, and of what is asked of them."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmmcalc.cams.tables.cam_spring import SPRING_KEYS, WIRE_KEYS, spring_method
from tmmcalc.cams.tables.checks.written_cam import A_FOLLOWER, WrittenCam, place, turning_shaft, written_cam
from tmmcalc.core.errors import UsageError
from tmmcalc.linkage.tables.checks.curves import Curve
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, subtable, word
from tmmcalc.spec.phrases import listing
from tmmcalc.spec.units import FULL_TURN
from tmmcalc.spec.values import amount, amounts, first_disorder

TURN = 2 * math.pi
_CONSTANT = ("force", "force_return")
_SPRING = "[cam.spring]"


def check_needs(outline: Outline) -> Iterator[Finding]:
    """Forces need a speed; a spring and requirements need forces."""
    cam = written_cam(outline)
    for part in ("loads", "elastic"):
        if cam.has(part) and not {"speed", "shaft"} & {*cam.table} and not turning_shaft(outline):
            rule = f"[cam.{part}] without speed: inertia forces depend on it"
            yield Finding(place(part), rule, 'add speed = "120 rpm" to [cam]')
    for part, why in (("spring", "it presses against them"), ("requirements", "they are judged by the forces")):
        if cam.has(part) and "loads" not in cam.table:
            yield Finding(place(part), f"[cam.{part}] without [cam.loads]: {why}", f"add [cam.loads] with {_mass(cam)}")
    elastic = cam.part("elastic")
    if cam.has("elastic") and "mass" not in elastic and not _has_mass(cam):
        yield Finding(place("elastic"), "missing key: what swings on the elastic train", f"add {_mass(cam)}")


def _has_mass(cam: WrittenCam) -> bool:
    return bool({"mass", "inertia"} & {*cam.part("loads")})


def _mass(cam: WrittenCam) -> str:
    return 'inertia = "1e-4 kg*m^2"' if cam.kind == "oscillating" else 'mass = "0.2 kg"'


def check_forces(outline: Outline) -> Iterator[Finding]:
    """Something acts on the follower; the technological force is given once."""
    cam = written_cam(outline)
    loads = cam.part("loads")
    if cam.has("loads") and not _has_mass(cam):
        if not {*_CONSTANT, "force_table"} & {*loads}:
            rule = "missing key: nothing acts on the follower"
            yield Finding(place("loads"), rule, f"add {_mass(cam)}, or a force")
        elif "gravity" in loads:
            yield Finding(place("loads", "gravity"), "gravity without mass: nothing is weighed", f"add {_mass(cam)}")
    given = [key for key in _CONSTANT if key in loads]
    if "force_table" in loads and given:
        rule = f"force_table together with {' and '.join(given)}: the table holds the force of the whole turn"
        yield Finding(place("loads", "force_table"), rule, "remove one of them")
    yield from _check_friction(cam)


def _check_friction(cam: WrittenCam) -> Iterator[Finding]:
    """Friction needs the length of the guide, or the radius of the pivot."""
    loads, guide = cam.part("loads"), cam.part("guide")
    if cam.kind == "oscillating":
        for key, other in (("pivot_friction", "pivot_radius"), ("pivot_radius", "pivot_friction")):
            if key in loads and other not in loads:
                example = '"6 mm"' if other == "pivot_radius" else "0.1"
                yield Finding(place("loads", key), f"{key} without {other}", f"add {other} = {example}")
    elif amount(loads.get("friction")) and not {"top", "length"} & {*guide} and not cam.has("optimum"):
        rule = "friction without a guide: the reactions in it depend on its length"
        yield Finding(place("loads", "friction"), rule, 'add [cam.guide] with top = "120 mm", or length')


def check_table(outline: Outline) -> Iterator[Finding]:
    """A table of forces has values that suit the follower, at angles that ascend within a turn."""
    cam = written_cam(outline)
    table = cam.part("loads").get("force_table")
    if not isinstance(table, dict):
        return
    curve = Curve(outline, table, place("loads", "force_table"), "angle")
    values = [key for key in ("force", "moment") if key in table]
    if "file" in table and curve.path not in outline.rows:
        given = [key for key in ("phi", *values) if key in table]
        if given:
            rule = f"file together with {' and '.join(given)}: the file holds all values"
            yield Finding((*curve.path, "file"), rule, f"remove file, or remove {' and '.join(given)}")
    elif not values:
        rule = "missing key: a table of forces has its values"
        yield Finding(curve.path, rule, 'add force = [0, "-150 N", 0], or file = "q.csv"')
    yield from _check_kind(cam, curve, values)
    for key in values[:1]:
        yield from _check_angles(curve, key)


def _check_kind(cam: WrittenCam, curve: Curve, values: list[str]) -> Iterator[Finding]:
    """A force on a stem, a moment on a rocker."""
    if len(values) == 2:
        yield Finding((*curve.path, "moment"), "force and moment together: a table holds one of them", "remove one")
    elif values and cam.kind and (values[0] == "moment") != (cam.kind == "oscillating"):
        needed = "moment" if cam.kind == "oscillating" else "force"
        rule = f"{values[0]} in a table of {A_FOLLOWER[cam.kind]}, on which a {needed} acts"
        yield Finding(curve.place(values[0]), rule, f"write {needed}")


def _check_angles(curve: Curve, key: str) -> Iterator[Finding]:
    phi, values = curve.table.get("phi"), curve.table.get(key)
    if not isinstance(phi, list) or not isinstance(values, list):
        return
    if len(phi) != len(values) > 1 < len(phi):
        yield Finding(curve.place(key), f"{len(values)} values for {len(phi)} angles", "write one for each angle")
        return
    angles, numbers = amounts(phi, "angle"), amounts(values, key)
    if not angles or len(angles) < 2 or not numbers:
        return
    last = len(angles) - 1
    back = first_disorder(angles, jumps=True)
    if back is not None:
        later, before = (f"{_degrees(angles[i])} deg" for i in (back, back - 1))
        rule = f"{curve.at(back)}{later} does not come after {before}; the angles ascend, two equal ones are a jump"
        yield Finding(curve.place("phi", back), rule, "put the values in order")
    elif angles[last] > FULL_TURN:
        rule = f"{curve.at(last)}{_degrees(angles[last])} deg is more than a turn"
        yield Finding(curve.place("phi", last), rule, "count from the start of the rise, 0 to 360 deg")
    elif (
        curve.path not in curve.outline.rows  # tables of a cam jump there where its phases do
        and angles[last] - angles[0] > TURN * (1 - 1e-12)
        and not _close(numbers[0], numbers[last], numbers)
    ):
        rule = f"{curve.at(last)}the values at 0 and at 360 deg differ, and the cam repeats its turn"
        yield Finding(curve.place(key, last), rule, "make the two equal")


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.6g}"


def _close(first: float, last: float, numbers: list[float]) -> bool:
    return abs(first - last) <= 1e-9 * max(map(abs, numbers))


def check_spring(outline: Outline) -> Iterator[Finding]:
    """The keys of a spring belong to the way in which it is found."""
    cam = written_cam(outline)
    spring = cam.part("spring")
    method = word(spring, "method") if "method" in spring else spring_method(spring)
    if method not in SPRING_KEYS:
        return
    for key in (key for other, keys in SPRING_KEYS.items() if other != method for key in keys if key in spring):
        homes = listing(f'"{home}"' for home, keys in SPRING_KEYS.items() if key in keys)
        rule = f'{key} is of no use with method = "{method}"'
        yield Finding(place("spring", key), rule, f"remove it, or write method = {homes}")
    if method == "given" and "stiffness" not in spring:
        rule = "missing key: a given spring has its stiffness"
        dimension = "2 N*m/rad" if cam.kind == "oscillating" else "5 N/mm"
        yield Finding(place("spring"), rule, f'add stiffness = "{dimension}"')
    if method == "safety" and cam.has("spring") and cam.has("loads") and not _has_mass(cam):
        rule = f'{_SPRING} with method = "safety" without a mass: it is sized by the inertia force'
        yield Finding(place("spring"), rule, f'add {_mass(cam)} to [cam.loads], or write method = "given"')
    yield from _check_wire(cam, method)


def _check_wire(cam: WrittenCam, method: str) -> Iterator[Finding]:
    """Wire and coil go together, the wire inside the coil; dead coils are those of springs by the allowed stress."""
    spring = cam.part("spring")
    given = [key for key in WIRE_KEYS if key in spring]
    if cam.kind == "oscillating" or not given:
        return
    if method == "none":
        yield Finding(place("spring", given[0]), f'{given[0]} is of no use with method = "none"', "remove it")
        return
    if "dead_coils" in spring and "shear_stress" not in spring:
        rule = "dead_coils without shear_stress: no spring is sized by it"
        yield Finding(place("spring", "dead_coils"), rule, 'add shear_stress = "500 MPa", or remove it')
    given = [key for key in given if key not in ("shear_stress", "dead_coils")]
    absent = [key for key in ("wire", "coil") if key not in spring]
    if not given or (given == ["shear_modulus"] and "shear_stress" in spring):
        return
    if absent:
        rule = f"{' and '.join(given)} without {' and '.join(absent)}"
        yield Finding(place("spring", given[0]), rule, 'write wire = "2 mm" and coil = "16 mm", or remove it')
        return
    wire, coil = amount(spring["wire"], "length"), amount(spring["coil"], "length")
    if wire is not None and coil is not None and 0 < coil <= wire:
        rule = f"a wire of {wire * 1e3:.6g} mm cannot be coiled to a mean diameter of {coil * 1e3:.6g} mm"
        yield Finding(place("spring", "coil"), rule, "write a larger coil: usual is 4 to 12 times the wire")


def check_guide(outline: Outline) -> Iterator[Finding]:
    """A guide has an upper edge, or a length."""
    guide = written_cam(outline).part("guide")
    if "top" in guide and "length" in guide:
        rule = "length together with top: the lower edge stands right above the follower, and gives the other"
        yield Finding(place("guide", "length"), rule, "remove one of them")


def check_limits(outline: Outline) -> Iterator[Finding]:
    """A tool for concave parts is of use only where there may be some."""
    limits = subtable(written_cam(outline).table, "limits")
    if limits.get("allow_concave") is False and "concave_radius" in limits:
        rule = "concave_radius together with allow_concave = false: no part is concave"
        yield Finding(place("limits", "concave_radius"), rule, "remove one of them")


def check_pin(outline: Outline) -> Iterator[Finding]:
    """A pin that is given goes into a roller that is given."""
    cam = written_cam(outline)
    pin, roller = (
        amount(cam.part("requirements").get("pin"), "length"),
        amount(cam.table.get("roller_radius"), "length"),
    )
    if cam.kind != "flat" and pin and roller and 0 < roller <= pin:
        rule = f"a pin of {pin * 1e3:.6g} mm radius does not fit into a roller of {roller * 1e3:.6g} mm"
        yield Finding(place("requirements", "pin"), rule, f'write less than "{roller * 1e3:.6g} mm"')


def check_material(outline: Outline) -> Iterator[Finding]:
    """The contact stress is given or that of a steel, whose hardness its treatment gives."""
    needs = written_cam(outline).part("requirements")
    steel = subtable(needs, "material")
    if "material" in needs and "contact" in needs:
        yield Finding(place("requirements", "contact"), "contact together with material: it gives it", "remove one")
    treatment, hardness = word(steel, "treatment"), word(steel, "hardness")
    if not treatment or not hardness:
        return
    from tmmcalc.cams.strength.material import TREATMENTS, allowed_contact  # late: few cams are told by their steel

    if treatment not in TREATMENTS:
        return
    try:
        allowed_contact(treatment, hardness, "ordinary")
    except UsageError as fault:
        remedy = "change the hardness or the treatment, or give contact in place of material"
        yield Finding((*place("requirements", "material"), "hardness"), fault.message, remedy)


CHECKS = (check_needs, check_forces, check_table, check_spring, check_guide, check_limits, check_pin, check_material)
