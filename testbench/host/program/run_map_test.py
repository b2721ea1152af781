"""sailmap run, sailmap map and sailmap simulate, as a user runs them."""

import csv
import json
import signal
import sqlite3
import time
import unittest
import xml.etree.ElementTree

import cv2
import networkx
import numpy as np
from program_case import SAILMAP, ProgramCase, scene

LAPS = [0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5]


class Run(ProgramCase):
    def test_two_laps(self):
        self.write_sequence(LAPS)
        printed = self.run_program("run", "images", "--map", "m.json", "--exclude-recent", "3").splitlines()
        loops = [line for line in printed if line.startswith("loop closure")]
        self.assertEqual(len(loops), 6)
        self.assertIn("image 6 (images/6.png) is at node 0 (images/0.png)", loops[0])
        self.assertIn("12 images, 6 nodes", printed[-1])
        self.assertIn("6 loops", printed[-1])

    def test_lines_of_json(self):
        self.write_sequence(LAPS)
        lines = self.run_program("run", "images", "--map", "m.json", "--exclude-recent", "3", "--json").splitlines()
        events = [json.loads(line) for line in lines]
        self.assertEqual([e["event"] for e in events], ["loop_closure"] * 6 + ["summary"])
        self.assertEqual([e["best"]["node"] for e in events[:6]], list(range(6)))
        self.assertEqual((events[-1]["nodes"], events[-1]["loops"]), (6, 6))

    def test_above_the_limit_only_loops_are_named(self):
        self.write_sequence(LAPS)
        for limit in (0, 3, 100):
            self.run_program("run", "images", "--map", f"{limit}.map", "--exclude-recent", "1", "--rank-up-to", str(limit))
            rows = list(csv.DictReader(self.run_program("map", "export", f"{limit}.map", "--format", "csv").splitlines()))
            self.assertEqual([row["reason"] for row in rows[:3]], ["no_nodes", "excluded", "below_threshold"])
            self.assertEqual([row["best_node"] for row in rows[6:]], list("012345"))
            # Image i is compared with i - 1 nodes.
            named = [row["best_node"] != "" for row in rows[2:6]]
            self.assertEqual(named, [i - 1 <= limit for i in range(2, 6)])
            self.assertEqual({row["reason"] for row in rows[2:6]}, {"below_threshold"})
        self.assertIn("-", self.run_program("loops", "0.map", "--reason", "below_threshold"))

    def test_a_folder_in_natural_order(self):
        self.write_sequence(range(12))
        self.run_program("run", "images", "--map", "m.json")
        exported = self.run_program("map", "export", "m.json", "--format", "csv").splitlines()[1:]
        self.assertEqual([line.split(",")[1] for line in exported], [f'"images/{i}.png"' for i in range(12)])

    def test_glob_list_and_video_are_sources_too(self):
        self.write_sequence(LAPS)
        (self.folder / "list.txt").write_text("".join(f"images/{i}.png\n" for i in range(12)))
        video = cv2.VideoWriter(str(self.folder / "v.avi"), cv2.VideoWriter_fourcc(*"MJPG"), 10, (160, 120))
        for place in LAPS:
            video.write(scene(place))
        video.release()
        for source in ("images/*.png", "list.txt", "v.avi"):
            with self.subTest(source):
                name = source.replace("/", "_").replace("*", "all") + ".json"
                printed = self.run_program("run", source, "--map", name, "--exclude-recent", "3")
                self.assertIn("12 images, 6 nodes", printed.splitlines()[-1])

    def test_a_map_is_extended(self):
        self.write_sequence(LAPS[:6], "first")
        self.write_sequence(LAPS[6:], "second")
        self.run_program("run", "first", "--map", "m.json", "--exclude-recent", "3")
        printed = self.run_program("run", "second", "--map", "m.json").splitlines()
        self.assertIn("12 images, 6 nodes", printed[-1])
        self.assertIn("this run 6 images, 6 loops", printed[-1])

    def test_other_parameters_than_the_maps_are_refused_by_name(self):
        self.write_sequence([0, 1])
        self.run_program("run", "images", "--map", "m.json", "--threshold", "7")
        self.fails("run", "images", "--map", "m.json", "--threshold", "8", says="--threshold (map 7.0, now 8.0)")
        self.run_program("run", "images", "--map", "m.json", "--threshold", "7")

    def test_sparse_maps_group_images(self):
        self.write_sequence([0, 0, 0, 1, 1, 2, 2, 2])
        printed = self.run_program("run", "images", "--map", "m.json", "--sparse").splitlines()
        self.assertIn("8 images, 3 nodes", printed[-1])

    def test_the_number_of_threads_changes_nothing(self):
        self.write_sequence([0, 1, 2, 3, 4, 5, 0, 1, 2, 9])
        for threads in ("1", "2", "7"):
            self.run_program("run", "images", "--map", f"{threads}.json", "--exclude-recent", "2", "--threads", threads)
        one, two, seven = (self.run_program("map", "export", f"{n}.json", "--format", "json") for n in (1, 2, 7))
        self.assertEqual(one, two)
        self.assertEqual(one, seven)
        self.run_program("run", "images", "--map", "n.json", "--threads", "-1", code=2)
        self.assertIn("--threads", self.errors)

    def test_max_images_counts_what_was_used(self):
        folder = self.write_sequence([0, 1, 2, 3, 4, 5, 6, 7])
        (folder / "1.png").write_text("no image")
        self.run_program("run", "images", "--map", "m.json", "--skip-bad", "--max-images", "3")
        self.assertIn("skipped images/1.png", self.errors)
        nodes = json.loads(self.run_program("map", "export", "m.json", "--format", "json"))["nodes"]
        self.assertEqual([v["name"] for n in nodes for v in n["views"]], [f"images/{i}.png" for i in (0, 2, 3)])

    def test_a_bad_image_ends_the_run_and_the_images_before_it_are_kept(self):
        folder = self.write_sequence([0, 1, 2])
        (folder / "1.png").write_text("no image")
        self.run_program("run", "images", "--map", "m.json", code=1)
        self.assertIn("1.png", self.errors)
        self.assertIn("; the 1 images before it are in m.json\n", self.errors)
        self.assertEqual(self.errors.count("\n"), 1)
        self.write_image("images/1.png", scene(1))
        printed = self.run_program("run", "images", "--map", "m.json", "--resume")
        self.assertIn("m.json: 3 images, 3 nodes, 2 edges", printed)
        (folder / "0.png").write_text("no image")
        self.fails("run", "images", "--map", "new.json", says="0.png")
        printed = self.run_program("run", "images", "--map", "new.json", "--skip-bad")
        self.assertIn("skipped images/0.png", self.errors)
        self.assertIn("2 images", printed)

    def test_localise_says_where_and_changes_nothing(self):
        self.write_sequence(LAPS[:6], "first")
        self.write_sequence([3, 4, 99, 5], "second")
        self.run_program("run", "first", "--map", "m.json")
        before = self.contents()
        lines = self.run_program("run", "second", "--map", "m.json", "--localise").splitlines()
        self.assertEqual(self.contents(), before)
        self.assertEqual([line.split(",")[0] for line in lines[:-1]], [
            f"located: image {i} (second/{i}.png) is at node {n} (first/{n}.png)" for i, n in ((0, 3), (1, 4), (3, 5))
        ])
        self.assertEqual(lines[-1], "m.json: 3 of 4 images located")
        events = [json.loads(line) for line in self.run_program("run", "second", "--map", "m.json", "--localise", "--json").splitlines()]
        self.assertEqual([e["event"] for e in events], ["located", "located", "lost", "located", "summary"])
        self.fails("run", "second", "--map", "gone.json", "--localise", says="gone.json: no such file")
        self.fails("run", "second", "--map", "m.json", "--localise", "--threshold", "5", says="--threshold (map")

    def test_thumbnails_are_kept(self):
        self.write_sequence([0, 1])
        self.run_program("run", "images", "--map", "m.json", "--thumbnails", "40")
        with sqlite3.connect(self.folder / "m.json") as database:
            pictures = [row[0] for row in database.execute("SELECT jpeg FROM thumbnail ORDER BY id")]
        database.close()
        shapes = [cv2.imdecode(np.frombuffer(p, np.uint8), cv2.IMREAD_COLOR).shape for p in pictures]
        self.assertEqual(shapes, [(30, 40, 3)] * 2)

    def test_a_second_run_on_the_same_map_is_refused_while_the_first_goes_on(self):
        self.write_sequence(list(range(100)) * 3)
        first = self.start_program("run", "images", "--map", "m.json")
        self.run_program("run", "images", "--map", "m.json", code=1)
        self.assertIn("m.json: another program is writing this map", self.errors)
        self.assertIn("nodes", self.run_program("map", "info", "m.json"))
        first.send_signal(signal.SIGINT)
        first.communicate(timeout=60)
        self.assertEqual(first.returncode, 0)

    def test_changing_size_is_refused(self):
        self.write_sequence([0, 1])
        self.write_image("images/2.png", scene(2, 200, 120))
        self.run_program("run", "images", "--map", "m.json", code=1)
        self.assertIn("2.png: 200x120 pixels, but the map's images are 160x120; the 2 images before it are in m.json", self.errors)

    def test_sources_that_are_none(self):
        (self.folder / "empty").mkdir()
        (self.folder / "list.txt").write_text("gone.png\n")
        for source, fault in {"nowhere": "nowhere", "empty": "empty", "list.txt": "gone.png", "*.tiff": "*.tiff"}.items():
            with self.subTest(source):
                self.fails("run", source, "--map", "m.json", says=fault)

    def test_a_map_that_is_none(self):
        self.write_sequence([0])
        (self.folder / "m.json").write_text('{"nodes": [')
        self.fails("run", "images", "--map", "m.json", says="m.json: not a sailmap map")

    def test_interrupt_saves_the_map(self):
        self.write_sequence(list(range(100)) * 3)
        running = self.start_program("run", "images", "--map", "m.json")  # the first loop closure: well under way
        running.send_signal(signal.SIGINT)
        rest = running.communicate(timeout=60)[0]
        self.assertEqual(running.returncode, 0)
        images = json.loads(self.run_program("map", "info", "m.json", "--json"))["images"]
        self.assertGreater(images, 100)
        self.assertLess(images, 300)
        self.assertIn(f"m.json: {images} images", rest)


