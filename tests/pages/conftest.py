"""The programs of docs that make pages and pictures; what they write is checked by `make pages`."""

import sys

from tests.support.docs import DOCS

sys.path.append(str(DOCS))
