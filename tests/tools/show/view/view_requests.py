# SPDX-License-Identifier: MIT
# Requests of browsers, and of others, to `crevice view mine.json --scene model.obj`.
#   view_requests.py ADDRESS FOLDER
import http.client
import json
import os
import socket
import sys
import threading
import time
import urllib.parse

address, folder = urllib.parse.urlparse(sys.argv[1]), sys.argv[2]
escaped_folder = urllib.parse.quote(folder)
base, port = address.path, address.port
failures = 0


def check(what, holds):
    global failures
    if not holds:
        failures += 1
        print("FAILED: " + what)


def ask(method, target, body=None, host=None, **headers):
    """Sends the target as it is."""
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=20)
    connection.putrequest(method, target, skip_host=True, skip_accept_encoding=True)
    connection.putheader("Host", host or "127.0.0.1:%d" % port)
    for name, value in headers.items():
        connection.putheader(name.replace("_", "-"), value)
    if body is not None:
        connection.putheader("Content-Length", str(len(body)))
    connection.endheaders(body)
    answer = connection.getresponse()
    answer.data = answer.read()
    connection.close()
    return answer


def status(*arguments, **headers):
    return ask(*arguments, **headers).status


def sent_as_is(text):
    """The first line that comes back for raw bytes."""
    with socket.create_connection(("127.0.0.1", port), timeout=20) as connection:
        connection.sendall(text)
        return connection.makefile("rb").readline().decode()


def lines_of(path):
    with open(os.path.join(folder, path)) as file:
        return file.read()


def check_page():
    page = ask("GET", base)
    check("the page is there", page.status == 200 and b"<title>page" in page.data)
    policy = page.getheader("Content-Security-Policy") or ""
    check("nothing is allowed unless named", policy.startswith("default-src 'none'"))
    check("scripts are the page's own", "script-src 'self' 'wasm-unsafe-eval';" in policy)
    for name, value in [("Content-Type", "text/html; charset=utf-8"), ("Cache-Control", "no-store"),
                        ("X-Content-Type-Options", "nosniff"), ("Referrer-Policy", "no-referrer")]:
        check("its " + name, page.getheader(name) == value)
    wasm = ask("GET", base + "crevice_page.wasm")
    check("WebAssembly has its type and bytes",
          wasm.getheader("Content-Type") == "application/wasm" and wasm.data == b"\0asm")
    check("a query does not matter", status("GET", base + "page.js?x=1") == 200)
    head = ask("HEAD", base + "page.js")
    check("HEAD has no body", head.status == 200 and not head.data)


