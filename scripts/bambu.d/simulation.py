"""The Verilog of a top, compiled by Verilator, against the words of the quantised reference."""

import json
import os
import subprocess

from job import ROOT, Fault, checked
from tables import ports_of

HERE = ROOT / "scripts" / "bambu.d"


def bench_source(job):
    """The main program of the bench (bench.hpp) for the ports of a top."""
    lines = ["// Written by scripts/bambu.", '#include "Vtop.h"', '#include "bench.hpp"', "",
             "int main(int argc, char** argv) {", "  sailmap::rtl::Bench<Vtop> bench(argc, argv);"]
    for port in ports_of(job.top.header, job.top.name):
        if port.kind == "scalar":
            lines.append(f'  bench.scalar("{port.name}", bench.model().{port.name});')
            continue
        direction = "input" if port.name in job.top.inputs else "output"
        signals = ", ".join(f"bench.model().{port.name}_{signal}" for signal in ("TDATA", "TVALID", "TREADY"))
        lines.append(f'  bench.{direction}("{port.name}", {signals});')
    return "\n".join(lines + ["  return bench.run();", "}", ""])


def build(job, seconds):
    """Compiles the bench; returns the program."""
    folder = job.folder / "bench"
    program = folder / "Vtop"
    if program.exists() and program.stat().st_mtime > max(job.verilog.stat().st_mtime,
                                                          (HERE / "bench.hpp").stat().st_mtime):
        return program
    folder.mkdir(exist_ok=True)
    source = folder / "bench.cpp"
    source.write_text(bench_source(job), encoding="utf-8")
    # Warnings are area.py's business. Registers and memories start with random contents (bench.hpp).
    checked(["verilator", "--cc", "--exe", "--build", "--Mdir", folder, "--prefix", "Vtop", "--top-module", job.module(),
             "-O3", "--x-initial", "unique", "-Wno-fatal", "-Wno-lint", "-CFLAGS", f"-std=c++17 -I{HERE}",
             "-MAKEFLAGS", "OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O1", job.verilog, source],
            job.folder / "verilator.log", job.folder, seconds)
    return program


def simulate(job, vectors, seed, seconds):
    """Runs all calls of a file of vectors; the cycles of each. A Fault with the first difference. `seed` 0: no stalls."""
    program = build(job, seconds)
    # Bambu's memories read their first contents from files beside the Verilog.
    command = [str(program), str(vectors), str(seed)] + ["network"] * job.is_network + ["ahead"] * job.takes_ahead
    try:
        run = subprocess.run(command, check=False, cwd=job.folder, capture_output=True, text=True, timeout=seconds,
                             env={**os.environ, "LC_ALL": "C"})
    except subprocess.TimeoutExpired:
        raise Fault(f"{job.top.name}: simulation without end after {seconds} s") from None
    try:
        result = json.loads(run.stdout.splitlines()[-1])
    except (IndexError, json.JSONDecodeError):
        raise Fault(f"{job.top.name}: simulation failed: {run.stderr.strip()}") from None
    if result["faults"] or run.returncode != 0:
        raise Fault(f"{job.top.name}: {'; '.join(result['faults'])}")
    return result["cycles"]
