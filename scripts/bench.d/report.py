"""Writes performance.md, and the plot of query time over map size, from the JSON of sailmap_bench.

report.py BENCH.json FOLDER
"""

import json
import re
import subprocess
import sys
from pathlib import Path

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}

# Heading of each group of benchmarks, by the first part of the name, and what a reader must know of it.
GROUPS = {
    "frontend": ("Front ends", "8-bit BGR to all maps."),
    "regions": ("Image to regions", "8-bit BGR to regions with descriptors, by `fixed`: what `run` does with an image."),
    "stage": ("Stages of `fixed`", "Each alone, on the output of the one before; `signature` is inhibition of return and the descriptors, from the maps."),
    "context": ("Method `context`", "Beyond the front end."),
    "match": ("Two images", "`match()` of two signatures of 20 regions."),
    "query": (
        "Query with the index",
        "Best node and runner-up among so many nodes of 20 regions: the exact answer. The image is of no place in the map, on a simulated way: the hard case, because no similarity ends the search early. "
        "Arithmetic is counted for all pairs of regions; what part of them is looked at is said below, at *Screening*.",
    ),
    "query_loop": ("Query with the index, of a known place", "The image is of a place in the map, on the same way."),
    "query_resampled": ("Query with the index, real regions", "The hard case on a map resampled from the images of Gardens Point."),
    "as_run": (
        "What run asks",
        "The same images and maps, asked what `run` asks by default: the same up to 10 000 nodes (`--rank-up-to`), beyond that only what is above the threshold and so can close a loop.",
    ),
    "as_run_loop": ("What run asks, of a known place", "As `query_loop`."),
    "as_run_resampled": ("What run asks, real regions", "As `query_resampled`."),
    "query_exhaustive": ("Query by comparing with every node", "The same answer as `query`, in the same run."),
    "screen": (
        "Screening",
        "What bounds a query: an image screened, on a map of 20 000 nodes whose runner-up is known. *Passing*: of 1000 images those "
        "that screening leaves to the second look. *With exact codes*: those that any bound without constraint 2 leaves; *by fours*: if "
        "four consecutive images shared that bound. *Pairs*: of 1000 pairs of regions those looked at; *in order*: if images shared "
        "blocks in the order in which they come. `estimate`: the third step, for one of those that pass both.",
    ),
    "insert": ("Insertion", "One more node in a map of so many."),
    "map": ("Map file", "Loading and saving a map of so many nodes."),
    "opencv": ("What a user would take instead", "OpenCV on the same image: features extracted, or a saliency map."),
    "machine": ("The limits of the machine", "One core."),
}


def seconds(entry):
    return entry["cpu_time"] * SECONDS[entry["time_unit"]]


def shown(value):
    """A time, with three digits and the unit that suits it."""
    for unit, scale in (("s", 1), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)):
        if value >= scale or unit == "ns":
            return f"{value / scale:.3g} {unit}"
    return ""


def limits(entries):
    """Bytes and operations a second that the machine reached in this run."""
    memory = next((e["bytes_per_second"] for e in entries if e["name"].startswith("machine/read/memory")), None)
    peak = next((e["operations"] for e in entries if e["name"].startswith("machine/multiply_add")), None)
    return memory, peak


def shares(entry, memory, peak):
    """What part of the machine's limits a benchmark used, as text for two columns."""
    bytes_rate = entry.get("bytes_per_second")
    operations = entry.get("operations")
    of_memory = f"{100 * bytes_rate / memory:.0f} %" if bytes_rate and memory else ""
    of_peak = f"{100 * operations / peak:.0f} %" if operations and peak else ""
    return of_memory, of_peak


def table(entries, memory, peak):
    lines = ["| benchmark | time | a second | of memory bandwidth | of arithmetic |", "|---|---|---|---|---|"]
    for entry in entries:
        time = seconds(entry)
        rate = entry.get("operations") if entry["name"].startswith("machine/multiply") else None
        if entry["name"].startswith("machine/read"):
            rate_text = f"{entry['bytes_per_second'] / 1e9:.1f} GB"
        elif rate:
            rate_text = f"{rate / 1e9:.0f} G operations"
        else:
            rate_text = f"{1 / time:.4g}"
        lines.append(f"| `{entry['name']}` | {shown(time)} | {rate_text} | " + " | ".join(shares(entry, memory, peak)) + " |")
    return "\n".join(lines)


