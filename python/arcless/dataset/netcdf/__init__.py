"""Result files: NetCDF written whole or in pieces, sealed, checked and read."""
