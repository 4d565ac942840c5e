"""Words for faults in ``[cam]``: what a missing key is for, what to write in its lists and tables."""

LAW = {
    "points": ("a list of two points or more", "points = [[0, 0], [0.5, 0.4], [1, 1]]"),
    "points[]": ("a part of the phase and a displacement", "[0.5, 0.4]"),
    "acceleration": ("a list of two points or more", "acceleration = [[0, 1], [1, -1]]"),
    "acceleration[]": ("a part of the phase and an acceleration", "[0.25, 1]"),
    "polynomial": ("a list of 3 to 30 coefficients", "polynomial = [0, 0, 3, -2]"),
}

MISSING = {
    "follower": ("a cam has a follower", 'add follower = "translating", "oscillating" or "flat"'),
    "stroke": ("a follower has its stroke", 'add stroke = "30 mm", or "20 deg" of an oscillating one'),
    "rise": ("the rise takes an angle of the cam", 'add rise = "60 deg"'),
    "return_angle": ("the return takes an angle of the cam", 'add return_angle = "60 deg"'),
    "requirements.material.treatment": ("a limit depends on the heat treatment", 'add treatment = "improved"'),
    "requirements.material.hardness": ("a limit depends on the hardness", 'add hardness = "300 HB"'),
    "elastic.stiffness": ("an elastic follower has its stiffness", 'add stiffness = "2000 N/mm"'),
}

LISTS = {
    "loads.force_table.phi": ("a list of two angles or more", 'phi = ["0 deg", "90 deg", "270 deg"]'),
    "loads.force_table.force": ("a list of two forces or more", 'force = [0, "-150 N", 0]'),
    "loads.force_table.moment": ("a list of two moments or more", 'moment = [0, "-4 N*m", 0]'),
    **{f"{key}.{slot}": said for key in ("law", "rise_law", "return_law") for slot, said in LAW.items()},
}

INLINE = {
    "requirements.material": 'material = { treatment = "improved", hardness = "300 HB" }',
    "loads.force_table": 'force_table = { phi = ["0 deg", "180 deg"], force = ["-150 N", 0] }',
}