def check_refusals():
    for target in ["/", base[:-1], "/" + "0" * 32 + "/", "*", "//", "/index.html", "/view.json", base[:-2] + "/",
                   base[:-2] + ("0" if base[-2] != "0" else "1") + "/", base.upper(), "/" + base, "/0" + base[1:]]:
        answer = ask("GET", target)
        check("404 without detail: " + target, answer.status == 404 and not answer.data)
    for target in ["../secret.txt", "%2e%2e/secret.txt", "..%2fsecret.txt", "..%5csecret.txt", "%2fetc%2fpasswd",
                   "%252e%252e/secret.txt", "page.js%00.txt", "%2e", escaped_folder + "/secret.txt", "a" * 4000,
                   ".hidden", "link.txt", "./page.js", "page.js/", "PAGE.JS", "mine.json", "configs/mine.json"]:
        check("no file: " + target[:40], status("GET", base + target) == 404)
    for host in ["evil.example", "evil.example:%d" % port, "127.0.0.1", "127.0.0.1:1", "[::1]:%d" % port]:
        check("403 for host " + host, status("GET", base, host=host) == 403)
        check("403 for a save to host " + host, status("PUT", base + "files/x", b"", host=host) == 403)
    for headers in [{"Origin": "http://evil.example"}, {"Origin": "null"}, {"Sec-Fetch-Site": "cross-site"},
                    {"Sec-Fetch-Site": "same-site"}]:
        check("403 for a page elsewhere: %s" % headers, ask("GET", base, **headers).status == 403)
    check("a browser's own requests", ask("GET", base, **{"Sec-Fetch-Site": "none"}).status == 200
          and ask("GET", base, Origin="http://127.0.0.1:%d" % port, **{"Sec-Fetch-Site": "same-origin"}).status == 200)
    check("localhost is this machine", status("GET", base, host="localhost:%d" % port) == 200)
    here = b"Host: 127.0.0.1:%d\r\n" % port
    for hosts in [b"", here + here, here + b"Host: evil.example\r\n"]:
        check("no host, or two, are refused",
              " 403 " in sent_as_is(b"GET " + base.encode() + b" HTTP/1.1\r\n" + hosts + b"\r\n"))
    check("nonsense is refused", " 400 " in sent_as_is(b"nonsense\r\n\r\n"))
    for method in ["POST", "PUT", "DELETE", "OPTIONS", "PATCH"]:
        answer = ask(method, base, b"")
        check("405 for " + method, answer.status == 405 and answer.getheader("Allow") == "GET, HEAD")
    check("405 for a look at a file", status("GET", base + "files/configs/mine.json") == 405)
    others = [line for line in os.popen("cat /proc/net/tcp /proc/net/tcp6") if ":%04X " % port in line.split(" 0A ")[0]]
    listening = [line for line in others if " 0A " in line]
    check("it listens on the loopback address alone",
          len(listening) == 1 and listening[0].split()[1].startswith("0100007F:"))


def view():
    return json.loads(ask("GET", base + "view.json").data)


def put(path, text, version, **headers):
    return ask("PUT", base + "files/" + path, text.encode(), If_Match=version, **headers)


def check_saves():
    path = "configs/more/radius.json"
    version = view()["files"][path]["version"]
    text = '{"format": 1, "params": {"radius": 0.5}}\n'
    for origin in ["http://evil.example", "null", "https://127.0.0.1:%d" % port, "http://127.0.0.1:1"]:
        check("403 for origin " + origin, put(path, text, version, Origin=origin).status == 403)
    for other in ["configs/%2e%2e/mine.json", "%2fetc%2fpasswd", escaped_folder + "/mine.json", "", "configs/other.json",
                  "configs/more/../mine.json", "configs/mine.json/", "mine.json", "../mine.json"]:
        check("404 for a save to " + other, put(other, text, version).status == 404)
    check("409 for any version", put(path, text, "*").status == 409)
    check("428 without a version", status("PUT", base + "files/" + path, text.encode()) == 428)
    check("413 for more than a file may have", put(path, "x" * (1 << 20) + "x", version).status == 413)
    chunked = ("PUT %sfiles/%s HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nIf-Match: %s\r\nTransfer-Encoding: chunked\r\n\r\n"
               % (base, path, port, version)).encode()
    over = chunked + b"".join(b"10000\r\n" + b"y" * 0x10000 + b"\r\n" for _ in range(17)) + b"0\r\n\r\n"
    check("413 for more than that in chunks", " 413 " in sent_as_is(over))
    for tail in [b"\xe9", b"\xc0\x80", b"\xed\xa0\x80"]:
        refused = ask("PUT", base + "files/" + path, text.encode() + tail, If_Match=version)
        check("403 for bytes that are not UTF-8", refused.status == 403 and b"UTF-8" in refused.data)
    check("so far nothing is written", '0.8' in lines_of("more/radius.json"))

    saved = put(path, text, version, Origin="http://127.0.0.1:%d" % port)
    check("a save is written", saved.status == 200 and lines_of("more/radius.json") == text)
    late = put(path, "late", version)
    now = json.loads(late.data)
    check("a save of an old version is refused", late.status == 409 and lines_of("more/radius.json") == text)
    check("with the text and version", now == {"text": text, "version": json.loads(saved.data)["version"]})
    again = put(urllib.parse.quote(path, safe=""), text + " ", '"%s"' % now["version"])
    check("path and version may be quoted", again.status == 200)


