"""How far the path of a point is from a wanted one."""
