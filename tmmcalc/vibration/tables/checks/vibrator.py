"""Checks of ``[vibrator]``: springs by stiffness or by sizes, an unbalance where something is to be excited."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, subtable
from tmmcalc.spec.phrases import Path, listing
from tmmcalc.spec.values import amount, check_bare_speed

_RODS = {"diameter": '"3 mm"', "length": '"80 mm"'}
_FLATS = {"width": '"12 mm"', "thickness": '"0.8 mm"', "length": '"30 mm"'}
_AXES = {"inertia_axis": '"4e-4 kg*m^2"', "inertia_cross": '"3e-4 kg*m^2"'}
_MOVED = ("x", "y", "phi", "tilt_x", "tilt_y", "z", "gamma")


def check_springs(outline: Outline) -> Iterator[Finding]:
    """Rods and flat springs have stiffnesses or sizes, not both."""
    device = subtable(outline.document, "vibrator")
    rods, flats = device.get("rods"), device.get("flats")
    if isinstance(rods, dict):
        yield from _either(("vibrator", "rods"), rods, ("stiffness",), _RODS, 'stiffness = "19.2 N/mm"')
    if isinstance(flats, dict):
        given = [key for key in ("vertical", "tilt") if key in flats]
        if len(given) == 1:
            return  # the sizes give the other stiffness
        both = 'vertical = "47 N/mm" and tilt = "130 N*m/rad"'
        yield from _either(("vibrator", "flats"), flats, ("vertical", "tilt"), _FLATS, both)


def check_sizes_beside(outline: Outline) -> Iterator[Finding]:
    """A flat spring of which one stiffness is given has the sizes that give the other."""
    flats = subtable(subtable(outline.document, "vibrator"), "flats")
    given = [key for key in ("vertical", "tilt") if key in flats]
    absent = [key for key in _FLATS if key not in flats]
    if len(given) == 1 and absent:
        other = "tilt" if given == ["vertical"] else "vertical"
        rule = f"missing key: {given[0]} alone; {other} is not known without {listing(absent)}"
        yield Finding(("vibrator", "flats"), rule, f"add {other}, or {' and '.join(_written(_FLATS, absent))}")


def check_exciter(outline: Outline) -> Iterator[Finding]:
    """The exciter has its moment of inertia about the vertical, or both that give it."""
    exciter = subtable(outline.document, "vibrator").get("exciter")
    if isinstance(exciter, dict):
        instead = 'inertia_vertical = "3e-4 kg*m^2"'
        yield from _either(("vibrator", "exciter"), exciter, ("inertia_vertical",), _AXES, instead)


def _either(path: Path, table: Raw, direct: tuple[str, ...], sizes: dict[str, str], example: str) -> Iterator[Finding]:
    """A table has the direct keys or all the sizes."""
    given = [key for key in direct if key in table]
    sized = [key for key in sizes if key in table]
    if len(given) == len(direct) and sized:
        rule = f"{sized[0]} together with {' and '.join(given)}: they say the same twice"
        yield Finding((*path, sized[0]), rule, f"remove {' and '.join(sized)}, or {' and '.join(given)}")
    elif not given and len(sized) < len(sizes):
        absent = [key for key in sizes if key not in table]
        rule = f"missing key: {' and '.join(direct)}, or {' and '.join(absent)}"
        yield Finding(path, rule, f"add {example}, or {' and '.join(_written(sizes, absent))}")


def _written(examples: dict[str, str], keys: list[str]) -> list[str]:
    return [f"{key} = {examples[key]}" for key in keys]


def check_damping(outline: Outline) -> Iterator[Finding]:
    """Damping is one ratio for all modes, or a coefficient for each coordinate."""
    damping = subtable(subtable(outline.document, "vibrator"), "damping")
    given = [key for key in _MOVED if key in damping]
    if "ratio" in damping and given:
        rule = f"ratio together with {listing(given)}: the ratio holds for all modes"
        yield Finding(("vibrator", "damping", "ratio"), rule, f"remove it, or remove {listing(given)}")


def check_unbalance(outline: Outline) -> Iterator[Finding]:
    """An unbalance is a mass at a radius or a static moment; what is excited needs one."""
    device = subtable(outline.document, "vibrator")
    unbalance = device.get("unbalance")
    if isinstance(unbalance, dict):
        given = [key for key in ("mass", "radius") if key in unbalance]
        path = ("vibrator", "unbalance")
        if "moment" in unbalance and given:
            rule = f"moment together with {' and '.join(given)}: the moment is mass times radius"
            yield Finding((*path, "moment"), rule, f"remove it, or remove {' and '.join(given)}")
        elif "moment" not in unbalance and len(given) < 2:
            rule = "missing key: an unbalance is a mass at a radius, or a static moment"
            yield Finding(path, rule, 'add mass = "20 g" and radius = "10 mm", or moment = "200 g*mm"')
    elif unbalance is None:
        for part in ("curve", "start", "drive"):
            if part in device:
                rule = f"[vibrator.{part}] without [vibrator.unbalance]: nothing excites the device"
                yield Finding(("vibrator", part), rule, 'add [vibrator.unbalance] with moment = "200 g*mm"')


def check_speeds(outline: Outline) -> Iterator[Finding]:
    """A start runs up to the speed; the curve goes upwards; bare speeds are in rad/s."""
    device = subtable(outline.document, "vibrator")
    if "start" in device and "speed" not in device:
        rule = "missing key: [vibrator.start] runs up to the speed of the steady motion"
        yield Finding(("vibrator",), rule, 'add speed = "1450 rpm"')
    yield from check_bare_speed(device.get("speed"), ("vibrator", "speed"))
    curve = subtable(device, "curve")
    for key in ("from", "to"):
        yield from check_bare_speed(curve.get(key), ("vibrator", "curve", key))
    low, high = (amount(curve.get(key), "angular speed") for key in ("from", "to"))
    if low is not None and high is not None and low >= high:
        yield Finding(("vibrator", "curve", "to"), "the curve ends before it begins", "write a speed above from")


def check_drive(outline: Outline) -> Iterator[Finding]:
    """A start by the motor needs a motor, and a rotor that can speed up."""
    device = subtable(outline.document, "vibrator")
    if "drive" not in device:
        return
    motor, unbalance = outline.document.get("motor"), subtable(device, "unbalance")
    if motor is None:
        rule = "[vibrator.drive] without [motor]: nothing turns the rotor"
        yield Finding(("vibrator", "drive"), rule, 'add [motor] with power = "60 W", speed and synchronous_speed')
    named = isinstance(motor, dict) and ("name" in motor or {"inertia", "flywheel_moment"} & {*motor})
    if "rotor_inertia" not in unbalance and "unbalance" in device and not named:
        rule = "missing key: a rotor that speeds up has its moment of inertia"
        yield Finding(("vibrator", "unbalance"), rule, 'add rotor_inertia = "2e-5 kg*m^2"')


CHECKS = (
    check_springs,
    check_sizes_beside,
    check_exciter,
    check_damping,
    check_unbalance,
    check_speeds,
    check_drive,
)
