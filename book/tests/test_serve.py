"""The book's server: what it gives, what it refuses, and that no request gets a traceback or a file from elsewhere."""

import base64
import contextlib
import gzip
import hashlib
import os
import random
import re
import socket
from http.client import HTTPMessage, parse_headers
from io import BytesIO

import pytest

from book.tools import layout, policy, serve

SECRET = b"not a part of the book"
PAGE = (
    '<!doctype html><title>A page</title><script>first = 1;</script><script src="a.js"></script>'
    '<p onclick="second(&quot;2&quot;)">words</p><script type="application/json">{"third": 3}</script>'
) + "<p>words</p>" * 100
LINKS = {
    "link.txt": "secret.txt",
    "linked": "elsewhere",
    "circle": "site/circle",
    "inside.txt": "site/chapters/a.txt",
}


@pytest.fixture(scope="module")
def http(tmp_path_factory):
    """A server of a small site, beside which lies a file that is none of its own."""
    top = tmp_path_factory.mktemp("served")
    own = {"index.html": PAGE, "chapters/index.html": "chapters", "chapters/a.txt": "a file", "worker.js": "1"}
    files = {f"site/{name}": text.encode() for name, text in own.items()} | {"site/numbers.bin": b"\x00" * 500}
    files |= dict.fromkeys(["secret.txt", "elsewhere/index.html", "site/.hidden/index.html"], SECRET)
    for name, content in (files | {"site/pictures/a.png": b"a"}).items():
        (top / name).parent.mkdir(parents=True, exist_ok=True)
        (top / name).write_bytes(content)
    for name, target in LINKS.items():
        (top / "site" / name).symlink_to(top / target)
    made = serve.Server(folder=top / "site")
    with serve.running(made):
        yield made


def sent(http: serve.Server, request: bytes) -> tuple[int, HTTPMessage, bytes]:
    """Status, headers and content of the answer to what is sent, as it is, to a socket."""
    got = b""
    with socket.create_connection(http.server_address, timeout=10) as line:
        with contextlib.suppress(ConnectionError):  # the server has answered, and does not read the rest
            line.sendall(request)
            line.shutdown(socket.SHUT_WR)
        with contextlib.suppress(ConnectionError):
            while piece := line.recv(1 << 16):
                got += piece
    first, _, rest = got.partition(b"\r\n")
    assert re.fullmatch(rb"HTTP/1\.0 \d{3} [\w -]+", first), got[:80]
    answer = BytesIO(rest)
    return int(first.split()[1]), parse_headers(answer), answer.read()


def asked(http: serve.Server, path: str, method: str = "GET", **headers: str) -> tuple[int, HTTPMessage, bytes]:
    """The answer to a request as browsers make them."""
    lines = {"Host": f"127.0.0.1:{http.server_address[1]}"} | {k.replace("_", "-"): v for k, v in headers.items()}
    said = "".join(f"{name}: {value}\r\n" for name, value in lines.items())
    return sent(http, f"{method} {path} HTTP/1.1\r\n{said}\r\n".encode("latin-1"))


def test_text_is_compressed_and_nothing_else(http):
    whole = (http.folder / "index.html").read_bytes()
    for path, encoding in (("/", "gzip"), ("/index.html?v=1", "gzip"), ("/numbers.bin", None)):
        status, headers, content = asked(http, path, Accept_Encoding="gzip, br")
        assert (status, headers["Content-Encoding"]) == (200, encoding)
        assert (gzip.decompress(content) if encoding else content) in (whole, b"\x00" * 500)
        assert int(headers["Content-Length"]) == len(content)
    assert asked(http, "/index.html", Range="bytes=10-19")[::2] == (200, whole)  # parts of files are not served


def test_a_file_that_has_not_changed_is_not_sent_again(http):
    file, before = http.folder / "worker.js", asked(http, "/worker.js")[1]["Last-Modified"]
    assert asked(http, "/worker.js", If_Modified_Since=before)[::2] == (304, b"")
    os.utime(file, (1e9, 1e9))
    assert asked(http, "/worker.js", If_Modified_Since=before)[::2] == (200, b"1")


def test_types_are_python_s_own_whatever_the_machine_says(http):
    text, binary = "text/{}; charset=utf-8", "application/octet-stream"
    for path, kind in {"/": text.format("html"), "/inside.txt": text.format("plain"), "/numbers.bin": binary}.items():
        assert asked(http, path)[1]["Content-Type"] == kind
    assert "/javascript" in asked(http, "/worker.js")[1]["Content-Type"]


