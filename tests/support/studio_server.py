"""`arcless studio` as a process, and clients of it that are no browser."""

import http.client
import json
import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from types import TracebackType
from typing import Any, Self
from urllib.parse import urlencode

# Time in s for an answer. Shorter, a busy machine fails tests that are right.
PATIENCE_S = 30.0


class StudioServer:
    """A server on a folder, ended with the block.

    Attributes
    ----------
    port, cookie
        Its port, and its cookie as a browser sends it.
    """

    def __init__(self, folder: Path, **environment: str) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "arcless", "studio", str(folder), "--no-browser"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONUNBUFFERED": "1", **environment},
        )
        assert self._process.stdout is not None
        self.address = self._process.stdout.readline().strip()
        assert self.address.startswith("http://127.0.0.1:"), self.error()
        self.port = int(self.address.split(":")[2].split("/")[0])
        status, head, _ = self.ask(self.address.split(str(self.port))[1], cookie="")
        assert status == 303
        self.cookie = head["set-cookie"].split(";")[0]

    @property
    def pid(self) -> int:
        return self._process.pid

    def ask(
        self,
        to: str,
        method: str = "GET",
        body: Any = None,
        cookie: str | None = None,
        patience: float = PATIENCE_S,
        **query: str,
    ) -> tuple[int, dict[str, str], bytes]:
        """Ask as the page does; return status, head and body."""
        line = http.client.HTTPConnection("127.0.0.1", self.port, timeout=patience)
        content = body if isinstance(body, bytes) or body is None else json.dumps(body).encode()
        head = {"Cookie": self.cookie if cookie is None else cookie}
        if method != "GET":
            head["Origin"] = f"http://127.0.0.1:{self.port}"
        try:
            line.request(method, to + (f"?{urlencode(query)}" if query else ""), content, head)
            answer = line.getresponse()
            found = {name.lower(): value for name, value in answer.getheaders()}
            return answer.status, found, answer.read()
        finally:
            line.close()

    def json(self, to: str, method: str = "GET", body: Any = None, **query: str) -> Any:
        """Ask a route and return its answer."""
        status, _, content = self.ask(f"/api/{to}", method, body, **query)
        assert status == 200, content
        return json.loads(content)

    def connect(self) -> socket.socket:
        """Return a connection to say anything on."""
        return socket.create_connection(("127.0.0.1", self.port), timeout=PATIENCE_S)

    def memory(self) -> float:
        """Return the memory of the process that is in use, in MB."""
        status = Path(f"/proc/{self.pid}/status").read_text()
        return int(status.split("VmRSS:")[1].split()[0]) / 1000

    def signal(self, number: signal.Signals) -> None:
        self._process.send_signal(number)

    def wait(self, patience: float = PATIENCE_S) -> tuple[int, float]:
        """Return the exit code and the seconds that it took."""
        start = time.monotonic()
        return self._process.wait(patience), time.monotonic() - start

    def error(self) -> str:
        """Return all of standard error, of a server that has ended."""
        assert self._process.stderr is not None
        return self._process.stderr.read()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None
    ) -> None:
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGCONT)
            self._process.terminate()
            try:
                self._process.wait(PATIENCE_S)
            except subprocess.TimeoutExpired:
                self._process.kill()
                raise
        told = self.error()
        if kind is None:
            assert told == "", told
