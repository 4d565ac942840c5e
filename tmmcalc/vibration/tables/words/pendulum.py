"""Words for faults in ``[pendulum]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "rod": ("a pendulum hangs on a rod", "add [pendulum.rod] with length and diameter"),
    "rod.length": ("a rod has its length", 'add length = "800 mm"'),
    "disc.mass": ("a disc has its mass", 'add mass = "4 kg"'),
    "speeds.to": ("the diagram has its highest speed", 'add to = "4000 rpm"'),
    "swing.duration": ("a motion has its duration", 'add duration = "8 s"'),
    "swing.carrier.time": ("speeds of a carrier have their times", 'add time = ["0 s", "1 s"]'),
}

INLINE = {
    "swing.carrier": 'carrier = { time = ["0 s", "1 s"], x = [0, "0.2 m/s"] }',
}
