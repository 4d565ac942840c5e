from __future__ import annotations

import json
import math
import re
import tomllib
from collections.abc import Iterator
from typing import Any

from project.scenes import ENGINE, MACHINE, ROTOR, TORQUE
from tmmcalc.project.schema import schema_text


def nodes(node: Any) -> Iterator[dict[str, Any]]:
    if isinstance(node, dict):
        yield node
    for item in node.values() if isinstance(node, dict) else node if isinstance(node, list) else ():
        yield from nodes(item)


def accepts(schema: dict[str, Any], value: Any, root: dict[str, Any]) -> bool:
    """The few keywords that the schema uses."""
    if "$ref" in schema:
        return accepts(root["$defs"][schema["$ref"].rsplit("/", 1)[1]], value, root)
    if "anyOf" in schema or "oneOf" in schema:
        return any(accepts(kind, value, root) for kind in schema.get("anyOf", schema.get("oneOf")))
    if "const" in schema and value != schema["const"]:
        return False
    if "enum" in schema and value not in schema["enum"]:
        return False
    kinds = {
        "object": dict,
        "array": list,
        "string": str,
        "integer": int,
        "number": int | float,
        "boolean": bool,
    }
    if "type" in schema and (
        not isinstance(value, kinds[schema["type"]]) or (value is True and schema["type"] != "boolean")
    ):
        return False
    if isinstance(value, str):
        return re.search(schema.get("pattern", ""), value) is not None
    if isinstance(value, list):
        size = schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value))
        return size and all(accepts(schema["items"], item, root) for item in value)
    if isinstance(value, dict):
        known, patterns = schema.get("properties", {}), schema.get("patternProperties", {})
        parts = {
            key: known.get(key) or next((p for r, p in patterns.items() if re.search(r, key)), None) for key in value
        }
        return (
            all(part is not None and accepts(part, value[key], root) for key, part in parts.items())
            and set(schema.get("required", ())) <= value.keys()
        )
    if not isinstance(value, int | float):
        return True
    low, high = schema.get("minimum", -math.inf), schema.get("maximum", math.inf)
    inside = schema.get("exclusiveMinimum", -math.inf) < value < schema.get("exclusiveMaximum", math.inf)
    return low <= value <= high and inside and ("not" not in schema or value != schema["not"]["const"])


def test_text_is_stable_json(schema: dict[str, Any]) -> None:
    text = schema_text()
    assert json.loads(text) == schema
    assert schema_text() == text
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"


def test_no_keyword_that_editors_or_toml_do_not_know(schema: dict[str, Any]) -> None:
    for node in nodes(schema):
        assert "prefixItems" not in node
        assert node.get("type") != "null"
        assert "discriminator" not in node


def test_every_key_has_a_description(schema: dict[str, Any]) -> None:
    for node in nodes(schema):
        for key, value in node.get("properties", {}).items():
            assert isinstance(value, dict)
            assert value.get("description"), key


def test_tables_are_closed(schema: dict[str, Any]) -> None:
    for node in nodes(schema):
        if node.get("type") == "object":
            assert node["additionalProperties"] is False


def test_shaper_is_accepted(shaper: str, schema: dict[str, Any]) -> None:
    assert accepts(schema, tomllib.loads(shaper), schema)
    for old, new in [
        ('"55 rpm"', '"55 kg"'),
        ("id = 1", "id = 0"),
        ("mass = 55", "mas = 55"),
        ('name = "A"', 'name = "1"'),
    ]:
        assert old in shaper
        assert not accepts(schema, tomllib.loads(shaper.replace(old, new, 1)), schema), new


def test_a_machine_is_accepted(shaper: str, schema: dict[str, Any]) -> None:
    text = shaper + MACHINE
    assert accepts(schema, tomllib.loads(text), schema)
    for old, new in [
        ("factor = 1.2", "factor = -1"),
        ("positions = [2, 12]", "positions = [2, 12.5]"),
        ("positions = [2, 12]", "positions = [2]"),
        ('"1/4"]', '"1/4 N"]'),
        ('viscous = "0.5 N*m*s/rad"', 'viscous = "0.5 N*m"'),
        ('of = "stroke"', 'of = "time"'),
        ("x = [0, 0.1, 1]", "x = [0, 0.1, 1.5]"),
        ('diameter = "80 mm"', "diameter = 0"),
        ("links = [3, 4]", "links = [3]"),
        ('kind = "gear"', 'kind = "belt"'),
        ("overload = 2.2", "overload = 1"),
        ("efficiency = 0.95", "efficiency = 0"),
        ("efficiency = 0.95", "efficency = 1"),
        ('delta = "1/25"', "delta = 1"),
        ("inertia = 12", "inertia = -12"),
    ]:
        assert text.count(old) >= 1, old
        assert not accepts(schema, tomllib.loads(text.replace(old, new)), schema), new


