"""The studio: models, runs and studies of a folder in the browser, on the same files as all else.

The server does nothing of its own with physics or validation: its routes call the functions that
`arcless` offers to scripts, and the page asks them.
"""
