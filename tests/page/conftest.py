"""A browser for each process of the tests, a page for each test, files that are written once."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from page.chromium import CHROMIUM
from page.opened import Opened, opened
from page.scenes import CONFIGS, write

Written = Callable[..., Path]
Open = Callable[..., Opened]


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """Chromium without a window; CI has one."""
    if CHROMIUM is None:
        assert not os.environ.get("CI"), "Chromium is not installed"
        pytest.skip("Chromium is not installed")
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield found
        found.close()


@pytest.fixture(scope="session")
def written(tmp_path_factory: pytest.TempPathFactory) -> Written:
    """The page of a ready spec with these keys changed, written once."""
    folder = tmp_path_factory.mktemp("pages")
    known: dict[tuple[str, ...], Path] = {}

    def once(name: str, *changed: str) -> Path:
        key = (name, *changed)
        if key not in known:
            known[key] = folder / f"{len(known)}-{name}.html"
            write(CONFIGS / f"{name}.toml", known[key], *[part for each in changed for part in ("--set", each)])
        return known[key]

    return once


@pytest.fixture
def open_page(browser: Any, written: Written) -> Iterator[Open]:
    """Open the page of a ready spec in a window; whatever a test does there, nothing is asked or complained of."""
    all_of_them: list[Opened] = []

    def start(name: str | Path, *changed: str, size: tuple[int, int] = (1500, 1000), **context: Any) -> Opened:
        file = name if isinstance(name, Path) else written(name, *changed)
        found = opened(browser, file, size, **context)
        all_of_them.append(found)
        return found

    yield start
    for each in all_of_them:
        each.page.context.close()
        assert each.said == []
        assert each.asked == []
