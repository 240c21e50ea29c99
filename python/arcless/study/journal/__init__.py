"""The rows of a study, each kept at once: a database that survives kills and damage."""
