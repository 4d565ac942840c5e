"""Checks of ``[pendulum]``: a rod with one section or stiffness, a disc with one set of inertias, speeds that fit."""

from __future__ import annotations

from collections.abc import Iterator

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.values import amount, amounts, check_bare_speed, first_disorder

_ROD: Path = ("pendulum", "rod")
_WAYS = {"a round section": ("diameter",), "a rectangle": ("width", "thickness"), "a stiffness": ("bending_stiffness",)}
_CARRIED = ("x", "y", "up")
_MOST = 120  # functions of elements that are written
_TWO = ("bending_stiffness", "section_radius"), ("gyration", "diametral_inertia")


def check_rod(outline: Outline) -> Iterator[Finding]:
    """The stiffness of the rod is known in one way, and so is its mass."""
    rod = subtable(outline.document, "pendulum").get("rod")
    if not isinstance(rod, dict):
        return
    begun = {name: keys for name, keys in _WAYS.items() if {*keys} & {*rod}}
    if not begun:
        rule = "missing key: a rod has a section, or its stiffness"
        yield Finding(_ROD, rule, 'add diameter = "12 mm", width and thickness, or bending_stiffness = 210')
    elif len(begun) > 1:
        key = next(key for key in list(begun.values())[1] if key in rod)
        yield Finding((*_ROD, key), f"{' together with '.join(begun)}: the rod has one", "remove one of them")
    for key, other in (("width", "thickness"), ("thickness", "width")):
        if key in rod and other not in rod:
            yield Finding(_ROD, f"missing key: {key} without {other}", f'add {other} = "8 mm"')
    if [*begun] == ["a stiffness"] and "mass" not in rod:
        rule = "missing key: a rod without a section has its mass"
        yield Finding(_ROD, rule, 'add mass = "0.7 kg"')
    yield from _check_bore(rod)


def _check_bore(rod: Raw) -> Iterator[Finding]:
    outer, inner = amount(rod.get("diameter"), "length"), amount(rod.get("bore"), "length")
    if "bore" in rod and "diameter" not in rod:
        yield Finding((*_ROD, "bore"), "bore without diameter", 'add diameter = "16 mm", or remove it')
    elif outer is not None and inner is not None and inner >= outer:
        rule = f"a bore of {show(rod['bore'])} leaves nothing of a rod of {show(rod['diameter'])}"
        yield Finding((*_ROD, "bore"), rule, "write a smaller one")


def check_disc(outline: Outline) -> Iterator[Finding]:
    """The inertias of the disc are those of a thin one, or given."""
    disc = subtable(subtable(outline.document, "pendulum"), "disc")
    given = [key for key in ("diametral_inertia", "polar_inertia") if key in disc]
    if "gyration" in disc and given:
        rule = f"gyration together with {' and '.join(given)}: it is that of a thin disc and gives both"
        yield Finding(("pendulum", "disc", "gyration"), rule, f"remove it, or remove {' and '.join(given)}")
    elif given == ["polar_inertia"]:
        rule = "missing key: polar_inertia without diametral_inertia"
        yield Finding(("pendulum", "disc"), rule, 'add diametral_inertia = "0.01 kg*m^2"')


def check_planes(outline: Outline) -> Iterator[Finding]:
    """A value holds for both planes, or there are two; a rotor with two different planes does not spin."""
    pendulum = subtable(outline.document, "pendulum")
    rod, disc = subtable(pendulum, "rod"), subtable(pendulum, "disc")
    different = False
    for name, table, keys in (("rod", rod, _TWO[0]), ("disc", disc, _TWO[1])):
        for key in keys:
            value = table.get(key)
            if isinstance(value, list):
                different = different or len(value) == 2
                if len(value) > 2:
                    rule = f"{len(value)} values: there are two planes of bending"
                    yield Finding(("pendulum", name, key), rule, "write one value, or one for each plane")
    if "width" in rod and "thickness" in rod:
        b, h = amount(rod["width"], "length"), amount(rod["thickness"], "length")
        different = different or (b is not None and h is not None and b != h)
    for key in ("spin", "speeds"):
        spins = key in pendulum and amount(pendulum[key], "angular speed") != 0
        if different and spins:
            rule = "the rod or disc differs in its two planes: while it spins its equations are not constant"
            yield Finding(("pendulum", key), rule, "remove it, or make the section round")


