"""--signature chip: every front end of the hardware makes the same map, and decides as with the host's signatures."""

import contextlib
import os
import shutil
import sqlite3
import unittest

from program_case import DATA, ProgramCase

# What the images themselves make of a map file; the tables map and session also hold versions and times.
TABLES = ("image", "signature", "detection", "node", "edge")
HARDWARE = ("csim", "fixed", "quantised", "xrt")
# Which kernels the simulated card has.
CARDS = ("maps", "signature", "both")


class ChipSignature(ProgramCase):
    def setUp(self):
        super().setUp()
        self.card("maps")
        self.addCleanup(os.environ.pop, "SAILMAP_SIMULATED_DEVICE", None)

    def card(self, kernels):
        os.environ["SAILMAP_SIMULATED_DEVICE"] = f"640x480x4 {kernels}"

    def query(self, name, statement):
        with contextlib.closing(sqlite3.connect(self.folder / name)) as file:
            return file.execute(statement).fetchall()

    def content(self, name):
        """All rows of all tables that the images make, bytes and checksums included."""
        return {table: self.query(name, f"SELECT * FROM {table} ORDER BY id") for table in TABLES}

    def decisions(self, name):
        """Nodes, edges, and of each image the verdict and the best node."""
        content = self.content(name)
        return content["node"], content["edge"], self.query(name, "SELECT id, reason, best_node FROM detection ORDER BY id")

    def map_of(self, source, frontend, signature, *more):
        name = f"{frontend}-{signature}.map"
        (self.folder / name).unlink(missing_ok=True)
        card = ["--xclbin", "k"] if frontend == "xrt" else []  # simulated
        self.run_program("run", source, "--map", name, "--frontend", frontend, "--signature", signature,
                         "--exclude-recent", "3", *card, *more)
        return name

    def loops(self, name):
        return self.query(name, "SELECT count(*) FROM edge WHERE kind = 'loop'")[0][0]

    def simulated(self):
        """A drive that comes by twice."""
        self.run_program("simulate", "--out", "drive", "--images", "24", "--images-per-lap", "12",
                         "--width", "160", "--height", "120")
        return "drive/images"

    def first_images(self, sequence, count):
        """The first images of a real sequence, in a folder of their own."""
        source = DATA / sequence / "images"
        if not source.exists():
            self.skipTest(f"no {source}; set SAILMAP_DATA")
        (self.folder / sequence).mkdir()
        for image in sorted(source.iterdir())[:count]:
            shutil.copy(image, self.folder / sequence)
        return sequence

    def test_every_front_end_of_the_hardware_makes_the_same_map(self):
        source = self.simulated()
        maps = [self.content(self.map_of(source, frontend, "chip")) for frontend in HARDWARE]
        self.assertGreater(len(maps[0]["signature"]), 5)
        for frontend, content in zip(HARDWARE[1:], maps[1:]):
            self.assertEqual(content, maps[0], frontend)

    def test_a_card_makes_the_same_map_with_either_kernel(self):
        source = self.simulated()
        other = ("--max-regions", "7", "--box-side", "12", "--stop-ratio", "0.125")
        for options in ((), other):
            want = self.content(self.map_of(source, "fixed", "chip", *options))
            for kernels in CARDS:
                self.card(kernels)
                self.assertEqual(self.content(self.map_of(source, "xrt", "chip", *options)), want, kernels)
                self.assertNotIn("warning", self.errors)

    def test_thumbnails_and_figures_beside_a_cards_own_signature(self):
        """They are made of the images; the maps stay on the card."""
        source = self.simulated()
        thumbnails = []
        for frontend in ("fixed", "xrt"):
            self.card("signature")
            name = self.map_of(source, frontend, "chip", "--thumbnails", "64")
            thumbnails.append(self.query(name, "SELECT jpeg FROM thumbnail ORDER BY id"))
        self.assertEqual(*thumbnails)
        self.assertTrue(all(row[0] for row in thumbnails[0]))
        pair = [sorted((self.folder / source).iterdir())[i] for i in (0, 12)]
        said = [self.run_program("match", *pair, "--out", f"{frontend}.png", "--signature", "chip", "--frontend", frontend,
                                 "--xclbin", "k") for frontend in ("fixed", "xrt")]
        self.assertEqual(*said)
        self.assertEqual(*((self.folder / f"{frontend}.png").read_bytes() for frontend in ("fixed", "xrt")))

    def test_decides_as_with_the_hosts_signatures(self):
        source = self.simulated()
        chip, host = (self.map_of(source, "fixed", signature) for signature in ("chip", "host"))
        self.assertGreater(self.loops(chip), 0)
        self.assertEqual(self.decisions(chip), self.decisions(host))
        self.assertNotEqual(self.content(chip)["signature"], self.content(host)["signature"], "both are the host's")

    def test_real_images(self):
        source = self.first_images("rtabmap_corridor", 12)
        csim, fixed = (self.map_of(source, frontend, "chip") for frontend in ("csim", "fixed"))
        host = self.map_of(source, "fixed", "host")
        self.assertEqual(self.content(csim), self.content(fixed))
        self.assertEqual(self.decisions(fixed), self.decisions(host))

    def test_a_whole_real_sequence_decides_as_with_the_hosts(self):
        source = self.first_images("rtabmap_corridor", 1000)
        chip, host = (self.map_of(source, "fixed", signature) for signature in ("chip", "host"))
        self.assertGreater(self.loops(chip), 5)
        self.assertEqual(self.decisions(chip), self.decisions(host))

    def test_is_kept_with_the_map(self):
        source = self.simulated()
        name = self.map_of(source, "fixed", "chip")
        self.assertIn('"signature":"chip"', self.query(name, "SELECT parameters FROM map")[0][0])
        self.run_program("run", source, "--map", name, "--signature", "host", code=1)
        self.assertIn('--signature (map "chip", now "host")', self.errors)
        # Not given: as the map was made.
        self.run_program("run", source, "--map", name)

    def test_refusals(self):
        source = self.simulated()
        for options, says in (
            (["--frontend", "reference"], "computes in floating point"),
            (["--inhibition", "gaussian"], "inhibition of return is the box"),
            (["--descriptor", "background"], "eq. 3-4"),
            (["--method", "context"], "the method context needs the maps"),
            (["--max-regions", "30"], "max_regions must be 1 to 20"),
            (["--stop-ratio", "0.3"], "a multiple of 1/65536, such as 0.30000305"),
        ):
            with self.subTest(options):
                self.fails("run", source, "--map", "no.map", "--signature", "chip", *options, says=says)
        self.fails("detect", "drive/images/000000.png", "--signature", "chip", "--box-side", "40", says="box_side")

    def test_detect_and_eval(self):
        source = self.simulated()
        image = sorted((self.folder / source).iterdir())[0]
        found = []
        self.card("both")
        for frontend, signature in (("csim", "chip"), ("fixed", "chip"), ("xrt", "chip"), ("fixed", "host")):
            folder = f"{frontend}-{signature}"
            self.run_program("detect", image, "--frontend", frontend, "--signature", signature, "--out", folder,
                             "--xclbin", "k")
            text = (self.folder / folder / "regions.json").read_text(encoding="utf-8")
            found.append(text[text.index('"regions"'):])
        self.assertEqual(found[0], found[1])
        self.assertEqual(found[0], found[2])
        self.assertNotEqual(found[2], found[3])
        # A figure shows the saliency map, which this card hands out on its own.
        self.assertEqual(*((self.folder / name / "figure.png").read_bytes() for name in ("fixed-chip", "xrt-chip")))
        printed = self.run_program("eval", source, "--ground-truth", "drive/ground_truth.txt", "--exclude-recent", "3",
                                   "--signature", "chip")
        self.assertIn("average precision", printed.lower())


if __name__ == "__main__":
    unittest.main()
