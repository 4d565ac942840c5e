"""The part of ``make bench`` that is about the page: how often it is drawn while the machine plays."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

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


def pages() -> list[str]:
    """Frames of the shaper with its vectors and two diagrams, in Chromium without a window."""
    print("\npage, shaper with vectors and two diagrams while it plays            median   95 %   a second     bar")
    if CHROMIUM is None:
        print("  left out: Chromium is not installed")
        return []
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        file = Path(folder) / "page.html"
        argv = ["page", str(CONFIGS / "shaper.toml"), "-o", str(file), "--no-store", "--quiet"]
        subprocess.run([sys.executable, "-m", "tmmcalc", *argv], check=True)
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1500, "height": 1000})
        page.goto(file.as_uri())
        for name in VECTORS:
            page.locator(f"[data-view=kinematics] input[name={name}]").check()
        while page.locator(".chart").count() > DIAGRAMS:
            page.locator(".chart .close").last.click()
        steps = np.diff(page.evaluate(FRAMES))
        browser.close()
    median, most = np.percentile(steps, (50, 95))
    told = f"{median:6.1f} ms  {most:6.1f} ms  {1e3 / steps.mean():6.1f}"
    print(f"  frames over three seconds                                    {told}  {bar_text(float(median), FRAME)}")
    return ["frames of the page"] if median > FRAME else []


if __name__ == "__main__":
    pages()
