"""The commands and options of the program as its help shows them: what completion and man pages must know too."""

import re


def commands(run):
    """All commands as tuples of words, () for the program itself; `run(*words)` gives its help."""
    found = [()]
    for path in found:
        section = re.search(r"^Subcommands:\n((?:  .*\n|\n(?=  ))*)", run(*path, "--help"), re.M)
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