def test_a_folder_has_its_index_or_is_not_there(http):
    assert asked(http, "/chapters/")[::2] == (200, b"chapters")
    assert asked(http, "/chapters?x=//evil.example")[1]["Location"] == "/chapters/"
    for path in ("/pictures/", "/pictures", "/index.html/", "/chapters/index.html/"):
        assert asked(http, path)[0] == 404, path


def test_a_redirection_stays_on_this_server(http):
    for path in ("//chapters", "///chapters", "//chapters//", "/%2Fchapters", "//%2fchapters", "/chapters?/../"):
        status, headers, _ = asked(http, path)
        assert status in (200, 301)
        assert re.fullmatch(r"/[^/\\].*/", headers.get("Location", "/chapters/")), path


ELSEWHERE = r"""
    /../secret.txt /%2e%2e/secret.txt /..%2fsecret.txt /%2e%2e%2fsecret.txt /chapters/../../secret.txt /.%2e/secret.txt
    /..\secret.txt /..%5csecret.txt /%252e%252e/secret.txt /%c0%ae%c0%ae/secret.txt //../secret.txt /..;/secret.txt
    /link.txt /linked/ /linked /linked/index.html /.hidden/ /.hidden /circle /circle/ /C:/secret.txt /%ff /%00 /%00.html
    /index.html%00 /a%0d%0aSet-Cookie:x /% /%zz //evil.example/.. //evil.example/%2e%2e /%5cevil.example/.. /\evil
    * ?x index.html http://127.0.0.1/secret.txt /worker.js/ /chapters#x /chapters%3fx
"""


@pytest.mark.parametrize("path", [*ELSEWHERE.split(), "/" + "a" * 5000, "/" + "a/" * 5000, "/\xff", "/\x01"])
def test_nothing_but_the_site_is_served(http, path, capfd):
    status, headers, content = asked(http, path)
    assert status == 404
    assert SECRET not in content
    assert "Location" not in headers
    assert "Set-Cookie" not in headers
    assert capfd.readouterr().err == ""


HOST = b"Host: localhost:8000\r\n"


BROKEN = {
    b"POST / HTTP/1.1\r\nContent-Length: 3\r\n\r\nabc": 405,
    b"DELETE /index.html HTTP/1.1\r\n\r\n": 405,
    b"get / HTTP/1.1\r\n\r\n": 405,
    b"__class__ / HTTP/1.1\r\n\r\n": 405,
    b"GET\r\n\r\n": 400,
    b"GET /": 400,
    b"GET / a HTTP/1.1\r\n\r\n": 400,
    b"GET / HTTP/x\r\n\r\n": 400,
    b"GET / HTTP/9.9\r\n\r\n": 505,
    b"GET / HTTP/1.1\r\n\r\n": 400,
    b"GET / HTTP/1.1\r\n: x\r\nnothing\r\n\x00\r\n\r\n": 400,
    b"GET / HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\n\r\n": 400,
    b"GET / HTTP/1.1\r\nX: " + b"a" * 66000 + b"\r\n\r\n": 431,
    b"GET / HTTP/1.1\r\n" + b"X: 1\r\n" * 200 + b"\r\n": 431,
    b"GET /" + b"a" * 66000 + b" HTTP/1.1\r\n\r\n": 414,
    b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\n\n": 400,  # a browser that wants https
}


@pytest.mark.parametrize("request_", BROKEN, ids=lambda sent: repr(sent[:24]))
def test_what_is_no_request_is_answered(http, request_, capfd):
    status, headers, content = sent(http, request_)
    assert status == BROKEN[request_]
    assert headers["Content-Security-Policy"] == policy.SHUT
    assert content.startswith(str(status).encode())
    assert capfd.readouterr().err == ""


def test_noise_neither_ends_nor_disturbs_the_server(http, capfd):
    random_ = random.Random(1)
    whole = f"GET /chapters/?x HTTP/1.1\r\nHost: 127.0.0.1:{http.server_address[1]}\r\nX: y\r\n\r\n".encode()
    for _ in range(200):
        changed = bytearray(whole)
        for _ in range(random_.randint(1, 4)):
            changed[random_.randrange(len(changed))] = random_.randrange(256)
        with socket.create_connection(http.server_address, timeout=10) as line:
            line.sendall(bytes(changed))
            line.shutdown(socket.SHUT_WR)
            got = line.recv(1 << 16)
        assert got == b"" or got.startswith(b"HTTP/1.0 "), bytes(changed)
        assert SECRET not in got
    assert asked(http, "/chapters/")[0] == 200
    assert capfd.readouterr().err == ""


