"""Running AMD's tools."""

import subprocess

from tables import Fault


def refuse_awkward(*paths):
    """The tools split their options at blanks and commas."""
    for path in paths:
        if any(character in " ,{}[]$\"\\" for character in str(path)):
            raise Fault(f"{path}: Vitis HLS takes no path with blanks, commas, brackets, $, quotes or backslashes")


def checked(command, **options):
    """Runs a command; a Fault when it fails."""
    if subprocess.run([str(word) for word in command], check=False, **options).returncode != 0:
        raise Fault(f"failed: {' '.join(str(word) for word in command)}")
