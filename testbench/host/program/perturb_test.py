"""sailmap perturb."""

import unittest

import cv2
import numpy as np
from program_case import ProgramCase, scene


class Perturb(ProgramCase):
    def test_a_folder(self):
        self.write_sequence([1, 2, 3])
        self.run_program("perturb", "images", "--out", "dark", "--kind", "brightness", "--strength", "0.5")
        for i, place in enumerate([1, 2, 3]):
            copy = cv2.imread(str(self.folder / f"dark/{i}.png")).astype(int)
            self.assertLessEqual(np.abs(copy - scene(place) / 2).max(), 1)

    def test_the_same_seed_gives_the_same_pictures(self):
        self.write_sequence([1, 1])
        for folder, seed in (("a", 7), ("b", 7), ("c", 8)):
            self.run_program("perturb", "images", "--out", folder, "--kind", "noise", "--strength", "9", "--seed", seed)
        a, b, c = ((self.folder / f / "0.png").read_bytes() for f in "abc")
        self.assertEqual(a, b)
        self.assertNotEqual(a, c)
        # Two images of one run have noise of their own.
        self.assertNotEqual(a, (self.folder / "a/1.png").read_bytes())

    def test_faults(self):
        self.write_sequence([1])
        self.fails("perturb", "images", "--out", "o", "--kind", "scale", "--strength", "0", says="factor")
        self.fails("perturb", "nowhere", "--out", "o", "--kind", "scale", "--strength", "1", says="nowhere")
        self.run_program("perturb", "images", "--out", "o", "--kind", "grey", "--strength", "1")
        self.fails("perturb", "images", "--out", "o", "--kind", "grey", "--strength", "1", says="exists already")


if __name__ == "__main__":
    unittest.main()
