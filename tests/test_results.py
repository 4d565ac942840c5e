"""What stages give out is said once, on the fields of their results, and docs/results.md is made from there."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

from tmmcalc.core.quantity import FORMS
from tmmcalc.rooms import ROOMS

ROOT = Path(__file__).parent.parent
KEY = re.compile(r"[A-Za-z_{][\w{}.']*\[[^\[\], ]+\]")
SAY = {"quantity", "derived", "Quantity"}


def maker() -> Any:
    found = spec_from_file_location("make_results", ROOT / "docs" / "make_results.py")
    assert found is not None
    assert found.loader is not None
    module = module_from_spec(found)
    found.loader.exec_module(module)
    return module


def test_the_page_of_results_is_current() -> None:
    assert (ROOT / "docs" / "results.md").read_text(encoding="utf-8") == maker().page(), "run make docs"


def said_in(tree: ast.AST) -> Iterator[str]:
    """Strings that look like a key with its unit, but those that declare a quantity, docstrings and annotations."""
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        text = ""
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in SAY:
            continue
        if isinstance(node, ast.JoinedStr):
            text = "".join(str(part.value) if isinstance(part, ast.Constant) else "{}" for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            text = node.value
        else:
            types = {id(node.annotation)} if isinstance(node, ast.arg | ast.AnnAssign) else set()
            types |= {id(node.returns)} if isinstance(node, ast.FunctionDef) else set()
            waiting += [part for part in ast.iter_child_nodes(node) if id(part) not in types]
        if KEY.fullmatch(text):
            yield text


def fields_in(tree: ast.AST) -> Iterator[str]:
    """Names of fields and properties that are given out."""
    for node in ast.walk(tree):
        if isinstance(node, ast.AnnAssign) and isinstance(node.value, ast.Call) and isinstance(node.target, ast.Name):
            if getattr(node.value.func, "id", "") == "quantity":
                yield node.target.id
        elif isinstance(node, ast.FunctionDef) and "derived" in ast.dump(ast.Tuple(node.decorator_list, ast.Load())):
            yield node.name


def test_no_room_says_a_key_a_second_time() -> None:
    """Pictures say quantities to people, as axes and labels; a field in a unit for people is asked for by its name."""
    folders = [ROOT / "tmmcalc" / name for name in (*(room.name for room in ROOMS), "report")]
    files = [file for folder in folders for file in sorted(folder.rglob("*.py")) if "pictures" not in file.parts]
    fields, said = set[str](), list[tuple[Path, str]]()
    for file in files:
        tree = ast.parse(file.read_text(encoding="utf-8"))
        fields |= {*fields_in(tree)}
        said += [(file, key) for key in said_in(tree)]
    units = {unit for _, unit in FORMS}

    def asks(key: str) -> bool:
        name, _, unit = key.removesuffix("]").partition("[")
        return unit in units and any(re.fullmatch(name.replace("{}", ".+"), field) for field in fields)

    again = [f"{file.relative_to(ROOT)}: {key}" for file, key in said if not asks(key)]
    assert again == []


def test_every_quantity_says_what_it_is() -> None:
    rows = [line.split("|") for line in maker().page().splitlines() if line.startswith("| `")]
    assert len(rows) > 500
    assert [key for _, key, meaning, *_ in rows if not meaning.strip() or meaning.strip().endswith(".")] == []
