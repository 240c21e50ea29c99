"""Wires of all systems, divided into elements and nodes."""
