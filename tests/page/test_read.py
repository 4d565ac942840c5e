"""Whatever a page holds is read by its scripts: what they never ask for is not sent."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest

from page.altered import altered
from page.conftest import Written
from page.scenes import CONFIGS, SPECS, write
from tmmcalc.page.document import WEB
from tmmcalc.page.said import words

# of all parts of the content the keys that are there, and those that scripts ask for; a part is named by the way to it
WATCHED = """(() => {
  const sent = new Set(), asked = new Set();
  const walk = (each, way) => {
    if (Array.isArray(each)) for (const one of each) walk(one, way);
    else if (each && typeof each === "object") for (const key of Object.keys(each)) {
      sent.add(`${way}.${key}`);
      walk(each[key], `${way}.${key}`);
    }
  };
  const known = new WeakMap();
  const watched = (each, way) => {
    if (!each || typeof each !== "object") return each;
    if (!known.has(each)) known.set(each, new Proxy(each, {
      get(target, key) {
        const inner = Array.isArray(target) ? way : `${way}.${String(key)}`;
        if (!Array.isArray(target) && typeof key === "string") asked.add(inner);
        return typeof target[key] === "function" ? target[key] : watched(target[key], inner);
      },
    }));
    return known.get(each);
  };
  const parse = JSON.parse;
  JSON.parse = (text) => {
    const content = parse(text);
    walk(content, "");
    return watched(content, "");
  };
  window.watch = () => [[...sent], [...asked]];
})();"""
# everything is unfolded, moved, taken, and one column of every stage has its diagram
USED = """() => {
  for (const each of document.querySelectorAll("details")) each.open = true;
  for (const each of document.querySelectorAll("input[type=checkbox]:not(:checked)")) each.click();
  for (const each of document.querySelectorAll("input[type=range]")) {
    for (const part of [0.3, 0.9]) {
      each.value = String(Number(each.min) + part * (Number(each.max) - Number(each.min)));
      each.dispatchEvent(new Event("input"));
    }
  }
  for (const each of document.querySelectorAll(".scene, .plane")) {
    for (const key of ["ArrowRight", "ArrowUp", "Home", "ArrowLeft"]) {
      each.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    }
  }
  for (const each of document.querySelectorAll(".body:not(.still)")) {
    for (const [name, at] of [["pointerdown", 9], ["pointermove", 99], ["pointermove", 30], ["pointerup", 30]]) {
      try {
        each.dispatchEvent(new PointerEvent(name, { pointerId: 1, clientX: at, clientY: at, buttons: 1 }));
      } catch {} // no pointer is there that could be kept
    }
  }
  const choice = document.querySelector(".adding select");
  for (const each of document.querySelectorAll(".adding optgroup option:last-child")) {
    choice.value = each.value;
    choice.dispatchEvent(new Event("change"));
  }
  document.querySelector(".view .player .main")?.click();
}"""
SAYING = (  # where scripts say a word by its key: there, in a choice before it, in lists
    r'\bword\("\w+"',
    r"\bword\((?:[^()]|\([^()]*\))*\)",
    r"\bconst place = [^;]*;",
    r"\bheader\(table, \[[^\]]*\]",
    r'\["\w+", (?:view|others|least|greatest)\b',
)
KEY = re.compile(r'"(\w+)"')
NAMES = re.compile(r"^\.(words|letters|languages)\.|^\.scenes\.trials\.given\.")  # keys that are names themselves
FEW = ("shaper", "course-project", "manipulator", "pair-blocking", "cam-translating")


def unread(browser: Any, files: Iterable[Path]) -> dict[str, list[str]]:
    """What is asked for on no page of these, with those in which it stands."""
    sent: dict[str, list[str]] = defaultdict(list)
    asked: set[str] = set()
    for file in files:
        page = browser.new_context().new_page()
        page.add_init_script(WATCHED)
        page.goto(file.as_uri())
        page.evaluate(USED)
        page.get_by_label("Language").select_option("uk")
        there, read = page.evaluate("new Promise((done) => setTimeout(() => done(watch()), 100))")
        page.context.close()
        asked |= set(read)
        for key in there:
            sent[key].append(file.stem)
    return {key: where for key, where in sent.items() if key not in asked and not NAMES.search(key)}


@pytest.mark.slow
def test_whatever_is_sent_is_read(browser: Any, written: Written, tmp_path: Path) -> None:
    several = tmp_path / "several.html"
    write(CONFIGS / "four-bar.toml", several, str(CONFIGS / "crank-slider.toml"))
    assert unread(browser, [*map(written, FEW), several]) == {}


@pytest.mark.slow
def test_whatever_is_sent_of_any_spec_is_read(browser: Any, written: Written, tmp_path: Path) -> None:
    several = tmp_path / "several.html"
    write(CONFIGS / "four-bar.toml", several, str(CONFIGS / "crank-slider.toml"))
    assert unread(browser, [*map(written, SPECS), several]) == {}


def test_what_is_never_read_is_found(browser: Any, written: Written, tmp_path: Path) -> None:
    def more(content: Any) -> None:
        content["more"] = 1
        content["scenes"][0]["views"][0]["handle"]["direction"] = [1, 0]

    file = altered(written("four-bar"), tmp_path / "more.html", more)
    assert {".more", ".scenes.views.handle.direction"} <= unread(browser, [file]).keys()


def test_all_words_of_the_page_are_said_somewhere() -> None:
    """As `word("key")`, or out of a list of keys, or one of two."""
    scripts = "".join(file.read_text(encoding="utf-8") for file in WEB.glob("*.js"))
    said = re.compile("|".join(SAYING))
    known = {key for found in said.finditer(scripts) for key in KEY.findall(found[0])}
    assert [key for key in words() if key not in known] == []
