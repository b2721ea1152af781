"""sailmap detect and sailmap match, as a user runs them."""

import unittest

import cv2
import numpy as np
from program_case import ProgramCase, scene

FEATURES = "intensity_on intensity_off green blue red yellow ori_0 ori_45 ori_90 ori_135".split()
CONSPICUITIES = ["conspicuity_intensity", "conspicuity_colour", "conspicuity_orientation"]


class Detect(ProgramCase):
    def test_regions_and_figure(self):
        self.write_image("a.png", scene(1))
        self.assertIn("regions", self.run_program("detect", "a.png", "--out", "out"))
        found = self.json("out/regions.json")
        self.assertEqual((found["width"], found["height"], found["frontend"]), (160, 120, "fixed"))
        self.assertGreater(len(found["regions"]), 2)
        for region in found["regions"]:
            self.assertEqual(len(region["descriptor"]), 10)
            self.assertLess(region["x"], 160)
            self.assertLess(region["y"], 120)
        saliencies = [region["saliency"] for region in found["regions"]]
        self.assertEqual(saliencies, sorted(saliencies, reverse=True))
        figure = cv2.imread(str(self.folder / "out/figure.png"))
        self.assertGreater(figure.shape[1], 600)

    def test_maps_are_read_by_numpy_and_agree_with_the_regions(self):
        self.write_image("a.png", scene(2, 101, 75))
        self.run_program("detect", "a.png", "--frontend", "reference", "--out", "out", "--save-maps")
        maps = {name: np.load(self.folder / f"out/{name}.npy") for name in FEATURES + CONSPICUITIES + ["saliency"]}
        for name, array in maps.items():
            self.assertEqual(array.dtype, np.float64, name)
            self.assertEqual(array.shape, (19, 26), name)
        formats = self.json("out/maps.json")
        for name in FEATURES:
            self.assertEqual(formats[name]["format"], "float64")
            self.assertEqual(formats[name]["maximum"], maps[name].max())
        first = self.json("out/regions.json")["regions"][0]
        y, x = np.unravel_index(maps["saliency"].argmax(), maps["saliency"].shape)
        self.assertEqual((first["x"], first["y"]), (4 * x, 4 * y))
        self.assertEqual(first["saliency"], np.float32(maps["saliency"].max()))  # kept in single precision
        # Conspicuity is the sum of the normalised maps of its kind (spec 7).
        for name, kind in zip(CONSPICUITIES, (FEATURES[:2], FEATURES[2:6], FEATURES[6:])):
            total = sum(maps[f] / (maps[f].max() * np.sqrt(formats[f]["maxima"])) for f in kind if maps[f].max() > 0)
            np.testing.assert_allclose(maps[name], total, atol=1e-9)

    def test_several_images_have_a_folder_each(self):
        self.write_image("one/a.png", scene(1))
        self.write_image("two/a.png", scene(2))
        self.run_program("detect", "one/a.png", "two/a.png", "--out", "out")
        self.assertNotEqual(self.json("out/a/regions.json")["regions"], self.json("out/a-2/regions.json")["regions"])

    def test_a_flat_image_has_no_region(self):
        self.write_image("flat.png", np.full((100, 100, 3), 128, np.uint8))
        self.run_program("detect", "flat.png", "--out", "out", "--save-maps")
        self.assertEqual(self.json("out/regions.json")["regions"], [])
        self.assertEqual(np.load(self.folder / "out/saliency.npy").max(), 0)

    def test_options_matter(self):
        self.write_image("a.png", scene(3))
        self.run_program("detect", "a.png", "--out", "few", "--max-regions", "2", "--inhibition", "disk")
        self.assertEqual(len(self.json("few/regions.json")["regions"]), 2)
        self.run_program("detect", "a.png", "--out", "vocus", "--descriptor", "background", "--max-regions", "2")
        few, vocus = self.json("few/regions.json")["regions"][0], self.json("vocus/regions.json")["regions"][0]
        self.assertEqual((few["x"], few["y"]), (vocus["x"], vocus["y"]))
        self.assertNotEqual(few["descriptor"], vocus["descriptor"])

    def test_bad_images(self):
        good = self.write_image("good.jpg", scene(1)).read_bytes()
        (self.folder / "empty.png").write_bytes(b"")
        (self.folder / "cut.jpg").write_bytes(good[: len(good) // 2])
        (self.folder / "text.png").write_text("this is no image")
        self.write_image("tiny.png", np.zeros((63, 100, 3), np.uint8))
        for name, fault in {
            "missing.png": "missing.png",
            "empty.png": "empty",
            "cut.jpg": "cut.jpg",
            "text.png": "text.png",
            "tiny.png": "64 to 4096",
        }.items():
            with self.subTest(name):
                self.fails("detect", name, "--out", "out", says=fault)
                self.assertFalse((self.folder / "out").exists())

    def test_wrong_use(self):
        self.write_image("a.png", scene(1))
        for arguments in (["detect"], ["detect", "a.png", "--frontend", "magic"], ["detect", "a.png", "--max-regions", "0"]):
            self.run_program(*arguments, code=2)
        self.assertIn("--save-maps", self.run_program("detect", "--help"))


class Match(ProgramCase):
    def test_the_same_image_is_the_same_place(self):
        self.write_image("a.png", scene(1))
        self.assertIn("same place: similarity 1000000", self.run_program("match", "a.png", "a.png", "--out", "m.png"))
        self.assertGreaterEqual(cv2.imread(str(self.folder / "m.png")).shape[1], 320)

    def test_another_place_is_not(self):
        self.write_image("a.png", scene(1))
        self.write_image("b.png", scene(2))
        self.assertIn("not the same place", self.run_program("match", "a.png", "b.png"))

    def test_a_real_loop_and_a_real_stranger(self):
        images = self.needs_data("rtabmap_corridor") / "images"
        loop = self.run_program("match", images / "0062.jpg", images / "0022.jpg", "--json")
        other = self.run_program("match", images / "0062.jpg", images / "0005.jpg", "--json")
        import json

        self.assertGreater(json.loads(loop)["similarity"], 2 * json.loads(other)["similarity"])

    def test_images_of_different_size_are_refused(self):
        self.write_image("a.png", scene(1))
        self.write_image("b.png", scene(1, 200, 120))
        self.fails("match", "a.png", "b.png", "--out", "m.png", says="160x120 and 200x120")


if __name__ == "__main__":
    unittest.main()
