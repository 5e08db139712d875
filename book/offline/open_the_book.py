"""Open this copy of the book in your browser: python open_the_book.py (needs Python 3 and no network)."""

import functools
import http.server
import pathlib
import webbrowser

FOLDER = pathlib.Path(__file__).resolve().parent
HANDLER = functools.partial(http.server.SimpleHTTPRequestHandler, directory=str(FOLDER))

if __name__ == "__main__":
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), HANDLER) as server:
        address = f"http://127.0.0.1:{server.server_address[1]}/"
        print(f"The book is at {address} as long as this runs; Ctrl-C ends it.")
        webbrowser.open(address)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print()
