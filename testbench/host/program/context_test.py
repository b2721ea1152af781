"""The method context and the temporal filter as a user runs them."""

import contextlib
import json
import sqlite3
import unittest

import numpy as np
from program_case import ProgramCase, scene

PLACES = list(range(12))


class Context(ProgramCase):
    def write_laps(self):
        # The second lap is a little brighter and moved by four pixels.
        for i, place in enumerate(PLACES):
            self.write_image(f"images/{i:02}.png", scene(place))
            again = np.roll(scene(place), 4, axis=1)
            self.write_image(f"images/{i + len(PLACES):02}.png", np.clip(again * 1.1, 0, 255).astype(np.uint8))
        lines = [f"{q + len(PLACES)}: {q}" for q in range(len(PLACES))]
        (self.folder / "truth.txt").write_text("\n".join(lines) + "\n")

    def evaluate(self, *options):
        self.run_program("eval", "images", "--ground-truth", "truth.txt", "--exclude-recent", "5",
                         "--json", "e.json", "--scores", "s.npy", *options)  # fmt: skip
        return self.json("e.json"), np.load(self.folder / "s.npy")

    def test_eval(self):
        self.write_laps()
        result, scores = self.evaluate("--method", "context")
        self.assertEqual(scores.dtype, np.float32)
        self.assertGreater(result["average_precision"], 0.95)
        self.assertEqual(result["fixed_threshold"]["threshold"], 0.2)
        known = scores[~np.isnan(scores)]
        self.assertTrue((known >= 0).all() and (known <= 1).all())
        self.assertTrue(np.isnan(scores[8, 3:]).all())

    def test_the_filter_is_for_every_method(self):
        self.write_laps()
        for method in ("paper", "paper_weighted", "context"):
            alone = self.evaluate("--method", method)[1]
            result, filtered = self.evaluate("--method", method, "--temporal", "5")
            self.assertEqual(result["config"]["temporal"], 5)
            self.assertTrue((np.isnan(alone) == np.isnan(filtered)).all())
            self.assertFalse(np.array_equal(alone, filtered, equal_nan=True), method)

    def test_a_map_is_extended_as_if_never_stored(self):
        self.write_laps()
        options = ["--method", "context", "--exclude-recent", "5", "--temporal", "0"]
        whole = self.run_program("run", "images", "--map", "whole.json", *options, "--json").splitlines()
        self.run_program("run", "images", "--map", "parts.json", *options, "--max-images", "15")
        for i in range(15):
            (self.folder / f"images/{i:02}.png").unlink()
        self.run_program("run", "images", "--map", "parts.json", "--resume")
        whole_map, parts_map = self.exported("whole.json"), self.exported("parts.json")
        strip = lambda m: [(i["node"], i["detection"]["best"]) for i in m["images"]]  # noqa: E731
        self.assertEqual(strip(whole_map), strip(parts_map))
        self.assertGreaterEqual(json.loads(whole[-1])["loops"], 10)

    def test_run_filters_by_default_with_context_only(self):
        self.write_laps()
        self.run_program("run", "images", "--map", "c.json", "--method", "context")
        self.run_program("run", "images", "--map", "p.json")
        self.assertEqual(self.exported("c.json")["config"]["temporal"], 10)
        self.assertEqual(self.exported("p.json")["config"]["temporal"], 0)
        self.fails("run", "images", "--map", "c.json", "--temporal", "3", says="--temporal")

    def test_a_damaged_descriptor_is_refused(self):
        self.write_laps()
        self.run_program("run", "images", "--map", "c.json", "--method", "context")
        path = self.folder / "c.json"
        with contextlib.closing(sqlite3.connect(path)) as database, database:
            database.execute("UPDATE signature SET place = substr(place, 1, length(place) - 1) WHERE id = 3")
        self.fails("run", "images", "--map", "c.json", says="c.json: row 3 of table signature is damaged")

    def exported(self, name):
        return json.loads(self.run_program("map", "export", name, "--format", "json"))

    def test_match(self):
        self.write_image("a.png", scene(1))
        self.write_image("b.png", np.roll(scene(1), 5, axis=1))
        self.write_image("c.png", scene(2))
        self.write_image("flat.png", np.full((120, 160, 3), 77, np.uint8))
        same = json.loads(self.run_program("match", "a.png", "b.png", "--method", "context", "--json", "--out", "m.png"))
        other = json.loads(self.run_program("match", "a.png", "c.png", "--method", "context", "--json"))
        self.assertTrue(same["same_place"])
        self.assertGreater(same["similarity"], 3 * other["similarity"])
        self.assertTrue((self.folder / "m.png").stat().st_size > 0)
        flat = json.loads(self.run_program("match", "a.png", "flat.png", "--method", "context", "--json"))
        self.assertEqual((flat["similarity"], flat["reason"]), (0, "no_regions"))


if __name__ == "__main__":
    unittest.main()
