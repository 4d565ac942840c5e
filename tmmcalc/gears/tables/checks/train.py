"""Checks of ``[train]``: layouts exist and use the keys, their ratio is possible, limits are in order."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction

from tmmcalc.gears.kinds import is_possible, kinds_of, rule, turns_back
from tmmcalc.gears.scheme import Layout, known_layouts
from tmmcalc.spec.choices import Exact
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, is_integer, subtable, word
from tmmcalc.spec.phrases import Path, listing, show
from tmmcalc.spec.units import UnitError
from tmmcalc.spec.values import amount, amounts, check_bare_speed

_NUMBER, _TOLERANCE = Exact("a number", "1"), Exact("a tolerance", "1 %", percent=True)
LARGEST_TERM = 10**12  # of a ratio of modules in whole numbers
FLATTEST, STEEPEST = math.radians(10), math.radians(44)  # of operating pressure angles


def _unfolded(layout: Layout) -> bool:
    return not layout.planetary and not layout.branched


def _tied(layout: Layout) -> bool:
    return layout.branched and layout.stages > 1


# key: which layouts use it, and what the others lack
_USES: dict[str, tuple[Callable[[Layout], bool], str]] = {
    "planets": (lambda layout: layout.branched, "it has neither planets nor parallel layshafts"),
    "module_ratios": (_tied, "no common axis ties the modules of its stages"),
    "modules": (_tied, "no common axis ties the modules of its stages"),
    "module_ratio_range": (_tied, "no common axis ties the modules of its stages"),
    "z_pinion_max": (_unfolded, "only an unfolded train limits its pinions"),
    "ring_min": (lambda layout: bool(layout.rings), "it has no internal wheels"),
    "ring_max": (lambda layout: bool(layout.rings), "it has no internal wheels"),
    "radial": (lambda layout: layout.paired, "its parameters are those of pairs of planets"),
    "constraints.mesh_angle_max": (lambda layout: layout.branched, "it has no common axis"),
    "constraints.assembly": (lambda layout: layout.branched, "it has neither planets nor parallel layshafts"),
    "constraints.adjacency_gap": (lambda layout: layout.branched, "it has neither planets nor parallel layshafts"),
    "constraints.ring_difference": (lambda layout: bool(layout.rings), "it has no internal wheels"),
    "constraints.stage_ratio_max": (lambda layout: not layout.planetary, "its stages are no reducers by themselves"),
    "constraints.diameter_band": (
        lambda layout: _unfolded(layout) or layout.common_axis,
        "it has no wheels 2 and 3 to be compared",
    ),
    "constraints.equal_pinions": (_unfolded, "the pinions of an unfolded train alone can be made equal"),
    "constraints.envelope": (lambda layout: layout.branched, "it has no circle around it"),
}


def useless(layout: Layout) -> list[tuple[str, ...]]:
    """The keys of `[train]` that are of no use to a layout."""
    return [tuple(key.split(".")) for key, (uses, _) in _USES.items() if not uses(layout)]


def _train(outline: Outline) -> Raw:
    return subtable(outline.document, "train")


def written_layouts(train: Raw) -> list[Layout]:
    """The layouts that are known among the written ones."""
    written = train.get("layout")
    keys = [key for key in (written if isinstance(written, list) else [written]) if isinstance(key, str)]
    return [known_layouts()[key] for key in keys if key in known_layouts()]


def exact(value: object, reader: Exact = _NUMBER) -> Fraction | None:
    """The number as it is written; None if it is absent or faulty."""
    try:
        return reader.read(value)
    except UnitError:
        return None


def check_keys(outline: Outline) -> Iterator[Finding]:
    """Every key is one that a layout uses."""
    train = _train(outline)
    layouts = written_layouts(train)
    constraints = subtable(train, "constraints")
    for key, (uses, lack) in _USES.items():
        table, _, name = key.rpartition(".")
        given = constraints if table else train
        if name in given and given[name] is not False and layouts and not any(map(uses, layouts)):
            path = ("train", *key.split("."))
            yield Finding(path, f"{name} is of no use to layout {_keys(layouts)}: {lack}", "remove it")
    if train.get("method") == "textbook":
        yield from _check_programs(layouts, constraints)


def _check_programs(layouts: list[Layout], constraints: Raw) -> Iterator[Finding]:
    from tmmcalc.gears.stepping import PROGRAMS  # late: few ask for them

    without = [layout for layout in layouts if layout.key not in PROGRAMS]
    if without:
        rule = f'method = "textbook": the textbook has no program for layout {_keys(without)}'
        yield Finding(("train", "method"), rule, f"remove method, or the layout; programs are for {listing(PROGRAMS)}")
    if constraints.get("mesh_angle_max", False) is not False:
        rule = 'method = "textbook" knows meshes at their reference centre distance alone'
        yield Finding(("train", "constraints", "mesh_angle_max"), rule, "remove it, or method")


def _keys(layouts: list[Layout]) -> str:
    return listing(layout.key for layout in layouts)


def check_ratio(outline: Outline) -> Iterator[Finding]:
    """The ratio is given once, of a kind that the layout has, and is possible for its layout."""
    train = _train(outline)
    layouts = written_layouts(train)
    speeds = [key for key in ("input_speed", "output_speed") if key in train]
    for key in speeds:
        yield from check_bare_speed(train[key], ("train", key))
    if "ratio" in train and speeds:
        yield Finding(
            ("train", "ratio"), f"ratio together with {' and '.join(speeds)}: they give it", "remove one of them"
        )
        return
    if not speeds and "ratio" not in train and _of_machine(outline.document):
        yield from _check_machine(outline.document, train, layouts)
        return
    if "ratio" not in train and len(speeds) < 2:
        rule = "missing key: a train has its ratio, or the speeds of its input and output"
        more = ", or [motor] beside [mechanism]: its rated speed over the mean speed of the crank is the ratio"
        remedy = 'add ratio = "8.15", or input_speed = "1450 rpm" and output_speed = "178 rpm"'
        yield Finding(("train",), rule, remedy + ("" if speeds else more))
        return
    yield from _check_kind(train, layouts)
    if speeds:
        yield from _check_speeds(train, layouts)
    else:
        yield from _check_possible(train, layouts)


def _of_machine(document: Raw) -> bool:
    """Whether a machine gives the ratio: that of its drive, or of the speeds of motor and crank."""
    drives = "motor" in document or "shafts" in document or "ratio" in subtable(document, "transmission")
    return drives and ("mechanism" in document or "torque" in document)


def _check_machine(document: Raw, train: Raw, layouts: list[Layout]) -> Iterator[Finding]:
    """A ratio of speeds is no ratio of the teeth of a planetary train, nor of a gear that stands between."""
    yield from _check_kind(train, layouts)
    if any(layout.planetary and _kind(train, layout) == "u" for layout in layouts):
        rule = "the ratio of teeth of a planetary train is not the ratio of the speeds of motor and crank"
        yield Finding(("train", "ratio_kind"), rule, 'write "i_1H", or "i_H1" if the carrier drives; or add ratio')
    if "moment_ratio" in subtable(document, "strength") and "open_pair" not in document:
        rule = "moment_ratio beside a train without ratio: what is left of the drive for the train is not known"
        yield Finding(("strength", "moment_ratio"), rule, "add ratio to [train], or remove moment_ratio")


def _check_kind(train: Raw, layouts: list[Layout]) -> Iterator[Finding]:
    kind = train.get("ratio_kind")
    for layout in layouts:
        if kind in ("u", "i_1H", "i_H1", "i_14") and kind not in kinds_of(layout):
            kinds = ", ".join(f'"{each}"' for each in kinds_of(layout))
            yield Finding(("train", "ratio_kind"), f"layout {layout.key} has no ratio {kind}", f"its kinds: {kinds}")


def _kind(train: Raw, layout: Layout) -> str:
    return word(train, "ratio_kind", kinds_of(layout)[0])


def _check_possible(train: Raw, layouts: list[Layout]) -> Iterator[Finding]:
    ratio = exact(train.get("ratio"))
    if not ratio:
        return  # zero has its fault
    for layout in layouts:
        kind = _kind(train, layout)
        if kind in kinds_of(layout) and not is_possible(layout, kind, ratio):
            yield _impossible(("train", "ratio"), show(train["ratio"]), layout, kind)


def _impossible(path: tuple[str, ...], value: str, layout: Layout, kind: str) -> Finding:
    others = [f'"{each}"' for each in kinds_of(layout) if each != kind]
    hint = f" or another ratio_kind: {', '.join(others)};" if others else ""
    return Finding(
        path,
        f"layout {layout.key} cannot have the ratio {value}: {rule(layout, kind)}",
        f"write another ratio,{hint} or choose another layout" if others else "write another ratio or layout",
    )


def _check_speeds(train: Raw, layouts: list[Layout]) -> Iterator[Finding]:
    """Speeds are in a ratio with its sign: fixed axes give the sign, too."""
    first, last = (amount(train.get(key), "angular speed") for key in ("input_speed", "output_speed"))
    if not first or not last:
        return
    for layout in layouts:
        kind = _kind(train, layout)
        if layout.planetary and kind == "u":
            rule = "the ratio of teeth of a planetary train is not the ratio of its speeds"
            yield Finding(("train", "ratio_kind"), rule, 'write "i_1H", or "i_H1" if the carrier drives')
            continue
        back = not layout.planetary and turns_back(layout)
        if not layout.planetary and (first / last < 0) != back:
            way = "against" if back else "the same way as"
            rule = f"the output of layout {layout.key} turns {way} the input: its meshes are external"
            yield Finding(("train", "output_speed"), rule, "change the sign of the speed, or the layout")
        elif not is_possible(layout, kind, Fraction(abs(first / last) if back else first / last)):
            yield _impossible(("train", "output_speed"), f"{first / last:.6g} of its speeds", layout, kind)


def check_tolerance(outline: Outline) -> Iterator[Finding]:
    """The tolerance leaves the sign of the ratio."""
    train = _train(outline)
    tolerance, ratio = exact(train.get("tolerance"), _TOLERANCE), exact(train.get("ratio"))
    if tolerance is None:
        return
    kind = train.get("tolerance_kind", "relative")
    if kind == "relative" and tolerance >= 1:
        rule = f"{show(train['tolerance'])} is 100 % or more of the ratio"
        yield Finding(("train", "tolerance"), rule, 'write "1 %", or tolerance_kind = "absolute"')
    if kind == "absolute" and isinstance(train.get("tolerance"), str) and "%" in train["tolerance"]:
        rule = f'{show(train["tolerance"])} is a relative tolerance, tolerance_kind is "absolute"'
        yield Finding(("train", "tolerance"), rule, 'remove tolerance_kind, or write a number, such as "0.1"')
    elif kind == "absolute" and ratio and tolerance >= abs(ratio):
        rule = f"{show(train['tolerance'])} is as large as the ratio {show(train['ratio'])} itself"
        yield Finding(("train", "tolerance"), rule, "write a smaller one")


def check_limits(outline: Outline) -> Iterator[Finding]:
    """The least number of teeth is not above the largest."""
    train = _train(outline)
    pairs = (("z_min", 17, "z_max", 150), ("z_min", 17, "z_pinion_max", 25), ("ring_min", 40, "ring_max", 350))
    for low, least, high, largest in pairs:
        first, last = train.get(low, least), train.get(high, largest)
        written = low in train or high in train
        unused = high == "z_pinion_max" and not any(map(_unfolded, written_layouts(train)))
        if written and not unused and is_integer(first) and is_integer(last) and first > last:
            key, given = (low, f"{low} = {first}") if low in train else (high, f"{high} = {last}")
            other = f"{high} = {last}" if low in train else f"{low} = {first}"
            yield Finding(("train", key), f"{given} leaves no number of teeth with {other}", "the least comes first")
    span = train.get("module_ratio_range")
    ends = [exact(each) for each in span] if isinstance(span, list) else []
    if len(ends) == 2 and ends[0] is not None and ends[1] is not None and ends[0] > ends[1]:
        yield Finding(("train", "module_ratio_range"), f"{show(span)} runs backwards", "write the smaller ratio first")


def check_teeth(outline: Outline) -> Iterator[Finding]:
    """Given teeth are those of one layout, one number a wheel, within the limits that are written."""
    train = _train(outline)
    teeth, layouts = train.get("teeth"), written_layouts(train)
    if not isinstance(teeth, list) or not layouts:
        return
    path = ("train", "teeth")
    if len(layouts) > 1:
        rule = f"given teeth are those of one layout, not of {_keys(layouts)}"
        yield Finding(path, rule, "keep one layout, or remove teeth")
        return
    wheels, rings = layouts[0].wheels, layouts[0].rings
    if len(teeth) != len(wheels):
        rule = f"{len(teeth)} numbers of teeth: layout {layouts[0].key} has the {len(wheels)} wheels {listing(wheels)}"
        yield Finding(path, rule, "write one number for each of them")
        return
    for index, (wheel, z) in enumerate(zip(wheels, teeth, strict=True)):
        low, high = ("ring_min", "ring_max") if wheel in rings else ("z_min", "z_max")
        for key, sign, where in ((low, 1, "below"), (high, -1, "above")):
            limit = train.get(key)
            if is_integer(z) and is_integer(limit) and sign * z < sign * limit:
                rule = f"wheel {wheel} with {z} teeth is {where} {key} = {limit}"
                yield Finding((*path, index), rule, f"write another number, or change {key}")


def check_modules(outline: Outline) -> Iterator[Finding]:
    """Modules are given in one way; distances need one."""
    train = _train(outline)
    given = [key for key in ("module_ratios", "modules", "module_ratio_range") if key in train]
    if len(given) > 1:
        rule = f"{' and '.join(given)} together: one of them gives the ratios of the modules"
        yield Finding(("train", given[-1]), rule, "keep one of them")
    if "module" in train and "modules" in train:
        yield Finding(("train", "module"), "module together with modules: the first of them is it", "remove it")
    yield from _check_terms(train)
    constraints = subtable(train, "constraints")
    for key in ("centre_distance", "envelope"):
        if constraints.get(key, False) is not False and not {"module", "modules"} & {*train}:
            rule = f"{key} without a module: teeth alone have no size"
            yield Finding(("train", "constraints", key), rule, 'add module = "2 mm" to [train]')
    pair = amounts(constraints.get("centre_distance"), "length")
    if pair is not None and len(pair) == 2 and pair[0] > pair[1]:
        rule = f"{show(constraints['centre_distance'])} runs backwards"
        yield Finding(("train", "constraints", "centre_distance"), rule, "write the smaller distance first")


def _check_terms(train: Raw) -> Iterator[Finding]:
    """Modules are in a ratio of whole numbers that the search, which is exact, can multiply tooth numbers by."""
    ratios, modules = train.get("module_ratios"), amounts(train.get("modules"), "length")
    pairs: list[tuple[Path, object, object]] = [
        (("train", "module_ratios", k), pair, pair) for k, pair in enumerate(ratios if isinstance(ratios, list) else [])
    ]
    if modules is not None:
        pairs.append((("train", "modules"), train["modules"], modules))
    for path, written, pair in pairs:
        terms = [exact(each) for each in pair] if isinstance(pair, list) else []
        if len(terms) != 2 or not terms[0] or not terms[1]:
            continue
        ratio = abs(terms[0] / terms[1])
        if max(ratio.numerator, ratio.denominator) > LARGEST_TERM:
            said = f"{show(written)} is no ratio of whole numbers up to {LARGEST_TERM}"
            yield Finding(path, said, "write the modules with fewer digits, such as [2, 3] or [2.5, 4]")


def check_angles(outline: Outline) -> Iterator[Finding]:
    """Pressure angles are those of gears; meshes are raised above the angle of the rack."""
    train = _train(outline)
    rack = amount(train.get("pressure_angle", math.pi / 9), "angle")
    if rack is not None and not math.radians(10) <= rack <= math.radians(35):
        rule = f"{show(train['pressure_angle'])} is no pressure angle of a rack; it is between 10 and 35 deg"
        yield Finding(("train", "pressure_angle"), rule, 'write "20 deg", for example')
        return
    constraints = subtable(train, "constraints")
    largest = amount(constraints.get("mesh_angle_max"), "angle")
    if largest is not None and rack is not None and not rack <= largest <= STEEPEST:
        said = f"{show(constraints['mesh_angle_max'])} is out of range"
        rule = f"{said}; it is between the angle of the rack, {math.degrees(rack):.6g} deg, and 44 deg"
        yield Finding(("train", "constraints", "mesh_angle_max"), rule, 'write "26 deg", for example')


def check_radial(outline: Outline) -> Iterator[Finding]:
    """t1 and t2 of 2A-AA are given in one way; mesh angles are those of gears."""
    radial = subtable(_train(outline), "radial")
    if "mesh_angles" not in radial:
        return
    path = ("train", "radial", "mesh_angles")
    both = [key for key in ("t1", "t2") if key in radial]
    if both:
        yield Finding(path, f"mesh_angles together with {' and '.join(both)}: they give them", "remove one of them")
    angles = amounts(radial["mesh_angles"], "angle") or []
    if any(not FLATTEST <= angle <= STEEPEST for angle in angles if angle is not None):
        rule = f"{show(radial['mesh_angles'])}: an operating pressure angle is between 10 and 44 deg"
        yield Finding(path, rule, 'write ["22 deg", "21 deg", "20 deg"], for example')


CHECKS = (
    check_keys,
    check_ratio,
    check_tolerance,
    check_limits,
    check_teeth,
    check_modules,
    check_angles,
    check_radial,
)
