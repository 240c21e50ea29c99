"""Runs: computed into the folder as `arcless run` does, read, explained and reported."""
