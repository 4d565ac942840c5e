"""Files in CSV that tables of the machine name."""

from tmmcalc.spec.csvtables import Form

FORMS = {
    "torque.table": Form(
        "a torque diagram", "theta", ("angle",), ("moment",), "write a header such as theta[deg],M[N*m]", turns=True
    ),
    "torque.reduced_inertia": Form(
        "a reduced inertia",
        "theta",
        ("angle",),
        ("inertia",),
        "write a header such as theta[deg],J[kg*m^2]",
        turns=True,
    ),
    "motor.table": Form(
        "the characteristic of a motor",
        "speed",
        ("angular speed",),
        ("moment",),
        "write a header such as n[rpm],M[N*m]",
    ),
}
