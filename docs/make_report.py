"""Take the picture of a report for README and tutorial: `python docs/make_report.py`.

The case of `make demo` is run in a temporary place, and the first screen of its report is looked at
by Chromium.
"""

import base64
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
sys.path.append(str(ROOT))

from tests.browser import tools  # noqa: E402
from tests.browser.browser import Browser  # noqa: E402
from tests.browser.kinds import arcless  # noqa: E402

SCENARIO = "en50318-ac-simple-320"
PICTURE = ROOT / "docs" / "images" / "report.webp"
# Below 40, WebP smears the curves of the figure.
QUALITY = 50
SIZE = {"width": 1120, "height": 900}


def main() -> None:
    """Take the picture."""
    if sentence := tools.missing():
        sys.exit(f"make: {sentence}")
    browser = Browser()
    with TemporaryDirectory() as folder:
        arcless("run", SCENARIO, "--certainty", "--quiet", "--out", folder, "--overwrite")
        with browser.open(Path(folder) / "report.html") as page:
            page("setViewportSize", SIZE)
            page.js("document.fonts.ready.then(() => true)")
            taken = page("send", "Page.captureScreenshot", {"format": "webp", "quality": QUALITY})
    browser.close()
    PICTURE.write_bytes(base64.b64decode(taken["data"]))
    print(f"{PICTURE.name}, {PICTURE.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
