"""The TOML tables of the extras room: models, with their checks and the tasks that are made of them."""
