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
    """A line of the table; an area that was not counted is a dash."""
    kinds = ("lut", "ff", "bram", "dsp")
    cells = [f"{result['area'][family][kind]:g}" if family in result["area"] else "-" for family in ("xc7", "ecp5")
             for kind in kinds]
    cycles = (f"{result['cycles']}", f"{result['cycles_per_pixel']:.2f}") if "cycles" in result else ("", "")
    return " | ".join([f"| {result['what']}", *cycles, *cells]) + " |"


# Stages of the front end with 8 pixels a beat that are instances of each kernel, on the kernel's level or a coarser one.
INSTANCES = {"sailmap_channels": 2, "sailmap_reduce_lanes": 10, "sailmap_reduce_pixels": 2, "sailmap_delay_line": 7,
             "sailmap_centre_surround": 3, "sailmap_orientation": 3, "sailmap_across_scales": 10,
             "sailmap_local_maxima": 7, "sailmap_join_pairs": 3, "sailmap_store": 4, "sailmap_gains": 4,
             "sailmap_normalise": 4}


def together(results):
    """The kernels as often as the front end has them, which is more than its smaller instances need."""
    area = {}
    for family in ("xc7", "ecp5"):
        counted = [(result["area"].get(family), INSTANCES[name]) for name, result in results.items() if name in INSTANCES]
        if len(counted) == len(INSTANCES) and all(one for one, _ in counted):
            area[family] = {kind: sum(one[kind] * times for one, times in counted) for kind in counted[0][0]}
    return {"what": "all kernels as often as the front end has them", "area": area}


def table(results):
    """Markdown, in the order of tops.csv."""
    lines = ["| top | cycles a VGA frame | a pixel | LUT | FF | BRAM36 | DSP | ECP5 LUT4 | FF | EBR | MULT18 |",
             "|---|" + "---:|" * 10]
    rows = sorted(results.values(), key=lambda result: result["order"])
    return "\n".join(lines + [row(result) for result in [*rows, together(results)] if result["area"]])


def write(folder):
    """Puts the table between the marks of docs/fpga.md."""
    results = {name: result for name, result in loaded(folder).items() if "area" in result}
    if not results:
        raise Fault(f"{folder}: no results with an area")
    text = DOCUMENT.read_text(encoding="utf-8")
    if BEGIN not in text or END not in text:
        raise Fault(f"{DOCUMENT}: no {BEGIN} ... {END}")
    head, rest = text.split(BEGIN, 1)
    tail = rest.split(END, 1)[1]
    DOCUMENT.write_text(f"{head}{BEGIN}\n{table(results)}\n{END}{tail}", encoding="utf-8")
