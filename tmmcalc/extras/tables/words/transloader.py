"""Words for faults in ``[transloader]``: what a missing key is for, what to write in its lists and tables."""

MISSING = {
    "capacity": ("a transloader has its capacity", 'add capacity = "16 t"'),
    "trolley.path": ("a trolley has its way", 'add path = "60 m"'),
    "trolley.acceleration": ("a trolley starts and brakes", 'add acceleration = "0.6 m/s^2"'),
    "hoist.height": ("a grab is lifted", 'add height = "25 m"'),
    "hoist.acceleration": ("a hoist starts and brakes", 'add acceleration = "1 m/s^2"'),
    "inertia.weights": ("weights are set into motion", 'add weights = ["160 kN", "90 kN"]'),
    "wind.pressure": ("a wind has its pressure", 'add pressure = "150 Pa"'),
    "wind.area": ("a wind acts on an area", 'add area = "200 m^2"'),
    "equivalent_wind.pressure": ("a wind has its pressure", 'add pressure = "50 Pa"'),
    "equivalent_wind.area": ("a wind acts on an area", 'add area = "200 m^2"'),
    "hurricane.pressure": ("a wind has its pressure", 'add pressure = "700 Pa"'),
    "hurricane.area": ("a wind acts on an area", 'add area = "200 m^2"'),
    "parts.name": ("a part has its name", 'add name = "lower chord"'),
    "parts.area": ("a section carries the force", 'add area = "240 cm^2"'),
    "parts.strength": ("stress has its limit", 'add strength = "240 MPa"'),
    "parts.influence": ("loads act on a part", "add influence = { dead_weight = 0.5, rated_load = 1.1 }"),
}

INLINE = {
    "trolley": 'trolley = { path = "60 m", acceleration = "0.6 m/s^2" }',
    "hoist": 'hoist = { height = "25 m", acceleration = "1 m/s^2" }',
    "inertia": 'inertia = { weights = ["160 kN", "90 kN"] }',
    "wind": 'wind = { pressure = "150 Pa", area = "200 m^2" }',
    "equivalent_wind": 'equivalent_wind = { pressure = "50 Pa", area = "200 m^2" }',
    "hurricane": 'hurricane = { pressure = "700 Pa", area = "200 m^2" }',
    "parts.influence": "influence = { dead_weight = 0.5, rated_load = 1.1 }",
}

ELEMENTS = {"parts": ("name", 'part "{}"')}
