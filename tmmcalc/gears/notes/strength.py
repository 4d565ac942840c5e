"""The strength of the chosen train: torque, permissible stresses and factors with their tables, modules, widths,
stresses beside their limits. Every formula is that of the factor itself (textbook 4.38 to 4.42, table D.4.9)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tmmcalc.gears.details import sized_train
from tmmcalc.gears.letters import LETTER
from tmmcalc.gears.notes.letters import letter, noted, short_train
from tmmcalc.gears.scheme import Layout
from tmmcalc.gears.sizing import GIVEN, REDUCTION, Sized, Torque, rows_of
from tmmcalc.gears.strength.chain import strength_factors
from tmmcalc.gears.strength.endurance import Factor
from tmmcalc.gears.strength.explain import real_width
from tmmcalc.gears.strength.letters import LETTERS
from tmmcalc.gears.strength.series import tied
from tmmcalc.gears.strength.solve import SLACK
from tmmcalc.gears.strength.steels import latin, steel_key
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.formula.digits import RESULT, Given, significant
from tmmcalc.report.language import spoken, tr, tr_name, tr_number, tr_unit
from tmmcalc.report.manuscript import Block, Heading, Lexicon, Paragraph, Place, Result, Table
from tmmcalc.report.telling import lines, named

PRINTED = {"Pa": ("MPa", 1e-6), "m": ("mm", 1e3), "-": ("", 1.0)}  # units of factors as the formulas have them
UNITS = {"T1": "N*m", "T": "N*m", "m": "mm", "d": "mm", "b": "mm", "m_H": "mm", "m_F": "mm", "m_req": "mm"}
UNITS |= {"A_H": "mm", "A_F": "mm"}
OF_WHEEL = ("sigma_Hlim", "sigma_HP", "sigma_Flim^0", "sigma_FP")
SYMBOL = re.compile(r"[A-Za-z]+_\w+(\^\w+)?'*(, )?")  # at the head of a column of a table
RANGE = re.compile(r"(?P<low>[\d.]+) to (?P<high>[\d.]+)")
ENDS = {r"(\w+) (\S+) at most": r"\1 ≤ \2", r"(\w+) (\S+) at least": r"\1 ≥ \2"}
TABLES = "strength_values"


class Own(NamedTuple):
    """A factor with what it belongs to: ``wheels 1, 3``, ``mesh 1–2``; empty where there is one such thing alone."""

    of: str
    factor: Factor


def blocks(order: Order) -> Iterator[Block]:
    """The train that criteria chose; without criteria the first that is strong enough."""
    sized, at, _ = sized_train(order.results)
    one = rows_of(sized.sets, np.array([at]))
    scheme = one.scheme
    told = strength_factors(sized.sets, sized.task, at)
    yield Heading(tr("Strength of the train"), 2)
    yield Paragraph(tr("The strength of this train is calculated: {train}.", train=short_train(one)))
    yield from _torque(sized.torque, one.planets, scheme)
    yield from _materials(sized)
    wheels, stages, meshes = (_of(told.factors, kind) for kind in ("wheel", "stage", "mesh"))
    yield Heading(tr("Permissible stresses and factors"), 3)
    groups = _alike(wheels)
    tab = f"{{tab:{TABLES}}}"
    yield Paragraph(tr("The values of table {tab} are taken from the tables of the textbook.", tab=tab))
    yield _values(groups, stages)
    for symbol in OF_WHEEL:
        yield from _lines(symbol, _owned(groups, symbol))
    real = real_width(sized.task)
    spreads = [block for symbol in ("psi", "K_Hbeta", "K_Fbeta") for block in _lines(symbol, _owned(stages, symbol))]
    yield from () if real else spreads
    yield Heading(tr("Modules and face widths"), 3)
    if real:
        yield Paragraph(tr("The factors $K_{Hβ}$, $K_{Fβ}$ are here those of $psi_{bd}$."))
    yield from _required(meshes, scheme)
    yield from _sizes(sized, stages)
    yield Heading(tr("Stresses"), 3)
    yield from spreads if real else ()
    yield from _stresses(meshes, scheme)
    for symbol in ("m", "b"):
        for own in _owned(stages, symbol):
            place = _owners(own.of, stage=True) if own.of else ""
            yield Result(symbol, Given(1e3 * own.factor.told.value, "mm", _meaning(symbol)), place=place)
    if not told.accepted:
        yield Paragraph(tr("The train is not strong enough."))


def _materials(sized: Sized) -> Iterator[Block]:
    """Steel, treatment and hardness of the wheels."""
    materials = (each for stage in sized.task.stages for each in (stage.pinion, stage.wheel) if each is not None)
    for material in dict.fromkeys(materials):
        told = {"treatment": tr_name(material.treatment), "hardness": str(material.hardness)}
        if not material.steel:
            yield Paragraph(tr("The wheels are {treatment}, of hardness {hardness}.", **told))
            continue
        told["steel"] = steel_word(material.steel)
        yield Paragraph(tr("Wheels of steel {steel}, {treatment}, of hardness {hardness}.", **told))


def steel_word(steel: str) -> str:
    """The designation of a steel in the letters of the language."""
    key = steel_key(steel)
    return key if spoken() == "uk" else latin(key)


def _of(factors: Sequence[Factor], kind: str) -> dict[str, list[Factor]]:
    """The factors of wheels, stages or meshes by what they belong to, without the word for it."""
    found: dict[str, list[Factor]] = {}
    for factor in factors:
        word, _, name = factor.told.of.partition(" ")
        if word == kind:
            found.setdefault(name, []).append(factor)
    return found


def _torque(torque: Torque, planets: int, scheme: Layout) -> Iterator[Block]:
    """The torque on wheel 1, and what it follows from."""
    value = f"$T_1$ = {tr_number(significant(torque.value, RESULT))} {tr_unit('N*m')}"
    if torque.source == GIVEN or torque.moment is None or torque.ratio is None:
        yield Paragraph(tr("The torque on wheel 1 is given: {torque}.", torque=value))
    else:
        said = tr("largest moment on the output shaft of the train, whose losses are not counted")
        if torque.source == REDUCTION:
            said = tr("largest reduced moment of the machine")
        lexicon = named(
            {
                "T_1": Given(torque.value, "N*m", tr("torque on wheel 1")),
                "M_{max}": Given(torque.moment, "N*m", said),
                "u_Σ": Given(torque.ratio, "", tr("speed of wheel 1 over that of the shaft of this moment")),
            }
        )
        yield from lines(["T_1 = M_{max}/u_Σ"], [Place("", lexicon)])
    if planets > 1 and scheme.branched:
        yield Paragraph(tr("The power is shared evenly; the number of branches is $K$ = {count}.", count=planets))


def _alike(wheels: Mapping[str, list[Factor]]) -> dict[str, list[Factor]]:
    """The same with wheels of like factors together."""
    found: dict[tuple[object, ...], list[str]] = {}
    for wheel, factors in wheels.items():
        key = tuple((f.told.symbol, f.told.value, f.told.source, f.row, f.column) for f in factors)
        found.setdefault(key, []).append(wheel)
    return {", ".join(names): wheels[names[0]] for names in found.values()}


def _owned(found: Mapping[str, list[Factor]], symbol: str) -> list[Own]:
    """The factors of one symbol."""
    return [
        Own(name if len(found) > 1 else "", each)
        for name, factors in found.items()
        for each in factors
        if each.told.symbol == symbol
    ]


def _place(of: str, factor: Factor) -> str:
    """What a factor belongs to, as it stands before its line."""
    word = factor.told.of.partition(" ")[0]
    if not of:
        return ""
    if word == "wheel":
        return tr("for wheels {wheels}", wheels=of) if ", " in of else tr("for wheel {wheel}", wheel=of)
    if word == "stage":
        return tr("for stages {stages}", stages=of) if ", " in of else tr("for stage {stage}", stage=of)
    mesh = of.replace("-", "–")
    return tr("for the meshes {meshes}", meshes=mesh) if ", " in of else tr("for the mesh {mesh}", mesh=mesh)


def _lines(symbol: str, owned: Sequence[Own]) -> Iterator[Block]:
    """The formula of one symbol, worked out for all that it is of; where formulas differ each of them."""
    for formula in dict.fromkeys(own.factor.formula for own in owned if own.factor.formula):
        like: dict[tuple[float, ...], list[Own]] = {}
        for own in owned:
            if own.factor.formula == formula:
                like.setdefault(tuple(_numbers(own.factor).values()), []).append(own)
        places = []
        for same in like.values():
            of = _sorted([own.of for own in same]) if len(same) < len(owned) else ""
            places.append(Place(_place(of, same[0].factor), factor_lexicon(symbol, same[0].factor)))
        yield from lines([f"{letter(symbol)} = {noted(formula)}"], places)


def _numbers(factor: Factor) -> dict[str, float]:
    """The letters that stand in a factor's formula."""
    used = LETTER.findall(factor.formula)
    return {name: value for name, value in factor.letters.items() if name in used}


