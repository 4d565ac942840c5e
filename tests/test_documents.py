"""The reference of the spec tells every key that the models have, in their words; the schema in configs is current."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

import pytest

from tmmcalc.project.schema import json_schema, schema_text

ROOT = Path(__file__).parent.parent
PAGE = ROOT / "docs" / "spec.md"


@pytest.fixture(scope="module")
def maker() -> Any:
    found = spec_from_file_location("make_spec", ROOT / "docs" / "make_spec.py")
    assert found is not None
    assert found.loader is not None
    module = module_from_spec(found)
    found.loader.exec_module(module)
    return module


def keys(node: Any) -> Iterator[str]:
    if isinstance(node, dict):
        yield from node.get("properties", {})
        for value in node.values():
            yield from keys(value)
    elif isinstance(node, list):
        for value in node:
            yield from keys(value)


def test_every_key_is_documented() -> None:
    text = PAGE.read_text(encoding="utf-8")
    spelt = ("`{}`", "[{}", ".{}", "{} = ")
    missing = {key for key in keys(json_schema()) if not any(form.format(key) in text for form in spelt)}
    assert not missing


def test_every_key_of_every_table_stands_in_the_reference(maker: Any) -> None:
    text = PAGE.read_text(encoding="utf-8")
    rows = {line.partition(" | ")[0].strip("| ") for line in text.splitlines() if line.startswith("| `")}
    assert maker.known() == maker.shown(text)
    assert {f"`{key}`" for key, _ in maker.known()} <= rows


def test_the_tables_of_the_reference_are_current(maker: Any) -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert maker.page(text) == text, "run make docs"


def test_a_table_that_is_stale_is_made_afresh(maker: Any) -> None:
    stale = "<!-- keys: mechanism (gravity) -->\n| key | meaning |\n|---|---|\n| `gravity` | old |\n<!-- end -->\n"
    fresh = maker.page(stale)
    assert "old" not in fresh
    assert "| `gravity` | 9.81 m/s^2 | Magnitude of the acceleration of free fall;" in fresh
    assert maker.page(fresh) == fresh


def test_a_table_that_is_not_closed_takes_no_prose_with_it(maker: Any) -> None:
    text = "<!-- keys: mechanism -->\nprose\n<!-- keys: mechanism (gravity) -->\n<!-- end -->\n"
    assert maker.page(text).startswith("<!-- keys: mechanism -->\nprose\n")


def test_a_table_that_no_spec_has_is_told(maker: Any) -> None:
    with pytest.raises(LookupError, match=r"keys: mechanism\.gird "):
        maker.page("<!-- keys: mechanism.gird -->\n<!-- end -->\n")


@pytest.mark.parametrize(
    ("asked", "row"),
    [
        ("mechanism (gravity_direction)", "| `gravity_direction` | -90 deg |"),
        ("mechanism.input (joint)", "| `joint` | required |"),
        ("contact (young)", '| `young` | `["206000 MPa", "206000 MPa"]` |'),
        ("cam.limits (convex_radius)", "| `convex_radius` | 2.5 mm |"),
        ("springs (name)", "| `name` | `spring 1` ... | Unique name. |"),
        ("unsteady (from)", "| `from` | position 0 | Where the motion begins:"),
        ("mechanism.joints.revolute, mechanism.joints.prismatic", "| `radius` | revolute | 0 | Radius of the pin. |"),
        ("cam (law limits)", "| `[cam.limits]` |"),
        ("transients (brake)", "| `brake` |"),
    ],
)
def test_a_row_has_the_key_its_default_and_its_meaning(maker: Any, asked: str, row: str) -> None:
    assert f"\n{row}" in maker.page(f"<!-- keys: {asked} -->\n<!-- end -->\n")


def test_the_schema_beside_the_configs_is_current() -> None:
    assert (ROOT / "configs" / "tmmcalc.schema.json").read_text() == schema_text(), "run make schema"
