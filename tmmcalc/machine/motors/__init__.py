"""Motors: characteristics as functions of speed, rated data, the catalogue, and the choice from it.

``characteristics`` has the closed forms, ``table`` the one given by points, ``gearing`` carries either to the input
shaft, ``model`` makes them from the rated data of a motor, ``plausibility`` tells what in these data
contradicts.
"""
