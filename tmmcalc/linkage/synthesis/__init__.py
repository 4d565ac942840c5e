"""Kinematic synthesis of planar linkages: sizes from what the linkage is to do, each checked by its kinematics."""
