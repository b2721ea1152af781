#!/usr/bin/python3
"""The bench of scripts/bambu notices what is wrong: notices_test.py FOLDER, that of the delay line's test."""

import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77


def faults(bench, folder, text):
    """The exit code and the output of the bench for these vectors."""
    vectors = folder / "changed.txt"
    vectors.write_text(text, encoding="utf-8")
    run = subprocess.run([str(bench), str(vectors), "0"], check=False, cwd=bench.parent.parent, capture_output=True,
                         text=True, timeout=200)
    return run.returncode, run.stdout


def changed(text, port, change):
    """The vectors with the words of the first call's `port` changed: words in, words out."""
    lines = text.splitlines()
    at = next(i for i, line in enumerate(lines) if line.startswith(f"words {port} "))
    words = change(lines[at].split()[3:])
    lines[at] = " ".join(["words", port, str(len(words)), *words])
    return "\n".join(lines) + "\n"


def main():
    if shutil.which("bambu") is None:
        print("bambu: not on the PATH, nothing checked")
        sys.exit(SKIPPED)
    folder = Path(sys.argv[1])
    bench = folder / "sailmap_delay_line" / "bench" / "Vtop"
    good = (folder / "vectors" / "sailmap_delay_line-small.txt").read_text(encoding="utf-8")
    assert faults(bench, folder, good)[0] == 0, "right words are refused"
    cases = {"a wrong word": (changed(good, "out", lambda words: words[:5] + ["1234"] + words[6:]), "out: word 5 is"),
             "a word missing": (changed(good, "out", lambda words: words + ["0"]), "out: 288 words"),
             "a word too many": (changed(good, "out", lambda words: words[:-1]), "out: "),
             # The kernel takes the first word of the next call for the one that is not there.
             "an input word missing": (changed(good, "in", lambda words: words[:-1]), "out: word 287 is"),
             "an input word unread": (changed(good, "in", lambda words: words + ["0"]), "in: 288 words")}
    for name, (text, message) in cases.items():
        code, output = faults(bench, folder, text)
        assert code == 1 and message in output, f"{name} goes unnoticed: {code} {output}"
    print(f"{len(cases)} faults noticed")


if __name__ == "__main__":
    main()
