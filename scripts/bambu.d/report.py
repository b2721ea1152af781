"""The table of docs/fpga.md, from the results of each top."""

import json
from pathlib import Path

from job import ROOT, Fault

DOCUMENT = ROOT / "docs" / "fpga.md"
BEGIN, END = "<!-- bambu: begin -->", "<!-- bambu: end -->"


def save(job, result):
    (job.folder / "result.json").write_text(json.dumps(result), encoding="utf-8")


def loaded(folder):
    """The results in a folder of jobs, by name of the job."""
    return {path.parent.name: json.loads(path.read_text(encoding="utf-8"))
            for path in sorted(Path(folder).glob("*/result.json"))}


def row(result):
    areas = [result["area"][family] for family in ("xc7", "ecp5")]
    cells = [f"{area[kind]:g}" for area in areas for kind in ("lut", "ff", "bram", "dsp")]
    return " | ".join([f"| {result['what']}", f"{result['cycles']}", f"{result['cycles_per_pixel']:.2f}", *cells]) + " |"


def table(results):
    """Markdown, in the order of tops.csv."""
    lines = ["| top | cycles a VGA frame | a pixel | LUT | FF | BRAM36 | DSP | ECP5 LUT4 | FF | EBR | MULT18 |",
             "|---|" + "---:|" * 10]
    return "\n".join(lines + [row(result) for result in sorted(results, key=lambda result: result["order"])])


def write(folder):
    """Puts the table between the marks of docs/fpga.md."""
    results = [result for result in loaded(folder).values() if "area" in result]
    if not results:
        raise Fault(f"{folder}: no results with an area")
    text = DOCUMENT.read_text(encoding="utf-8")
    if BEGIN not in text or END not in text:
        raise Fault(f"{DOCUMENT}: no {BEGIN} ... {END}")
    head, rest = text.split(BEGIN, 1)
    tail = rest.split(END, 1)[1]
    DOCUMENT.write_text(f"{head}{BEGIN}\n{table(results)}\n{END}{tail}", encoding="utf-8")
