"""sailmap eval against the numbers computed again from its score matrix, here."""

import unittest
import xml.etree.ElementTree

import numpy as np
from program_case import ProgramCase

LAPS = [0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 9, 5]


def average_precision(scores, truth):
    """Of the best candidate per query, as scikit-learn defines it for distinct scores; and the queries with a match."""
    best, with_match = [], 0
    for query, row in enumerate(scores):
        admissible = np.flatnonzero(~np.isnan(row))
        if admissible.size == 0:
            continue
        with_match += bool(truth[query] & set(admissible))
        candidate = admissible[row[admissible].argmax()]
        best.append((row[candidate], candidate in truth[query]))
    best.sort(key=lambda pair: -pair[0])
    right, total = 0, 0.0
    for rank, (_, is_right) in enumerate(best, 1):
        right += is_right
        total += is_right * right / rank
    return total / with_match, with_match


def read_truth(path, images):
    truth = [set() for _ in range(images)]
    for line in path.read_text().splitlines():
        query, matches = line.split(":")
        truth[int(query)] = set(map(int, matches.split()))
    return truth


class Eval(ProgramCase):
    def truth_of_laps(self):
        lines = [f"{q}: {' '.join(str(c) for c in range(q) if LAPS[c] == LAPS[q])}" for q in range(len(LAPS))]
        (self.folder / "truth.txt").write_text("\n".join(lines) + "\n")

    def test_a_small_sequence(self):
        self.write_sequence(LAPS)
        self.truth_of_laps()
        printed = self.run_program(
            "eval", "images", "--ground-truth", "truth.txt", "--exclude-recent", "3",
            "--scores", "s.npy", "--json", "e.json", "--plot", "p.svg",
        )  # fmt: skip
        scores = np.load(self.folder / "s.npy")
        self.assertEqual((scores.dtype, scores.shape), (np.float32, (12, 12)))
        rows, columns = np.indices(scores.shape)
        np.testing.assert_array_equal(np.isnan(scores), columns >= rows - 3)
        result = self.json("e.json")
        expected, with_match = average_precision(scores, read_truth(self.folder / "truth.txt", 12))
        self.assertAlmostEqual(result["average_precision"], expected, places=12)
        self.assertEqual(result["queries_with_match"], with_match)
        self.assertEqual(result["fixed_threshold"]["right"], 5)
        self.assertEqual(result["recall_at"]["1"], 1)
        for word in ("average precision", "recall at 100 % precision", "recall at 95 % precision", "best F1", "recall@10"):
            self.assertIn(word, printed)
        xml.etree.ElementTree.parse(self.folder / "p.svg")

    def test_two_traverses(self):
        self.write_sequence(LAPS[:6], "map")
        self.write_sequence(LAPS[6:], "now")
        (self.folder / "truth.txt").write_text("0: 0\n1: 1\n2: 2\n3: 3\n5: 5\n")
        self.run_program(
            "eval", "--reference", "map", "--query", "now", "--ground-truth", "truth.txt", "--scores", "s.npy", "--json", "e.json"
        )
        self.assertEqual(np.load(self.folder / "s.npy").shape, (6, 6))
        self.assertEqual(self.json("e.json")["queries_with_match"], 5)
        self.assertEqual(self.json("e.json")["recall_at"]["1"], 1)

    def test_contradictions(self):
        self.write_sequence(LAPS[:6])
        self.truth_of_laps()
        truth = ["--ground-truth", "truth.txt"]
        for arguments in (
            ["eval", *truth],
            ["eval", "images", "--reference", "images", "--query", "images", *truth],
            ["eval", "--reference", "images", *truth],
            ["eval", "images", "--side", "left", *truth],
            ["eval", "images", "--layout", "oxford", *truth],
            ["eval", "--reference", "images", "--query", "images", "--exclude-recent", "3", *truth],
        ):
            with self.subTest(arguments):
                self.run_program(*arguments, code=2)
                self.assertEqual(self.errors.count("\n"), 1, self.errors)

    def test_ground_truth_that_does_not_fit(self):
        self.write_sequence(LAPS[:6])
        for text, fault in (("0: 1\nx: 2\n", "truth.txt"), ("0:\n9: 1\n", "9"), ("5: 17\n", "17"), ("", "truth.txt")):
            with self.subTest(text):
                (self.folder / "truth.txt").write_text(text)
                self.fails("eval", "images", "--ground-truth", "truth.txt", "--scores", "s.npy", says=fault)
        self.fails("eval", "images", "--ground-truth", "gone.txt", says="gone.txt")

    def test_the_corridor(self):
        corridor = self.needs_data("rtabmap_corridor")
        result = {}
        for method in ("paper", "paper_weighted"):
            self.run_program(
                "eval", corridor / "images", "--ground-truth", corridor / "ground_truth.txt", "--exclude-recent", "20",
                "--method", method, "--scores", "s.npy", "--json", "e.json",
            )  # fmt: skip
            result[method] = self.json("e.json")
            expected, with_match = average_precision(
                np.load(self.folder / "s.npy"), read_truth(corridor / "ground_truth.txt", 84)
            )
            self.assertAlmostEqual(result[method]["average_precision"], expected, places=12)
            self.assertEqual((result[method]["queries_with_match"], with_match), (44, 44))
        # What an independent prototype of the same specification reached.
        self.assertGreater(result["paper"]["average_precision"], 0.525)
        self.assertGreater(result["paper_weighted"]["average_precision"], 0.865)


if __name__ == "__main__":
    unittest.main()
