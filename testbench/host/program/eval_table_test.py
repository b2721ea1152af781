"""sailmap eval --table against single runs of sailmap eval, on simulated sequences; and eval's method fabmap."""

import csv
import importlib.util
import io
import json
import pathlib
import shutil
import unittest
import xml.etree.ElementTree

import numpy as np
from program_case import ProgramCase, skip_without

TEMPLATE = pathlib.Path(__file__).parents[3] / "share/paper_table.json"
LAPS = [0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 9, 5]
TRUTH = "".join(f"{q}: {' '.join(str(c) for c in range(q) if LAPS[c] == LAPS[q])}\n" for q in range(len(LAPS)))
METHODS = [
    "paper_weighted",
    {"name": "context 5", "method": "context", "temporal": 5},
    {"name": "FAB-MAP", "method": "fabmap", "words": 40},
    {"method": "bow", "words": 40},
]


class EvalTable(ProgramCase):
    def write_config(self, data_sets, methods=METHODS, name="data/table.json"):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(json.dumps({"methods": methods, "data_sets": data_sets}))
        return name

    def write_laps(self, folder):
        self.write_sequence(LAPS, f"{folder}/images")
        (self.folder / folder / "truth.txt").write_text(TRUTH)

    def write_training(self):
        self.write_sequence(range(100, 115), "training")
        self.run_program("fabmap", "train", "training", "--words", "40", "--out", "words.json")

    def single(self, *arguments):
        self.run_program("eval", *arguments, "--json", "single.json")
        return self.json("single.json")

    def assert_same_figures(self, one, other):
        for key in ("queries", "queries_with_match", "fixed_threshold", "average_precision", "recall_at_100_precision",
                    "recall_at_95_precision", "best_f1", "recall_at", "curve", "method", "images"):  # fmt: skip
            self.assertEqual(one[key], other[key], key)

    def test_figures_are_those_of_single_runs(self):
        self.run_program("simulate", "--out", "data/world", "--images", "50", "--images-per-lap", "30",
                         "--width", "320", "--height", "240")  # fmt: skip
        self.write_laps("data/laps")
        self.write_sequence(LAPS[:8], "data/first")
        self.write_sequence(LAPS[8:], "data/second")
        (self.folder / "data/pairs.txt").write_text("0: 0\n1: 1\n2: 2\n3: 3\n5: 5\n")
        self.write_training()
        config = self.write_config([
            {"name": "world", "folder": "world", "source": "images", "ground_truth": "ground_truth.txt",
             "exclude_recent": 10, "vocabulary": "../../words.json"},
            {"name": "laps", "source": "laps/images", "ground_truth": "laps/truth.txt", "exclude_recent": 3,
             "length_km": 1.25, "train_on": "world"},
            {"name": "lap in lap", "reference": "first", "query": "second", "ground_truth": "pairs.txt"},
        ])  # fmt: skip
        printed = self.run_program("eval", "--table", config, "--json", "t.json", "--csv", "t.csv", "--markdown", "t.md",
                                   "--plot", "t.svg")  # fmt: skip
        table = self.json("t.json")
        rows = {row["name"]: row["results"] for row in table["data_sets"]}
        self.assertEqual(list(rows), ["world", "laps", "lap in lap"])
        world = ["data/world/images", "--ground-truth", "data/world/ground_truth.txt", "--exclude-recent", "10"]
        laps = ["data/laps/images", "--ground-truth", "data/laps/truth.txt", "--exclude-recent", "3"]
        pairs = ["--reference", "data/first", "--query", "data/second", "--ground-truth", "data/pairs.txt"]
        for name, sequence in (("world", world), ("laps", laps), ("lap in lap", pairs)):
            self.assert_same_figures(rows[name]["paper_weighted"], self.single(*sequence))
            self.assert_same_figures(
                rows[name]["context 5"], self.single(*sequence, "--method", "context", "--temporal", "5")
            )
        fabmap = ["--method", "fabmap", "--vocabulary"]
        self.assert_same_figures(rows["world"]["FAB-MAP"], self.single(*world, *fabmap, "words.json"))
        bow = self.single(*world, "--method", "bow", "--vocabulary", "words.json")
        self.assert_same_figures(rows["world"]["bow"], bow)
        self.run_program("fabmap", "train", "data/world/images", "--words", "40", "--out", "world.json")
        self.assert_same_figures(rows["laps"]["FAB-MAP"], self.single(*laps, *fabmap, "world.json"))
        self.assertIn("no vocabulary", rows["lap in lap"]["FAB-MAP"]["skipped"])

        lines = list(csv.DictReader(io.StringIO((self.folder / "t.csv").read_text())))
        self.assertEqual(len(lines), 12)
        for line in lines:
            self.assertNotIn(None, line.values())
            result = rows[line["data_set"]][line["method"]]
            self.assertEqual(line["skipped"], result.get("skipped", ""))
            if not line["skipped"]:
                self.assertEqual(float(line["average_precision"]), result["average_precision"])
                self.assertEqual(float(line["recall"]), result["fixed_threshold"]["recall"])
                self.assertEqual(int(line["detections"]), result["fixed_threshold"]["detections"])

        # The text shows what the JSON says, in the columns of Table I first.
        laps_line = next(line for line in printed.splitlines() if line.startswith("laps "))
        cells = laps_line.split()
        self.assertEqual(cells[1:5], ["1.2", "km", "14", "5"])
        of = [rows["laps"][m] for m in table["methods"]]
        expected = [f"{100 * r['fixed_threshold']['precision']:.1f}" if r["fixed_threshold"]["detections"] else "-" for r in of]
        expected += [f"{100 * r['fixed_threshold']['recall']:.1f}" for r in of]
        expected += [f"{r['average_precision']:.3f}" for r in of]
        expected += [f"{100 * r['recall_at_100_precision']:.1f}" for r in of]
        self.assertEqual(cells[5:], expected)
        self.assertIn("lap in lap, FAB-MAP: skipped", printed)
        markdown = (self.folder / "t.md").read_text().splitlines()
        self.assertEqual([c.strip() for c in markdown[3].split("|")[5:-1]], expected)
        self.assertEqual(len({line.count("|") for line in markdown[:5]}), 1)

        texts = ["".join(t.itertext()).strip() for t in xml.etree.ElementTree.parse(self.folder / "t.svg").iterfind(".//{*}text")]
        for word in ("Recall (%)", "Precision (%)", "world", "laps", "lap in lap", "FAB-MAP", "context 5"):
            self.assertIn(word, texts)

    def test_oxford_and_poses(self):
        # Left and right interleave; the left camera sees the laps, the right one places of its own.
        self.write_sequence([p for k, place in enumerate(LAPS) for p in (place, 50 + k)], "data/images")
        (self.folder / "data/truth.txt").write_text(TRUTH)
        poses = "lat,lon\n" + "".join(f"45.0,{3 + place * 0.001:.6f}\n" for place in LAPS)
        (self.folder / "data/poses.csv").write_text(poses)
        oxford = {"source": "images", "layout": "oxford", "exclude_recent": 3}
        config = self.write_config(
            [{"name": "left", "side": "left", "ground_truth": "truth.txt", **oxford},
             {"name": "poses", "side": "left", "ground_truth": "poses.csv", "radius": 10, **oxford}],
            ["paper_weighted"],
        )  # fmt: skip
        self.run_program("eval", "--table", config, "--json", "t.json")
        left, poses = self.json("t.json")["data_sets"]
        single = self.single("data/images", "--ground-truth", "data/truth.txt", "--exclude-recent", "3",
                             "--layout", "oxford", "--side", "left")  # fmt: skip
        self.assert_same_figures(left["results"]["paper_weighted"], single)
        self.assertIsNone(left["length_km"])
        # A thousandth of a degree at 45 degrees north is 78.85 m; the steps of the laps are 7, 7, 3, 6 and 4 long.
        self.assertAlmostEqual(poses["length_km"], (7 + 7 + 3 + 6 + 4) * 0.07885, places=2)
        self.assertEqual(
            poses["results"]["paper_weighted"]["fixed_threshold"], left["results"]["paper_weighted"]["fixed_threshold"]
        )

    def test_what_is_not_filled_in_is_skipped(self):
        self.write_laps("data/laps")
        (self.folder / "data/empty").mkdir()
        laps = {"source": "laps/images", "ground_truth": "laps/truth.txt", "exclude_recent": 3}
        config = self.write_config([
            {"name": "A", "source": "", "ground_truth": "truth.txt"},
            {"name": "B", "source": "empty", "ground_truth": "truth.txt"},
            {"name": "C", "folder": "", "source": "laps/images", "ground_truth": "laps/truth.txt"},
            {"name": "D", "folder": "empty", "source": "images", "ground_truth": "truth.txt"},
            {"name": "E", "source": "laps/images", "ground_truth": ""},
            {"name": "F", **laps, "train_on": "A"},
        ])  # fmt: skip
        printed = self.run_program("eval", "--table", config, "--json", "t.json", "--plot", "t.svg")
        for name, why in (("A", "source is not filled in"), ("B", "holds no image"), ("C", "folder is not filled in"),
                          ("D", "is empty"), ("E", "ground_truth is not filled in"),
                          ("F, FAB-MAP", "its words are learned from A, which is skipped")):  # fmt: skip
            self.assertTrue(
                any(line.startswith(f"{name}: skipped, ") and why in line for line in printed.splitlines()), (name, printed)
            )
        self.assertEqual([d["name"] for d in self.json("t.json")["data_sets"] if "skipped" not in d], ["F"])

    @skip_without(importlib.util.find_spec("scipy"), "scipy, which writes the .mat file")
    def test_the_template(self):
        """Every data set waits to be filled in; one that is, is evaluated."""
        shutil.copy(TEMPLATE, self.folder / "t.json")
        printed = self.run_program("eval", "--table", "t.json")
        self.assertEqual(printed.count("skipped, folder is not filled in"), 8)
        self.fails("eval", "--table", "t.json", "--plot", "t.svg", says="t.svg: there is nothing to draw")
        pairs = LAPS[:8] + list(range(20, 80)) + LAPS[8:]
        self.write_sequence([p for place in pairs for p in (place, place + 200)], "oxford/Images")
        matches = np.zeros((len(pairs), len(pairs)), np.uint8)
        for query in range(68, len(pairs)):
            matches[query, [c for c in range(8) if pairs[c] == pairs[query]]] = 1
        from scipy.io import savemat

        savemat(self.folder / "oxford/CityCentreGroundTruth.mat", {"truth": np.kron(matches, np.eye(2, dtype=np.uint8))})
        text = TEMPLATE.read_text()
        filled = text.replace('"CC-Left", "folder": ""', '"CC-Left", "folder": "oxford"')
        self.assertNotEqual(text, filled)
        (self.folder / "t.json").write_text(filled)
        printed = self.run_program("eval", "--table", "t.json", "--json", "out.json")
        self.assertEqual(printed.count("skipped, folder is not filled in"), 7)
        left = self.json("out.json")["data_sets"][0]
        self.assertEqual(left["results"]["SAIL-MAP"]["queries_with_match"], 5)
        self.assertGreater(left["results"]["SAIL-MAP"]["average_precision"], 0.9)

    def test_wrong_entries_are_named(self):
        self.write_laps("data/laps")
        good = {"name": "laps", "source": "laps/images", "ground_truth": "laps/truth.txt"}

        def fails_with(entry, says, methods=METHODS, first=good):
            with self.subTest(says):
                config = self.write_config([first, entry], methods)
                self.fails("eval", "--table", config, "--csv", "t.csv", says=says)
                self.assertIn("data/table.json: ", self.errors)

        fails_with({**good, "name": "B", "source": "gone"}, "data set 'B': data/gone")
        fails_with({**good, "name": "B", "ground_truth": "gone.txt"}, "data set 'B': data/gone.txt")
        fails_with({**good, "name": "B", "groundtruth": "x"}, "data set 2 'B': unknown key 'groundtruth'")
        fails_with({**good, "name": "B", "exclude_recent": -1}, "exclude_recent must be a whole number")
        fails_with({**good, "name": "B", "exclude_recent": 2**70}, "exclude_recent must be a whole number")
        fails_with({**good, "name": "B", "radius": "5"}, "radius must be a number")
        fails_with({**good, "name": "B", "layout": "oxford"}, "layout oxford and side")
        fails_with({**good, "name": "B", "reference": "laps"}, "either source or both")
        fails_with({**good, "name": "B", "vocabulary": "gone.json"}, "data set 'B': data/gone.json")
        fails_with({**good, "name": "B", "train_on": "C"}, "train_on names no data set 'C'")
        fails_with({**good, "name": "B", "train_on": "B"}, "must name another data set")
        fails_with({"source": "laps/images"}, "data set 2: has no name")
        fails_with(good, "data set 'laps' a second time")
        fails_with(7, "data set 2: must be an object")
        other = {**good, "name": "B"}
        fails_with(other, "method 1: no method 'sift'", ["sift"])
        fails_with(other, "method 1 'x': words is for the methods fabmap and bow", [{"name": "x", "method": "paper", "words": 3}])
        fails_with(other, "method 'fabmap': data/gone.json", [{"method": "fabmap", "vocabulary": "gone.json"}])
        fails_with(other, "methods must be a list", [])
        (self.folder / "data/table.json").write_text("{")
        self.fails("eval", "--table", "data/table.json", says="data/table.json: not JSON")
        self.fails("eval", "--table", "gone.json", says="gone.json")
        # Found while it works: no query of the second can have a match.
        config = self.write_config([{**good, "exclude_recent": 3}, {**other, "exclude_recent": 13}], ["paper"])
        self.fails("eval", "--table", config, says="data set 'B': no query has an admissible true match")

    def test_options_that_belong_elsewhere(self):
        for arguments in (
            ["--table", "t.json", "--method", "paper"],
            ["--table", "t.json", "images"],
            ["--table", "t.json", "--scores", "s.npy"],
            ["images", "--ground-truth", "t.txt", "--csv", "t.csv"],
            ["images"],
        ):
            with self.subTest(arguments):
                self.fails("eval", *arguments, says="sailmap: error", code=2)