def _sorted(names: Sequence[str]) -> str:
    """Names of wheels, stages or meshes in their order, each name one or several."""
    return ", ".join(sorted({one for name in names for one in name.split(", ")}))


def factor_lexicon(symbol: str, factor: Factor) -> Lexicon:
    """The quantities of a factor's formula."""
    found = {
        letter(name): Given(float(value), UNITS.get(name, "MPa" if name.startswith("sigma") else ""), _meaning(name))
        for name, value in _numbers(factor).items()
    }
    _, scale = PRINTED.get(factor.told.unit, ("", 1.0))
    value = factor.told.value * (scale if factor.formula_unit in ("mm", "MPa") else 1.0)
    found[letter(symbol)] = Given(float(value), factor.formula_unit.replace("N·m", "N*m"), _meaning(symbol))
    return named(found)


def _meaning(name: str) -> str:
    """What a letter of the strength is."""
    if re.fullmatch(r"Z\d'*", name):
        return tr("number of teeth of wheel {wheel}", wheel=name[1:])
    return tr_name(LETTERS.get(name, ""))


def _values(wheels: Mapping[str, list[Factor]], stages: Mapping[str, list[Factor]]) -> Table:
    """What is read from tables or given, with its place."""
    rows = []
    for found in (wheels, stages):
        symbols = dict.fromkeys(factor.told.symbol for factors in found.values() for factor in factors)
        for symbol in symbols:
            same: dict[tuple[str, str], list[str]] = {}
            for name, factors in found.items():
                for factor in factors:
                    if factor.told.symbol == symbol and _is_read(factor):
                        same.setdefault((_value(factor), source_of(factor)), []).append(name)
            for (value, source), names in same.items():
                of = _owners(_sorted(names), stage=found is stages)
                rows.append((f"${letter(symbol)}$", _meaning(symbol), of, value, source))
    head = (tr("Designation"), tr("Quantity"), tr("Of what"), tr("Value"), tr("Source"))
    return Table(tr("Values from tables"), head, tuple(rows), TABLES)


