"""What the scripts that measure recognition share: the program, the data, and how figures get into a page of docs/."""

import json
import os
import pathlib
import platform
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DATA = pathlib.Path(os.environ.get("SAILMAP_DATA", ROOT.parent / "shared/data")).resolve()
RECOGNITION = ROOT / "docs/recognition.md"
IMAGES = ROOT / "docs/images"


PROGRAM = pathlib.Path(os.environ.get("SAILMAP_PROGRAM", ROOT / "build/host/app/sailmap"))


def sailmap(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def machine():
    """The processor and how many cores of it there are."""
    names = [line.split(":")[1].strip() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")]  # fmt: skip
    return f"{names[0] if names else platform.machine()}, {os.cpu_count()} cores"


def eval_table(scratch, methods, data_sets, *options):
    """{data set: {method: figures}} of `sailmap eval --table`."""
    config, out = scratch / "table.json", scratch / "out.json"
    config.write_text(json.dumps({"methods": methods, "data_sets": data_sets}))
    sailmap("eval", "--table", config, "--json", out, *options)
    return {d["name"]: d["results"] for d in json.loads(out.read_text())["data_sets"]}


def cell(result):
    """Average precision / recall at 100 % precision (precision / recall at the threshold)."""
    fixed = result["fixed_threshold"]
    precision = f"{fixed['precision']:.2f}" if fixed["detections"] else "-"
    return (
        f"{result['average_precision']:.3f} / {result['recall_at_100_precision']:.3f} "
        f"({precision} / {fixed['recall']:.2f})"
    )


def put(document, script, lines):
    """Replaces what stands between the marks of a script in a page."""
    name = pathlib.Path(script).name
    begin, end = f"<!-- {name}: begin, written by scripts/{name} -->", f"<!-- {name}: end -->"
    before, rest = document.read_text().split(begin)
    after = rest.split(end)[1]
    document.write_text("\n".join([before + begin, *lines, end + after]))
