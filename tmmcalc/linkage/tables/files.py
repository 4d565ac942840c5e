"""Files in CSV that tables of the linkage name."""

from tmmcalc.spec.csvtables import Form

FORMS = {
    "loads.table": Form(
        "a load",
        "x",
        ("angle", "length"),
        ("force", "moment"),
        "write a header such as phi[deg],Q[N]",
        counted={"position": "numbers of positions", "stroke": "parts of the stroke"},
    ),
}