class EvalFabmap(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence(LAPS)
        (self.folder / "truth.txt").write_text(TRUTH)
        self.write_sequence(range(100, 115), "training")
        self.run_program("fabmap", "train", "training", "--words", "40", "--out", "words.json")
        self.laps = ["eval", "images", "--ground-truth", "truth.txt", "--exclude-recent", "3", "--method", "fabmap"]

    def test_beside_the_other_methods(self):
        printed = self.run_program(*self.laps, "--vocabulary", "words.json", "--scores", "s.npy", "--json", "e.json",
                                   "--plot", "p.svg", "--temporal", "4")  # fmt: skip
        scores = np.load(self.folder / "s.npy")
        rows, columns = np.indices(scores.shape)
        np.testing.assert_array_equal(np.isnan(scores), columns >= rows - 3)
        result = self.json("e.json")
        self.assertEqual(result["recall_at"]["1"], 1)
        self.assertEqual(result["config"]["vocabulary"]["words"], 40)
        self.assertEqual(result["config"]["temporal"], 4)
        self.assertEqual(result["fixed_threshold"]["threshold"], 4.6)
        self.assertIn("images, fabmap, temporal filter of 4 images", printed)
        xml.etree.ElementTree.parse(self.folder / "p.svg")

    def test_threads_change_nothing(self):
        for threads in ("1", "3"):
            self.run_program("fabmap", "train", "training", "--words", "40", "--out", f"{threads}.json", "--threads", threads)
            self.run_program(*self.laps, "--vocabulary", f"{threads}.json", "--scores", f"{threads}.npy", "--threads", threads)
        for end in ("json", "npy"):
            self.assertEqual((self.folder / f"1.{end}").read_bytes(), (self.folder / f"3.{end}").read_bytes())

    def test_vocabulary_faults(self):
        self.fails(*self.laps, says="--vocabulary and the methods fabmap and bow go together", code=2)
        self.fails(*self.laps[:-1], "paper", "--vocabulary", "words.json", says="go together", code=2)
        self.fails(*self.laps, "--vocabulary", "gone.json", says="gone.json")
        self.fails(*self.laps, "--vocabulary", "truth.txt", says="truth.txt: not a sailmap vocabulary")

    def test_other_commands_say_so(self):
        for command in (["match", "images/0.png", "images/1.png"], ["run", "images", "--map", "m.json"]):
            for method in ("fabmap", "bow"):
                self.run_program(*command, "--method", method, code=2)
                self.assertIn(f"{method} is a method of `sailmap eval` alone", self.errors)


if __name__ == "__main__":
    unittest.main()
