"""Files in CSV that tables of the cams name."""

from tmmcalc.cams.tables.law_columns import NO_HEADER, law_columns
from tmmcalc.spec.csvtables import ByName, Form

_FORCE = Form(
    "a force on a cam", "phi", ("angle",), ("force", "moment"), "write a header such as phi[deg],Q[N]", turns=True
)
_LAW = Form(
    "a law of motion",
    "k",
    ("angle", ""),
    ("length", "angle", ""),
    "write a header such as k,s or phi[deg],s[mm]",
    by_name=ByName(
        law_columns,
        NO_HEADER,
        "a law of motion has k and its displacement s, or k and its acceleration a",
        "name them k and s, or k and a",
        {"acceleration": ("accelerations are to any scale", "write a name without unit, such as a")},
    ),
    instead=("points", "acceleration", "polynomial"),
)

FORMS = {
    "cam.law": _LAW,
    "cam.rise_law": _LAW,
    "cam.return_law": _LAW,
    "cam.loads.force_table": _FORCE,
    "indexing.law": _LAW,
}