def _owners(names: str, *, stage: bool) -> str:
    """Wheels or stages by their names."""
    if stage:
        return tr("stages {stages}", stages=names) if ", " in names else tr("stage {stage}", stage=names)
    return tr("wheels {wheels}", wheels=names) if ", " in names else tr("wheel {wheel}", wheel=names)


def _is_read(factor: Factor) -> bool:
    """Whether a factor is the cell of a table, or given."""
    return factor.told.symbol not in ("m", "b", "psi*") and (bool(factor.table) or factor.told.source == GIVEN)


def _value(factor: Factor) -> str:
    unit, scale = PRINTED.get(factor.told.unit, (factor.told.unit, 1.0))
    return f"{tr_number(significant(scale * factor.told.value, RESULT))} {tr_unit(unit)}".strip()


def source_of(factor: Factor) -> str:
    """The table, its row and column."""
    if not factor.table:
        return tr("given")
    cells = [*factor.row.partition(": ")[2 if ": " in factor.row else 0].split("; ")]
    cells += SYMBOL.sub("", factor.column, count=1).split("; ") if factor.column else []
    said = "; ".join(_words(cell) for cell in cells if cell)
    return f"{factor.table.replace('D.', tr('D.'))}: {said}"


def _words(cell: str) -> str:
    """One cell of a table in the language in force: as a whole, or word by word of those between commas."""
    if cell.startswith("wear "):
        return tr("no abrasive wear") if cell == "wear none" else tr("abrasive wear")
    whole = tr_name(cell)
    if whole == cell and ", " in cell:
        whole = ", ".join(map(tr_name, cell.split(", ")))
    for found, put in ENDS.items():
        whole = re.sub(found, put, whole)
    if cell.startswith("the largest of "):
        return tr("the largest of {values}", values=tr_number(RANGE.sub(r"\g<low>–\g<high>", cell[15:])))
    return RANGE.sub(r"\g<low>–\g<high>", whole)


