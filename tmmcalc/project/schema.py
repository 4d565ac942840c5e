"""The JSON Schema of a spec, for editors: completion, descriptions and faults while typing."""

from __future__ import annotations

import json
from typing import Any

from tmmcalc.project.root import Spec

DIALECT = "https://json-schema.org/draft/2020-12/schema"


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of the spec."""
    schema = _plain(Spec.model_json_schema())
    return {
        "$schema": DIALECT,
        "title": "tmmcalc project spec",
        **{k: v for k, v in schema.items() if k != "title"},
    }


def schema_text() -> str:
    """Return the schema as stable text: equal models give equal bytes."""
    return json.dumps(json_schema(), indent=2, ensure_ascii=False) + "\n"


def _plain(node: Any) -> Any:
    """Return a schema node without what TOML cannot hold (null) and what repeats the key (titles)."""
    if isinstance(node, list):
        return [_plain(item) for item in node]
    if not isinstance(node, dict):
        return node
    kept = {key: _plain(value) for key, value in node.items() if not _is_noise(key, value)}
    if "patternProperties" in kept:
        kept.setdefault("additionalProperties", False)
        kept.pop("propertyNames", None)
    return _without_null(kept)


def _is_noise(key: str, value: Any) -> bool:
    return (key == "title" and isinstance(value, str)) or key == "discriminator" or (key == "default" and value is None)


def _without_null(node: dict[str, Any]) -> dict[str, Any]:
    """Unwrap ``anyOf [kind, null]``: a key that may be absent is just not required."""
    kinds = node.get("anyOf")
    if not isinstance(kinds, list) or {"type": "null"} not in kinds:
        return node
    kinds = [kind for kind in kinds if kind != {"type": "null"}]
    rest = {key: value for key, value in node.items() if key != "anyOf"}
    return {**kinds[0], **rest} if len(kinds) == 1 else {"anyOf": kinds, **rest}