def screening_table(entries):
    columns = {
        "passing": "passing",
        "with exact codes": "passing_exact",
        "by fours": "fours_passing_exact",
        "pairs": "pairs",
        "in order": "pairs_in_order",
    }
    lines = ["| benchmark | time | " + " | ".join(columns) + " |", "|---" * (2 + len(columns)) + "|"]
    for entry in entries:
        if entry["name"].split("/")[0] not in ("screen", "estimate"):
            continue
        counts = [f"{1000 * entry[key]:.3g}" if key in entry else "" for key in columns.values()]
        lines.append(f"| `{entry['name']}` | {shown(seconds(entry))} | " + " | ".join(counts) + " |")
    return "\n".join(lines)


def machine(context):
    model = next(
        (line.split(":", 1)[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")),
        "unknown processor",
    )
    compiler = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
    return (
        f"{model}, {context['num_cpus']} cores, {context['mhz_per_cpu']} MHz nominal; {compiler}, Release (-O3, no -march). "
        f"One thread, pinned to one core. Load of the machine when the run began: {context['load_avg'][0]:.2f}."
    )


def query_points(entries, prefix):
    points = []
    for entry in entries:
        match = re.fullmatch(prefix + r"/paper_weighted/(\d+)", entry["name"])
        if match:
            points.append((int(match.group(1)), seconds(entry)))
    return sorted(points)


def plot(entries, path):
    """Query time over map size: every node compared, and with the index. False when there is nothing to draw."""
    series = [
        ("every node compared", query_points(entries, "query_exhaustive")),
        ("most similar, with the index", query_points(entries, "query")),
        ("what run asks, with the index", query_points(entries, "as_run")),
    ]
    if any(len(points) < 2 for _, points in series):
        return False
    data = "".join(
        "$%s << EOD\n%s\nEOD\n" % ("abc"[i], "\n".join(f"{n} {1e3 * t}" for n, t in points)) for i, (_, points) in enumerate(series)
    )
    curves = ", ".join(f"${'abc'[i]} with linespoints linewidth 2 pointtype 7 title '{name}'" for i, (name, _) in enumerate(series))
    script = (
        f"set terminal svg size 720,420 background 'white'\nset output '{path}'\nset logscale xy\nset grid\nset key left top\n"
        f"set xlabel 'nodes of the map'\nset ylabel 'ms a query, one core'\n{data}plot {curves}\n"
    )
    subprocess.run(["gnuplot"], input=script, text=True, check=True)
    return True


def document(report, plotted):
    entries = [e for e in report["benchmarks"] if "error_occurred" not in e and e.get("run_type") != "aggregate"]
    memory, peak = limits(entries)
    parts = [
        "# Performance",
        "Made by `scripts/bench`. Do not edit.",
        machine(report["context"]),
        "Times are of one iteration (processor time). *Of memory bandwidth* and *of arithmetic* hold the bytes and the 16-bit operations "
        "that a benchmark says it needs against what the machine itself reached in the same run (last table); where both are "
        "far below 100 %, neither bounds it: latency, gathers, comparisons or branches do.",
    ]
    for group, (heading, what) in GROUPS.items():
        chosen = [e for e in entries if e["name"].split("/")[0] == group]
        if not chosen:
            continue
        if group == "screen":
            parts += [f"## {heading}", what, screening_table(entries)]
            continue
        parts += [f"## {heading}", what, table(chosen, memory, peak)]
        if group == "query_exhaustive" and plotted:
            parts.append("![Query time over map size](images/query_time.svg)")
    return "\n\n".join(parts) + "\n"


def main():
    report = json.loads(Path(sys.argv[1]).read_text())
    folder = Path(sys.argv[2])
    plotted = plot(report["benchmarks"], folder / "images" / "query_time.svg")
    (folder / "performance.md").write_text(document(report, plotted))


if __name__ == "__main__":
    main()
