"""Words for faults in ``[engine]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "speed": ("inertia forces depend on the speed of the shaft", 'add speed = "3000 rpm"'),
    "cylinders": (
        "an engine has cylinders",
        "add cylinders = 4 with an arrangement, or [[engine.cylinders]], one for each",
    ),
    "cylinders.crank_angle": ("the crank of every cylinder has its direction", 'add crank_angle = "180 deg"'),
    "cylinders.position": ("every cylinder has its place along the shaft", 'add position = "90 mm"'),
}

LISTS = {
    "firing_order": ("a list of cylinder numbers", "firing_order = [1, 3, 4, 2]"),
    "throws": ("a list of angles", 'throws = ["0 deg", "180 deg", "180 deg", "0 deg"]'),
    "orders": ("a list of orders", "orders = [1, 2, 4, 6]"),
}
