"""Serve the built book on this machine only; prints the URL, stops with Ctrl-C."""

import argparse
import contextlib
import functools
import gzip
import http.server
import io
import sys
import threading
from collections.abc import Iterator
from email.utils import formatdate
from pathlib import Path
from typing import Any, BinaryIO

from book.tools import layout

TEXT = {".html", ".js", ".css", ".json", ".svg", ".txt", ".ipynb"}


@functools.lru_cache(maxsize=256)
def compressed(file: Path, changed: float) -> bytes:
    """A file's content in gzip; `changed`, its time of change, makes an old copy useless."""
    return gzip.compress(file.read_bytes(), compresslevel=6, mtime=0)


class Handler(http.server.SimpleHTTPRequestHandler):
    """Files of the site; text is compressed, as static hosts do; no log line for each."""

    def send_head(self) -> io.BytesIO | BinaryIO | None:
        """Headers of a file, and what to send."""
        file = Path(self.translate_path(self.path))
        if file.is_dir() and self.path.split("?")[0].endswith("/"):
            file = file / "index.html"
        accepted = "gzip" in self.headers.get("Accept-Encoding", "")
        if not (accepted and file.is_file() and file.suffix in TEXT):
            return super().send_head()
        changed = file.stat().st_mtime
        content = compressed(file, changed)
        self.send_response(200)
        self.send_header("Content-Type", self.guess_type(str(file)))
        self.send_header("Content-Encoding", "gzip")
        self.send_header("Content-Length", str(len(content)))
        self.send_header("Last-Modified", formatdate(changed, usegmt=True))
        self.end_headers()
        return io.BytesIO(content)

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""


class Server(http.server.ThreadingHTTPServer):
    """A server that says nothing of readers who leave before a file is through."""

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Report what is not a connection that the reader closed."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)


def server(port: int = 0) -> Server:
    """A server of the site on loopback; port 0 takes a free one."""
    return Server(("127.0.0.1", port), functools.partial(Handler, directory=str(layout.SITE)))


@contextlib.contextmanager
def running(http: Server) -> Iterator[str]:
    """The URL of a server that runs for as long as the block lasts."""
    threading.Thread(target=http.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{http.server_address[1]}"
    finally:
        http.shutdown()
        http.server_close()


def main(arguments: list[str] | None = None) -> int:
    """Serve until interrupted."""
    parser = argparse.ArgumentParser(prog="python -m book.tools.serve", description=__doc__)
    parser.add_argument("--port", type=int, default=8000, help="port to listen on (default 8000; 0 takes a free one)")
    port = parser.parse_args(arguments).port
    if not (layout.SITE / "index.html").is_file():
        print("there is no book yet: run `make book` first", file=sys.stderr)
        return 1
    try:
        site = server(port)
    except OSError as error:
        print(
            f"port {port} cannot be used ({error.strerror}); try python -m book.tools.serve --port 0", file=sys.stderr
        )
        return 1
    print(f"serving the book at http://127.0.0.1:{site.server_address[1]}/ (Ctrl-C stops)", flush=True)
    try:
        site.serve_forever()
    except KeyboardInterrupt:
        print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
