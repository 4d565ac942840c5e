"""The vibratory assembly device: ring on rods, gripper on flat springs, exciter on an elastic plate."""
