"""Result → report.html: one file with linked figures, verdicts, data and sources."""

from arcless.report.page import html, write

__all__ = ["html", "write"]
