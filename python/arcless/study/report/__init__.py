"""A study → its report, as an HTML file or on paper: variables, outputs, their dependences."""

from arcless.study.report.page import html, write
from arcless.study.report.paper import write as write_pdf

__all__ = ["html", "write", "write_pdf"]
