"""The gate: hosts, origins, tokens, the cookie, and what every answer says to a browser."""

import pytest
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from arcless.studio.server import keys as keys_module
from arcless.studio.server.keys import TICKET_S, Keys
from tests.unit.studio.conftest import OWN, PORT, Ask

REFUSED, MISDIRECTED, SEE_OTHER, OK = 403, 421, 303, 200
FOREIGN_HOSTS = [
    "evil.example", "127.0.0.1", f"127.0.0.1:{PORT + 1}", f"evil.example:{PORT}", "",
    f"localhost.evil.example:{PORT}", f"127.0.0.1:{PORT}@evil.example", f"0.0.0.0:{PORT}",
    f"127.1:{PORT}", f"[::]:{PORT}",
]  # fmt: skip
FOREIGN_ORIGINS = [
    "http://evil.example", "null", f"https://127.0.0.1:{PORT}", f"http://127.0.0.1:{PORT + 1}",
    "http://127.0.0.1", f"http://localhost:{PORT}", f"{OWN}.evil.example", "",
]  # fmt: skip


def routes_of(client: TestClient) -> list[BaseRoute]:
    return list(client.app._app.routes)  # type: ignore[attr-defined]


@pytest.mark.parametrize("host", FOREIGN_HOSTS)
def test_other_hosts_get_nothing(client: TestClient, host: str) -> None:
    for path in ("/", "/api/project", "/index.html"):
        assert client.get(path, headers={"host": host}).status_code == MISDIRECTED


@pytest.mark.parametrize("host", [f"127.0.0.1:{PORT}", f"localhost:{PORT}", f"[::1]:{PORT}"])
def test_names_of_this_machine(client: TestClient, host: str) -> None:
    own = {"host": host, "origin": f"http://{host}"}
    assert client.get("/api/project", headers=own).status_code == OK


@pytest.mark.parametrize("origin", FOREIGN_ORIGINS)
@pytest.mark.parametrize("method", ["GET", "POST", "PUT", "DELETE", "OPTIONS"])
def test_other_origins_get_nothing(client: TestClient, origin: str, method: str) -> None:
    found = client.request(method, "/api/project", headers={"origin": origin})
    assert found.status_code == REFUSED
    assert not [name for name in found.headers if name.startswith("access-control")]


def test_only_a_plain_question_needs_no_origin(stranger: Ask, keys: Keys) -> None:
    client = stranger()
    client.cookies.set(keys.cookie, str(keys.session_for(keys.token)))
    assert client.get("/api/project").status_code == OK
    for method in ("POST", "PUT", "DELETE", "PATCH", "OPTIONS"):
        assert client.request(method, "/api/project").status_code == REFUSED
    with pytest.raises(WebSocketDisconnect), client.websocket_connect("/api/stream"):
        pass


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_other_sites_get_no_answer_of_the_interface(client: TestClient, site: str) -> None:
    found = client.get("/api/project", headers={"sec-fetch-site": site})
    assert found.status_code == REFUSED


@pytest.mark.parametrize("origin", FOREIGN_ORIGINS)
def test_sockets_of_other_origins(client: TestClient, origin: str) -> None:
    with (
        pytest.raises(WebSocketDisconnect),
        client.websocket_connect("/api/stream", headers={"origin": origin}),
    ):
        pass


def test_without_the_cookie_every_route_refuses(stranger: Ask) -> None:
    client = stranger(origin=OWN)
    asked = 0
    for route in routes_of(client):
        if isinstance(route, Route):
            for method in route.methods or ():
                path = route.path.replace("{", "").replace("}", "")
                assert client.request(method, path).status_code == REFUSED, path
                asked += 1
        elif isinstance(route, WebSocketRoute):
            with pytest.raises(WebSocketDisconnect), client.websocket_connect(route.path):
                pass
        else:
            assert isinstance(route, Mount)
            assert client.get("/").status_code == REFUSED
            assert client.get("/index.html").status_code == REFUSED
    # The routes of the contract are more than these; the number tells that they were found.
    assert asked > 20


