"""A page that is open in a browser: what it says and asks for, where its input stands, where things are drawn."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

# the middles of all spots, in pixels of the window
SPOTS = """() => Object.fromEntries([...document.querySelectorAll("[data-view=kinematics] .spot")].map((spot) => {
  const m = spot.getScreenCTM();
  return [spot.dataset.spot, [m.e, m.f]];
}))"""
# what brings the axes of each body, in pixels of its drawing, to pixels of the window
BODIES = """() => Object.fromEntries([...document.querySelectorAll("[data-view=kinematics] .body")].map((body) => {
  const m = body.getScreenCTM();
  return [body.dataset.body, [m.a, m.b, m.c, m.d, m.e, m.f]];
}))"""


class Opened(NamedTuple):
    """A page, the lines that it wrote to the console, the addresses that it asked for beside its own."""

    page: Any
    said: list[str]
    asked: list[str]

    @property
    def slider(self) -> Any:
        return self.page.locator("[data-view=kinematics] input[type=range]")

    @property
    def variants(self) -> Any:
        return self.page.locator(".variants input")

    @property
    def at(self) -> float:
        """Where the input stands, all digits of it."""
        return float(self.slider.input_value())

    @property
    def told(self) -> str:
        """What stands under the player."""
        found: str = self.page.locator("[data-view=kinematics] .told").inner_text()
        return found

    @property
    def refused(self) -> str:
        """What is said of a place that cannot be reached."""
        found: str = self.page.locator("[data-view=kinematics] .wrong").inner_text()
        return found

    def move(self, at: float) -> None:
        """Move the slider as a hand would, to any place."""
        slid(self.slider, at)

    def choose(self, k: int) -> None:
        """Show another variant."""
        slid(self.variants, k)

    def wait(self, beyond: float) -> None:
        """Until what plays has gone beyond a place."""
        self.page.wait_for_function(
            "(at) => Number(document.querySelector('[data-view=kinematics] input[type=range]').value) > at", arg=beyond
        )

    def spots(self) -> dict[str, complex]:
        """Where the named points are on the screen, y upwards."""
        return {name: complex(x, -y) for name, (x, y) in self.page.evaluate(SPOTS).items()}

    def bodies(self) -> dict[str, Any]:
        """By body, the matrix from the axes of its drawing to the screen."""
        return {name: np.array(m) for name, m in self.page.evaluate(BODIES).items()}


def slid(slider: Any, at: float) -> None:
    """Move a slider as a hand would, to any place."""
    slider.evaluate("(each, at) => { each.value = String(at); each.dispatchEvent(new Event('input')); }", at)


def opened(browser: Any, file: Path, size: tuple[int, int], **context: Any) -> Opened:
    """The page of a file in a window of its own; ``context`` goes to the browser."""
    wide, high = size
    page = browser.new_context(viewport={"width": wide, "height": high}, **context).new_page()
    found = Opened(page, [], [])
    page.on("console", lambda message: found.said.append(f"{message.type}: {message.text}"))
    page.on("pageerror", lambda error: found.said.append(f"error: {error}"))
    page.on("dialog", lambda dialog: (found.said.append(f"dialog: {dialog.message}"), dialog.dismiss()))
    page.on("request", lambda asked: found.asked.append(asked.url) if asked.url != file.as_uri() else None)
    page.goto(file.as_uri())
    return found
