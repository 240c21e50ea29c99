"""Figures as Bokeh's script reads them."""
