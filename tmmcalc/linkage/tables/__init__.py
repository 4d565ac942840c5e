"""The TOML tables of the linkage room: models, with their checks and the tasks that are made of them."""
