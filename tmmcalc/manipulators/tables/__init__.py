"""The TOML tables of the manipulator room: models, with their checks and the tasks that are made of them."""
