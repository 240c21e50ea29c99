"""The gate: who may ask, from where, and what is said with every answer."""

import time
from collections.abc import Callable
from typing import Any

import pytest
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse
from starlette.routing import Route, WebSocketRoute
from starlette.testclient import TestClient
from starlette.websockets import WebSocket, WebSocketDisconnect

from arcless.studio.answers.answers import route
from arcless.studio.server import keys as keys_module
from arcless.studio.server.crowd import Crowd
from arcless.studio.server.gate import Gate
from arcless.studio.server.keys import Keys

PORT = 8123
OWN = f"http://127.0.0.1:{PORT}"


async def page(_: Request) -> PlainTextResponse:
    return PlainTextResponse("the page")


async def length(request: Request) -> int:
    return len(await request.body())


async def stream(socket: WebSocket) -> None:
    await socket.accept()
    await socket.send_text("hello")
    await socket.close()


@pytest.fixture
def keys() -> Keys:
    return Keys(PORT)


Client = Callable[..., TestClient]


@pytest.fixture
def client(keys: Keys) -> Client:
    """Return a function that makes a browser, which knows the cookie or not."""
    routes = [
        route("length", length, "POST"),
        route("long", length, "POST"),
        WebSocketRoute("/api/stream", stream),
        Route("/{path:path}", page),
    ]
    app = Gate(Starlette(routes=routes), keys, Crowd(), {"/api/long": 10 * 2**20})

    def made(base: str = OWN, *, known: bool = True) -> TestClient:
        browser = TestClient(app, base_url=base, follow_redirects=False)
        if known:
            assert browser.get(f"/?token={keys.token}").status_code == 303
        return browser

    return made


def test_token_becomes_a_cookie_and_leaves_the_address(client: Client, keys: Keys) -> None:
    browser = client(known=False)
    answer = browser.get(f"/?token={keys.token}")
    assert (answer.status_code, answer.headers["location"]) == (303, "/")
    cookie = answer.headers["set-cookie"]
    assert cookie.startswith(f"arcless-studio-{PORT}=")
    assert "HttpOnly" in cookie
    assert "SameSite=strict" in cookie
    assert keys.token not in cookie
    assert browser.get("/").text == "the page"


def test_without_the_cookie_nothing_is_answered(client: Client) -> None:
    browser = client(known=False)
    for path in ("/", "/assets/index.js", "/api/project", "/api/", "/?token=", "/?token=wrong"):
        answer = browser.get(path)
        assert answer.status_code == 403, path
        assert "the page" not in answer.text
    assert "arcless studio" in browser.get("/").text
    assert "terminal" in browser.get("/api/project").json()["error"]["text"]


def test_token_opens_nothing_but_the_page(client: Client, keys: Keys) -> None:
    assert client(known=False).get(f"/api/project?token={keys.token}").status_code == 403


def test_cookie_of_another_server_or_by_another_name(client: Client) -> None:
    browser = client(known=False)
    for cookie in (f"arcless-studio-{PORT}=x", "arcless-studio-1=x", "=", ";;;", "a\xff=b"):
        answer = browser.get("/", headers={"cookie": cookie.encode("latin-1")})
        assert answer.status_code == 403


def test_printed_token_serves_two_browsers(client: Client) -> None:
    assert client().get("/").text == client().get("/").text == "the page"


def test_ticket_of_a_started_browser_is_good_once(client: Client, keys: Keys) -> None:
    ticket, browser = keys.ticket(), client(known=False)
    assert browser.get(f"/?token={ticket}").status_code == 303
    other = client(known=False).get(f"/?token={ticket}")
    assert other.status_code == 403
    assert "good\nonce" in other.text


def test_ticket_is_good_for_a_minute(
    client: Client, keys: Keys, monkeypatch: pytest.MonkeyPatch
) -> None:
    ticket, now = keys.ticket(), time.monotonic()
    monkeypatch.setattr(keys_module.time, "monotonic", lambda: now + keys_module.TICKET_S + 1)
    assert client(known=False).get(f"/?token={ticket}").status_code == 403


