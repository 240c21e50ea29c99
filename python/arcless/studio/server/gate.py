"""The gate before all routes: who asks, from where, and what is said with every answer.

Host is checked, so that a page of the internet whose name was made to lead to this machine gets
nothing (DNS rebinding); Origin, so that no other page can ask in the user's name; then the cookie.
"""

from collections.abc import Mapping
from http.cookies import CookieError, SimpleCookie
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import HTMLResponse, JSONResponse, PlainTextResponse, RedirectResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from arcless.studio.server.bodies import LONGEST, limited
from arcless.studio.server.crowd import Crowd, client_of
from arcless.studio.server.keys import Keys

CONTENT_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
    "connect-src 'self'; font-src 'self'; worker-src 'self'; frame-src 'self'; "
    "frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
)
# Headers of every answer; its route may set them itself.
_HEADERS = {
    "Content-Security-Policy": CONTENT_POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}
# Fields of an address behind the question mark; the longest question of the page has eight.
_MOST_FIELDS = 50
_LOCKED = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Arcless studio</title></head>
<body><h1>Arcless studio</h1>
<p>Open the address that <code>arcless studio</code> printed in the terminal, with its token. It
belongs to this server and opens it in any browser of yours. What a browser is started with is good
once.</p></body></html>
"""


class Gate:
    """An application behind the gate.

    Parameters
    ----------
    app
        What answers those who may ask.
    keys
        Secrets of the server.
    crowd
        Connections that have not shown the cookie yet.
    longest
        Most bytes of a question, by its path, where it is another number than that of all.
    """

    def __init__(self, app: ASGIApp, keys: Keys, crowd: Crowd, longest: Mapping[str, int]) -> None:
        self._app, self._keys, self._crowd, self._longest = app, keys, crowd, longest
        self._hosts = {f"{name}:{keys.port}" for name in ("127.0.0.1", "localhost", "[::1]")}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, or refuse."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        answer = self._refusal(scope, headers)
        if answer is not None and scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 1008})
            return
        longest = self._longest.get(scope["path"], LONGEST)
        body = limited(scope, receive, longest)
        await (answer or self._app)(scope, body, _with_headers(scope, send))

    def _refusal(self, scope: Scope, headers: Headers) -> ASGIApp | None:
        """Return what is answered to somebody who may not ask; None to who may."""
        host = headers.get("host", "")
        if host not in self._hosts or len(headers.getlist("host")) > 1:
            return PlainTextResponse("This server answers on its own address only.", 421)
        own = headers.get("origin") == f"http://{host}"
        is_plain = scope["type"] == "http" and scope["method"] in ("GET", "HEAD")
        if not own and ("origin" in headers or not is_plain):
            return PlainTextResponse("This server answers its own page only.", 403)
        if headers.get("sec-fetch-site", "none") not in ("same-origin", "none") and _is_api(scope):
            return PlainTextResponse("This server answers its own page only.", 403)
        if self._keys.admits(_cookie(headers, self._keys.cookie)):
            if client := client_of(scope):
                self._crowd.leave(client)
            return None if "token" not in _query(scope) else RedirectResponse("/", 303)
        return self._unknown(scope)

    def _unknown(self, scope: Scope) -> ASGIApp:
        """Return the answer to somebody without the cookie: one, for a token."""
        token = _query(scope).get("token")
        session = self._keys.session_for(token[0]) if token and scope["path"] == "/" else None
        if session is not None and scope["type"] == "http":
            answer = RedirectResponse("/", 303)
            answer.set_cookie(self._keys.cookie, session, httponly=True, samesite="strict")
            return answer
        if _is_api(scope):
            text = "Open the address that the terminal shows again: the studio was restarted"
            return JSONResponse({"error": {"text": text}}, 403)
        return HTMLResponse(_LOCKED, 403)


def _is_api(scope: Scope) -> bool:
    return str(scope["path"]).startswith("/api")


def _query(scope: Scope) -> dict[str, list[str]]:
    try:
        return parse_qs(scope["query_string"].decode("latin-1"), max_num_fields=_MOST_FIELDS)
    except ValueError:  # more of them
        return {}


def _cookie(headers: Headers, name: str) -> str | None:
    found: SimpleCookie = SimpleCookie()
    try:
        found.load(headers.get("cookie", ""))
    except CookieError:
        return None
    return found[name].value if name in found else None


def _with_headers(scope: Scope, send: Send) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in _HEADERS.items():
                headers.setdefault(name, value)
            if _is_api(scope) or scope["path"] == "/":
                headers.setdefault("Cache-Control", "no-store")
        await send(message)

    return sending