class Stream(threading.Thread):
    """What comes from the events, line by line."""

    def __init__(self):
        super().__init__(daemon=True)
        self.connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
        self.connection.request("GET", base + "events")
        self.answer = self.connection.getresponse()
        self.lines = []
        self.start()

    def run(self):
        try:
            for line in self.answer:
                self.lines.append(line.decode().rstrip("\n"))
        except (OSError, http.client.HTTPException):
            pass

    def data(self):
        return [json.loads(line[6:]) for line in self.lines if line.startswith("data: ")]

    def waited(self, count):
        for _ in range(100):
            if len(self.data()) >= count:
                return True
            time.sleep(0.05)
        return False


def check_events():
    stream = Stream()
    check("events have their type", stream.answer.getheader("Content-Type") == "text/event-stream")
    path = "configs/mine.json"
    text = lines_of("mine.json")
    with open(os.path.join(folder, "mine.json"), "w") as file:
        file.write(text + "\n")
    check("an edit is told", stream.waited(1))
    check("with its name", "event: file" in stream.lines)
    event = stream.data()[0] if stream.data() else {}
    check("and its text", event.get("path") == path and event.get("text") == text + "\n")
    check("and its version", event.get("version") == view()["files"][path]["version"])
    with open(os.path.join(folder, "new"), "w") as file:
        file.write(text)
    os.rename(os.path.join(folder, "new"), os.path.join(folder, "mine.json"))
    check("so is one that an editor renames", stream.waited(2) and stream.data()[1]["text"] == text)
    check("a save is no edit", put(path, text + " ", stream.data()[1]["version"]).status == 200)
    time.sleep(0.5)
    check("and is not told", len(stream.data()) == 2)
    streams = [Stream() for _ in range(20)]
    check("too many streams are refused", {each.answer.status for each in streams} == {200, 503})
    check("and keep nobody from the page", status("GET", base) == 200)


def check_view():
    shown = view()
    check("the config has its name", shown["config"] == "mine" and shown["editable"])
    check("and its files", sorted(shown["files"]) == ["configs/mine.json", "configs/more/radius.json"])
    check("with their texts", shown["files"]["configs/mine.json"]["text"] == lines_of("mine.json"))
    check("the camera is told", shown["camera"] == "eye=1,2,3")
    check("the scene comes as bytes", shown["scene"] == {"name": "model.obj", "bytes": True})
    scene = ask("GET", base + "scene").data
    check("which are a scene's", scene[:8] == b"crvs\3\0\0\0" and len(scene) > 200)


def drop(name, model, **headers):
    answer = ask("PUT", base + "scene/" + name, model, **headers)
    return answer.status, json.loads(answer.data or "{}")


def check_dropped():
    model = b"v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 2 3\nf 1 2 4\n"
    check("403 for a model of another site", status("PUT", base + "scene/a.obj", model, Origin="http://evil.example") == 403)
    code, said = drop("broken.glb", b"glTF nonsense")
    check("a broken model is refused with the reader's words", code == 422 and said["diagnostics"][0]["code"] == "CV7002")
    check("a name is no path", drop("..%2f..%2fsecret.txt", model)[0] == 422 and drop("%2e%2e", model)[0] == 422)
    check("and nothing has changed", view()["scene"]["name"] == "model.obj")
    code, said = drop("tent%20%231.obj", model)
    check("a model that is dropped is the scene", code == 200 and view()["scene"] == {"name": "tent #1.obj", "bytes": True})
    check("of no camera that was asked for", view()["camera"] == "")
    check("which comes as bytes", ask("GET", base + "scene").data[:8] == b"crvs\3\0\0\0")


check_page()
check_refusals()
check_view()
check_saves()
check_events()
check_dropped()
sys.exit(1 if failures else 0)