def _required(meshes: Mapping[str, list[Factor]], scheme: Layout) -> Iterator[Block]:
    """The modules that contact and bending of each mesh ask for."""
    for symbol in ("u", "q", "T", "A_H"):
        yield from _lines(symbol, _owned(meshes, symbol))
    forms: dict[str, Own] = {}
    for mesh, factors in meshes.items():
        weaker = _weaker(mesh, factors)
        for factor in factors:
            if factor.told.symbol.startswith("Y_F"):
                wheel = factor.told.symbol.partition(" of wheel ")[2] or weaker
                forms.setdefault(wheel, Own(tr("for wheel {wheel}", wheel=wheel), factor))
    external = [forms[wheel] for wheel in sorted(forms) if forms[wheel].factor.formula]
    places = [Place(own.of, factor_lexicon("Y_F", own.factor)) for own in external]
    yield from lines(["Y_F = 3.568 + 201.95/z**2"], places)
    rings = [wheel for wheel, own in forms.items() if not own.factor.formula]
    if rings:
        said = tr_number(significant(forms[rings[0]].factor.told.value, RESULT))
        yield Paragraph(tr("Of the ring {wheel} $Y_F$ = {value}, as of a rack.", wheel=", ".join(rings), value=said))
    weakest: dict[str, list[str]] = {}
    for mesh, factors in meshes.items():
        weakest.setdefault(_weaker(mesh, factors), []).append(mesh.replace("-", "–"))
    for wheel, names in weakest.items():
        yield Paragraph(
            tr(
                "In the meshes {meshes} wheel {wheel} with the larger ratio of $Y_F$ to $sigma_{FP}$ decides.",
                meshes=", ".join(names),
                wheel=wheel,
            )
            if names[1:]
            else tr(
                "In the mesh {mesh} wheel {wheel} with the larger ratio of $Y_F$ to $sigma_{FP}$ decides.",
                mesh=names[0],
                wheel=wheel,
            )
        )
    for symbol in ("A_F", "m_H", "m_F"):
        yield from _lines(symbol, [Own(own.of, _plain(own.factor)) for own in _owned(meshes, symbol)])


def _weaker(mesh: str, factors: Sequence[Factor]) -> str:
    """The wheel of a mesh that decides its bending: the other one has its name in its factors."""
    other = next(f.told.symbol.partition(" of wheel ")[2] for f in factors if f.told.symbol.startswith("Y_F of"))
    return next(wheel for wheel in mesh.split("-") if wheel != other)


def _plain(factor: Factor) -> Factor:
    """A factor whose formula has one number of teeth where the pinion is the least of its stage."""
    if factor.letters.get("Z_1") != factor.letters.get("Z"):
        return factor
    formula = factor.formula.replace("Z_1*Z**2", "Z**3").replace("Z_1*Z", "Z**2")
    return Factor(factor.told, formula=formula, formula_unit=factor.formula_unit, letters=factor.letters)