class MapFiles(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence(LAPS)
        self.run_program("run", "images", "--map", "m.json", "--exclude-recent", "3")

    def test_info(self):
        info = json.loads(self.run_program("map", "info", "m.json", "--json"))
        self.assertEqual((info["images"], info["nodes"], info["loops"], info["path_edges"]), (12, 6, 6, 5))
        self.assertEqual(info["config"]["exclude_recent"], 3)
        self.assertIn("nodes      6", self.run_program("map", "info", "m.json"))

    def test_graphml_is_read_by_networkx(self):
        self.run_program("map", "export", "m.json", "--out", "m.graphml")
        graph = networkx.read_graphml(self.folder / "m.graphml")
        self.assertEqual(graph.number_of_nodes(), 6)
        self.assertEqual(graph.nodes["3"]["name"], "images/3.png")
        kinds = [kind for *_, kind in graph.edges(data="kind")]
        self.assertEqual(kinds.count("path"), 5)

    def test_every_format_by_extension(self):
        for name in ("dot", "graphml", "g2o", "csv", "json"):
            self.run_program("map", "export", "m.json", "--out", f"x.{name}")
            self.assertEqual((self.folder / f"x.{name}").read_text(), self.run_program("map", "export", "m.json", "--format", name))

    def test_drawing(self):
        self.run_program("map", "draw", "m.json", "--out", "m.svg")
        root = xml.etree.ElementTree.parse(self.folder / "m.svg").getroot()
        self.assertTrue(root.tag.endswith("svg"))

    def test_bad_maps(self):
        self.fails("map", "info", "gone.json", says="gone.json")
        self.fails("map", "export", "m.json", "--out", "m.xls", says="--format", code=2)


class Simulate(ProgramCase):
    def test_a_sequence_that_run_and_eval_take(self):
        self.run_program("simulate", "--out", "s", "--images", "40", "--images-per-lap", "15", "--width", "160", "--height", "120")
        self.assertEqual(len(list((self.folder / "s/images").iterdir())), 40)
        truth = (self.folder / "s/ground_truth.txt").read_text().splitlines()
        self.assertEqual(len(truth), 40)
        by_matches = self.run_program("eval", "s/images", "--ground-truth", "s/ground_truth.txt", "--exclude-recent", "8", "--json", "e.json")
        self.assertIn("average precision", by_matches)
        # The poses give the same truth when the radius is the simulation's (nothing turns round on this route).
        self.run_program("eval", "s/images", "--ground-truth", "s/poses.txt", "--radius", "3", "--exclude-recent", "8", "--json", "p.json")
        self.assertEqual(self.json("e.json")["average_precision"], self.json("p.json")["average_precision"])

    def test_the_same_seed_is_the_same_sequence(self):
        for name, seed in (("a", 5), ("b", 5), ("c", 6)):
            self.run_program("simulate", "--out", name, "--images", "3", "--seed", seed)
        pictures = [cv2.imread(str(self.folder / name / "images/000002.png")) for name in "abc"]
        np.testing.assert_array_equal(pictures[0], pictures[1])
        self.assertFalse(np.array_equal(pictures[0], pictures[2]))

    def test_a_folder_in_use_is_refused(self):
        self.run_program("simulate", "--out", "s", "--images", "2")
        self.fails("simulate", "--out", "s", "--images", "2", says="s")
        self.fails("simulate", "--out", "t", "--images", "0", says="images")


if __name__ == "__main__":
    unittest.main()
