"""The TOML tables of the machine room: models, with their checks and the tasks that are made of them."""
