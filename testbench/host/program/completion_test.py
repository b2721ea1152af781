"""The bash completion: sourced by bash, its function called as bash calls it."""

import os
import pty
import select
import shlex
import shutil
import subprocess
import time
import unittest

import command_help
from program_case import SAILMAP, ProgramCase, skip_without


@skip_without(shutil.which("bash"), "bash")
class Completion(ProgramCase):
    def setUp(self):
        super().setUp()
        (self.folder / "sailmap.bash").write_text(self.run_program("completion", "bash"))

    def complete_all(self, lines):
        """What bash would offer for the last word of each list of words after `sailmap`."""
        script = "source ./sailmap.bash\n"
        for words in lines:
            quoted = " ".join(map(shlex.quote, words))
            script += f'COMP_WORDS=(sailmap {quoted}); COMP_CWORD={len(words)}; _sailmap; printf "%s\\t" "${{COMPREPLY[@]}}"; echo\n'
        done = subprocess.run(["bash"], input=script, cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return [[word for word in line.split("\t") if word] for line in done.stdout.splitlines()]

    def complete(self, *words):
        return self.complete_all([words])[0]

    def test_every_command_is_offered(self):
        paths = command_help.commands()
        self.assertGreater(len(paths), 15)
        for path in paths:
            children = [p[-1] for p in paths if p[:-1] == path and p]
            if children:
                self.assertEqual(self.complete(*path, ""), children)
                self.assertEqual(self.complete(*path, children[0][:2])[0], children[0])

    def test_every_option_is_offered_where_the_help_has_it(self):
        paths = command_help.commands()
        for path, offered in zip(paths, self.complete_all([*path, "--"] for path in paths)):
            with self.subTest(path):
                own = command_help.options(command_help.help_of(*path))
                self.assertEqual(offered, own if not path else own + ["--threads"])

    def test_every_choice_is_offered_and_is_what_the_parser_takes(self):
        options = [
            ((*path, option), choices) for path in command_help.commands() for option, choices in command_help.choices(command_help.help_of(*path)).items()
        ]
        self.assertGreater(len(options), 15)
        for end in ([""], ["=", ""], ["="]):
            offered = self.complete_all([*words, *end] for words, _ in options)
            self.assertEqual(offered, [choices for _, choices in options])
        # The parser looks at values before it misses what is required; a wrong one is told by name.
        for words, choices in options:
            for value, refused in (("nonsense", True), (choices[-1], False)):
                with self.subTest((words, value)):
                    done = subprocess.run([SAILMAP, *words, value], cwd=self.folder, capture_output=True, text=True)
                    self.assertEqual(f"{words[-1]}: " in done.stderr, refused, done.stderr)

    def test_files_and_folders(self):
        (self.folder / "my images").mkdir()
        (self.folder / "my map.db").write_text("")
        self.assertEqual(sorted(self.complete("run", "my")), ["my images", "my map.db"])
        self.assertEqual(sorted(self.complete("run", "--map", "my")), ["my images", "my map.db"])
        self.assertEqual(self.complete("detect", "a.png", "--out", "my"), ["my images"])
        self.assertEqual(sorted(self.complete("map", "diff", "a", "my")), ["my images", "my map.db"])
        self.assertEqual(self.complete("loops", "--pictures", "=", "my"), ["my images"])

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
