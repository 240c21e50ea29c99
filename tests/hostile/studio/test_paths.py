"""Nothing outside of the folder is ever in an answer, and no text runs code."""

from pathlib import Path

from tests.hostile.studio.asked import LEADING_OUT, PATHS, POSTED
from tests.hostile.studio.conftest import CANARY, check_well, read_all
from tests.support.studio_server import StudioServer


def leading_out(folder: Path) -> list[str]:
    return [one.format(outside=folder.parent / "outside") if "{outside}" in one else one
            for one in LEADING_OUT]  # fmt: skip


def test_no_path_leads_out(server: StudioServer, folder: Path) -> None:
    for path in leading_out(folder):
        for route in PATHS[5:]:
            for name in ("path", "run", "name"):
                status, _, content = server.ask(route, **{name: path, "key": "force"})
                assert CANARY not in content, (route, name, path)
                assert status < 500 or route == "/api/stream", (route, name, path, content)
    check_well(server, folder)


def test_no_question_leads_out(server: StudioServer, folder: Path) -> None:
    text = (folder / "my.yaml").read_text()
    for path in leading_out(folder):
        named = text.replace("line: my-line.yaml", f"line: {path!r}")
        bodies = [
            {"path": path, "text": "name: x\n", "version": None},
            {"path": "my.yaml", "text": named, "want": ["line"], "question": 1},
            {"path": path, "text": None, "want": ["line"], "question": 1},
            {"path": "my.yaml", "text": None, "changes": {"line": path}, "want": ["line"],
             "question": 1},
            {"scenario": path, "name": "v", "changes": {}},
            {"scenario": "my.yaml", "name": "v", "changes": {"line": path}},
            {"scenario": "my.yaml", "name": path, "changes": {}},
            {"scenario": "my.yaml", "changes": {"line": path}},
            {"name": path, "from": "shipped:line/ac-simple-55"}, {"name": "v", "from": path},
            {"subjects": [path, path]},
        ]  # fmt: skip
        for body in bodies:
            for route in (*POSTED[:-1], "runs"):
                status, _, content = server.ask(f"/api/{route}", "POST", body)
                assert CANARY not in content, (route, body)
                assert status < 500, (route, body, content)
        status, _, content = server.ask(f"/api/measured?name={'x' * 9}.py", "POST", CANARY)
        assert status == 400
    check_well(server, folder)


def test_static_files_are_those_of_the_page(server: StudioServer, folder: Path) -> None:
    for path in ("/../app.py", "/..%2fapp.py", "/%2e%2e/server/app.py", "//etc/passwd", "/assets/..",
                 "/assets/../../server/app.py", "/%00", "/index.html%00.js", "/.gitignore"):  # fmt: skip
        with server.connect() as line:
            line.sendall(f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n"
                         f"Cookie: {server.cookie}\r\nConnection: close\r\n\r\n".encode())  # fmt: skip
            content = read_all(line)
        assert b"def application" not in content, path
        assert b"root:" not in content, path
    check_well(server, folder)


def test_no_tag_and_no_expression_runs_code(server: StudioServer, folder: Path) -> None:
    proof = folder / "proof"
    make = f"import pathlib; pathlib.Path({str(proof)!r}).touch()"
    texts = [
        f"!!python/object/apply:os.system ['touch {proof}']\n",
        f"format: arcless-line/1\nname: !!python/object/apply:os.system ['touch {proof}']\n",
        "format: arcless-line/1\nname: &a !!python/name:os.system\nx: *a\n",
        f"format: arcless-study/1\nname: s\nscenario: my.yaml\nvariables:\n"
        f"  v: {{field: speed, values: [1, 2]}}\noutputs:\n"
        f"  o: \"__import__('os').system('touch {proof}')\"\n",
        f"format: arcless-study/1\nname: s\nscenario: my.yaml\noutputs: {{o: \"exec({make!r})\"}}\n",
        (folder / "my.yaml").read_text() + "x: !!python/module:os\n",
    ]  # fmt: skip
    for text in texts:
        for route in ("check", "form", "patch", "statics"):
            body = {"path": "my.yaml", "text": text, "changes": {"name": text}, "want": ["line"],
                    "question": 1}  # fmt: skip
            status, _, _ = server.ask(f"/api/{route}", "POST", body)
            assert status in (200, 400)
    assert server.json("check", "POST", {"path": "my.yaml", "text": texts[0]})["errors"]
    assert not proof.exists()
    check_well(server, folder)
