"""Words for faults in ``[synthesis]``: what a missing key is for, what to write in its lists and tables."""

_REGION = ("two corners", 'region = [["-100 mm", "-100 mm"], ["200 mm", "100 mm"]]')

# Of the parameters that are sought for a six-bar with a dwell.
_RANGES = {
    "phi12_part": "[0.4, 0.6]",
    "psi0": '["18 deg", "162 deg"]',
    "psi13": '["-162 deg", "-18 deg"]',
    "psi12_part": "[0.4, 0.6]",
    "CB": "[0.1, 1.5]",
    "CD": "[0.1, 1.5]",
    "alpha": '["18 deg", "354 deg"]',
    "n": "[0.2, 0.8]",
}

MISSING = {
    "slotted_link.stroke": ("a slider has its stroke", 'add stroke = "280 mm"'),
    "slotted_link.time_ratio": ("the strokes differ by their time ratio", "add time_ratio = 1.4"),
    "rotating_slotted_link.stroke": ("a slider has its stroke", 'add stroke = "200 mm"'),
    "rotating_slotted_link.time_ratio": ("the strokes differ by their time ratio", "add time_ratio = 1.8"),
    "crank_rocker.swing": ("a rocker has its swing", 'add swing = "40 deg"'),
    "trailing_rod.v_angle": ("a V-engine has the angle between its cylinders", 'add v_angle = "45 deg"'),
    "trailing_rod.crank": ("a V-engine has its crank", 'add crank = "70 mm"'),
    "trailing_rod.rod": ("the trailing rod hangs on a master rod", 'add rod = "250 mm"'),
    "trailing_rod.lug": ("the trailing rod hangs on a pin beside the crank pin", 'add lug = "60 mm"'),
    "path.points": ("a path has its points", 'add points = [[0, 0], ["20 mm", "15 mm"], ["40 mm", 0]]'),
    "motion.points": ("every pose has a place", 'add points = [[0, 0], ["20 mm", "15 mm"]]'),
    "motion.angles": ("every pose has an angle", 'add angles = ["0 deg", "30 deg"]'),
    "dwell.dwell": ("the output stands while the crank turns by an angle", 'add dwell = "90 deg"'),
    "dwell.lengths.OA": ("a linkage by its lengths has its crank", "add OA = 0.25, a part of l_OB"),
    "dwell.lengths.AC": ("a linkage by its lengths has its coupler", "add AC = 0.9, a part of l_OB"),
    "dwell.lengths.CB": ("a linkage by its lengths has its bar 3", "add CB = 0.3, a part of l_OB"),
    "dwell.lengths.CD": (
        "a linkage by its lengths has the side of the coupler",
        "add CD = 0.8, a part of l_OB",
    ),
    "dwell.lengths.alpha": (
        "the coupler is bent by an angle, from C -> A to C -> D",
        'add alpha = "-11 deg"',
    ),
    "dwell.lengths.phi0": ("the crank has its angle in position 1", 'add phi0 = "150 deg"'),
}

LISTS = {
    "path.points": ("a list of two points or more", 'points = [[0, 0], ["20 mm", "15 mm"]]'),
    "path.timing": ("a list of angles", 'timing = ["0 deg", "30 deg", "60 deg"]'),
    "motion.points": ("a list of two points or more", 'points = [[0, 0], ["20 mm", "15 mm"]]'),
    "motion.angles": ("a list of two angles or more", 'angles = ["0 deg", "30 deg"]'),
    "function.range": ("the two ends of an interval", "range = [1, 2]"),
    "function.table": ("a list of three pairs or more", "table = [[0, 0], [0.5, 0.25], [1, 1]]"),
    "function.table[]": ("an abscissa and a value", "[0.5, 0.25]"),
    "function.inputs": ("a list of angles", 'inputs = ["0 deg", "30 deg", "60 deg"]'),
    "function.outputs": ("a list of outputs", 'outputs = ["0 deg", "20 deg", "50 deg"]'),
    "dwell.pivot": ("two coordinates", "pivot = [-0.6, 0.8], parts of l_OB"),
    "path.region": _REGION,
    "motion.region": _REGION,
    **{
        f"dwell.optimum.ranges.{key}": ("the two ends of a range", f"{key} = {example}")
        for key, example in _RANGES.items()
    },
}
