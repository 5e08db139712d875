"""Serve the built book on this machine only; prints the URL, stops with Ctrl-C."""

import argparse
import functools
import http.server
import sys

from book.tools import layout


class Handler(http.server.SimpleHTTPRequestHandler):
    """Files of the site, without a log line for each."""

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing."""


def server(port: int = 0) -> http.server.ThreadingHTTPServer:
    """A server of the site on loopback; port 0 takes a free one."""
    return http.server.ThreadingHTTPServer(("127.0.0.1", port), functools.partial(Handler, directory=str(layout.SITE)))


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
