"""``tmmcalc cam synth`` on real files."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from cli.conftest import Cli

SPEC = """
[cam]
follower = "translating"
stroke = "30 mm"
rise = "90 deg"
high_dwell = "30 deg"
return_angle = "60 deg"
law = "cosine"
[cam.limits]
pressure_angle = "30 deg"
pressure_angle_return = "40 deg"
"""


@pytest.fixture(autouse=True)
def spec(folder: Path) -> Path:
    file = folder / "cam.toml"
    file.write_text(SPEC)
    return file


def test_the_corners_of_the_region_are_printed_where_it_is_said(cli: Cli) -> None:
    told = cli("cam", "synth", "cam.toml").out
    found = re.search(r"(\d+) corners[\s\S]*?--format (\w+) prints all", told)
    assert found is not None
    payload = json.dumps(json.loads(cli("cam", "synth", "cam.toml", "--format", found[2]).out))
    corners = re.search(r'"region": ({.*?})', payload)
    assert corners is not None
    assert [len(column) for column in json.loads(corners[1]).values()] == [int(found[1])] * 4
