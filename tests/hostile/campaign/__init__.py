"""A long search with seeds: spoilt texts for the loader, models to run, calls of the core.

Case number n of a kind is the same on every machine. `python -m tests.hostile.campaign --help`.
"""
