"""The studio's server as a process with a page of one line, and what it is asked over sockets."""

import http.client
import json
import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Self

# Time in s that a start may take: imports on a machine that does much else.
START_S = 60.0
PAGE = "<!doctype html><title>Arcless studio</title>"


class Server:
    """`arcless studio FOLDER`, killed at the end of the block.

    Attributes
    ----------
    address
        The address that it printed.
    """

    def __init__(self, folder: Path, place: Path, *words: str) -> None:
        page = place / "page"
        page.mkdir(exist_ok=True)
        (page / "index.html").write_text(PAGE, "utf-8")
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.support.studio_server", str(page), "studio",
             str(folder), "--no-browser", *words],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            env={**os.environ, "PYTHONUNBUFFERED": "1"},
        )  # fmt: skip
        assert self.process.stdout is not None
        self.address = self.process.stdout.readline().strip()
        assert self.address.startswith("http://127.0.0.1:"), self.process.communicate()
        self.port = int(self.address.split(":")[2].split("/")[0])
        self.host = f"127.0.0.1:{self.port}"
        self.cookie = self._cookie()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if sys.platform != "win32":  # nothing stops a process there
            self.process.send_signal(signal.SIGCONT)
        self.process.kill()
        self.process.communicate()

    def _cookie(self) -> str:
        answer = self.ask("GET", self.address.partition(str(self.port))[2], cookie=None)
        assert answer.status == http.client.SEE_OTHER, answer.status
        return str(answer.headers["set-cookie"]).split(";")[0]

    def ask(
        self, method: str, path: str, body: bytes | dict[str, Any] | None = None,
        cookie: str | None = "", timeout: float = 30.0, **headers: str,
    ) -> "Answer":  # fmt: skip
        """Ask as the page does, on a connection of its own."""
        given = {"Origin": f"http://{self.host}"} | headers
        if cookie is not None:
            given["Cookie"] = cookie or self.cookie
        content = json.dumps(body).encode() if isinstance(body, dict) else body
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        try:
            connection.request(method, path, content, given)
            found = connection.getresponse()
            return Answer(found.status, found.headers, found.read())
        finally:
            connection.close()

    def connect(self, timeout: float = 30.0) -> socket.socket:
        """Return a socket to the server."""
        return socket.create_connection(("127.0.0.1", self.port), timeout)

    def head(self, line: str, *more: str) -> bytes:
        """Return the head of a request as the page sends it, with its first line given."""
        lines = [line, f"Host: {self.host}", f"Origin: http://{self.host}",
                 f"Cookie: {self.cookie}", *more, "", ""]  # fmt: skip
        return "\r\n".join(lines).encode("latin-1")

    def answers_within(self) -> float:
        """Return the time in s that the server takes to answer."""
        started = time.monotonic()
        assert self.ask("GET", "/api/schema").status == http.client.OK
        return time.monotonic() - started

    def memory(self) -> float:
        """Return the memory of the server in MiB."""
        status = Path(f"/proc/{self.process.pid}/status").read_text("utf-8")
        kibibytes = next(line for line in status.splitlines() if line.startswith("VmRSS"))
        return int(kibibytes.split()[1]) / 1024.0

    def open_files(self) -> int:
        """Return how many files and sockets the server has open."""
        return len(list(Path(f"/proc/{self.process.pid}/fd").iterdir()))


class Answer:
    """An answer of the server."""

    def __init__(self, status: int, headers: http.client.HTTPMessage, body: bytes) -> None:
        self.status, self.headers, self.body = status, headers, body

    def json(self) -> Any:
        """Return the value of its body."""
        return json.loads(self.body)


def is_there(process: int) -> bool:
    """Return whether a process has not ended."""
    try:
        return "Z" not in Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except FileNotFoundError:
        return False


def main() -> None:
    """Run the command line with the page of a folder."""
    from arcless.cli import main as command
    from arcless.studio.server import page

    page.FOLDER = Path(sys.argv.pop(1))
    command()


if __name__ == "__main__":
    main()
