"""What a spec says is shown, never run; the page reaches no network and evaluates no text."""

from __future__ import annotations

import re
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest
from sparing import sparing

from page.conftest import Open
from page.opened import opened
from page.scenes import CONFIGS, write

HOSTILE = (
    "</script><script>alert(1)</script>",
    "{{SCRIPT}} {{DATA}} {{POLICY}}",
    """"><img src=x onerror="alert(1)"> ' onclick='alert(1)""",
    "<!-- <script> -->",
    "</title></style><style>body { display: none }</style>",
    "&lt;b&gt; &amp; \\u003c ${alert(1)} `${1}`",
    "\U0001f600 javascript:alert(1)",
)


@sparing("title", HOSTILE, every=len(HOSTILE))
def test_a_hostile_title_is_shown(title: str, open_page: Open, tmp_path: Path) -> None:
    """In the heading, the name of the window and the text of the spec; nothing of it runs."""
    quoted = "".join(f"\\U{ord(sign):08x}" if sign in '"\\' or not sign.isprintable() else sign for sign in title)
    source = (CONFIGS / "extra-tie-down.toml").read_text(encoding="utf-8")
    source = re.sub(r"^title = .*$", lambda _: f'title = "{quoted}"  # {title}', source, flags=re.MULTILINE)
    (tmp_path / "my.toml").write_text(source, encoding="utf-8")
    write(tmp_path / "my.toml", tmp_path / "page.html")
    page = open_page(tmp_path / "page.html").page
    assert page.locator("h1").evaluate("each => each.textContent") == title
    assert page.evaluate("document.querySelector('title').textContent") == title
    assert page.locator("pre").evaluate("each => each.textContent") == source
    assert page.locator("body > script").count() == 2
    assert page.locator("img, iframe, object, embed, link, base, form").count() == 0
    assert page.locator("section").count() >= 2


@pytest.fixture
def server() -> Iterator[tuple[str, list[str]]]:
    """A server of this machine, and the paths that it was asked for."""
    asked: list[str] = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            asked.append(self.path)
            self.send_response(200)
            self.send_header("Access-Control-Allow-Origin", "*")
            self.end_headers()

        def do_POST(self) -> None:
            self.do_GET()

        def log_message(self, *_: Any) -> None:
            """Nothing is written to the terminal."""

    listening = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=listening.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{listening.server_port}", asked
    listening.shutdown()
    listening.server_close()


LOADED = "new Promise((yes, no) => {{ const x = {}; x.onload = yes; x.onerror = no; {} }})"
OPENED = "new Promise((yes, no) => {{ const x = {}; x.onopen = x.onmessage = yes; x.onerror = no; }})"
LEFT = "new Promise((yes, no) => {{ const x = document.createElement('{}'); {}; setTimeout(no, 300); }})"
WAYS = {
    "fetch": "fetch(at)",
    "module": "import(at)",
    "request": LOADED.format("new XMLHttpRequest()", "x.open('GET', at); x.send();"),
    "image": LOADED.format("new Image()", "x.src = at;"),
    "script": LOADED.format("document.createElement('script')", "x.src = at; document.body.append(x);"),
    "style": LOADED.format(
        "document.createElement('link')", "x.rel = 'stylesheet'; x.href = at; document.body.append(x);"
    ),
    "socket": OPENED.format("new WebSocket(at.replace('http', 'ws'))"),
    "events": OPENED.format("new EventSource(at)"),
    "worker": OPENED.format("new Worker(URL.createObjectURL(new Blob([`fetch('${at}')`])))"),
    "frame": LEFT.format("iframe", "x.src = at; document.body.append(x)"),
    "form": LEFT.format("form", "x.action = at; x.method = 'post'; document.body.append(x); x.submit()"),
}
CODES = (
    "Function('1')()",
    "eval('1')",
    "setTimeout('document.title = 1')",
    "document.body.setAttribute('onclick', 'document.title = 1'); document.body.click()",
)


@sparing("way", WAYS, every=len(WAYS))
def test_no_way_leads_to_the_network(way: str, browser: Any, server: tuple[str, list[str]], written: Any) -> None:
    found = opened(browser, written("extra-tie-down"), (900, 700))
    address, asked = server
    went = found.page.evaluate(f"(at) => ({WAYS[way]}).then(() => true, () => false)", f"{address}/{way}")
    found.page.wait_for_timeout(100)
    assert not went
    assert asked == []
    assert any("Content Security Policy" in line for line in found.said)
    found.page.context.close()


@sparing("code", CODES, every=len(CODES))
def test_no_text_becomes_code(code: str, browser: Any, written: Any) -> None:
    """Run after the call of the test itself, which a browser lets evaluate what it will."""
    found = opened(browser, written("extra-tie-down"), (900, 700))
    title = found.page.title()
    ran = found.page.evaluate(
        f"() => new Promise((done) => setTimeout(() => {{ try {{ {code}; done(true); }} catch {{ done(false); }} }}))"
    )
    found.page.wait_for_timeout(50)
    assert found.page.title() == title
    if "title" in code:  # what the browser refuses later
        assert any("Content Security Policy" in line for line in found.said)
    else:
        assert not ran
    found.page.context.close()
