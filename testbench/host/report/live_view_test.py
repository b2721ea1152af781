"""sailmap run --view: the page while a run goes on, and what it does not give away."""

import json
import os
import re
import signal
import socket
import subprocess
import tempfile
import time
import unittest

from report_case import LAPS, By, ReportCase, needs_browser, scene
from program_case import SAILMAP


class LiveView(ReportCase):
    """The run reads a list whose last image is a pipe: it goes on until the test says so."""

    def start(self, *options, places=LAPS):
        self.write_sequence(places)
        (self.folder / "secret.txt").write_text("not for viewers")
        os.mkfifo(self.folder / "last.png")
        lines = [f"images/{i}.png" for i in range(len(places))] + ["last.png"]
        (self.folder / "list.txt").write_text("\n".join(lines) + "\n")
        errors = tempfile.TemporaryFile("w+")
        self.addCleanup(errors.close)
        self.process = subprocess.Popen(
            [SAILMAP, "run", "list.txt", "--map", "a.map", "--exclude-recent", "5", "--threads", "1", "--view", "0",
             *options],
            cwd=self.folder, stdout=subprocess.DEVNULL, stderr=errors, text=True)
        self.addCleanup(self.kill)
        for _ in range(600):
            errors.seek(0)
            found = re.search(r"live view at http://(\S+):(\d+)/", errors.read())
            if found:
                break
            time.sleep(0.05)
        self.assertTrue(found, "no address")
        self.port = int(found[2])

    def kill(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()

    def finish(self):
        """Gives the run its last image; it must end well, whoever is looking."""
        import cv2

        _, png = cv2.imencode(".png", scene(3))
        with open(self.folder / "last.png", "wb") as pipe:
            pipe.write(png.tobytes())
        self.assertEqual(self.process.wait(60), 0)

    def ask(self, text):
        """Sends bytes as they are; returns status, headers, body."""
        with socket.create_connection(("127.0.0.1", self.port), 20) as connection:
            connection.sendall(text.encode())
            answer = b""
            while chunk := connection.recv(65536):
                answer += chunk
        head, _, body = answer.partition(b"\r\n\r\n")
        return int(head.split()[1]), head.decode(), body

    def get(self, path, host=None, method="GET"):
        host = f"127.0.0.1:{self.port}" if host is None else host
        return self.ask(f"{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n")

    def news(self, images=0):
        status, _, body = self.get(f"/news?images={images}&layout=0")
        self.assertEqual(status, 200)
        return json.loads(body)

    def wait_for_images(self, wanted):
        for _ in range(600):
            if len(self.news()["names"]) >= wanted:
                return
            time.sleep(0.05)
        self.fail(f"not {wanted} images in time")

    def test_what_is_served(self):
        self.start()
        self.wait_for_images(len(LAPS))
        status, head, body = self.get("/")
        self.assertEqual(status, 200)
        self.assertIn("nosniff", head)
        self.assertIn(b"connect-src 'self'", body)
        news = self.news()
        self.assertEqual(len(news["names"]), len(LAPS))
        self.assertEqual(len(news["history"]["score"]), len(LAPS))
        self.assertGreaterEqual(len(news["loops"]["image"]), 20)
        # The layout is renewed now and then; in the end it has all places.
        for _ in range(600):
            if len(self.news()["layout"]) == 2 * len(news["graph"]["images"]):
                break
            time.sleep(0.1)
        else:
            self.fail("the layout does not catch up")
        # What is asked for again is what is new, and two halves make the whole.
        rest = self.news(20)
        self.assertEqual(rest["names"], news["names"][20:])
        self.assertEqual(rest["loops"]["image"], [i for i in news["loops"]["image"] if i >= 20])
        self.assertEqual(rest["graph"]["images"], [i for i in news["graph"]["images"] if i >= 20])
        picture = json.loads(self.get("/picture/7")[2])
        self.assertEqual((picture["width"], picture["height"]), (160, 120))
        pair = json.loads(self.get("/pair/0")[2])
        self.assertGreater(len(pair["pair"]["matches"]), 0)
        self.assertEqual(len(pair["pictures"]), 2)
        self.finish()
        # The map is the one that a run without a viewer makes.
        info = json.loads(self.run_program("map", "info", "a.map", "--json"))
        self.assertEqual(info["images"], len(LAPS) + 1)

    def test_nothing_else_is_served(self):
        self.start()
        self.wait_for_images(len(LAPS))
        for path in (
            "/secret.txt", "/../secret.txt", "/picture/../secret.txt", "/picture/%2e%2e/secret.txt", "/picture/-1",
            "/picture/999", "/picture/99999999999999999999", "/picture/secret.txt", "/pair/999", "/pair/x",
            "/images/0.png", f"/{self.folder}/secret.txt", "//etc/passwd", "/picture/1/../../secret.txt",
            "/picture/1%00", "/news/x",
        ):
            status, _, body = self.get(path)
            self.assertIn(status, (400, 404), path)
            self.assertNotIn(b"not for viewers", body)
            self.assertNotIn(b"root:", body)
        for query in ("", "?images=1", "?images=-1&layout=0", "?images=x&layout=0", "?images=1&layout=1e9"):
            self.assertEqual(self.get("/news" + query)[0], 400, query)
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "HEAD"):
            status, head, _ = self.get("/", method=method)
            self.assertEqual(status, 405, method)
            self.assertIn("Allow: GET", head)
        for host in ("evil.example", f"evil.example:{self.port}", "127.0.0.1.evil.example", "localhost.evil.example", ""):
            for path in ("/", "/news?images=0&layout=0", "/picture/0"):
                self.assertEqual(self.get(path, host=host)[0], 403, (host, path))
        for host in ("localhost", f"localhost:{self.port}", "127.0.0.1", f"[::1]:{self.port}"):
            self.assertEqual(self.get("/", host=host)[0], 200, host)
        self.finish()

    def test_other_machines_cannot_connect(self):
        self.start()
        with self.assertRaises(OSError):
            # 127.0.0.2 is this machine too, by another address than the one that is served.
            socket.create_connection(("127.0.0.2", self.port), 5).close()
        self.finish()

    def test_stalled_viewers_do_not_hold_the_run(self):
        self.start()
        stalled = [socket.create_connection(("127.0.0.1", self.port), 20) for _ in range(12)]
        for k, connection in enumerate(stalled):
            self.addCleanup(connection.close)
            connection.sendall(b"GET / HT" if k % 2 else b"")
        self.finish()

    def test_port_in_use(self):
        self.write_sequence([1, 2])
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            self.fails("run", "images", "--map", "a.map", "--view", port, says=f"port {port} of 127.0.0.1")
        self.assertFalse((self.folder / "a.map").exists())
        # And one that another view has.
        self.start()
        self.run_program("run", "images", "--map", "b.map", "--view", self.port, code=1)
        self.assertIn(f"port {self.port}", self.errors)
        self.assertEqual(self.errors.count("\n"), 1)
        self.assertFalse((self.folder / "b.map").exists())
        self.finish()

    def test_wrong_address(self):
        self.write_sequence([1, 2])
        self.fails("run", "images", "--map", "a.map", "--view", "0", "--view-address", "no.such.host.invalid",
                   says="no.such.host.invalid")

    @needs_browser
    def test_two_viewers_in_browsers(self):
        self.start()
        viewers = [self.browser(), self.browser(width=360, height=740)]
        for viewer in viewers:
            viewer.get(f"http://127.0.0.1:{self.port}/")
        for viewer in viewers:
            self.until(viewer, lambda v=viewer: f"{len(LAPS)} images" in self.one(v, ".lead").text)
            self.until(viewer, lambda v=viewer: self.all(v, ".pair svg.figure"))
            self.until(viewer, lambda v=viewer: v.execute_script(
                "const i = document.querySelector('.latest img'); return i && !i.hidden && i.naturalWidth > 0"))
            self.assertGreater(len(self.all(viewer, ".loop")), 3)
            row = self.all(viewer, ".loop")[2]
            viewer.execute_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", row)
            row.click()
            self.until(viewer, lambda v=viewer: self.all(v, ".pair svg.figure line"))
            size = viewer.execute_script("return [document.documentElement.scrollWidth, innerWidth]")
            self.assertLessEqual(size[0], size[1])
            self.assertEqual([e["message"] for e in viewer.get_log("browser")], [])
        self.finish()
        self.until(viewers[0], lambda: "does not answer" in self.one(viewers[0], ".latest").text)


if __name__ == "__main__":
    unittest.main()
