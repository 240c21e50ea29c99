"""Every kind of page at three widths, light and dark: quiet, offline, nothing cut, accessible."""

import pytest

from tests.browser.browser import Page, rgb

# Titles, legends, and what the first screen says; tables scroll in boxes of their own.
TEXTS = "h1, h2, h3, figcaption *, .legend button, .verdict *, .bullets *, .tools *, .identity dd"


def in_scheme(page: Page, scheme: str) -> None:
    page("emulateMedia", {"colorScheme": scheme})
    found, schemes = page.js("[tried.background(), arcless.data.schemes]")
    assert found == rgb(schemes[scheme]["paper"])


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_is_cut_and_nothing_complains(page: Page, scheme: str) -> None:
    in_scheme(page, scheme)
    assert page.js("tried.keys().length") > 0
    assert page.js("tried.overflow()") <= 0
    assert page.js(f"tried.clipped({TEXTS!r})") == []
    assert page.js("tried.empty()") == []
    assert page.js("tried.keys().flatMap(tried.cut)") == []
    assert page.js(f"tried.wrong_colours({scheme!r})") == []


# A contrast does not depend on the width.
@pytest.mark.parametrize(
    ("opened", "scheme"),
    [(1400, "light"), (1400, "dark"), (390, "light")],
    indirect=["opened"],
    scope="session",
)
def test_accessible_by_axe(page: Page, scheme: str) -> None:
    in_scheme(page, scheme)
    assert page.axe() == []
