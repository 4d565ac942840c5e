"""Drawings of the documents, which are kept with the program, in few bytes."""

from __future__ import annotations

import re


def light(svg: str, places: int = 2) -> str:
    """The same drawing in a third of the bytes: each style said once, few decimals of a point, no names of groups."""
    styles: dict[str, str] = {}
    svg = re.sub(r"\n\s*", "\n", re.sub(r"<!--.*?-->", "", svg))
    svg = re.sub(r' id="(?!clip|[mp][0-9a-f]{10})[^"]*"', "", svg)
    digits = re.compile(rf"(\d\.\d{{{places}}})\d+")
    svg = re.sub("<[^>]*>", lambda tag: digits.sub(r"\1", tag[0]), svg)  # not what stands between tags: that is text
    svg = re.sub(r'style="([^"]*)"', lambda told: f'class="{styles.setdefault(told[1], f"s{len(styles)}")}"', svg)
    svg = re.sub(r"\s*\n([LQCz])\s*", r"\1", svg).replace("<g>\n", "<g>").replace("</g>\n", "</g>")
    rules = "".join(f".{name}{{{style}}}\n" for style, name in styles.items())
    return svg.replace("</defs>", f"<style>\n{rules}</style>\n</defs>", 1)
