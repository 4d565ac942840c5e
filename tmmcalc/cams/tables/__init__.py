"""The TOML tables of the cam room: models, with their checks and the tasks that are made of them."""
