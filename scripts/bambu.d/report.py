"""The tables of docs/fpga.md, from the results of each top."""

import json
import re
from pathlib import Path

from job import ROOT, Fault

DOCUMENT = ROOT / "docs" / "fpga.md"
KERNELS = ("<!-- bambu: begin -->", "<!-- bambu: end -->")
PARTS = ("<!-- bambu parts: begin -->", "<!-- bambu parts: end -->")
WHOLE = "sailmap_front_end-8"


def save(job, result):
    (job.folder / "result.json").write_text(json.dumps(result), encoding="utf-8")


def loaded(folder):
    """The results in a folder of jobs, by name of the job."""
    return {path.parent.name: json.loads(path.read_text(encoding="utf-8"))
            for path in sorted(Path(folder).glob("*/result.json"))}


KINDS = {"xc7": ("lut", "sites", "ff", "bram", "dsp"), "ecp5": ("lut", "ff", "bram", "dsp")}


def number(value):
    """A dash where nothing was counted."""
    return "-" if value is None else f"{value:.0f}" if value == int(value) else f"{value:g}"


def row(result):
    """A line of the table."""
    cells = [number(result["area"].get(family, {}).get(kind)) for family, kinds in KINDS.items() for kind in kinds]
    cycles = (f"{result['cycles']}", f"{result['cycles_per_pixel']:.2f}") if "cycles" in result else ("", "")
    return " | ".join([f"| {result['what']}", *cycles, *cells]) + " |"


# A stage's mangled name begins so: ...hls<length><function>.
FUNCTION = re.compile(r"_*ZN7sailmap3hls(\d+)(\w+)")


def kernel(stage):
    """The function that a stage is an instance of; other parts have their own name."""
    match = FUNCTION.fullmatch(stage)
    return match[2][:int(match[1])] if match else stage


def parts_table(parts):
    """Markdown: the area of a region by kernel, the largest first."""
    kinds = KINDS["xc7"]
    groups = {}
    for stage, area in parts.items():
        groups.setdefault(kernel(stage), []).append(area)
    totals = {name: [len(areas), *(sum(area[kind] for area in areas) for kind in kinds)]
              for name, areas in groups.items()}
    lines = ["| kernel | stages | LUT | LUT sites | FF | BRAM36 | DSP |", "|---|" + "---:|" * 6]
    lines += [f"| {name} | " + " | ".join(map(number, values)) + " |"
              for name, values in sorted(totals.items(), key=lambda item: -item[1][1])]
    return "\n".join(lines)


def table(results):
    """Markdown, in the order of tops.csv."""
    lines = ["| top | cycles a VGA frame | a pixel | LUT | LUT sites | FF | BRAM36 | DSP | ECP5 LUT4 | FF | EBR | MULT18 |",
             "|---|" + "---:|" * 11]
    rows = sorted(results.values(), key=lambda result: result["order"])
    return "\n".join(lines + [row(result) for result in rows])


def put(text, marks, table_text):
    """The text with a table between two marks."""
    begin, end = marks
    if begin not in text or end not in text:
        raise Fault(f"{DOCUMENT}: no {begin} ... {end}")
    head, rest = text.split(begin, 1)
    return f"{head}{begin}\n{table_text}\n{end}{rest.split(end, 1)[1]}"


def write(folder):
    """Puts the tables between the marks of docs/fpga.md."""
    results = {name: result for name, result in loaded(folder).items() if "area" in result}
    if not results:
        raise Fault(f"{folder}: no results with an area")
    text = put(DOCUMENT.read_text(encoding="utf-8"), KERNELS, table(results))
    if WHOLE in results:
        text = put(text, PARTS, parts_table(results[WHOLE]["parts"]["xc7"]))
    DOCUMENT.write_text(text, encoding="utf-8")
