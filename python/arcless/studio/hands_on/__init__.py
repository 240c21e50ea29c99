"""Hands on: a line and its pantographs in real time, with a hand on the static force."""
