"""What the tests of the program share: running it in a folder of its own, and small images to run it on."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from needs import skip_without  # noqa: E402,F401

SAILMAP = os.environ["SAILMAP_PROGRAM"]
DATA = pathlib.Path(os.environ.get("SAILMAP_DATA") or os.environ["SAILMAP_DEFAULT_DATA"])


def scene(place, width=160, height=120):
    """A picture of coloured rectangles that is the same for the same place."""
    random = np.random.default_rng(place)
    image = np.full((height, width, 3), 90, np.uint8)
    for _ in range(12):
        x, y = int(random.integers(width - 20)), int(random.integers(height - 20))
        w, h = (int(v) for v in random.integers(6, 20, 2))
        colour = tuple(int(c) for c in random.integers(0, 256, 3))
        cv2.rectangle(image, (x, y), (x + w, y + h), colour, -1)
    return image


def simulated(case, *arguments):
    """The folder of a simulated sequence of small images that all tests of the class `case` share and leave alone."""
    folder = tempfile.TemporaryDirectory()
    case.addClassCleanup(folder.cleanup)
    out = pathlib.Path(folder.name) / "s"
    subprocess.run([SAILMAP, "simulate", "--out", out, "--width", "160", "--height", "120", *arguments], check=True, capture_output=True)
    return out


class ProgramCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments, code=0):
        """Runs sailmap in the test's folder; returns what it printed."""
        done = subprocess.run(
            [SAILMAP, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, timeout=300
        )
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stdout}{done.stderr}")
        self.errors = done.stderr
        return done.stdout

    def start_program(self, *arguments):
        """Starts sailmap in the test's folder; returns the process once it has printed a line.

        Its output goes through a pipe of 4 KiB: a program that has far more to print cannot end before the test reads it,
        however fast the machine.
        """
        running = subprocess.Popen([SAILMAP, *map(str, arguments)], cwd=self.folder, text=True, pipesize=4096,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)

        def end():
            running.kill()
            running.communicate()

        self.addCleanup(end)
        running.first_line = running.stdout.readline()
        return running

    def fails(self, *arguments, says, code=1):
        """The command must fail with one line that says so, and leave the folder as it was."""
        before = self.contents()
        self.run_program(*arguments, code=code)
        self.assertIn(says, self.errors)
        self.assertEqual(self.errors.count("\n"), 1, self.errors)
        self.assertEqual(self.contents(), before)

    def contents(self):
        return {p: p.stat().st_mtime_ns for p in self.folder.rglob("*") if p.is_file()}

    def write_image(self, name, image):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        self.assertTrue(cv2.imwrite(str(path), image))
        return path

    def write_sequence(self, places, folder="images"):
        for i, place in enumerate(places):
            self.write_image(f"{folder}/{i}.png", scene(place))
        return self.folder / folder

    def json(self, name):
        return json.loads((self.folder / name).read_text())

    def needs_data(self, name):
        if not (DATA / name).exists():
            self.skipTest(f"no {name} in {DATA}; set SAILMAP_DATA")
        return DATA / name