def test_shafts_motions_and_balancing_are_accepted(shaper: str, schema: dict[str, Any]) -> None:
    text = shaper + MACHINE + ENGINE + ROTOR
    assert accepts(schema, tomllib.loads(text), schema)
    for old, new in [
        ('stiffness = "5000 N*m/rad"', 'stiffness = "5000 N*m"'),
        ("behind_gear = true", 'behind_gear = "yes"'),
        ('from = "steady"', 'from = "rest"'),
        ('from = "steady"', 'begin = "steady"'),
        ('motor_on = [["0 s", "2 s"]]', 'motor_on = ["0 s", "2 s"]'),
        ("quiet = true", "quiet = 1"),
        ('to = "8 s"', 'until = "8 s"'),
        ('method = "merson"', 'method = "euler"'),
        ('"lanchester 2"', '"lanchester 3"'),
        ("link = 1, radius", "link = 0, radius"),
        ("order = -1", "order = 1.5"),
        ("cylinders = 4", 'cylinders = "four"'),
        ("cylinders = 4", "cylinders = [4]"),
        ("firing_order = [1, 3, 4, 2]", "firing_order = []"),
        ('grade = "G6.3"', 'grade = "6.3 G"'),
        ('moment = "12 g*mm"', 'moment = "12 g"'),
        ("planes = [", "plains = ["),
    ]:
        assert text.count(old) >= 1, old
        assert not accepts(schema, tomllib.loads(text.replace(old, new)), schema), new
    listed = "[engine]\nspeed = 300\n[[engine.cylinders]]\ncrank_angle = 0\nposition = 0\n"
    assert accepts(schema, tomllib.loads(listed), schema)


def test_a_torque_diagram_is_accepted(schema: dict[str, Any]) -> None:
    head = '[torque]\nspeed = "180 rpm"\n'
    for law in (
        'harmonics = { terms = [{ order = "1/2", cos = 5 }] }',
        'pieces = [["0 deg", "5 N*m"], [1, 2]]',
        'table = { theta = [0, "90 deg"], moment = [1, "2 N*m"], interpolation = "pchip" }',
    ):
        assert accepts(schema, tomllib.loads(head + law), schema), law
    assert accepts(schema, tomllib.loads(TORQUE), schema)
    for law in (
        "formula = 5",
        "pieces = [[0, 1]]",
        "pieces = [[0], [1]]",
        'delays = ["5 s"]',
        "constants = { M0 = [] }",
    ):
        assert not accepts(schema, tomllib.loads(head + law), schema), law


def test_pairs_are_accepted(schema: dict[str, Any]) -> None:
    text = (
        '[pair]\nteeth = [14, 27]\nmodule = "5 mm"\nhelix_angle = "-15 deg"\nrack = "stub 20"\nx1 = 0.5\nx2 = "1/3"\n'
        'angle_range = ["15 deg", 0.5]\nspan_teeth = [3]\npoints = 30\n[[pair.meshes]]\nmesh = "2\'-3"\n'
        'cutter = { teeth = 20, tip_diameter = "80 mm" }\nball_diameters = ["8 mm", 0.009]\n'
    )
    assert accepts(schema, tomllib.loads(text), schema)
    for old, new in [
        ("[14, 27]", "[14, 2]"),
        ("[14, 27]", "[14, 27, 30]"),
        ('"5 mm"', "5"),
        ('"-15 deg"', "-2"),
        ('"stub 20"', '"stub"'),
        ("x1 = 0.5", "x1 = 6"),
        ("0.5]", "0.5, 0.6]"),
        ("[3]", "[]"),
        ("points = 30", "points = 1"),
        ("mesh =", "points = 30\nmesh ="),
        ("teeth = 20, ", ""),
        ("0.009", "9"),
    ]:
        assert old in text
        assert not accepts(schema, tomllib.loads(text.replace(old, new, 1)), schema), new
