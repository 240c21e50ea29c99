"""Fields of all parts of a model: units, provenance, refusal of unknown names."""
