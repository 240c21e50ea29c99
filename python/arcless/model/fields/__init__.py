"""What all parts of a model share: fields with units, provenance, refusal of unknown names."""
