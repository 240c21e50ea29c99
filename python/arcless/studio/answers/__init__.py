"""Answers to questions of the page: JSON, bytes, and complaints."""
