"""The look of the pictures: colours of a palette safe for the colour-blind, line widths, sizes on paper.

Every colour comes with a dash pattern, so that a grey print reads as well.
"""

from __future__ import annotations

from typing import Any

INK = "#1a1a1a"
THIN = "#9a9a9a"  # other positions
PLATE = "#dfe6ec"  # ternary and bigger links
PATH = "#0072b2"  # paths of points
MARK = "#d55e00"  # input arrow, dead centres

CURVES: tuple[dict[str, Any], ...] = (
    {"color": "#0072b2", "linestyle": "-"},
    {"color": "#d55e00", "linestyle": "--"},
    {"color": "#009e73", "linestyle": "-."},
    {"color": "#cc79a7", "linestyle": ":"},
    {"color": "#56b4e9", "linestyle": (0, (6, 1.5))},
    {"color": "#e69f00", "linestyle": (0, (3, 1, 1, 1, 1, 1))},
    {"color": "#7a5195", "linestyle": (0, (8, 2, 2, 2))},
    {"color": "#6b6b6b", "linestyle": (0, (2, 1))},
)
VECTORS: dict[str, dict[str, Any]] = {
    "absolute": {"color": INK, "linestyle": "-", "linewidth": 1.3},
    "relative": {"color": "#0072b2", "linestyle": "-", "linewidth": 1.0},
    "normal": {"color": "#009e73", "linestyle": (0, (5, 1.5)), "linewidth": 1.2},
    "tangential": {"color": "#56b4e9", "linestyle": (0, (3, 1, 1, 1)), "linewidth": 1.4},
    "sliding": {"color": "#cc79a7", "linestyle": (0, (1.2, 1)), "linewidth": 1.6},
    "coriolis": {"color": "#d55e00", "linestyle": (0, (7, 1.5, 1.5, 1.5)), "linewidth": 1.4},
}
FORCES: dict[str, dict[str, Any]] = {
    "load": {"color": "#d55e00", "linestyle": "-", "linewidth": 1.6},
    "weight": {"color": "#009e73", "linestyle": (0, (5, 1.5)), "linewidth": 1.4},
    "inertia": {"color": "#0072b2", "linestyle": (0, (7, 1.5, 1.5, 1.5)), "linewidth": 1.4},
    "spring": {"color": "#e69f00", "linestyle": (0, (3, 1, 1, 1)), "linewidth": 1.4},
    "damper": {"color": "#56b4e9", "linestyle": (0, (3, 1)), "linewidth": 1.4},
    "drive": {"color": "#7a5195", "linestyle": "-", "linewidth": 1.6},
    "reaction": {"color": INK, "linestyle": "-", "linewidth": 1.3},
    "friction": {"color": "#cc79a7", "linestyle": (0, (1.2, 1)), "linewidth": 1.8},
}

SHEET = (297 / 25.4, 210 / 25.4)  # A4 landscape [in]
RESOLUTION = 200  # of png [dots/in]

# On paper [mm].
PIN = 0.85  # radius of a revolute joint
BLOCK = (6.4, 3.6)  # length and height of a slider
PIVOT = (4.4, 3.4)  # width and height of the triangle under a pivot
HATCH = (1.1, 1.3)  # pitch and length of hatching
MARGIN = 9.0  # free border of a scheme

RC: dict[str, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": 8,
    "axes.titlesize": 9,
    "axes.labelsize": 8,
    "axes.linewidth": 0.6,
    "axes.edgecolor": "#555555",
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "legend.fontsize": 7.5,
    "legend.frameon": False,
    "axes.unicode_minus": True,
    "svg.hashsalt": "tmmcalc",
    "svg.fonttype": "path",
    "mathtext.fontset": "dejavusans",
    "savefig.dpi": RESOLUTION,
}