@pytest.mark.parametrize(
    "host",
    ["evil.example", f"evil.example:{PORT}", "127.0.0.1", "127.0.0.1:80", f"127.0.0.1.:{PORT}",
     f"127.0.0.2:{PORT}", f"localhost.evil.example:{PORT}", f"0.0.0.0:{PORT}", ""],
)  # fmt: skip
def test_host_of_another_name(client: Client, host: str) -> None:
    """A name that was made to lead here (DNS rebinding) is answered nothing, not even a token."""
    answer = client().get("/", headers={"host": host})
    assert answer.status_code == 421
    assert "the page" not in answer.text


def test_own_names(client: Client) -> None:
    for name in ("127.0.0.1", "localhost", "[::1]"):
        assert client(f"http://{name}:{PORT}").get("/").text == "the page"


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", f"https://127.0.0.1:{PORT}", "http://127.0.0.1:1", ""]
)
def test_origin_of_another_page(client: Client, origin: str) -> None:
    browser = client()
    head = {"origin": origin}
    assert browser.get("/", headers=head).status_code == 403
    assert browser.post("/api/length", content=b"x", headers=head).status_code == 403


def test_what_changes_something_needs_the_origin(client: Client) -> None:
    browser = client()
    assert browser.post("/api/length", content=b"x").status_code == 403
    assert browser.request("DELETE", "/api/length").status_code == 403
    answer = browser.post("/api/length", content=b"x", headers={"origin": OWN})
    assert (answer.status_code, answer.json()) == (200, 1)


def test_questions_that_another_page_makes_a_browser_ask(client: Client) -> None:
    browser = client()
    for site in ("cross-site", "same-site"):
        assert browser.get("/api/x", headers={"sec-fetch-site": site}).status_code == 403
    for site in ("same-origin", "none"):
        assert browser.get("/api/x", headers={"sec-fetch-site": site}).text == "the page"


@pytest.mark.parametrize(
    ("known", "origin"), [(True, None), (True, "http://evil.example"), (True, "null"), (False, OWN)]
)
def test_stream_is_refused(client: Client, known: bool, origin: str | None) -> None:
    head = {} if origin is None else {"origin": origin}
    browser = client(known=known)
    with pytest.raises(WebSocketDisconnect), browser.websocket_connect(
        f"ws://127.0.0.1:{PORT}/api/stream", headers=head
    ):  # fmt: skip
        pass


def test_stream_of_the_own_page(client: Client) -> None:
    browser = client()
    cookie = "; ".join(f"{name}={value}" for name, value in browser.cookies.items())
    with browser.websocket_connect(
        f"ws://127.0.0.1:{PORT}/api/stream", headers={"origin": OWN, "cookie": cookie}
    ) as socket:
        assert socket.receive_text() == "hello"


@pytest.mark.parametrize("path", ["/", "/api/x", "/assets/x.js"])
@pytest.mark.parametrize("known", [True, False])
def test_headers_of_every_answer(client: Client, path: str, known: bool) -> None:
    head = client(known=known).get(path).headers
    policy = dict(part.split(" ", 1) for part in head["content-security-policy"].split("; "))
    assert policy["default-src"] == policy["frame-ancestors"] == policy["base-uri"] == "'none'"
    assert policy["script-src"] == policy["style-src"] == policy["connect-src"] == "'self'"
    assert "unsafe" not in head["content-security-policy"]
    assert head["x-content-type-options"] == "nosniff"
    assert head["referrer-policy"] == "no-referrer"
    assert head["cross-origin-opener-policy"] == "same-origin"
    assert head["cross-origin-resource-policy"] == "same-origin"
    if not path.startswith("/assets"):
        assert head["cache-control"] == "no-store"


def post(browser: TestClient, path: str, content: Any) -> tuple[int, Any]:
    answer = browser.post(path, content=content, headers={"origin": OWN})
    return answer.status_code, answer.json()


def test_bodies_are_limited_by_their_route(client: Client) -> None:
    browser, mib = client(), 2**20
    assert post(browser, "/api/length", b"x" * 4 * mib) == (200, 4 * mib)
    status, answer = post(browser, "/api/length", b"x" * (4 * mib + 1))
    assert (status, answer["error"]["text"]) == (413, "The question is too long: 4 MiB at most")
    assert post(browser, "/api/long", b"x" * 10 * mib)[0] == 200
    assert post(browser, "/api/long", b"x" * 11 * mib)[0] == 413


def test_bodies_without_a_length_are_counted(client: Client) -> None:
    browser = client()
    pieces = (b"x" * 2**20 for _ in range(5))
    assert post(browser, "/api/length", pieces)[0] == 413