def _sizes(sized: Sized, stages: Mapping[str, list[Factor]]) -> Iterator[Block]:
    """Standard modules and face widths."""
    task = sized.task
    yield Paragraph(tr("The larger module is required, in a stage of several meshes the largest of theirs."))
    yield from _lines("m_req", _owned(stages, "m_req"))
    for own in _owned(stages, "m"):
        value = f"$m$ = {_value(own.factor)}"
        lead = _place(own.of, own.factor)
        if task.checks:
            said = tr("The module is given: {module}.", module=value)
        elif own.factor.table:
            said = tr("By table {table} the standard module {module} is taken.", table=_number(own), module=value)
        else:
            said = tr("The module {module} is taken.", module=value)
        yield Paragraph(f"{lead[0].upper()}{lead[1:]}: {said[0].lower()}{said[1:]}" if lead else said)
    if tied(sized.sets.scheme) and not task.checks:
        yield Paragraph(tr("The modules keep the proportion that the common axis asks for."))
    yield from _lines("psi*", _owned(stages, "psi*"))
    widths = _owned(stages, "b")
    if any(own.factor.formula.startswith("ceil") for own in widths):
        yield Paragraph(tr("The face width is rounded up to whole millimetres."))
    yield from _lines("b", [Own(own.of, _of_pinion(own.factor)) for own in widths])
    for own in widths:
        if not own.factor.formula:
            yield Paragraph(tr("The face width is given: {width}.", width=f"$b$ = {_value(own.factor)}"))


def _number(own: Own) -> str:
    return own.factor.table.replace("D.", tr("D."))


def _of_pinion(factor: Factor) -> Factor:
    """A width by the teeth of the pinion that it is told of."""
    letters = {"Z" if name == "Z_1" else name: value for name, value in factor.letters.items()}
    formula = factor.formula.replace("Z_1", "Z")
    return Factor(factor.told, formula=formula, formula_unit=factor.formula_unit, letters=letters)


def _stresses(meshes: Mapping[str, list[Factor]], scheme: Layout) -> Iterator[Block]:
    """Stresses of every mesh and wheel, beside the permissible ones."""
    for symbol in ("d", "sigma_H"):
        yield from _lines(symbol, _owned(meshes, symbol))
    bending, limits = [], {}
    for mesh, factors in meshes.items():
        for factor in factors:
            symbol, _, wheel = factor.told.symbol.partition(" of wheel ")
            place = tr("for wheel {wheel} in the mesh {mesh}", wheel=wheel, mesh=mesh.replace("-", "–"))
            if symbol == "sigma_F":
                bending.append((mesh, wheel, Place(place, factor_lexicon("sigma_F", factor))))
            elif symbol == "sigma_FP" and wheel:
                limits[mesh, wheel] = factor.told.value / 1e6
    formula = "K_m**3*T*K_Fbeta*Y_F/(b*m*d)"
    yield from lines([f"sigma_F = {noted(formula)}"], [place for _, _, place in bending])
    found = []
    for mesh, factors in meshes.items():
        symbols = {factor.told.symbol: factor.told.value / 1e6 for factor in factors}
        said = tr("mesh {mesh}", mesh=mesh.replace("-", "–"))
        found.append((said, "sigma_{H}", symbols["sigma_H"], symbols["sigma_HP"]))
    for mesh, wheel, at in bending:
        given = at.lexicon["sigma_F"].value
        assert isinstance(given, float)
        said = tr("wheel {wheel} in the mesh {mesh}", wheel=wheel, mesh=mesh.replace("-", "–"))
        found.append((said, "sigma_{F}", given, limits[mesh, wheel]))
    yield Paragraph(tr("Table {tab} compares the stresses with their limits.", tab="{tab:strength_stresses}"))
    head = (tr("Of what"), tr("Stress, MPa"), tr("Limit, MPa"), tr("Verdict"))
    yield Table(tr("Stresses and their limits"), head, tuple(_row(*each) for each in found), "strength_stresses")
    for said, symbol, value, limit in found:
        yield Result(symbol, Given(value, "MPa", _meaning(symbol.replace("{", "").replace("}", ""))), limit, "<=", said)


def _row(of: str, symbol: str, value: float, limit: float) -> tuple[str, ...]:
    numbers = [tr_number(significant(each, RESULT)) for each in (value, limit)]
    kept = tr("kept") if value <= limit * (1 + SLACK) else tr("not kept")
    return of, f"${symbol}$ = {numbers[0]}", f"${symbol[:-1]}P}}$ = {numbers[1]}", kept
