"""The bash completion: sourced by bash, its function called as bash calls it."""

import os
import pty
import select
import shutil
import subprocess
import time
import unittest

import command_help
from program_case import SAILMAP, ProgramCase


class Completion(ProgramCase):
    def setUp(self):
        super().setUp()
        if not shutil.which("bash"):
            self.skipTest("no bash")
        (self.folder / "sailmap.bash").write_text(self.run_program("completion", "bash"))

    def complete(self, *words):
        """What bash would offer for the last of the words after `sailmap`."""
        script = 'source ./sailmap.bash; COMP_WORDS=(sailmap "$@"); COMP_CWORD=$#; _sailmap; printf "%s\\n" "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-c", script, "bash", *words], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return [line for line in done.stdout.splitlines() if line]

    def help(self, *words):
        return self.run_program(*words)

    def test_every_command_is_offered(self):
        paths = command_help.commands(self.help)
        self.assertGreater(len(paths), 15)
        for path in paths:
            children = [p[-1] for p in paths if p[:-1] == path and p]
            if children:
                self.assertEqual(self.complete(*path, ""), children)
                self.assertEqual(self.complete(*path, children[0][:2])[0], children[0])

    def test_every_option_is_offered_where_the_help_has_it(self):
        for path in command_help.commands(self.help):
            text = self.help(*path, "--help")
            with self.subTest(path):
                offered = self.complete(*path, "--")
                own = command_help.options(text)
                self.assertEqual(offered, own if not path else own + ["--threads"])

    def test_every_choice_is_offered_and_is_what_the_parser_takes(self):
        seen = 0
        for path in command_help.commands(self.help):
            for option, choices in command_help.choices(self.help(*path, "--help")).items():
                with self.subTest((path, option)):
                    seen += 1
                    self.assertEqual(self.complete(*path, option, ""), choices)
                    self.assertEqual(self.complete(*path, option, "=", ""), choices)
                    self.assertEqual(self.complete(*path, option, "="), choices)
                    self.assertIn(choices[-1], self.complete(*path, option, choices[-1][:1]))
                    # The parser looks at values before it misses what is required; a wrong one is told by name.
                    self.run_program(*path, option, "nonsense", code=2)
                    self.assertIn(f"{option}: ", self.errors)
                    for choice in choices:
                        done = subprocess.run([SAILMAP, *path, option, choice], cwd=self.folder, capture_output=True, text=True)
                        self.assertNotIn(f"{option}: ", done.stderr)
        self.assertGreater(seen, 15)

    def test_files_and_folders(self):
        (self.folder / "my images").mkdir()
        (self.folder / "my map.db").write_text("")
        self.assertEqual(sorted(self.complete("run", "my")), ["my images", "my map.db"])
        self.assertEqual(sorted(self.complete("run", "--map", "my")), ["my images", "my map.db"])
        self.assertEqual(self.complete("detect", "a.png", "--out", "my"), ["my images"])
        self.assertEqual(sorted(self.complete("map", "diff", "a", "my")), ["my images", "my map.db"])
        self.assertEqual(self.complete("loops", "--pictures=", "my")[:1], sorted(self.complete("loops", "my"))[:1])

    def test_numbers_are_left_to_the_user(self):
        self.assertEqual(self.complete("run", "--max-images", ""), [])
        self.assertEqual(self.complete("--threads", ""), [])
        self.assertEqual(self.complete("run", "--threads", ""), [])

    def test_values_and_flags_before_the_cursor(self):
        self.assertIn("--method", self.complete("--threads", "2", "run", "--json", "--map", "run", "--m"))
        self.assertEqual(self.complete("--threads", "2", "map", ""), self.complete("map", ""))
        self.assertEqual(self.complete("completion", ""), ["bash"])
        self.assertEqual(self.complete("nonsense", "--version")[:1], ["--version"])

    def test_in_a_terminal(self):
        """Bash itself, with the tabulator key."""
        (self.folder / "one file.png").write_text("")
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder)
            os.environ.update({"PS1": "> ", "TERM": "dumb"})
            os.execvp("bash", ["bash", "--norc", "--noprofile", "-i"])
        self.addCleanup(os.waitpid, child, 0)
        self.addCleanup(os.close, terminal)
        os.write(terminal, b"source ./sailmap.bash; sailmap() { printf '<%s>' \"$@\"; echo; }\n")
        os.write(terminal, b"sailmap detec\ton\t--inhib\tgauss\t\nsailmap detect --inhibition d\t\nexit\n")
        printed, end = b"", time.monotonic() + 60
        while time.monotonic() < end and select.select([terminal], [], [], 60)[0]:
            try:
                piece = os.read(terminal, 4096)
            except OSError:  # the terminal is closed
                break
            if not piece:
                break
            printed += piece
        text = printed.decode(errors="replace")
        self.assertIn("<detect><one file.png><--inhib", text)
        self.assertIn("<detect><--inhibition><disk>", text)


if __name__ == "__main__":
    unittest.main()
