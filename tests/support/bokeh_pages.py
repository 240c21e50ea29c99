"""Pages read again with Bokeh's own classes, which know each object and attribute."""

import json
import re
from html.parser import HTMLParser
from typing import Any

_CONFIG = {
    "type": "object", "name": "DocumentConfig", "id": "config",
    "attributes": {"notifications": {"type": "object", "name": "Notifications", "id": "notes"}},
}  # fmt: skip


def document_of(roots: list[Any]) -> Any:
    """Return the document of objects as a page has them."""
    import bokeh.models  # noqa: F401 - only imported classes are known
    from bokeh.document import Document

    _check_names(roots)
    return Document.from_json({"version": "", "title": "", "config": _CONFIG, "roots": roots})


def _check_names(written: Any) -> None:
    """Fail at an attribute that its object has not: Bokeh leaves it out, and only logs that."""
    from bokeh.model import Model

    if isinstance(written, dict):
        if written.get("type") == "object":
            known = Model.model_class_reverse_map[written["name"]].properties()
            unknown = set(written["attributes"]) - set(known)
            assert not unknown, f"{written['name']} has no {unknown}"
        written = list(written.values())
    if isinstance(written, list):
        for item in written:
            _check_names(item)


def data_in(page: str) -> Any:
    """Return what the script of a page reads: objects, groups of axes, tokens, the track."""
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    assert found is not None, "the page has no data"
    return json.loads(found[1])


def document_in(page: str) -> Any:
    """Return the document that the script of a page draws."""
    return document_of(data_in(page)["objects"]["roots"])


def mistakes_of(document: Any) -> list[Any]:
    """Return what Bokeh finds wrong with a document that it could read."""
    from bokeh.core.validation.check import check_integrity

    found = check_integrity(document.models)
    return [*found.error, *found.warning]


class _Words(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.words: list[str] = []
        self._hidden = False

    def handle_starttag(self, tag: str, _: Any) -> None:
        self._hidden = tag in ("script", "style")

    def handle_endtag(self, _: str) -> None:
        self._hidden = False

    def handle_data(self, data: str) -> None:
        if not self._hidden:
            self.words.append(data)


def text_in(page: str) -> str:
    """Return the text that a reader sees, without scripts and styles, with single spaces."""
    found = _Words()
    found.feed(page)
    return " ".join("".join(found.words).split())
