"""Serve the built book on this machine only; prints the URL, stops with Ctrl-C."""

import argparse
import contextlib
import functools
import gzip
import http.server
import mimetypes
import os
import re
import sys
import threading
from collections.abc import Iterator
from email.utils import formatdate
from http import HTTPStatus
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from book.tools import layout, policy

TEXT = {".html", ".js", ".css", ".json", ".svg", ".txt", ".ipynb"}
PATH = re.compile(r"(/(?!\.)[^/\\:\x00-\x1f]*)+")  # nothing hidden, no way up, nothing that Windows takes for one
KINDS = mimetypes.MimeTypes()  # Python's own list, whatever this machine has: browsers insist on it (nosniff)


@functools.lru_cache(maxsize=256)
def compressed(file: Path, changed: float) -> bytes:
    """A file's content in gzip; `changed`, its time of change, makes an old copy useless."""
    return gzip.compress(file.read_bytes(), compresslevel=6, mtime=0)


def find(folder: Path, target: str) -> Path:
    """The file of a folder that a request's target names; a folder if it has an index and lacks the slash at its end.

    Raises OSError for all else: what isn't there, is hidden, leads outside as a symbolic link, or is no path at all.
    """
    target = target.partition("?")[0]
    path = unquote(target)
    if not PATH.fullmatch(path):
        raise FileNotFoundError(path)
    file = Path(os.path.realpath(folder / path.strip("/") / ("index.html" if path.endswith("/") else ""), strict=True))
    if file.is_dir() and not path.endswith("/"):
        find(folder, target + "/")
    elif not file.is_file() or not file.is_relative_to(os.path.realpath(folder)):
        raise FileNotFoundError(path)
    return file


class Handler(http.server.BaseHTTPRequestHandler):
    """Files of the site; text is compressed, as static hosts do; no log line for each."""

    server: "Server"
    default_request_version = "HTTP/1.0"  # what is too broken to say its version gets a status line all the same

    def do_GET(self) -> None:
        """The file that is asked for, where it is, or why there is none."""
        hosts = self.headers.get_all("Host", [])
        if len(hosts) != 1:
            return self.send_error(HTTPStatus.BAD_REQUEST)
        if hosts[0].strip().lower() not in self.server.names:  # a page of another site whose name was made to lead here
            return self.send_error(HTTPStatus.MISDIRECTED_REQUEST, explain=f"this is {self.server.url}")
        try:
            file = find(self.server.folder, self.path)
            headers, content = self.packed(file) if file.is_file() else ({}, b"")
        except (OSError, ValueError):  # the latter for a name that this file system cannot spell
            return self.send_error(HTTPStatus.NOT_FOUND)
        if not headers:
            place = f"/{self.path.partition('?')[0].strip('/')}/"  # one slash to begin with: on this server
            return self.answer(HTTPStatus.MOVED_PERMANENTLY, {"Location": place})
        known = self.headers.get("If-Modified-Since") == headers["Last-Modified"]
        self.answer(HTTPStatus.NOT_MODIFIED if known else HTTPStatus.OK, headers, b"" if known else content)

    do_HEAD = do_GET

    def packed(self, file: Path) -> tuple[dict[str, str], bytes]:
        """The headers and the content of a file; raises OSError."""
        changed = file.stat().st_mtime
        kind = KINDS.guess_type(file.name)[0] or "application/octet-stream"
        headers = {
            "Content-Type": f"{kind}; charset=utf-8" if kind.startswith("text/") else kind,
            "Content-Security-Policy": policy.of(file, changed),
            "Last-Modified": formatdate(changed, usegmt=True),
            "Cache-Control": "no-cache",  # a browser asks each time whether the book was built again
        }
        if file.suffix in TEXT and "gzip" in self.headers.get("Accept-Encoding", ""):
            return {**headers, "Content-Encoding": "gzip"}, compressed(file, changed)
        return headers, file.read_bytes()

    def answer(self, status: HTTPStatus, headers: dict[str, str], content: bytes = b"") -> None:
        """Send headers, with those of every answer, and the content if it is asked for."""
        self.send_response(status)
        length = {} if status is HTTPStatus.NOT_MODIFIED else {"Content-Length": str(len(content))}
        for name, value in {**policy.HEADERS, **length, **headers}.items():
            self.send_header(name, value)
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(content)

    def send_error(self, code: int, message: str | None = None, explain: str | None = None) -> None:
        """Say what is wrong, and repeat nothing of the request; a method that is not there is one not allowed."""
        status = HTTPStatus.METHOD_NOT_ALLOWED if code == HTTPStatus.NOT_IMPLEMENTED else HTTPStatus(code)
        said = f"{status.value} {status.phrase}{': ' if explain else ''}{explain or ''}\n"
        self.answer(status, {"Content-Type": "text/plain; charset=utf-8", "Allow": "GET, HEAD"}, said.encode())

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""


class Server(http.server.ThreadingHTTPServer):
    """Serves the site, or another folder, on loopback; says nothing of readers who leave before a file is through."""

    def __init__(self, port: int = 0, folder: Path | None = None) -> None:
        super().__init__(("127.0.0.1", port), Handler)
        self.folder, port = folder or layout.SITE, self.server_address[1]
        self.url = f"http://127.0.0.1:{port}"
        self.names = {f"{name}:{port}".removesuffix(":80") for name in ("127.0.0.1", "localhost", "[::1]")}

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Report what is not a connection that the reader closed."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)


@contextlib.contextmanager
def running(http: Server) -> Iterator[str]:
    """The URL of a server that runs for as long as the block lasts."""
    threading.Thread(target=http.serve_forever, daemon=True).start()
    try:
        yield http.url
    finally:
        http.shutdown()
        http.server_close()


def port_number(text: str) -> int:
    """A port from the command line; raises ArgumentTypeError."""
    if not (text.isascii() and text.isdigit() and len(text) < 6 and int(text) < 65536):
        raise argparse.ArgumentTypeError(f"a port is a whole number from 0 to 65535, not {text!r}")
    return int(text)


def main(arguments: list[str] | None = None) -> int:
    """Serve until interrupted."""
    parser = argparse.ArgumentParser(prog="python -m book.tools.serve", description=__doc__)
    parser.add_argument("--port", type=port_number, default=8000, help="default 8000; 0 takes a free one")
    port = parser.parse_args(arguments).port
    if not (layout.SITE / "index.html").is_file():
        print("there is no book yet: run `make book` first", file=sys.stderr)
        return 1
    try:
        site = Server(port)
    except OSError as error:
        print(f"port {port} cannot be used ({error.strerror}); try {parser.prog} --port 0", file=sys.stderr)
        return 1
    print(f"serving the book at {site.url}/ (Ctrl-C stops)", flush=True)
    try:
        site.serve_forever()
    except KeyboardInterrupt:
        print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
