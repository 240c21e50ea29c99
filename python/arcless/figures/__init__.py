"""Figures as descriptions that no drawing library is needed for: made once, drawn on many media.

`description` says what a figure is made of; the other rooms make figures of their subjects. Pages
draw them by Bokeh (`report.drawing`), paper and notebooks by matplotlib (`paper`).
"""