@pytest.mark.parametrize("value", ["", "x", "é", "\x7f", "a" * 5000, "0"])
def test_wrong_cookies(stranger: Ask, keys: Keys, value: str) -> None:
    client = stranger(origin=OWN)
    raw = f"{keys.cookie}={value}".encode()
    assert client.get("/api/project", headers=[(b"cookie", raw)]).status_code == REFUSED


def test_the_cookie_of_another_port_is_another_one(stranger: Ask, keys: Keys) -> None:
    client, other = stranger(origin=OWN), Keys(PORT + 1)
    assert other.cookie != keys.cookie
    client.cookies.set(other.cookie, str(keys.session_for(keys.token)))
    assert client.get("/api/project").status_code == REFUSED


def test_the_token_becomes_a_cookie_that_no_script_reads(stranger: Ask, keys: Keys) -> None:
    client = stranger()
    found = client.get("/", params={"token": keys.token})
    assert (found.status_code, found.headers["location"]) == (SEE_OTHER, "/")
    said = found.headers["set-cookie"].lower()
    assert str(PORT) in said.split("=")[0]
    assert "httponly" in said
    assert "samesite=strict" in said
    assert "domain" not in said
    assert keys.token.lower() not in said
    assert client.get("/").status_code == OK


def test_a_token_opens_the_page_alone(stranger: Ask, keys: Keys) -> None:
    client = stranger(origin=OWN)
    for path in ("/api/project", "/index.html", "/api/stream"):
        found = client.get(path, params={"token": keys.token})
        assert found.status_code == REFUSED
        assert "set-cookie" not in found.headers


def test_a_ticket_is_good_once_and_for_a_while(keys: Keys, monkeypatch: pytest.MonkeyPatch) -> None:
    ticket = keys.ticket()
    session = keys.session_for(ticket)
    assert session is not None
    assert keys.admits(session)
    assert keys.session_for(ticket) is None
    late = keys.ticket()
    now = keys_module.time.monotonic() + TICKET_S + 1.0
    monkeypatch.setattr(keys_module.time, "monotonic", lambda: now)
    assert keys.session_for(late) is None


def test_secrets_differ_and_are_long() -> None:
    one, other = Keys(PORT), Keys(PORT)
    # 256 bits in base 64.
    assert len({one.token, other.token, one.ticket(), other.ticket()}) == 4
    assert len(one.token) >= 43


@pytest.mark.parametrize("path", ["/", "/api/project", "/api/none", "/none.js"])
def test_headers_of_every_answer(client: TestClient, path: str) -> None:
    said = client.get(path).headers
    policy = dict(part.strip().split(" ", 1) for part in said["content-security-policy"].split(";"))
    assert policy["default-src"] == "'none'"
    assert policy["script-src"] == "'self'"
    assert policy["connect-src"] == "'self'"
    assert policy["frame-ancestors"] == "'none'"
    assert policy["base-uri"] == "'none'"
    assert policy["form-action"] == "'none'"
    assert "unsafe" not in said["content-security-policy"]
    assert said["x-content-type-options"] == "nosniff"
    assert said["referrer-policy"] == "no-referrer"
    assert said["cross-origin-opener-policy"] == "same-origin"
    assert said["cross-origin-resource-policy"] == "same-origin"
    if path == "/" or path.startswith("/api"):
        assert said["cache-control"] == "no-store"


def test_refusals_have_the_headers_too(stranger: Ask) -> None:
    said = stranger().get("/").headers
    assert "default-src 'none'" in said["content-security-policy"]
    assert said["x-content-type-options"] == "nosniff"


def test_many_fields_in_an_address_are_no_fault(client: TestClient, stranger: Ask) -> None:
    path = "/?" + "&".join(f"token={number}" for number in range(5000))
    assert client.get(path).status_code == OK
    assert stranger().get(path).status_code == REFUSED
