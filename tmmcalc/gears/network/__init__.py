"""Any train as members that turn and wheels in mesh: speeds, torques, power flow, efficiency, mesh frequencies.

    Network (model)  ->  Motion (speeds)  ->  PowerFlow (power)  ->  loops (circulation)
                         Motion  ->  equations (willis), plans of velocities and speeds (places, plans)
    layout and teeth  ->  Train (builder)  ->  ratio, efficiency (efficiency)

`types` holds the closed formulas of the simple planetary types, which need no teeth.
"""
