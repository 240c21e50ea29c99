"""The folder of a run: its name, its files, written all together or not at all."""
