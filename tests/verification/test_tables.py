"""Every verification file has a table of faults, and what both say is recorded."""

from collections import Counter
from importlib import import_module
from pathlib import Path

import pytest

from arcless.validate.evidence import GROUPS
from tests.support import records

HERE = Path(__file__).parent
FILES = [file for group in GROUPS for file in sorted((HERE / group).glob("test_*.py"))]


@pytest.mark.parametrize("file", FILES, ids=lambda file: "/".join(records.place(file)))
def test_every_topic_and_its_faults_are_recorded(file: Path) -> None:
    assert "\nFAULTS = " in file.read_text(encoding="utf-8"), "no table of what its checks notice"
    record = records.load(*records.place(file))
    assert record.rows and record.faults, "nothing recorded: run the file with --publish"
    assert record.title and record.text
    faults = import_module(f"tests.verification.{file.parent.name}.{file.stem}").FAULTS
    new = Counter(fault.what for fault in faults) - Counter(told.fault for told in record.faults)
    assert not new, "not recorded: run the file with --publish"
    assert len({fault.name for fault in faults}) == len(faults) > 0


def test_no_record_is_without_its_file() -> None:
    known = [records.path_of(*records.place(file)) for file in FILES]
    assert sorted(records.RECORDS.glob("*/*.json")) == sorted(known)
    assert len(known) > 20
