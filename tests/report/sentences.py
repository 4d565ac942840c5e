"""What the rooms say, read from their source: texts of warnings and notes as literals, and as catalogues have them."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import tmmcalc
from tmmcalc.core.notes import LEVELS

ROOT = Path(tmmcalc.__file__).parent
ROOMS = tuple(file.parent.name for file in sorted(ROOT.glob("*/room.py")))
# what makes a sentence: places of its texts among the arguments, and their names
MAKERS = {
    "Phrase": (0,),
    "Note": (1, 2),
    "held": (1,),
    "Grade": (1, 2),
    "Verdict": (1,),
    "Remark": (0, 1),
    "Check": (6,),
}
MAKERS |= {"at_least": (4,), "_told": (2,), "Interference": (2,)}
KEYS = {"text", "place", "message", "why", "note"}
SPEC = re.compile(r"\{(\w+):[^{}]*\}")
LEVEL = re.compile(rf"^(?:{'|'.join(LEVELS)}|\{{degree\}}): ")
WORD = re.compile(r"[A-Za-z]{2,}")
PLACES = re.compile(r"\{\w+\}")
GEAR = re.compile(r"\b(?:gear|wheel) (?:([12])\b|(?=\{))")
Scope = Mapping[str, list[ast.expr]]


def key_of(text: str) -> str:
    """The template of a literal as catalogues have it: numbers without their forms, gears by the names of wheels."""
    names = iter(("wheel", "mate"))
    return GEAR.sub(
        lambda found: f"wheel {{{next(names, '')}}}" if found[1] else "wheel ", LEVEL.sub("", SPEC.sub(r"{\1}", text))
    )


def of_ring(key: str) -> str:
    """The same where there is one wheel, a ring."""
    return re.sub(r"\bwheel \{\w+\}", "the ring", key)


@cache
def sentences() -> dict[str, str]:
    """Every template that has words, with the file that says it."""
    found = {}
    for file, rows in said().items():
        for maker, text in rows:
            if isinstance(text, ast.Constant):
                key = key_of(str(text.value))
                if WORD.search(PLACES.sub("", key)) and (" " in key or maker == "Phrase"):
                    found[key] = file
    return found


@cache
def said() -> dict[str, list[tuple[str, ast.expr]]]:
    """The texts of all sentences by file: who takes the text, a maker or a keyword of it, and the text."""
    found: dict[str, list[tuple[str, ast.expr]]] = {}
    for file in (file for room in ROOMS for file in sorted((ROOT / room).rglob("*.py"))):
        tree = ast.parse(file.read_text(encoding="utf-8"))
        rows = found.setdefault(str(file.relative_to(ROOT)), [])
        outer = scope_of(tree, {}, whole=False)
        rows += [("level", each) for each in ast.walk(tree) if isinstance(each, ast.Constant) and levelled(each.value)]
        for function in (each for each in ast.walk(tree) if isinstance(each, ast.FunctionDef)):
            if calls := [each for each in ast.walk(function) if isinstance(each, ast.Call) and maker_of(each)]:
                scope = scope_of(function, outer)
                rows += [row for call in calls for row in taken(call, scope)]
    return found


def maker_of(call: ast.Call) -> str:
    """What makes a sentence in this call, or nothing."""
    return call.func.id if isinstance(call.func, ast.Name) and call.func.id in MAKERS else ""


def taken(call: ast.Call, scope: Scope) -> Iterator[tuple[str, ast.expr]]:
    """The texts that a call of a maker makes a sentence of."""
    maker = maker_of(call)
    for place in MAKERS[maker]:
        if place < len(call.args):
            yield from ((maker, text) for text in texts(call.args[place], scope))
    for word in call.keywords:
        if maker == "Phrase" or word.arg in KEYS:
            yield from ((f"{maker}.{word.arg}", text) for text in texts(word.value, scope))


def texts(found: ast.expr, scope: Scope, seen: frozenset[str] = frozenset()) -> Iterator[ast.expr]:
    """The constants and f-strings that an expression may be, by the assignments of its function and its module."""
    match found:
        case ast.Constant(str()) | ast.JoinedStr():
            yield found
        case ast.IfExp(_, one, other) | ast.BinOp(one, _, other):
            yield from (each for part in (one, other) for each in texts(part, scope, seen))
        case ast.Dict(values=parts) | ast.Tuple(parts) | ast.List(parts):
            yield from (each for part in parts for each in texts(part, scope, seen))
        case ast.Subscript(value):
            yield from texts(value, scope, seen)
        case ast.Name(name) if name not in seen:
            yield from (each for part in scope.get(name, ()) for each in texts(part, scope, seen | {name}))


def scope_of(node: ast.AST, outer: Scope, whole: bool = True) -> dict[str, list[ast.expr]]:
    """What the names of a function, or of a module, are assigned."""
    found = {name: list(values) for name, values in outer.items()}
    for each in ast.walk(node) if whole else ast.iter_child_nodes(node):
        if isinstance(each, ast.Assign | ast.AnnAssign) and each.value is not None:
            for target in each.targets if isinstance(each, ast.Assign) else [each.target]:
                for name, value in paired(target, each.value):
                    found.setdefault(name, []).append(value)
    return found


def paired(target: ast.expr, value: ast.expr) -> Iterator[tuple[str, ast.expr]]:
    """Names with what an assignment gives them."""
    if isinstance(target, ast.Name):
        yield target.id, value
    elif isinstance(target, ast.Tuple):
        for whole in [value.body, value.orelse] if isinstance(value, ast.IfExp) else [value]:
            if isinstance(whole, ast.Tuple):
                for one, part in zip(target.elts, whole.elts, strict=False):
                    yield from paired(one, part)


def levelled(value: object) -> bool:
    """Whether a constant is a whole note."""
    return isinstance(value, str) and any(value.startswith(f"{level}: ") and len(value) > 15 for level in LEVELS)
