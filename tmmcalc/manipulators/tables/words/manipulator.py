"""Words for faults in ``[manipulator]``: what a missing key is for, what to write in its lists and tables."""

# An example of each coordinate, and a larger one.
_JOINTS = {
    "psi": ("-30 deg", "90 deg"),
    "phi_2": ("10 deg", "70 deg"),
    "phi_3": ("-60 deg", "20 deg"),
    "l_3": ("0.6 m", "1.2 m"),
    "h": ("0.2 m", "0.9 m"),
    "r": ("0.5 m", "1.1 m"),
}
_LIMITED = {**_JOINTS, "elbow": ("-150 deg", "-5 deg")}

MISSING = {
    "arm": ("a manipulator has its arm", 'add arm = "spherical", "cylindrical" or "angular"'),
    "path.kind": ("a path has its kind", 'add kind = "arc", "line" or "polyline"'),
    "motion.t": ("a table of the joints has its times", 'add t = ["0 s", "0.5 s", "1 s"]'),
    **{
        f"joints.{name}.from": ("a joint begins somewhere", f'add from = "{low}"') for name, (low, _) in _JOINTS.items()
    },
}

LISTS = {
    "path.points[]": ("two coordinates, or three", '["1.2 m", "0.3 m"]'),
    "path.points": ("a list of two points or more", 'points = [["1.2 m", "0.3 m"], ["0.5 m", "1.1 m"]]'),
    "path.normal": ("three components", "normal = [0.0, 0.0, 1.0]"),
    "motion.t": ("a list of two times or more", 't = ["0 s", "0.5 s", "1 s"]'),
    "obstacles.corners": ("three points or more", 'corners = [[0, 0], ["1 m", 0], ["1 m", "1 m"]]'),
    "obstacles.box": ("two opposite corners", 'box = [[0, 0], ["1 m", "1 m"]]'),
    **{f"path.{key}": ("two coordinates, or three", f'{key} = ["1.2 m", "0.3 m"]') for key in ("start", "end", "via")},
    **{
        f"motion.{name}": ("a list of coordinates", f'{name} = ["{low}", "{low}"]')
        for name, (low, _) in _JOINTS.items()
    },
    **{
        f"limits.{name}": ("the lowest and the highest", f'{name} = ["{low}", "{high}"]')
        for name, (low, high) in _LIMITED.items()
    },
}

INLINE = {
    **{f"joints.{name}": f'{name} = {{ from = "{low}", to = "{high}", ... }}' for name, (low, high) in _JOINTS.items()},
}
