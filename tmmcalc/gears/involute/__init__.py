"""The involute pair: geometry of wheels and meshes, quality, blocking contour, profiles, measurement."""
