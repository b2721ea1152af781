"""What a script sees: with --json nothing but JSON on standard output, with the same fields for the same things."""

import json
import unittest

import command_help
from program_case import ProgramCase, scene

LAPS = [0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5]
# They have no results but what they print or what their subcommands do.
WITHOUT = {(), ("map",), ("fabmap",), ("completion",)}


class Json(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence(LAPS)
        lines = [f"{q}: {' '.join(str(c) for c in range(q) if LAPS[c] == LAPS[q])}" for q in range(len(LAPS))]
        (self.folder / "truth.txt").write_text("\n".join(lines) + "\n")
        self.run_program("run", "images", "--map", "m.map", "--exclude-recent", "3")

    def lines(self, *arguments):
        return [json.loads(line) for line in self.run_program(*arguments).splitlines()]

    def one(self, *arguments):
        lines = self.lines(*arguments)
        self.assertEqual(len(lines), 1)
        return lines[0]

    def test_every_command_has_it(self):
        for path in command_help.commands():
            with self.subTest(path):
                has = "--json" in command_help.options(command_help.help_of(*path))
                self.assertEqual(has, path not in WITHOUT)

    def test_detect(self):
        found = self.lines("detect", "images/0.png", "images/1.png", "--out", "d", "--json")
        self.assertEqual([(f["image"], f["out"]) for f in found], [("images/0.png", "d/0"), ("images/1.png", "d/1")])
        for line in found:
            written = self.json(line.pop("out") + "/regions.json")
            self.assertEqual(line, written)

    def test_match(self):
        found = self.one("match", "images/0.png", "images/6.png", "--json")
        self.assertEqual((found["query"], found["candidate"], found["same_place"], found["reason"]), ("images/0.png", "images/6.png", True, "accepted"))

    def test_run(self):
        lines = self.lines("run", "images", "--map", "n.map", "--exclude-recent", "3", "--json")
        self.assertEqual((lines[-1]["event"], lines[-1]["map"], lines[-1]["images"], lines[-1]["loops"]), ("summary", "n.map", 12, 6))

    def test_eval_in_place_of_its_text(self):
        arguments = ["eval", "images", "--ground-truth", "truth.txt", "--exclude-recent", "3"]
        found = self.one(*arguments, "--json", "-")
        self.run_program(*arguments, "--json", "e.json")
        written = self.json("e.json")
        found.pop("images_per_second"), written.pop("images_per_second")
        self.assertEqual(found, written)
        config = {"data_sets": [{"name": "laps", "source": "images", "ground_truth": "truth.txt", "exclude_recent": 3}], "methods": [{"name": "paper", "method": "paper"}]}
        (self.folder / "t.json").write_text(json.dumps(config))
        table = self.one("eval", "--table", "t.json", "--json", "-")
        self.run_program("eval", "--table", "t.json", "--json", "table.json")
        self.assertEqual(set(table), set(self.json("table.json")))
        self.assertFalse((self.folder / "-").exists())

    def test_compare(self):
        found = self.one("compare", "images", "--out", "c", "--max-images", "2", "--json")
        self.assertEqual(found, self.json("c/compare.json"))
        self.assertEqual((found["source"], found["images"]), ("images", 2))

    def test_perturb(self):
        found = self.one("perturb", "images", "--out", "p", "--kind", "grey", "--strength", "1", "--json")
        self.assertEqual((found["out"], found["images"], found["kind"]), ("p", 12, "grey"))

    def test_simulate(self):
        found = self.one("simulate", "--out", "s", "--images", "12", "--width", "160", "--height", "120", "--json")
        self.assertEqual((found["out"], found["images"], found["width"], found["height"]), ("s", 12, 160, 120))
        for key in ("source", "ground_truth", "poses"):
            self.assertTrue((self.folder / found[key]).exists(), key)

    def test_map(self):
        counts = {"map": "m.map", "images": 12, "nodes": 6, "loops": 6}
        whole = self.one("map", "info", "m.map", "--json")
        edges = whole["path_edges"] + whole["loop_edges"]
        self.assertEqual({key: whole[key] for key in counts}, counts)
        for command, out in (("export", "x.dot"), ("draw", "x.svg")):
            found = self.one("map", command, "m.map", "--out", out, "--json")
            self.assertEqual({key: found[key] for key in counts}, counts)
            self.assertEqual((found["out"], found["edges"]), (out, edges))

    def test_report(self):
        found = self.one("report", "m.map", "--out", "r.html", "--json")
        self.assertEqual(found, {"out": "r.html", "bytes": (self.folder / "r.html").stat().st_size})

    def test_loops_tune_diff_manual(self):
        self.assertEqual(len(self.lines("loops", "m.map", "--json")), 6)
        self.assertEqual(self.one("map", "diff", "m.map", "m.map", "--json")["equal"], True)
        tuned = self.one("tune", "images", "--ground-truth", "truth.txt", "--map", "m.map", "--json")
        self.assertEqual((tuned["map"], tuned["frontend"], tuned["method"]), ("m.map", "fixed", "paper_weighted"))
        self.assertIn("man/sailmap.1", self.one("manual", "--out", "man", "--json")["files"])

    def test_fabmap_train(self):
        for place in range(20, 28):
            self.write_image(f"train/{place}.png", scene(place, 320, 240))
        found = self.one("fabmap", "train", "train", "--out", "v.vocabulary", "--words", "8", "--json")
        self.assertEqual((found["out"], found["words"], found["images"]), ("v.vocabulary", 8, 8))

    def test_names_that_are_not_text(self):
        (self.folder / "images/0.png").rename(self.folder / "images" / b"0\xe9.png".decode("utf-8", "surrogateescape"))
        self.run_program("run", "images", "--map", "odd.map")
        self.assertEqual(self.lines("loops", "odd.map", "--reason", "all", "--json")[0]["name"], "images/0\ufffd.png")
        self.run_program("map", "info", "odd.map", "--json")


if __name__ == "__main__":
    unittest.main()
