"""scripts/vpr_bench on a small data set laid out like those of VPR-Bench."""

import pathlib
import pickle
import subprocess
import sys
import unittest

import cv2
import numpy as np
from program_case import ProgramCase, scene

SCRIPT = pathlib.Path(__file__).resolve().parents[3] / "scripts/vpr_bench"
PLACES = 24


class Opened:
    """What a file would run that is no data."""

    def __init__(self, path):
        self.path = path

    def __reduce__(self):
        return open, (str(self.path), "w")


class VprBench(ProgramCase):
    def setUp(self):
        super().setUp()
        self.data = self.folder / "datasets/halls"
        random = np.random.default_rng(3)
        for part in ("ref", "query"):
            (self.data / part).mkdir(parents=True)
            for place in range(PLACES):
                noisy = np.clip(scene(place) + random.normal(0, 2, (120, 160, 3)), 0, 255).astype(np.uint8)
                cv2.imwrite(str(self.data / part / f"{place:07}.png"), noisy)
        self.save_truth([(place, [place]) for place in range(PLACES)])

    def save_truth(self, pairs):
        truth = np.empty((len(pairs), 2), object)
        for row, (query, matches) in enumerate(pairs):
            truth[row] = [query, None]
            truth[row, 1] = matches
        np.save(self.data / "ground_truth_new.npy", truth)

    def publish(self, scores):
        folder = self.folder / "precomputed_matches/halls/Peer"
        folder.mkdir(parents=True)
        record = np.empty(6, object)
        for i, part in enumerate((np.arange(PLACES), scores.argmax(1), scores.max(1), scores, 0.5, 1e-5)):
            record[i] = part
        np.save(folder / "precomputed_data_corrected.npy", record)

    def run_script(self, code=0):
        done = subprocess.run([sys.executable, "-B", SCRIPT, self.folder, "--data-set", "halls"], capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.errors = done.stderr
        return done.stdout

    def rows(self):
        cells = [line.strip("| ").split(" | ") for line in self.run_script().splitlines() if line.startswith("| ")]
        return {row[0]: row[1:] for row in cells}

    def test_figures_of_others_and_ours(self):
        # Queries by falling score: right, right, wrong, right, and the others wrong.
        scores = np.zeros((PLACES, PLACES))
        for query, (candidate, score) in enumerate([(0, 0.9), (1, 0.8), (0, 0.7), (3, 0.6)] + [(0, 0.1)] * 20):
            scores[query, candidate] = score
        self.publish(scores)
        rows = self.rows()
        self.assertEqual(rows["Peer"], [f"{(1 + 1 + 3 / 4) / PLACES:.3f} / {2 / PLACES:.3f}", "0.125"])
        self.assertEqual(rows["`context`"], ["1.000 / 1.000", "1.000"])
        self.assertEqual(rows["backwards"][0], "1.000")
        self.assertEqual(len([order for order in rows if order.startswith("as one sequence")]), 1)

    def test_a_query_without_a_match_is_not_counted(self):
        self.save_truth([(place, [place] if place < 16 else []) for place in range(PLACES)])
        self.publish(np.diag([1 - 0.05 * place if place < 16 else 0 for place in range(PLACES)]))
        self.assertEqual(self.rows()["Peer"], ["1.000 / 1.000", "1.000"])

    def test_what_is_wrong_is_named(self):
        self.save_truth([(0, [PLACES])])
        self.run_script(code=1)
        self.assertIn("names images that are not there", self.errors)
        (self.data / "ground_truth_new.npy").write_bytes(b"\x93NUMPY nothing")
        self.run_script(code=1)
        self.assertEqual(len(self.errors.splitlines()), 1)
        (self.data / "ground_truth_new.npy").unlink()
        self.run_script(code=1)
        self.assertIn("ground_truth_new.npy", self.errors)

    def test_a_file_that_would_run_something_is_refused(self):
        path = self.data / "ground_truth_new.npy"
        victim = self.folder / "victim"
        with path.open("wb") as file:
            header = {"descr": "|O", "fortran_order": False, "shape": (1,)}
            np.lib.format.write_array_header_1_0(file, header)
            pickle.dump(Opened(victim), file)
        self.run_script(code=1)
        self.assertIn("which is no array", self.errors)
        self.assertFalse(victim.exists())


if __name__ == "__main__":
    unittest.main()
