"""Checks of what is written: comments, the program's own texts, pages.

``python -m tests.prose`` names each place that breaks a rule of `docs/style.md` or house rule 3 of
CONTRIBUTING.md; `make lint` runs it.
"""
