"""Files in CSV that tables of the machine name."""

from tmmcalc.spec.csvtables import Form

FORMS = {
    "torque.table": Form(
        "a torque diagram", "theta", ("angle",), ("moment",), "write a header such as theta[deg],M[N*m]", turns=True
    ),
}
