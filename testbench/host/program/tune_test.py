"""sailmap tune: the threshold it gives, held against the score matrix of sailmap eval, and written into maps."""

import contextlib
import json
import shutil
import sqlite3
import unittest

import numpy as np
from program_case import ProgramCase, simulated
from scipy.stats import beta

TRUTH = ["--ground-truth", "s/ground_truth.txt"]


class Tune(ProgramCase):
    @classmethod
    def setUpClass(cls):
        cls.drive = simulated(cls, "--images", "60", "--images-per-lap", "20")

    def setUp(self):
        super().setUp()
        shutil.copytree(self.drive, self.folder / "s")
        self.run_program("eval", "s/images", *TRUTH, "--exclude-recent", "5", "--json", "e.json", "--scores", "s.npy")
        self.truth = [set(map(int, line.split(":")[1].split())) for line in (self.folder / "s/ground_truth.txt").read_text().splitlines()]

    def tune(self, *arguments):
        return json.loads(self.run_program("tune", *arguments, "--json"))

    def best_of_each(self):
        """Score of the best candidate, whether it is right, and whether there is a match, by query."""
        for query, row in enumerate(np.load(self.folder / "s.npy")):
            admissible = np.flatnonzero(~np.isnan(row))
            if admissible.size:
                best = admissible[row[admissible].argmax()]
                yield row[best], best in self.truth[query], bool(self.truth[query] & set(admissible))

    def at(self, threshold):
        rows = list(self.best_of_each())
        detected = [right for score, right, _ in rows if score > threshold]
        return len(detected), sum(detected), sum(has_match for *_, has_match in rows)

    def test_the_threshold_does_what_it_says(self):
        for precision in (0.5, 0.9, 0.95, 1.0):
            with self.subTest(precision):
                tuned = self.tune("--evaluation", "e.json", "--precision", precision)
                detections, right, with_match = self.at(tuned["threshold"])
                self.assertEqual((tuned["detections"], tuned["right"], tuned["queries_with_match"]), (detections, right, with_match))
                self.assertAlmostEqual(tuned["precision"], right / detections, places=12)
                self.assertAlmostEqual(tuned["recall"], right / with_match, places=12)
                self.assertGreaterEqual(tuned["precision"], precision)
                # No other threshold has that precision and more recall.
                for score, *_ in self.best_of_each():
                    others, others_right, _ = self.at(np.nextafter(score, -np.inf, dtype=np.float64))
                    if others_right / others >= precision:
                        self.assertLessEqual(others_right, right)
                # Clopper and Pearson's bound, from scipy.
                self.assertAlmostEqual(tuned["precision_at_least"], beta.ppf(0.05, right, detections - right + 1), places=9)

    def test_eval_at_that_threshold_agrees(self):
        tuned = self.tune("s/images", *TRUTH, "--exclude-recent", "5", "--precision", "0.9")
        self.assertEqual(tuned["threshold"], self.tune("--evaluation", "e.json", "--precision", "0.9")["threshold"])
        self.run_program("eval", "s/images", *TRUTH, "--exclude-recent", "5", "--threshold", tuned["threshold"], "--json", "f.json")
        fixed = self.json("f.json")["fixed_threshold"]
        self.assertEqual((fixed["detections"], fixed["right"]), (tuned["detections"], tuned["right"]))

    def test_few_queries_are_warned_of(self):
        few = self.tune("--evaluation", "e.json", "--precision", "0.99")
        self.assertFalse(few["enough"])
        self.assertEqual(few["needed_detections"], 299)  # 0.99 ** 299 < 0.05 < 0.99 ** 298
        self.assertIn("warning", self.errors)
        self.assertIn("it takes 299", self.errors)
        enough = self.tune("--evaluation", "e.json", "--precision", "0.5")
        self.assertTrue(enough["enough"])
        self.assertEqual(self.errors, "")

    def test_text_for_people(self):
        text = self.run_program("tune", "--evaluation", "e.json", "--precision", "0.9")
        for word in ("threshold", "precision", "recall", "confidence"):
            self.assertIn(word, text)

    def test_a_precision_that_is_never_reached(self):
        evaluation = self.json("e.json")
        for point in evaluation["curve"]:
            point["precision"] *= 0.9
        (self.folder / "low.json").write_text(json.dumps(evaluation))
        self.fails("tune", "--evaluation", "low.json", "--precision", "0.95", says="never reached; the highest is 0.9")

    def test_written_into_a_map(self):
        self.run_program("run", "s/images", "--map", "m.map", "--exclude-recent", "5")
        before = json.loads(self.run_program("map", "export", "m.map", "--format", "json"))
        tuned = self.tune("--evaluation", "e.json", "--precision", "0.9", "--map", "m.map")
        self.assertEqual(tuned["map"], "m.map")
        after = json.loads(self.run_program("map", "export", "m.map", "--format", "json"))
        self.assertEqual(after["config"]["detection"]["threshold"], tuned["threshold"])
        before["config"]["detection"]["threshold"] = tuned["threshold"]
        self.assertEqual(before, after)
        # The map goes on with it.
        printed = self.run_program("run", "s/images", "--map", "m.map", "--threshold", tuned["threshold"])
        self.assertIn("120 images", printed)

    def test_nothing_else_in_the_file_changes(self):
        self.run_program("run", "s/images", "--map", "m.map", "--exclude-recent", "5", "--thumbnails", "40")
        self.run_program("run", "s/images", "--map", "m.map")
        before = self.tables("m.map")
        self.assertEqual((len(before["session"]), len(before["thumbnail"]), len(before["image"])), (2, 60, 120))
        tuned = self.tune("--evaluation", "e.json", "--precision", "0.9", "--map", "m.map")
        after = self.tables("m.map")
        (row,), (tuned_row,) = before.pop("map"), after.pop("map")
        self.assertEqual(before, after)
        parameters = json.loads(row["parameters"])
        parameters["detection"]["threshold"] = tuned["threshold"]
        self.assertEqual(json.loads(tuned_row["parameters"]), parameters)
        self.assertIn("sound", self.run_program("map", "check", "m.map"))
        self.assertEqual(sorted(p.name for p in self.folder.glob("m.map*")), ["m.map"])

    def tables(self, name):
        with contextlib.closing(sqlite3.connect(self.folder / name)) as database:
            database.row_factory = sqlite3.Row
            names = [row[0] for row in database.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
            return {table: [dict(row) for row in database.execute(f"SELECT * FROM {table}")] for table in names}

    def test_a_map_lends_its_parameters(self):
        self.run_program("run", "s/images", "--map", "m.map", "--exclude-recent", "5", "--max-regions", "12", "--method", "paper")
        tuned = self.tune("s/images", *TRUTH, "--precision", "0.9", "--map", "m.map")
        self.assertEqual(tuned["method"], "paper")
        alone = self.tune("s/images", *TRUTH, "--precision", "0.9", "--max-regions", "12", "--method", "paper", "--exclude-recent", "5")
        self.assertEqual(tuned["threshold"], alone["threshold"])

    def test_other_parameters_are_refused_by_name(self):
        self.run_program("run", "s/images", "--map", "m.map", "--exclude-recent", "5")
        tune = ["tune", "s/images", *TRUTH, "--map", "m.map"]
        self.fails(*tune, "--max-regions", "7", says="regions/max_regions (map 20, measured 7)")
        self.fails(*tune, "--frontend", "reference", says="frontend")
        self.fails(*tune, "--method", "paper", says='match/method (map "paper_weighted", measured "paper")')
        self.fails(*tune, "--method", "bow", says="--map", code=2)
        self.run_program("eval", "s/images", *TRUTH, "--exclude-recent", "9", "--stop-ratio", "0.3", "--json", "f.json")
        self.fails("tune", "--evaluation", "f.json", "--map", "m.map", says="regions/stop_ratio (map 0.25, measured 0.3)")
        self.assertIn("exclude_recent (map 5, measured 9)", self.errors)

    def test_wrong_use_and_wrong_files(self):
        self.fails("tune", says="either SOURCE", code=2)
        self.fails("tune", "s/images", says="--ground-truth", code=2)
        self.fails("tune", "s/images", *TRUTH, "--evaluation", "e.json", says="does not go with --evaluation", code=2)
        self.run_program("tune", "--evaluation", "e.json", "--precision", "0", code=2)
        self.run_program("tune", "--evaluation", "e.json", "--precision", "1.5", code=2)
        self.fails("tune", "--evaluation", "gone.json", says="gone.json")
        evaluation = self.json("e.json")
        for key, value in {"curve": None, "queries": 0, "queries_with_match": "many", "method": 3, "config": []}.items():
            (self.folder / "bad.json").write_text(json.dumps({**evaluation, key: value} if value is not None else {k: v for k, v in evaluation.items() if k != key}))
            with self.subTest(key):
                self.fails("tune", "--evaluation", "bad.json", says="bad.json: ")
        curve = [dict(point) for point in evaluation["curve"]]
        curve[1]["precision"] = 1.5
        (self.folder / "bad.json").write_text(json.dumps({**evaluation, "curve": curve}))
        self.fails("tune", "--evaluation", "bad.json", says="not within 0 and 1")
        (self.folder / "bad.json").write_text(json.dumps({**evaluation, "curve": evaluation["curve"][::-1]}))
        self.fails("tune", "--evaluation", "bad.json", says="do not fall")
        (self.folder / "bad.json").write_text("[")
        self.fails("tune", "--evaluation", "bad.json", says="bad.json: not what")


if __name__ == "__main__":
    unittest.main()
