"""Words for faults in ``[tie_down]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "weight": ("a load has its weight", 'add weight = "70 kN"'),
    "factor": ("the inertia force is a part of the weight", "add factor = 0.8"),
    "elevation": ("ties rise above the floor", 'add elevation = "30 deg"'),
    "friction": ("the load rubs on its cradle", "add friction = 0.5"),
    "thread.moment": ("a thread is tightened by a moment", 'add moment = "30 N*m"'),
    "thread.diameter": ("a thread has its mean diameter", 'add diameter = "14.701 mm"'),
    "thread.lead_angle": ("a thread has its lead angle", 'add lead_angle = "2.5 deg"'),
    "thread.friction_angle": ("a thread rubs", 'add friction_angle = "11.7 deg"'),
    "support.friction": ("the load rubs on the support", "add friction = 0.2"),
    "support.base": ("the support is at a distance", 'add base = "15 m"'),
    "support.cradle_arm": ("the cradle carries a part of the load", 'add cradle_arm = "12 m"'),
    "support.arm": ("the support carries a part of the load", 'add arm = "3 m"'),
}
