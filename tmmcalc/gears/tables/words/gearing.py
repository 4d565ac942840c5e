"""Words for faults in ``[gearing]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "members.name": ("every member has its name, as the meshes have it", 'add name = "planet"'),
    "meshes.first": ("a mesh has two members", 'add first = "sun"'),
    "meshes.first_teeth": ("every wheel has its number of teeth", "add first_teeth = 18"),
    "meshes.second": ("a mesh has two members", 'add second = "planet"'),
    "meshes.second_teeth": ("every wheel has its number of teeth", "add second_teeth = 48"),
}

LISTS = {
    "teeth": ("a list of numbers of teeth", "teeth = [22, 118, 17, 97]"),
    "locked": ("a list of pairs of members", 'locked = [["sun", "H"]]'),
}

INLINE = {
    "speeds": 'speeds = { sun = "1500 rpm", ring = 0 }',
    "torques": 'torques = { sun = "20 N*m" }',
    "load": 'load = { H = "150 N*m" }',
    "powers": 'powers = { sun = "4 kW" }',
}
