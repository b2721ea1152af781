"""sailmap loops: what is listed, chosen and drawn, against the whole map as JSON."""

import json
import unittest

import cv2
import numpy as np
from program_case import ProgramCase, scene

LAPS = [0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5]


class Loops(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence(LAPS)
        # The second lap differs a little from the first, each image in its own way.
        for i in range(6, 12):
            noise = np.random.default_rng(i).normal(0, 2 + i - 6, (120, 160, 3))
            self.write_image(f"images/{i}.png", np.clip(scene(LAPS[i]) + noise, 0, 255).astype(np.uint8))
        self.run_program("run", "images", "--map", "m.map", "--exclude-recent", "3", "--same-place-nodes", "1")
        whole = json.loads(self.run_program("map", "export", "m.map", "--format", "json"))
        self.images = whole["images"]

    def loops(self, *arguments, **how):
        lines = self.run_program("loops", "m.map", "--json", *arguments, **how).splitlines()
        return [json.loads(line) for line in lines]

    def expected(self, passes):
        return [i["image"] for i in self.images if passes(i["detection"])]

    def test_all_of_them_with_their_facts(self):
        loops = self.loops()
        self.assertGreater(len(loops), 3)
        self.assertEqual([loop["image"] for loop in loops], self.expected(lambda d: d["reason"] == "accepted"))
        for loop in loops:
            image = self.images[loop["image"]]
            self.assertEqual({k: loop[k] for k in image["detection"]}, image["detection"])
            self.assertEqual(loop["name"], image["name"])
            self.assertEqual(loop["node_name"], f"images/{loop['best']['node']}.png")

    def test_fields_are_those_of_run(self):
        self.run_program("run", "images", "--map", "again.map", "--exclude-recent", "3", "--json")
        events = self.run_program("run", "images", "--map", "third.map", "--exclude-recent", "3", "--json").splitlines()
        event = json.loads(events[0])
        self.assertEqual(set(event) - {"event"}, set(self.loops("--limit", "1")[0]))

    def test_filters(self):
        similarities = sorted(i["detection"]["best"]["similarity"] for i in self.images if i["detection"]["reason"] == "accepted")
        middle = similarities[len(similarities) // 2]
        accepted = lambda d: d["reason"] == "accepted"
        for arguments, passes in {
            ("--min-similarity", repr(middle)): lambda d: accepted(d) and d["best"]["similarity"] >= middle,
            ("--max-similarity", repr(middle)): lambda d: accepted(d) and d["best"]["similarity"] <= middle,
            ("--node", "2"): lambda d: accepted(d) and d["best"]["node"] == 2,
            ("--reason", "excluded"): lambda d: d["reason"] == "excluded",
            ("--reason", "no_nodes"): lambda d: d["reason"] == "no_nodes",
            ("--reason", "all"): lambda d: True,
            ("--reason", "all", "--min-similarity", "0"): lambda d: d["best"] is not None,
        }.items():
            with self.subTest(arguments):
                expected = self.expected(passes)
                self.assertNotEqual(expected, [])
                self.assertEqual([loop["image"] for loop in self.loops(*arguments)], expected)
        self.assertEqual([loop["image"] for loop in self.loops("--reason", "all", "--image", "2..4")], [2, 3, 4])
        self.assertEqual([loop["image"] for loop in self.loops("--reason", "all", "--image", "7")], [7])

    def test_orders(self):
        by_similarity = [loop["best"]["similarity"] for loop in self.loops("--sort", "similarity")]
        self.assertEqual(by_similarity, sorted(by_similarity, reverse=True))
        doubts = [loop["runner_up"]["similarity"] / loop["best"]["similarity"] if loop["runner_up"] else 0 for loop in self.loops("--sort", "doubt")]
        self.assertEqual(doubts, sorted(doubts, reverse=True))
        self.assertGreater(len(set(doubts)), 1)
        self.assertEqual(self.loops("--sort", "similarity", "--limit", "2"), self.loops("--sort", "similarity")[:2])

    def test_a_table_for_people(self):
        lines = self.run_program("loops", "m.map").splitlines()
        loops = self.loops()
        self.assertEqual(len(lines), len(loops) + 2)
        for line, loop in zip(lines[1:], loops):
            self.assertEqual(line.split()[:2], [str(loop["image"]), str(loop["best"]["node"])])
            self.assertIn(f"{loop['name']} at {loop['node_name']}", line)
        self.assertIn(f"{len(loops)} listed", lines[-1])

    def test_pictures_are_those_of_match(self):
        loops = self.loops("--pictures", "p", "--limit", "2")
        self.assertEqual(sorted(p.name for p in (self.folder / "p").iterdir()), sorted(loop["picture"].split("/")[-1] for loop in loops))
        for loop in loops:
            self.run_program("match", loop["name"], loop["node_name"], "--out", "pair.png")
            ours, match = (cv2.imread(str(self.folder / name)) for name in (loop["picture"], "pair.png"))
            # Everything but the verdict beneath and the width it may need.
            images = 120
            np.testing.assert_array_equal(ours[:images, :320], match[:images, :320])
            self.assertEqual(len(loop["matches"]), len(json.loads(self.run_program("match", loop["name"], loop["node_name"], "--json"))["matches"]))

    def test_missing_images_are_reported_and_the_rest_drawn(self):
        loops = self.loops()
        (self.folder / loops[1]["name"]).unlink()
        listed = self.loops("--pictures", "p", code=1)
        self.assertEqual([loop["picture"] is None for loop in listed], [i == 1 for i in range(len(loops))])
        self.assertIn(loops[1]["name"], self.errors)
        self.assertIn(f"1 of {len(loops)} pairs could not be drawn", self.errors)
        self.assertEqual(len(list((self.folder / "p").iterdir())), len(loops) - 1)

    def test_images_that_changed_are_told(self):
        name = self.loops("--limit", "1")[0]["name"]
        self.write_image(name, scene(77))
        self.run_program("loops", "m.map", "--pictures", "p", "--limit", "1")
        self.assertIn("has changed since the map was made", self.errors)

    def test_images_elsewhere(self):
        (self.folder / "elsewhere").mkdir()
        (self.folder / "images").rename(self.folder / "elsewhere/images")
        self.loops("--pictures", "p", code=1)
        self.loops("--pictures", "p", "--images-in", "elsewhere")

    def test_sparse_and_context_maps_can_be_drawn(self):
        for arguments in (["--sparse"], ["--method", "context", "--temporal", "0"]):
            with self.subTest(arguments):
                name = arguments[-1].strip("-") + ".map"
                self.run_program("run", "images", "--map", name, "--exclude-recent", "3", *arguments)
                lines = self.run_program("loops", name, "--json", "--pictures", "p").splitlines()
                self.assertGreater(len(lines), 0)
                self.assertEqual(self.errors, "")

    def test_wrong_use(self):
        for arguments, fault in {("--image", "x"): "--image", ("--image", "4..2"): "--image", ("--image", "1..2x"): "--image",
                                 ("--image", "99999999999"): "--image"}.items():
            self.fails("loops", "m.map", *arguments, says=fault, code=2)
        self.fails("loops", "gone.map", says="gone.map")


if __name__ == "__main__":
    unittest.main()
