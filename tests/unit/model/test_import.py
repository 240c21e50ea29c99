"""`arcless.model` is light: the command line checks a file without the heavy libraries."""

import subprocess
import sys


def test_heavy_libraries_stay_out() -> None:
    program = (
        "import sys, arcless.model\n"
        "arcless.model.load('en50318-ac-simple-320-planar')\n"
        "print([m for m in ('xarray', 'scipy', 'bokeh', 'pandas', 'h5py') if m in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
