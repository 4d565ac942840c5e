"""The part of ``make bench`` that is about the page: how often it is drawn while the machine plays."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from page.chromium import CHROMIUM
from timing import bar_text

CONFIGS = Path(__file__).parents[1] / "configs"
FRAME = 20.0  # ms: fifty frames a second
VECTORS = ("velocity", "acceleration", "reaction")
DIAGRAMS = 2
# the times of frames over three seconds of play [ms]
FRAMES = """() => new Promise((done) => {
  const times = [];
  document.querySelector("[data-view=kinematics] .player .main").click();
  const frame = (now) => {
    times.push(now);
    if (now - times[0] < 3000) requestAnimationFrame(frame);
    else done(times);
  };
  requestAnimationFrame(frame);
})"""


# the same while the point of shifts goes round in a blocking contour
DRAGGED = """() => new Promise((done) => {
  const times = [];
  const plane = document.querySelector(".plane");
  plane.scrollIntoView();
  plane.setPointerCapture = () => {};
  plane.hasPointerCapture = () => true;
  const box = plane.getBoundingClientRect();
  const frame = (now) => {
    times.push(now);
    const turn = times.length / 20;
    const [clientX, clientY] = [0.5 + 0.1 * Math.sin(turn), 0.5 + 0.3 * Math.cos(1.3 * turn)];
    const at = { clientX: box.left + clientX * box.width, clientY: box.top + clientY * box.height, buttons: 1 };
    plane.dispatchEvent(new PointerEvent("pointermove", at));
    if (now - times[0] < 3000) requestAnimationFrame(frame);
    else done(times);
  };
  requestAnimationFrame(frame);
})"""


def pages() -> list[str]:
    """Frames of the shaper that plays and of teeth that follow their shifts, in Chromium without a window."""
    print("\npage: frames over three seconds                                       median   95 %   a second     bar")
    if CHROMIUM is None:
        print("  left out: Chromium is not installed")
        return []
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])

        def opened(name: str) -> Any:
            file = Path(folder) / f"{name}.html"
            argv = ["page", str(CONFIGS / f"{name}.toml"), "-o", str(file), "--no-store", "--quiet"]
            subprocess.run([sys.executable, "-m", "tmmcalc", *argv], check=True)
            page = browser.new_page(viewport={"width": 1500, "height": 1000})
            page.goto(file.as_uri())
            return page

        page = opened("shaper")
        for name in VECTORS:
            page.locator(f"[data-view=kinematics] input[name={name}]").check()
        while page.locator(".chart").count() > DIAGRAMS:
            page.locator(".chart .close").last.click()
        slow = _judged("shaper with vectors and two diagrams while it plays", page.evaluate(FRAMES))
        page.close()
        slow += _judged("teeth of 9 and 13 while their shifts are dragged", opened("pair-blocking").evaluate(DRAGGED))
        browser.close()
    return slow


def _judged(what: str, times: list[float]) -> list[str]:
    """Tell the frames at these times [ms]; what is too slow."""
    steps = np.diff(times)
    median, most = np.percentile(steps, (50, 95))
    told = f"{median:6.1f} ms  {most:6.1f} ms  {1e3 / steps.mean():6.1f}"
    print(f"  {what:60} {told}  {bar_text(float(median), FRAME)}")
    return [f"frames: {what}"] if median > FRAME else []


if __name__ == "__main__":
    pages()
