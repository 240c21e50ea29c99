"""The packed inputs of the fuzzer are those that are unpacked."""

from pathlib import Path

from tests.hostile.corpus import CORPUS, pack, unpack


def test_inputs_are_packed_as_they_were(tmp_path: Path) -> None:
    unpack(tmp_path / "files")
    targets = sorted(path.stem for path in CORPUS.iterdir())
    assert targets == ["border", "lcp"]
    for target in targets:
        files = tmp_path / "files" / target
        assert len(list(files.iterdir())) > 50
        (files / "again").write_bytes(next(files.iterdir()).read_bytes())
        pack(target, files, tmp_path)
        packed = (tmp_path / f"{target}.txt").read_bytes()
        assert packed == (CORPUS / f"{target}.txt").read_bytes()
