"""A page whose content is changed after it was written, to what a run rarely gives."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tmmcalc.page.document import data_text

CONTENT = re.compile(r'(<script type="application/json" id="content">)(.*?)(</script>)', re.DOTALL)


def altered(file: Path, to: Path, change: Callable[[Any], None]) -> Path:
    """The page of a file with its content changed."""
    text = file.read_text(encoding="utf-8")
    found = CONTENT.search(text)
    assert found
    content = json.loads(found[2])
    change(content)
    to.write_text(text[: found.start(2)] + data_text(content) + text[found.end(2) :], encoding="utf-8")
    return to


def stored(content: Any, values: Sequence[float]) -> list[int]:
    """Numbers put behind the block of a content: where they stand."""
    block = np.frombuffer(base64.b64decode(content["block"]), "<f4")
    content["block"] = base64.b64encode(np.append(block, np.array(values, "<f4")).tobytes()).decode()
    return [len(block), len(values)]


def contents(file: Path) -> tuple[Any, Any]:
    """The content of a page and the numbers of its block."""
    found = CONTENT.search(file.read_text(encoding="utf-8"))
    assert found
    content = json.loads(found[2])
    return content, np.frombuffer(base64.b64decode(content["block"]), "<f4")
