"""Words for faults in ``[torque]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "speed": ("a torque diagram is that of a shaft with its mean speed", 'add speed = "180 rpm"'),
    "harmonics.terms": ("a sum of harmonics has terms", 'add terms = [{ order = 2, sin = "100 N*m" }]'),
    "harmonics.terms.order": ("every harmonic has its order", "add order = 1 (2, 3, ...)"),
}

LISTS = {
    "pieces": ("a list of two points or more", 'pieces = [["0 deg", "100 N*m"], ["90 deg", "-50 N*m"]]'),
    "pieces[]": ("an angle and a moment", '["90 deg", "100 N*m"]'),
    "table.theta": ("a list of two angles or more", 'theta = ["0 deg", "90 deg", "270 deg"]'),
    "table.moment": ("a list of two moments or more", 'moment = [0, "40 N*m", 0]'),
    "reduced_inertia.theta": ("a list of two angles or more", 'theta = ["0 deg", "90 deg", "270 deg"]'),
    "reduced_inertia.inertia": (
        "a list of two moments of inertia or more",
        'inertia = ["4 kg*m^2", "5 kg*m^2", "4.5 kg*m^2"]',
    ),
    "delays": ("a list of angles", 'delays = ["0 deg", "180 deg"]'),
}

INLINE = {
    "constants": "constants = { M0 = 500 }",
    "harmonics": 'harmonics = { constant = "20 N*m", terms = [{ order = 2, sin = "100 N*m" }] }',
    "harmonics.terms": 'terms = [{ order = 2, sin = "100 N*m" }]',
    "reduced_inertia": 'reduced_inertia = { file = "reduction.csv", columns = "phi,J_red" }',
    "table": 'table = { theta = ["0 deg", "180 deg"], moment = ["100 N*m", 0] }',
}
