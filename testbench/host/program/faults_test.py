"""Every command's ways to fail: one line on standard error that names what is wrong, nothing on standard output, the
folder left as it was, and 1 for a fault in what was given or 2 for wrong use (of map diff 2 for both)."""

import unittest

import command_help
from program_case import ProgramCase, scene

TRUTH = ["--ground-truth", "truth.txt"]
# Command line, exit code, what the line must name.
FAULTS = [
    (["detect", "gone.png"], 1, "gone.png"),
    (["detect", "text.png"], 1, "text.png"),
    (["detect", "0.png", "--out", "text.png/x"], 1, "text.png/x"),
    (["match", "0.png", "gone.png"], 1, "gone.png"),
    (["match", "0.png", "small.png"], 1, "160x120 and 100x80"),
    (["match", "0.png", "0.png", "--out", "nowhere/pair.png"], 1, "nowhere/pair.png"),
    (["run", "gone", "--map", "new.map"], 1, "gone"),
    (["run", "images", "--map", "text.png"], 1, "text.png"),
    (["run", "images", "--map", "nowhere/new.map"], 1, "nowhere/new.map"),
    (["eval", "gone", *TRUTH], 1, "gone"),
    (["eval", "images", "--ground-truth", "gone.txt"], 1, "gone.txt"),
    (["eval", "images"], 2, "--ground-truth"),
    (["eval", *TRUTH], 2, "SOURCE"),
    (["eval", "images", *TRUTH, "--csv", "x.csv"], 2, "--table"),
    (["eval", "images", *TRUTH, "--method", "bow"], 2, "--vocabulary"),
    (["eval", "--table", "gone.json"], 1, "gone.json"),
    (["compare", "gone"], 1, "gone"),
    (["perturb", "gone", "--out", "p", "--kind", "grey", "--strength", "1"], 1, "gone"),
    (["perturb", "images", "--out", "p", "--kind", "blur", "--strength", "-1"], 1, "blur"),
    (["simulate", "--out", "text.png", "--images", "2"], 1, "text.png"),
    (["simulate", "--out", "s", "--images", "0"], 1, "images"),
    (["map", "info", "gone.map"], 1, "gone.map"),
    (["map", "info", "text.png"], 1, "text.png"),
    (["map", "export", "gone.map", "--format", "dot"], 1, "gone.map"),
    (["map", "export", "m.map"], 2, "--format"),
    (["map", "export", "m.map", "--format", "tum"], 2, "--poses"),
    (["map", "export", "m.map", "--out", "nowhere/x.dot"], 1, "nowhere/x.dot"),
    (["map", "export", "m.map", "--format", "kitti", "--poses", "truth.txt"], 1, "truth.txt"),
    (["map", "check", "gone.map"], 1, "gone.map"),
    (["map", "recover", "gone.map", "--out", "new.map"], 1, "gone.map"),
    (["map", "merge", "m.map", "gone.map", "--out", "new.map"], 1, "gone.map"),
    (["map", "prune", "gone.map", "--similar", "5"], 1, "gone.map"),
    (["map", "prune", "m.map"], 2, "--similar"),
    (["map", "draw", "gone.map", "--out", "x.svg"], 1, "gone.map"),
    (["map", "draw", "m.map", "--out", "nowhere/x.svg"], 1, "nowhere/x.svg"),
    (["map", "diff", "m.map", "gone.map"], 2, "gone.map"),
    (["map", "diff", "text.png", "m.map"], 2, "text.png"),
    (["loops", "gone.map"], 1, "gone.map"),
    (["loops", "text.png"], 1, "text.png"),
    (["loops", "m.map", "--image", "b"], 2, "--image"),
    (["loops", "m.map", "--pictures", "text.png/x"], 1, "text.png/x"),
    (["tune", "gone", *TRUTH], 1, "gone"),
    (["tune", "--evaluation", "gone.json"], 1, "gone.json"),
    (["tune", "--evaluation", "text.png"], 1, "text.png"),
    (["tune", "images", *TRUTH, "--map", "gone.map"], 1, "gone.map"),
    (["tune", "images"], 2, "--ground-truth"),
    (["report", "gone.map", "-o", "x.html"], 1, "gone.map"),
    (["report", "text.png", "-o", "x.html"], 1, "text.png"),
    (["fabmap", "train", "gone", "--out", "v"], 1, "gone"),
    (["manual", "--out", "text.png/man"], 1, "text.png/man"),
]


class Faults(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence(range(4))
        self.run_program("run", "images", "--map", "m.map")
        self.write_sequence([0], ".")
        self.write_image("small.png", scene(0, 100, 80))
        (self.folder / "text.png").write_text("neither an image nor a map\n")
        (self.folder / "truth.txt").write_text("3: 0\n")

    def test_one_line_and_the_right_code(self):
        for arguments, code, names in FAULTS:
            with self.subTest(" ".join(arguments)):
                self.fails(*arguments, says=names, code=code)
                self.assertTrue(self.errors.startswith("sailmap: error: "), self.errors)

    def test_every_command_is_in_the_table(self):
        commands = {path for path in command_help.commands() if path}
        parents = {path[:-1] for path in commands}
        told = {tuple(arguments[: len(path)]) for arguments, *_ in FAULTS for path in commands if tuple(arguments[: len(path)]) == path}
        self.assertEqual(commands - parents - told, {("completion",)})

    def test_what_the_parser_refuses(self):
        """Unknown words and options, values out of range, nothing at all: exit code 2, and a word of help."""
        for path in command_help.commands():
            with self.subTest(path):
                self.assertEqual(self.run_program(*path, "--no-such-option", code=2), "")
                self.assertNotEqual(self.errors, "")
        for arguments, names in {
            (): "subcommand",
            ("nonsense",): "subcommand",
            ("run", "images"): "--map",
            ("run", "images", "--map", "n.map", "--max-images", "-1"): "--max-images",
            ("run", "images", "--map", "n.map", "--method", "bow"): "--method",
            ("loops",): "MAP",
            ("loops", "m.map", "--sort", "size"): "--sort",
            ("loops", "m.map", "--images-in", "x"): "--pictures",
            ("tune", "images", "--precision", "2"): "--precision",
            ("completion", "fish"): "SHELL",
            ("manual",): "--out",
        }.items():
            with self.subTest(arguments):
                self.assertEqual(self.run_program(*arguments, code=2), "")
                self.assertIn(names.lower(), self.errors.lower())


if __name__ == "__main__":
    unittest.main()
