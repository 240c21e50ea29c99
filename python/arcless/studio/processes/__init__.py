"""Worker processes: started, told what to compute, heard, cancelled and ended."""