def test_a_reader_who_leaves_is_not_reported(http, capfd):
    (http.folder / "large.bin").write_bytes(bytes(20_000_000))
    with socket.create_connection(http.server_address) as line:
        line.sendall(f"GET /large.bin HTTP/1.1\r\nHost: localhost:{http.server_address[1]}\r\n\r\n".encode())
        line.recv(10)
    assert asked(http, "/chapters/")[0] == 200
    assert capfd.readouterr().err == ""


def test_only_this_machine_s_names_are_answered(http):
    port = http.server_address[1]
    for name in (f"127.0.0.1:{port}", f"localhost:{port}", f"LOCALHOST:{port}", f"[::1]:{port}"):
        assert asked(http, "/", Host=name)[0] == 200, name
    for name in ("evil.example", f"evil.example:{port}", f"localhost.evil.example:{port}", "localhost:1", "localhost"):
        status, headers, content = asked(http, "/", Host=name)
        assert status == 421
        assert content.decode() == f"421 Misdirected Request: this is http://127.0.0.1:{port}\n"
        assert headers["X-Content-Type-Options"] == "nosniff"


def test_head_has_the_headers_alone(http):
    for path in ("/", "/nothing", "/chapters", "/%00"):
        status, headers, content = asked(http, path, "HEAD")
        full = asked(http, path)
        assert (status, content) == (full[0], b"")
        assert headers.items()[2:] == full[1].items()[2:]  # but for the date


def test_every_answer_has_its_headers(http):
    asks = [("/", {}), ("/", {"Accept_Encoding": "gzip"}), ("/nothing", {}), ("/chapters", {}), ("/worker.js", {})]
    asks += [("/", {"Host": "evil.example"}), ("/%00", {}), ("/numbers.bin", {}), ("/", {"If_Modified_Since": "x"})]
    for path, more in asks:
        headers = asked(http, path, **more)[1]
        for name in policy.HEADERS:
            assert len(headers.get_all(name, [])) == 1, (path, name)
        assert "frame-ancestors 'none'" in headers["Content-Security-Policy"]


def test_a_page_may_run_its_own_programs_and_no_others(http):
    said = asked(http, "/")[1]["Content-Security-Policy"]
    scripts = set(re.search(r"script-src ([^;]*);", said)[1].split()) - {"'self'", "'unsafe-hashes'"}
    for program in ("first = 1;", 'second("2")'):
        scripts.remove(f"'sha256-{base64.b64encode(hashlib.sha256(program.encode()).digest()).decode()}'")
    # What starts a player, the player, and a slider that plays by itself: no data, no file, no 'unsafe-inline'.
    assert len(scripts) == 3
    assert all(name.startswith("'sha256-") for name in scripts)
    assert "wasm-unsafe-eval" in asked(http, "/worker.js")[1]["Content-Security-Policy"]
    assert asked(http, "/numbers.bin")[1]["Content-Security-Policy"] == policy.SHUT


def test_a_page_that_is_built_again_gets_its_new_policy(http):
    said = []
    for changed, program in ((1e9, "one()"), (2e9, "two()")):
        (http.folder / "built.html").write_text(f"<script>{program}</script>", "utf-8")
        os.utime(http.folder / "built.html", (changed, changed))
        said.append(asked(http, "/built.html")[1]["Content-Security-Policy"])
    assert said[0] != said[1]


# -- the command -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("port", ["99999", "65536", "-1", "abc", "", "1e3", "8_000", "9" * 5000])
def test_a_port_that_is_none_is_refused_in_one_line(port, capsys):
    with pytest.raises(SystemExit) as stopped:
        serve.main([f"--port={port}"])
    assert stopped.value.code == 2
    *_, said = capsys.readouterr().err.splitlines()
    assert "argument --port: a port is a whole number from 0 to 65535, not" in said


def test_a_port_in_use_and_a_missing_book_are_named(http, monkeypatch, tmp_path, capsys):
    for folder, said in ((http.folder, "cannot be used"), (tmp_path, "run `make book` first")):
        monkeypatch.setattr(layout, "SITE", folder)
        assert serve.main(["--port", str(http.server_address[1])]) == 1
        line, *more = capsys.readouterr().err.splitlines()
        assert said in line
        assert not more
