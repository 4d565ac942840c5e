"""Words for faults in ``[liner]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "radius": ("a shell has its radius", 'add radius = "69 mm"'),
    "thickness": ("a shell has its wall", 'add thickness = "8 mm"'),
    "ring_outer": ("the collar has its outer radius", 'add ring_outer = "78 mm"'),
    "ring_width": ("the collar has its width", 'add ring_width = "9 mm"'),
    "clamp.gas_pressure": ("the collar is held against the gas", 'add gas_pressure = "8 MPa"'),
    "clamp.bore": ("the gas acts on an area", 'add bore = "130 mm"'),
    "clamp.arm": ("head and block press at different radii", 'add arm = "4 mm"'),
}

INLINE = {"clamp": 'clamp = { gas_pressure = "8 MPa", bore = "130 mm", arm = "4 mm" }'}
