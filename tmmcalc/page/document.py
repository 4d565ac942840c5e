"""The page as one file: its style, its scripts and its data within it, and a policy that lets nothing else in."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import Any

WEB = Path(__file__).parent / "web"
MODULES = (  # in this order: each imports from those before it
    "data",
    "words",
    "kept",
    "keys",
    "motion",
    "state",
    "marks",
    "letters",
    "elements",
    "scales",
    "ghosts",
    "labels",
    "layers",
    "naming",
    "drag",
    "scene",
    "drawing",
    "player",
    "readings",
    "formulas",
    "charts",
    "plans",
    "facts",
    "outlines",
    "sketch",
    "field",
    "trials",
    "main",
)
IMPORT = re.compile(r'^import (\{[^}]*\}) from "\./(\w+)\.js";\n', re.MULTILINE)
EXPORT = re.compile(r"^export (const|function|class) (\w+)", re.MULTILINE)


def document(content: Mapping[str, Any]) -> str:
    """The text of the file. What the spec says is data: it stands in no script and no attribute."""
    script, style = joined(), (WEB / "page.css").read_text(encoding="utf-8")
    policy = (
        f"default-src 'none'; base-uri 'none'; form-action 'none'; script-src {_hash(script)}; style-src {_hash(style)}"
    )
    parts = {
        "POLICY": policy,
        "LANGUAGE": str(content["language"]),
        "TITLE": escape(str(content["title"])),
        "STYLE": style,
        "SCRIPT": script,
        "DATA": data_text(content),
    }
    page = (WEB / "page.html").read_text(encoding="utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda found: parts[found[1]], page)


def joined() -> str:
    """All modules as one script, for a file has no others to import: each a function that returns what it exports."""
    return "\n".join(_wrapped(name, (WEB / f"{name}.js").read_text(encoding="utf-8")) for name in MODULES)


def _wrapped(name: str, text: str) -> str:
    exported = ", ".join(found[2] for found in EXPORT.finditer(text))
    body = EXPORT.sub(r"\1 \2", IMPORT.sub(r"const \1 = \2_module;\n", text))
    return f"const {name}_module = (() => {{\n{body}\nreturn {{ {exported} }};\n}})();"


def data_text(content: Mapping[str, Any]) -> str:
    """The data as JSON that ends no element: every < is written by its number."""
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")


def _hash(text: str) -> str:
    digest = hashlib.sha256(text.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode()}'"
