"""The front end xrt from the command line, on the simulated device (SAILMAP_SIMULATED_DEVICE)."""

import json
import os
import unittest

from program_case import ProgramCase, scene

GOOD = "640x480x4"


class Xrt(ProgramCase):
    def setUp(self):
        super().setUp()
        for name in ("SAILMAP_SIMULATED_DEVICE", "XILINX_XRT", "XCL_EMULATION_MODE"):
            os.environ.pop(name, None)
        self.addCleanup(os.environ.pop, "SAILMAP_SIMULATED_DEVICE", None)

    def device(self, text):
        os.environ["SAILMAP_SIMULATED_DEVICE"] = text

    def drive(self, images=8, width=96, height=72):
        """Images of four places, seen twice."""
        for i in range(images):
            self.write_image(f"images/{i:03}.png", scene(i % 4, width, height))

    def run_and_list(self, *options, out):
        """What a run says, but for its speed, and the map that it makes."""
        printed = self.run_program("run", "images", "--exclude-recent", "1", "--map", out, *options).splitlines()
        errors = self.errors
        exported = self.run_program("map", "export", out, "--format", "csv")
        self.errors = errors
        return [line for line in printed if line.startswith("loop closure")], exported

    def test_a_map_of_a_card_is_looked_at_without_the_card(self):
        self.device(GOOD)
        self.drive()
        loops, _ = self.run_and_list("--frontend", "xrt", "--xclbin", "k", "--threshold", "1", out="card.map")
        self.assertTrue(loops)
        os.environ.pop("SAILMAP_SIMULATED_DEVICE")
        self.run_program("report", "card.map", "-o", "card.html")
        self.assertEqual(self.errors, "")
        self.run_program("loops", "card.map", "--pictures", "pairs")
        self.assertEqual(self.errors, "")
        self.assertEqual(len(list((self.folder / "pairs").iterdir())), len(loops))

    def test_needs_an_xclbin(self):
        self.write_image("a.png", scene(1))
        for command in (("detect", "a.png", "--out", "out"), ("run", ".", "--map", "m.db"), ("match", "a.png", "a.png")):
            self.fails(*command, "--frontend", "xrt", says="--frontend xrt needs --xclbin FILE", code=2)

    def test_wrong_options(self):
        self.write_image("a.png", scene(1))
        start = ("detect", "a.png", "--out", "out", "--frontend", "xrt", "--xclbin", "k")
        for more in (("--fallback", "reference"), ("--device", "-1"), ("--device-timeout", "0")):
            self.run_program(*start, *more, code=2)
            self.assertIn(more[0], self.errors)

    def test_a_missing_xclbin_is_one_line(self):
        self.write_image("a.png", scene(1))
        self.run_program("detect", "a.png", "--out", "out", "--frontend", "xrt", "--xclbin", "missing.xclbin", code=1)
        self.assertRegex(self.errors, r"^sailmap: .*(missing\.xclbin: cannot be read|this build has no XRT).*\n$")

    def test_detect_says_what_fixed_says(self):
        self.device(GOOD)
        self.write_image("a.png", scene(3, 160, 120))
        regions = []
        for more in (("--frontend", "xrt", "--xclbin", "k"), ("--frontend", "fixed")):
            self.run_program("detect", "a.png", "--out", more[1], *more)
            file = next((self.folder / more[1]).rglob("regions.json"))
            report = json.loads(file.read_text())
            self.assertEqual(report.pop("frontend"), more[1])
            regions.append(report)
        self.assertEqual(*regions)

    def test_run_makes_the_map_that_fixed_makes(self):
        self.device(GOOD)
        self.drive()
        made = self.run_and_list("--frontend", "xrt", "--xclbin", "k", out="x.db")
        self.assertEqual(len(made[0]), 4)
        self.assertEqual(self.errors.count("warning"), 0)
        self.assertEqual(made, self.run_and_list("--frontend", "fixed", out="f.db"))

    def test_frames_in_flight(self):
        """The device does not begin before two frames are on it, and does the second one first."""
        self.device(f"{GOOD} gather 2")
        self.drive()
        made = self.run_and_list("--frontend", "xrt", "--xclbin", "k", "--device-timeout", "200000", out="x.db")
        self.assertEqual(made, self.run_and_list("--frontend", "fixed", out="f.db"))

    def test_a_device_that_fails_midway(self):
        self.drive()
        for fault, says in (("lost 3", "simulated device: the device is lost"),
                            ("hang 2", "the kernel did not finish a frame within 2000 ms"),
                            ("wrong-length 1", "the kernel reports maps of"),
                            ("no-device", "simulated device: there is none")):
            self.device(f"{GOOD} {fault}")
            # A fault of the device is none of the image: nothing is passed over.
            self.run_program("run", "images", "--map", f"{fault[:4]}.db", "--skip-bad", "--frontend", "xrt",
                             "--xclbin", "k", code=1)
            self.assertIn(says, self.errors)
            self.assertNotIn("skipped", self.errors)

    def test_the_fallback_takes_over_and_is_told_of_once(self):
        self.drive()
        want = self.run_and_list("--frontend", "fixed", out="f.db")
        for i, fault in enumerate(("lost 3", "hang 2", "wrong-frame 1", "other-version", "wrong-kernel")):
            self.device(f"{GOOD} {fault}")
            got = self.run_and_list("--frontend", "xrt", "--xclbin", "k", "--fallback", "fixed", out=f"x{i}.db")
            self.assertEqual(got, want)
            self.assertEqual(self.errors.count("the front end fixed takes over"), 1, self.errors)

    def test_a_card_of_signatures_fails_midway_as_one_of_maps(self):
        self.drive()
        want = self.run_and_list("--frontend", "fixed", "--signature", "chip", out="f.db")
        on_card = ("--frontend", "xrt", "--xclbin", "k", "--signature", "chip")
        for i, (fault, says) in enumerate((("lost 3", "simulated device: the device is lost"),
                                           ("hang 2", "the kernel did not finish a frame within 2000 ms"),
                                           ("wrong-length 1", "the kernel reports a signature of 240 words"),
                                           ("damaged-record 2", "a signature from the hardware is damaged"),
                                           ("other-version", "reports version 0x53470002, this program is for 0x53470001"))):
            self.device(f"{GOOD} signature {fault}")
            self.run_program("run", "images", "--map", f"a{i}.db", "--skip-bad", *on_card, code=1)
            self.assertIn(says, self.errors)
            self.assertNotIn("skipped", self.errors)
            self.assertEqual(self.run_and_list(*on_card, "--fallback", "fixed", out=f"x{i}.db"), want)
            self.assertEqual(self.errors.count("the front end fixed takes over"), 1, self.errors)

    def test_what_needs_maps_fails_on_a_card_of_signatures(self):
        self.device(f"{GOOD} signature")
        self.drive(2)
        says = "simulated device: it has no kernel sailmap_memory, which hands out maps, but sailmap_signature_memory"
        card = ("--frontend", "xrt", "--xclbin", "k")
        chip = ("--signature", "chip")
        for command in (("run", "images", "--map", "m.db"), ("run", "images", "--map", "m.db", "--method", "context"),
                        ("detect", "images/000.png"), ("detect", "images/000.png", "--save-maps", *chip),
                        ("match", "images/000.png", "images/001.png"), ("compare", "images"), ("compare", "images", *chip,
                                                                                              "--against", "fixed")):
            with self.subTest(command):
                self.run_program(*command, *card, code=1)
                self.assertIn(says, self.errors)
                self.assertEqual(self.errors.count("\n"), 1, self.errors)
        self.assertFalse((self.folder / "sailmap-detect").exists())
        self.fails("run", "images", "--map", "n.db", "--method", "context", *chip, *card,
                   says="the method context needs the maps")
        # The front end of the CPU has them, and says so once.
        self.run_program("detect", "images/000.png", *card, "--fallback", "fixed", "--out", "fallback")
        self.assertIn(says + "; the front end fixed takes over", self.errors)
        self.assertTrue((self.folder / "fallback" / "figure.png").exists())

    def test_compare_on_a_card_of_both_kernels(self):
        self.device(f"{GOOD} both")
        self.drive(2)
        printed = json.loads(self.run_program("compare", "images", "--frontend", "xrt", "--xclbin", "k", "--signature", "chip",
                                              "--against", "fixed", "--json"))
        self.assertEqual({map["largest_error"] for map in printed["maps"].values()}, {0})

    def test_images_too_large_for_the_kernel(self):
        self.device("128x100x4")
        self.drive(2, 160, 120)
        says = "image is 160x120 pixels; the kernel of simulated device takes up to 128x100"
        self.run_program("run", "images", "--map", "a.db", "--frontend", "xrt", "--xclbin", "k", code=1)
        self.assertIn("000.png: " + says, self.errors)
        self.run_program("run", "images", "--map", "b.db", "--frontend", "xrt", "--xclbin", "k", "--fallback", "fixed")
        self.assertIn(says, self.errors)


if __name__ == "__main__":
    unittest.main()
