"""Words for faults in ``[indexing]``: what a missing key is for, what to write in its lists and tables."""

from tmmcalc.cams.tables.words.cam import LAW

MISSING = {
    "rollers": ("the wheel has its number of rollers", "add rollers = 6"),
    "step_angle": ("a step takes an angle of the cams", 'add step_angle = "90 deg"'),
    "law": ("the wheel moves by a law", 'add law = "shun"'),
    "wheel_radius": ("the rollers stand on a radius of the wheel", 'add wheel_radius = "50 mm"'),
}

LISTS = {
    **{f"law.{slot}": said for slot, said in LAW.items()},
}
