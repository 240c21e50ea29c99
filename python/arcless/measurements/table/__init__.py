"""A CSV file of a measurement: its dialect, the rows it has, its columns, their numbers."""