def check_held(outline: Outline) -> Iterator[Finding]:
    """Gravity or the joint holds the rod; a clamped one does not tilt."""
    pendulum = subtable(outline.document, "pendulum")
    stiffness = pendulum.get("stiffness", 0)
    clamped = stiffness == "clamped"
    free = not clamped and amount(stiffness, "torsional stiffness") == 0
    if free and amount(pendulum.get("gravity", 9.81), "acceleration") == 0:
        rule = "neither gravity nor the joint holds the rod: it turns freely"
        yield Finding(("pendulum", "gravity"), rule, 'write stiffness = "20 N*m/rad" or "clamped", or a gravity')
    swing = subtable(pendulum, "swing")
    if clamped and "tilt" in swing and amount(swing["tilt"], "angle") != 0:
        rule = "a clamped rod does not turn about its joint"
        yield Finding(("pendulum", "swing", "tilt"), rule, 'write deflection = "10 mm" in its place')
    if "degree" in pendulum and "elements" not in pendulum:
        rule = "degree without elements: without them the degree is found"
        yield Finding(("pendulum", "degree"), rule, "remove it, or add elements = 20")
    elements, degree = pendulum.get("elements"), pendulum.get("degree", 3)
    if is_integer(elements) and is_integer(degree) and elements * (degree - 1) > _MOST:
        rule = f"{elements} elements of degree {degree} are {elements * (degree - 1)} functions, more than {_MOST}"
        yield Finding(("pendulum", "elements"), rule, "write fewer, or leave both out: the accuracy is found")


def check_speeds(outline: Outline) -> Iterator[Finding]:
    """The diagram goes upwards; bare speeds are in rad/s."""
    pendulum = subtable(outline.document, "pendulum")
    speeds = subtable(pendulum, "speeds")
    yield from check_bare_speed(pendulum.get("spin"), ("pendulum", "spin"))
    for key in ("from", "to"):
        yield from check_bare_speed(speeds.get(key), ("pendulum", "speeds", key))
    low, high = amount(speeds.get("from", 0), "angular speed"), amount(speeds.get("to"), "angular speed")
    if low is not None and high is not None and low >= high:
        yield Finding(("pendulum", "speeds", "to"), "the diagram ends before it begins", "write a speed above from")


def check_swing(outline: Outline) -> Iterator[Finding]:
    """Something sets the pendulum in motion; a carrier has a speed at each of its times."""
    pendulum = subtable(outline.document, "pendulum")
    swing = pendulum.get("swing")
    if not isinstance(swing, dict):
        return
    path: Path = ("pendulum", "swing")
    shaken = "spin" in pendulum and "eccentricity" in subtable(pendulum, "disc")
    if not {"tilt", "deflection", "push", "carrier"} & {*swing} and not shaken:
        rule = "missing key: nothing sets the pendulum in motion"
        yield Finding(path, rule, 'add tilt = "3 deg", deflection, push or carrier, or spin with an eccentricity')
    carrier = swing.get("carrier")
    if not isinstance(carrier, dict):
        return
    if not {*_CARRIED} & {*carrier}:
        yield Finding(
            (*path, "carrier"), "missing key: a carrier that moves has speeds", 'add x = ["0 m/s", "0.5 m/s"]'
        )
    times = amounts(carrier.get("time"), "time")
    if times is None:
        return
    disorder = first_disorder(times)
    if times and times[0] != 0:
        yield Finding((*path, "carrier", "time", 0), "the times of a carrier begin at 0", "write 0 first")
    if disorder is not None:
        rule = f"{show(carrier['time'][disorder])} does not come after {show(carrier['time'][disorder - 1])}"
        yield Finding((*path, "carrier", "time", disorder), f"{rule}; times ascend", "put them in order")
    for key in _CARRIED:
        values = carrier.get(key)
        if isinstance(values, list) and len(values) != len(times):
            rule = f"{len(values)} speeds for {len(times)} times"
            yield Finding((*path, "carrier", key), rule, "write one for each time")


CHECKS = (check_rod, check_disc, check_planes, check_held, check_speeds, check_swing)
