"""Names of the follower's motion in time, and those of the transfer functions that stand for them per radian."""

PER_RADIAN = {
    "v": "S1",
    "a": "S2",
    "jerk": "S3",
    "velocity_max": "S1_max",
    "velocity_min": "S1_min",
    "acceleration_max": "S2_max",
    "acceleration_min": "S2_min",
}
IN_TIME = {other: name for name, other in PER_RADIAN.items()}
