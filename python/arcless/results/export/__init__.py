"""A result as a file that other programs read: CSV, Excel, MATLAB, Parquet."""
