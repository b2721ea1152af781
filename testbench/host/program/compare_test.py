"""sailmap compare, and detect with fixed-point front ends, as a user runs them."""

import unittest

import cv2
import numpy as np
from program_case import ProgramCase, scene

MAPS = (
    "intensity_on intensity_off green blue red yellow ori_0 ori_45 ori_90 ori_135 conspicuity_intensity "
    "conspicuity_colour conspicuity_orientation saliency"
).split()


class Compare(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence([1, 2, 3, 1])
        self.run_options = ["--exclude-recent", "1"]

    def saved_maps(self, name, frontend):
        """The maps of an image as real numbers, from the raw integers and their lsb."""
        self.run_program("detect", name, "--frontend", frontend, "--out", frontend, "--save-maps")
        formats = self.json(f"{frontend}/maps.json")
        return {m: np.load(self.folder / frontend / f"{m}.npy") * formats[m]["lsb"] for m in MAPS}

    def test_its_figures_are_those_of_the_saved_maps(self):
        self.write_image("one/a.png", scene(5))
        self.run_program("compare", "one", "--out", "out")
        found = self.json("out/compare.json")
        self.assertEqual((found["frontend"], found["against"], found["images"]), ("quantised", "reference", 1))
        quantised = self.saved_maps("one/a.png", "quantised")
        exact = self.saved_maps("one/a.png", "reference")
        for name in MAPS:
            error = np.abs(quantised[name] - exact[name])
            entry = found["maps"][name]
            self.assertAlmostEqual(entry["largest_error"], error.max(), places=12, msg=name)
            self.assertAlmostEqual(entry["largest_error_share"], error.max() / exact[name].max(), places=9)
            rms = np.sqrt(np.mean(error**2)) / exact[name].max()
            self.assertAlmostEqual(entry["rms_error_share"], rms, places=9)
        self.assertGreater(found["maps"]["green"]["largest_error"], 0)

    def test_a_sequence(self):
        printed = self.run_program("compare", "images", "--out", "out", *self.run_options)
        found = self.json("out/compare.json")
        self.assertEqual(found["images"], 4)
        self.assertEqual(found["loops"]["frontend_loops"], 1)
        self.assertEqual(found["loops"]["same_verdict"], 4)
        self.assertGreaterEqual(found["regions"]["same"], 0.9 * found["regions"]["compared"])
        self.assertIn(found["worst_image"], printed)
        for name in MAPS:
            self.assertIn(name, printed)
        figure = cv2.imread(str(self.folder / "out/worst.png"))
        self.assertGreater(figure.shape[1], 600)

    def test_the_kernels_equal_the_quantised_reference(self):
        self.run_program("compare", "images", "--frontend", "csim", "--against", "quantised", "--out", "out")
        found = self.json("out/compare.json")
        self.assertEqual(found["images_with_other_m"], 0)
        for name in MAPS:
            self.assertEqual(found["maps"][name]["largest_error"], 0, name)

    def test_max_images(self):
        self.run_program("compare", "images", "--max-images", "2", "--out", "out")
        self.assertEqual(self.json("out/compare.json")["images"], 2)

    def test_bad_input_is_one_line(self):
        (self.folder / "bad.png").write_bytes(b"not an image")
        self.fails("compare", "bad.png", "--out", "out", says="bad.png")
        self.fails("compare", "nowhere", "--out", "out", says="nowhere")


class FixedPointMaps(ProgramCase):
    def test_the_format_tells_how_to_read_the_raw_numbers(self):
        self.write_image("a.png", scene(2, 101, 75))
        for frontend in ("quantised", "csim"):
            self.run_program("detect", "a.png", "--frontend", frontend, "--out", frontend, "--save-maps")
            formats = self.json(f"{frontend}/maps.json")
            for name in MAPS:
                raw = np.load(self.folder / frontend / f"{name}.npy")
                self.assertEqual(raw.dtype, np.uint16, name)
                self.assertEqual(raw.shape, (19, 26), name)
                form = formats[name]
                self.assertEqual((form["word"], form["signed"]), (16, False), name)
                self.assertAlmostEqual(form["lsb"], form["unit"] * 2.0 ** -form["fraction"], places=15)
                if name != "saliency":
                    self.assertAlmostEqual(form["maximum"], raw.max() * form["lsb"], places=12)
                    self.assertGreaterEqual(form["maxima"], 1)


if __name__ == "__main__":
    unittest.main()
