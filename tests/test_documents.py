"""The reference of the spec names every key that the schema knows."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from runpy import run_path
from typing import Any

from tmmcalc.project.schema import json_schema, schema_text

ROOT = Path(__file__).parent.parent


def keys(node: Any) -> Iterator[str]:
    if isinstance(node, dict):
        yield from node.get("properties", {})
        for value in node.values():
            yield from keys(value)
    elif isinstance(node, list):
        for value in node:
            yield from keys(value)


def test_every_key_is_documented() -> None:
    text = (ROOT / "docs" / "spec.md").read_text()
    spelt = ("`{}`", "[{}", ".{}", "{} = ")
    missing = {key for key in keys(json_schema()) if not any(form.format(key) in text for form in spelt)}
    assert not missing


def test_the_schema_beside_the_configs_is_current() -> None:
    assert (ROOT / "configs" / "tmmcalc.schema.json").read_text() == schema_text(), "run make schema"


def test_the_laws_of_motion_in_the_documents_are_current() -> None:
    text = (ROOT / "docs" / "spec.md").read_text()
    found = run_path(str(ROOT / "docs" / "make_laws.py"))
    assert found["written"](text) == text, "run make laws"
