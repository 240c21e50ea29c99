"""Rows as the journal has them: a text, and a seal that no changed text and no other study fits."""

import json
from hashlib import blake2b

from arcless.study.journal.row import Row, row_of

FORMAT = "arcless-study-journal/1"
# Of 128 bits: of 10^12 damaged texts one would pass with a chance of 3e-27.
_BYTES = 16
SEAL_LETTERS = 2 * _BYTES


def seal(text: bytes, study: str) -> bytes:
    """Return the seal of a text of a study, which is named by the hash of what it asks."""
    return blake2b(text, digest_size=_BYTES, key=f"{FORMAT} {study}".encode()).hexdigest().encode()


def written(row: Row, study: str) -> tuple[bytes, bytes]:
    """Return a row as a text, and its seal."""
    text = json.dumps(row.to_dict(), ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    plain = text.encode()
    return plain, seal(plain, study)


def opened(text: object, mark: object, study: str, number: object = None) -> Row | None:
    """Return a row from a text and its seal; None where they do not fit.

    Parameters
    ----------
    text, mark
        As they were found.
    study
        Hash of what the study asks.
    number
        Number of the variant, where it stands next to the text.
    """
    if not (isinstance(text, bytes) and isinstance(mark, bytes) and mark == seal(text, study)):
        return None
    row = row_of(json.loads(text))
    return row if row is not None and number in (None, row.variant) else None
