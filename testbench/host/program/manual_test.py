"""The man pages: groff finds no fault in them, and nothing of the help is missing."""

import re
import shutil
import subprocess
import unittest

import command_help
from program_case import ProgramCase, skip_without


@skip_without(shutil.which("groff"), "groff (groff-base)")
class Manual(ProgramCase):
    def setUp(self):
        super().setUp()
        self.run_program("manual", "--out", "man")

    def page(self, name):
        """As a terminal 100 columns wide shows it, in plain text on one line."""
        done = subprocess.run(
            ["groff", "-man", "-ww", "-Tutf8", "-rLL=100n", "-P-cbou", f"man/{name}.1"], cwd=self.folder, capture_output=True, text=True, check=True
        )
        self.assertEqual(done.stderr, "")
        return done.stdout

    @staticmethod
    def flat(text):
        # Hyphens at the end of a line are groff's (U+2010); what it spread to fill lines is one blank again.
        return " ".join(re.sub("\u2010\\s*\n\\s*", "", text).replace("\u2010", "-").split())

    def test_a_page_a_command(self):
        top = [path[0] for path in command_help.commands() if len(path) == 1]
        pages = sorted(p.name for p in (self.folder / "man").iterdir())
        self.assertEqual(pages, sorted(["sailmap.1"] + [f"sailmap-{name}.1" for name in top]))
        overview = self.page("sailmap")
        for name in top:
            self.assertIn(f"sailmap-{name}(1)", self.flat(overview).replace("\u2010", "-"))

    def test_every_option_and_its_text_is_in_its_page(self):
        pages = {}
        for path in command_help.commands():
            name = "-".join(("sailmap",) + path[:1])
            if name not in pages:
                pages[name] = self.page(name)
            page = pages[name]
            flat = self.flat(page).replace(" ", "").replace("-", "")
            text = command_help.help_of(*path)
            for option in command_help.options(text):
                self.assertRegex(page, rf"(?m)^ +(-\w, )?{option}\b", (path, option))
            for line in text.splitlines():
                described = re.match(r"  (?:-\w,)?--[a-z-]+\S*(?: \S+)*?  +(\S.*)", line)
                if described:
                    # Words break wherever groff pleases; quotes and dashes have other forms in running text.
                    wanted = re.sub(r"[-` ]", "", described.group(1))
                    self.assertIn(wanted, flat, (path, line))

    def test_sections(self):
        page = self.page("sailmap-run")
        headings = re.findall(r"(?m)^([A-Z][A-Z ]+)$", page)
        self.assertEqual(headings[:5], ["NAME", "SYNOPSIS", "DESCRIPTION", "ARGUMENTS", "OPTIONS"])
        self.assertEqual(headings[-2:], ["NOTES", "SEE ALSO"])
        self.assertEqual(len(headings), len(set(headings)))
        self.assertIn("sailmap run [OPTIONS] SOURCE", page)
        self.assertIn("sailmap-run - build or extend a map", self.flat(page))
        self.assertIn("Default: paper_weighted.", self.flat(page))

    @skip_without(shutil.which("mandoc"), "mandoc")
    def test_lint(self):
        for page in sorted((self.folder / "man").iterdir()):
            done = subprocess.run(["mandoc", "-Tlint", "-Wwarning", page], capture_output=True, text=True)
            faults = [line for line in done.stdout.splitlines() if "missing date" not in line and "outdated mandoc.db" not in line]
            self.assertEqual(faults, [])


if __name__ == "__main__":
    unittest.main()
