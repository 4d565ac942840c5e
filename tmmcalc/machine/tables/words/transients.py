"""Words for faults in ``[[transients]]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "load_steps.factor": ("a load step has its load factor", "add factor = 1"),
    "braking.kind": ("there are three ways to brake", 'add kind = "dynamic"'),
}

LISTS = {
    "motor_on": ("a list of intervals of time", 'motor_on = [["0 s", "2 s"]]'),
    "motor_on[]": ("two times, on and off", '["0 s", "2 s"]'),
    "targets": ("a list of speeds", 'targets = ["500 rpm"]'),
}

INLINE = {
    "load_steps": 'load_steps = [{ factor = 0.5, time = "3 s" }]',
    "braking": 'braking = { kind = "dynamic", resistance = "2 ohm" }',
    "brake": 'brake = { moment = "200 N*m", from = "2 s" }',
}

ELEMENTS = {"": ("name", 'transient "{}"')}
