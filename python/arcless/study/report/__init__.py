"""A study → one HTML file: what was varied, what came out, what follows from what."""

from arcless.study.report.page import html, write

__all__ = ["html", "write"]
