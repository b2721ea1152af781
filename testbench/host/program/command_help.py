"""The commands and options of the program as its help shows them: what completion and man pages must know too."""

import functools
import re
import subprocess

from program_case import SAILMAP


@functools.cache
def help_of(*path):
    """What `sailmap PATH --help` prints."""
    return subprocess.run([SAILMAP, *path, "--help"], capture_output=True, text=True, check=True).stdout


def commands():
    """All commands as tuples of words, () for the program itself."""
    found = [()]
    for path in found:
        section = re.search(r"^Subcommands:\n((?:  .*\n|\n(?=  ))*)", help_of(*path), re.M)
        for line in section.group(1).splitlines() if section else []:
            if re.match(r"  \S", line):
                found.append((*path, line.split()[0]))
    return found


def options(text):
    """Long options of a help text."""
    return re.findall(r"^  (?:-\w,)?(--[a-z][a-z-]*)", text, re.M)


def choices(text):
    """What options take when it is one of several words: {option: [choice, ...]}."""
    found = {}
    for option, words in re.findall(r"^  (?:-\w,)?(--[a-z-]+) ([a-z0-9_]+(?:\|[a-z0-9_]+)+)", text, re.M):
        found[option] = words.split("|")
    return found
