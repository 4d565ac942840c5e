"""Write the pictures of the README and of the guide: ``make pictures``.

Each is that of ``tmmcalc plot configs/NAME.toml STAGE``, with the flags below, its text as text; a sheet that of
``tmmcalc sheet configs/NAME.toml --as svg``, a page one of ``tmmcalc note configs/NAME.toml``, a screen that of
``tmmcalc page configs/NAME.toml`` in Chromium.
"""

from __future__ import annotations

import subprocess
from io import BytesIO
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

from tmmcalc import load_spec
from tmmcalc.cli.plot import PICTURES
from tmmcalc.core.atomic import replace_file
from tmmcalc.core.stage import resolve
from tmmcalc.pipeline.runner import run
from tmmcalc.report.drawing import written
from tmmcalc.report.drawing.order import CHOOSE, PHASE, POLYGONS, POSITIONS, Order

HOME = Path(__file__).parent
DRAWN = {  # file: ready spec, stage, flags
    "shaper.svg": ("shaper", "kinematics", {POSITIONS: "0:20:5"}),
    "guide/cam.svg": ("cam", "cam_profile", {}),
}
PAGES = {"guide/note.png": ("shaper", 7)}  # file: ready spec, page of its note
SCREENS = {"guide/page.png": ("shaper", "250")}  # file: ready spec, place of the input
WINDOW, COLOURS = {"width": 1360, "height": 1240}, 64
RESOLUTION, GREYS = 110, 16  # of a page: dots to an inch, and shades
SHEETS = {"guide/linkage.svg": "shaper"}  # file, called as its sheet: ready spec


def drawing(name: str, stage: str, given: dict[str, str]) -> bytes:
    """The picture of a stage of a ready spec."""
    spec = load_spec(HOME.parent / "configs" / f"{name}.toml")
    results = run(spec, target=stage).results
    flags = dict.fromkeys((POSITIONS, POLYGONS, CHOOSE, PHASE), None) | given
    order = Order(spec, results, flags, results.__getitem__, lambda text: text)
    shown = PICTURES[stage]
    return written("svg", resolve(shown.figure)(order))


def page(name: str, number: int) -> bytes:
    """A page of the note of a ready spec in shades of grey."""
    from pypdfium2 import PdfDocument

    with TemporaryDirectory() as folder:
        file = Path(folder) / "note.pdf"
        spec = str(HOME.parent / "configs" / f"{name}.toml")
        subprocess.run(["tmmcalc", "note", spec, "-o", str(file), "--no-store", "-q"], check=True)
        document = PdfDocument(file)
        picture = document[number - 1].render(scale=RESOLUTION / 72).to_pil()
        document.close()
    buffer = BytesIO()
    picture.convert("L").quantize(GREYS).save(buffer, format="png", optimize=True)
    return buffer.getvalue()


def screen(name: str, at: str) -> bytes:
    """The page of a ready spec in a browser, with its first plan unfolded, the input at a place."""
    from PIL import Image
    from playwright.sync_api import sync_playwright

    with TemporaryDirectory() as folder, sync_playwright() as browsers:
        file = Path(folder) / "page.html"
        spec = str(HOME.parent / "configs" / f"{name}.toml")
        subprocess.run(["tmmcalc", "page", spec, "-o", str(file), "--no-store", "-q"], check=True)
        browser = browsers.chromium.launch(executable_path=which("chromium"), args=["--no-sandbox"])
        shown = browser.new_page(viewport=WINDOW)
        shown.goto(file.as_uri())
        slider = shown.locator(".player input[type=range]").first
        slider.evaluate("(slider, at) => { slider.value = at; slider.dispatchEvent(new Event('input')); }", at)
        shown.locator(".plans summary").first.click()
        picture = Image.open(BytesIO(shown.screenshot()))
        browser.close()
    buffer = BytesIO()
    picture.convert("RGB").quantize(COLOURS).save(buffer, format="png", optimize=True)
    return buffer.getvalue()


if __name__ == "__main__":
    for file, (name, stage, given) in DRAWN.items():
        replace_file(HOME / file, drawing(name, stage, given))
    for file, (name, number) in PAGES.items():
        replace_file(HOME / file, page(name, number))
    for file, (name, at) in SCREENS.items():
        replace_file(HOME / file, screen(name, at))
    for file, name in SHEETS.items():
        spec = str(HOME.parent / "configs" / f"{name}.toml")
        flags = ("--only", Path(file).stem, "--as", "svg", "--no-store", "-q")
        subprocess.run(["tmmcalc", "sheet", spec, "-o", str((HOME / file).parent), *flags], check=True)
