"""The document of the rolling bearing: speeds, sizes, frequencies of defects, crest factors."""

from __future__ import annotations

from tmmcalc.extras.bearing import Bearing
from tmmcalc.report.document import Document, Fact
from tmmcalc.report.numbers import number
from tmmcalc.report.sizes import quantity


def summary(result: Bearing, title: str) -> Document:
    """Speeds, sizes, frequencies of defects, crest factors."""
    speed = f"{number(result.omega)} rad/s, n = {number(result.turns)} 1/s ({number(60 * result.turns)} rpm)"
    sizes = f"between the rings {quantity(result.width, 'm')}, half of it {quantity(result.half, 'm')}; mean radius "
    named = (
        ("cage", "FTF", result.cage),
        ("outer raceway", "BPFO", result.outer_race),
        ("inner raceway", "BPFI", result.inner_race),
        ("rolling body", "BSF", result.roller),
    )
    facts = [
        Fact("speed", speed, {"omega[rad/s]": result.omega, "n[1/s]": result.turns}),
        Fact(
            "sizes",
            f"{sizes}{quantity(result.mean_radius, 'm')}",
            {"R_n[m]": result.width, "half[m]": result.half, "R_mean[m]": result.mean_radius},
        ),
        Fact("speed of the inner ring", f"{number(result.raceway_speed)} m/s", {"v_inner[m/s]": result.raceway_speed}),
        *(Fact(name, f"{short} = {number(f)} Hz", {f"{short}[Hz]": f}) for name, short, f in named),
    ]
    if result.crest:
        text = ", ".join(number(each, 4) for each in result.crest)
        facts.append(Fact("crest factors", text, {"crest": list(result.crest)}))
    return Document(title, tuple(facts), result.notes)
