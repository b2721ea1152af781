"""sailmap map diff: exit codes as of diff(1), and each kind of difference."""

import json
import unittest

from program_case import ProgramCase, scene

LAPS = [0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5]


class MapDiff(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence(LAPS)
        self.make("a.map")

    def make(self, name, *arguments, source="images"):
        self.run_program("run", source, "--map", name, *([] if "--exclude-recent" in arguments else ["--exclude-recent", "3"]), *arguments)

    def diff(self, b, *arguments, a="a.map", code=1):
        found = json.loads(self.run_program("map", "diff", a, b, "--json", *arguments, code=code))
        self.assertEqual(found["equal"], code == 0)
        return found

    def test_equal_maps(self):
        self.make("b.map")
        self.assertEqual(self.run_program("map", "diff", "a.map", "b.map"), "")
        found = self.diff("b.map", code=0)
        for key in ("parameters", "regions", "detections"):
            self.assertEqual(found[key], [])
        for key in ("images", "nodes", "edges"):
            self.assertEqual(found[key], {"only_in_a": [], "only_in_b": []})

    def test_a_verdict(self):
        # Above what identical images have, so that nothing is a loop.
        self.make("b.map", "--threshold", "1e7")
        found = self.diff("b.map")
        self.assertEqual([(p["parameter"], p["a"], p["b"]) for p in found["parameters"]], [("detection.threshold", 3.0, 1e7)])
        self.assertEqual([d["image"]["name"] for d in found["detections"]], [f"images/{i}.png" for i in range(6, 12)])
        first = found["detections"][0]
        self.assertEqual((first["a"]["reason"], first["b"]["reason"]), ("accepted", "below_threshold"))
        self.assertEqual(first["a"]["node"]["name"], "images/0.png")
        self.assertEqual([n["name"] for n in found["nodes"]["only_in_b"]], [f"images/{i}.png" for i in range(6, 12)])
        self.assertEqual(found["regions"], [])
        self.assertIn(("images/5.png", "images/0.png", "loop"), [(e["from"]["name"], e["to"]["name"], e["kind"]) for e in found["edges"]["only_in_a"]])
        self.assertIn(("images/5.png", "images/6.png", "path"), [(e["from"]["name"], e["to"]["name"], e["kind"]) for e in found["edges"]["only_in_b"]])
        text = self.run_program("map", "diff", "a.map", "b.map", code=1)
        self.assertIn("- detection.threshold 3.0\n+ detection.threshold 10000000.0\n", text)
        self.assertIn("- images/6.png: accepted at images/0.png", text)
        self.assertIn("+ images/6.png: below_threshold at images/0.png", text)
        self.assertIn("- loop edge from images/5.png to images/0.png\n", text)

    def test_images_only_in_one(self):
        (self.folder / "images/3.png").unlink()
        self.make("b.map")
        found = self.diff("b.map")
        self.assertEqual([i["name"] for i in found["images"]["only_in_a"]], ["images/3.png"])
        self.assertEqual(found["images"]["only_in_b"], [])
        turned = self.diff("a.map", a="b.map")
        self.assertEqual([i["name"] for i in turned["images"]["only_in_b"]], ["images/3.png"])

    def test_the_same_name_again_is_another_image(self):
        self.make("b.map")
        self.make("b.map")
        found = self.diff("b.map")
        self.assertEqual({i["occurrence"] for i in found["images"]["only_in_b"]}, {2})
        self.assertEqual(len(found["images"]["only_in_b"]), 12)

    def test_similarities_within_the_tolerance(self):
        # The reference in floating point against the fixed-point default: all similarities differ a little.
        self.write_image("images/12.png", scene(0)[:, ::-1])
        self.make("fixed.map")
        self.make("reference.map", "--frontend", "reference")
        found = self.diff("reference.map", a="fixed.map")
        self.assertEqual([p["parameter"] for p in found["parameters"]], ["frontend"])
        self.assertGreater(len(found["regions"]), 0)
        changed = [d for d in found["detections"] if d["a"]["node"] == d["b"]["node"] and d["a"]["reason"] == d["b"]["reason"]]
        self.assertGreater(len(changed), 0)
        largest = max(abs(d["a"]["similarity"] - d["b"]["similarity"]) / max(d["a"]["similarity"], d["b"]["similarity"]) for d in changed)
        tolerant = self.diff("reference.map", "--tolerance", repr(min(1.0, largest * 1.01)), a="fixed.map")
        self.assertEqual(len(tolerant["detections"]), len(found["detections"]) - len(changed))
        strict = self.diff("reference.map", "--tolerance", repr(largest * 0.99), a="fixed.map")
        self.assertGreater(len(strict["detections"]), len(tolerant["detections"]))

    def test_trouble_is_2(self):
        self.fails("map", "diff", "a.map", "gone.map", says="gone.map", code=2)
        (self.folder / "bad.map").write_text("no map")
        self.fails("map", "diff", "bad.map", "a.map", says="bad.map", code=2)
        self.run_program("map", "diff", "a.map", code=2)
        self.run_program("map", "diff", "a.map", "a.map", "--tolerance", "2", code=2)


if __name__ == "__main__":
    unittest.main()
