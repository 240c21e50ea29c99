"""A pantograph, its place on the train, and what acts on it."""
