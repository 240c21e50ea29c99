"""A study → one HTML file: variables, outputs, and their dependences."""

from arcless.study.report.page import html, write

__all__ = ["html", "write"]
