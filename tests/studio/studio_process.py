"""The real `suffuse studio` in a folder of its own, and a client that speaks HTTP to it: what its tests share.

A test is called as test_NAME.py PROGRAM [unittest's words].
"""
import http.client
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import uuid

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
CURVE = "d [mm],passing [%]\n0.25,0\n0.3,10\n0.36,18\n0.40,20\n0.9,21\n1.1,45\n1.3,75\n1.5,100\n"
REPLAY = ["new", "replay", "--from", "replay"]


def form(fields):
    """Body and type of a multipart form; a field is text, or a pair of a file's name and its bytes."""
    mark = uuid.uuid4().hex
    body = b""
    for name, value in fields.items():
        file, content = value if isinstance(value, tuple) else (None, value)
        content = content.encode() if isinstance(content, str) else content
        named = f'; filename="{file}"' if file else ""
        body += f'--{mark}\r\nContent-Disposition: form-data; name="{name}"{named}\r\n\r\n'.encode() + content + b"\r\n"
    return body + f"--{mark}--\r\n".encode(), f"multipart/form-data; boundary={mark}"


class Studio:
    """The program in a folder, and a client that has its cookie."""

    def __init__(self, folder, *words):
        self.folder = folder
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        environment["TMPDIR"] = str(folder / "temporary")  # a studio that is killed leaves its files there
        (folder / "temporary").mkdir(exist_ok=True)
        self.error = open(folder / "studio-error.txt", "w+")
        self.process = subprocess.Popen([PROGRAM, "studio", *words], cwd=folder, stdout=subprocess.PIPE,
                                        stderr=self.error, text=True, env=environment)
        address = self.process.stdout.readline().strip()
        if not address:
            return
        self.port, self.token = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{64})", address).groups()
        self.port = int(self.port)
        self.cookie = f"suffuse-studio-{self.port}={self.token}"

    def request(self, method, path, body=None, headers=None, cookie=True):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        given = {"Cookie": self.cookie} if cookie else {}
        given.update(headers or {})
        connection.request(method, path, body, given)
        answer = connection.getresponse()
        answer.text = answer.read()
        connection.close()
        return answer

    def get(self, path, **more):
        return self.request("GET", path, **more)

    def get_json(self, path):
        return json.loads(self.get(path).text)

    def post(self, path, fields=None, headers=None, **more):
        body, kind = form(fields or {"nothing": ""})
        return self.request("POST", path, body, {"Content-Type": kind, **(headers or {})}, **more)

    def raw(self, text):
        """The first line of the answer to these bytes."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=30) as connection:
            connection.sendall(text)
            return connection.makefile("rb").readline().decode().strip()

    def end(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        self.process.wait(60)
        self.process.stdout.close()
        self.error.seek(0)
        words = self.error.read()
        self.error.close()
        return words


class InAFolder(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        self.runs = self.folder / "runs"

    def studio(self, *words):
        studio = Studio(self.folder, "--no-browser", *words)
        self.addCleanup(lambda: studio.error.closed or studio.end(signal.SIGKILL))
        return studio

    def suffuse(self, *words):
        return subprocess.run([PROGRAM, *words], cwd=self.folder, capture_output=True, text=True, check=True)

    def finished_run(self):
        self.suffuse(*REPLAY)
        self.suffuse("run", "replay/case.toml", "-q")
        return "replay-0001"

    def wait(self, what, is_true):
        end = time.monotonic() + 120
        while not is_true():
            self.assertLess(time.monotonic(), end, what)
            time.sleep(0.05)


def main():
    if not any((PROGRAM.parent / page / "studio.html").exists() for page in ("../../report-page", "../share/suffuse/report-page")):
        print("npm has not built the studio's page; ./test does")
        sys.exit(77)
    unittest.main()
