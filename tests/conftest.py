"""What all tests share: examples of properties, the collector of cyclic garbage, one spec and the faults of a text."""

from __future__ import annotations

import gc
import os
from pathlib import Path
from typing import Any

# One thread for each of the processes that test side by side, as on the command line; numpy reads it when it starts.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import faults
import properties
import pytest
from faults import Faults

SHAPER = Path(__file__).parents[0] / "shaper.toml"


def pytest_configure(config: pytest.Config) -> None:
    properties.choose(quick="not slow" in config.option.markexpr)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """A run of the long tests takes the properties too, with all of their examples."""
    if config.option.markexpr == "slow":
        for item in items:
            if item.get_closest_marker("deep"):
                item.add_marker("slow")


def pytest_collection_finish() -> None:
    """Thousands of collected tests live as long as the run: the collector need not walk them again and again."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def shaper() -> str:
    return SHAPER.read_text(encoding="utf-8")


@pytest.fixture(scope="session")
def schema() -> dict[str, Any]:
    """The schema of specs, as editors get it."""
    from tmmcalc.project.schema import json_schema

    return json_schema()


@pytest.fixture
def known_schema(schema: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    """Commands write the schema that is made already: it is the same in all, and a third of a second each time."""
    monkeypatch.setattr("tmmcalc.project.schema.json_schema", lambda: schema)


@pytest.fixture
def faults_of() -> Faults:
    return faults.faults_of
