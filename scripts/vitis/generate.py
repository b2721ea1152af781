#!/usr/bin/env python3
"""Writes what Vitis HLS needs for one top, part and clock into a folder:

hls.cfg        for v++ -c --mode hls and vitis-run --mode hls (2023.2 and later)
hls.tcl        for vitis_hls -f (before), the same steps; SAILMAP_STEPS selects some of them
testbench.cpp  for C simulation and co-simulation: the top's words against vectors.txt (written by scripts/vitis/run)
"""

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

from tables import BEATS, CLOCKS, HERE, PRESETS, ROOT, Fault, chosen, ports_of, read_parts, read_tops


@dataclass(frozen=True)
class Job:
    """One top for one device. Throws Fault for what does not exist."""

    top: object  # tables.Top
    part: str  # part number
    clock: int  # MHz
    width: int
    height: int
    beat: int
    double_buffer: bool
    folder: Path

    @property
    def flags(self):
        includes = [f"-I{ROOT / path}" for path in ("hls/include", "hls/top", "scripts/vitis")]
        macros = {"MAX_WIDTH": self.width, "MAX_HEIGHT": self.height, "BEAT": self.beat,
                  "DOUBLE_BUFFER": str(self.double_buffer).lower()}
        return " ".join(["-std=c++14", *includes, *(f"-DSAILMAP_{name}={value}" for name, value in macros.items())])

    def path(self, name):
        return self.folder / name


def job_from(options, top):
    """A Job of the parsed options for the named top."""
    width, height = chosen(PRESETS, options.preset, "preset")
    tops = read_tops()
    job = Job(chosen(tops, top, "top"), chosen(read_parts(), options.part, "part"),
              chosen({mhz: mhz for mhz in CLOCKS}, options.clock, "clock (MHz)"), width, height,
              chosen({beat: beat for beat in BEATS}, options.beat, "beat"), options.double_buffer,
              (Path(options.folder) / "-".join([top, options.part, f"{options.clock}MHz", options.preset,
                                                f"{options.beat}"] + ["double"] * options.double_buffer)).resolve())
    return job


def configuration(job):
    """hls.cfg. Without flow_target: the Vivado IP flow is the default, and the 2026.1 manual has no such key."""
    testbench = job.path("testbench.cpp")
    return "\n".join([
        f"part={job.part}",
        "",
        "[hls]",
        f"clock={job.clock}MHz",
        f"syn.top={job.top.name}",
        f"syn.file={job.top.source}",
        f"syn.file_cflags={job.top.source},{job.flags}",
        f"tb.file={testbench}",
        f"tb.file_cflags={testbench},{job.flags}",
        f"csim.argv={job.path('vectors.txt')}",
        f"cosim.argv={job.path('vectors.txt')}",
        "cosim.rtl=verilog",
        "package.output.format=ip_catalog",
        "package.output.syn=false",
        "",
    ])


def kernel_configuration(job):
    """kernel.cfg: synthesis to an .xo that v++ links. flow_target is of the manuals from 2023.2 to 2025.2."""
    return "\n".join([
        f"part={job.part}",
        "",
        "[hls]",
        "flow_target=vitis",
        f"clock={job.clock}MHz",
        f"syn.top={job.top.name}",
        f"syn.file={job.top.source}",
        f"syn.file_cflags={job.top.source},{job.flags} -DSAILMAP_VITIS_KERNEL",
        "package.output.format=xo",
        f"package.output.file={job.path(job.top.name + '.xo')}",
        "",
    ])


def tcl(job):
    """hls.tcl."""
    vectors = job.path("vectors.txt")
    return "\n".join([
        'set steps [expr {[info exists ::env(SAILMAP_STEPS)] ? $::env(SAILMAP_STEPS) : "csim synth cosim package"}]',
        f"open_project {job.top.name}",
        f"set_top {job.top.name}",
        f'add_files {job.top.source} -cflags "{job.flags}"',
        f'add_files -tb {job.path("testbench.cpp")} -cflags "{job.flags}"',
        "open_solution solution -flow_target vivado",
        f"set_part {job.part}",
        f"create_clock -period {job.clock}MHz -name default",
        f'if {{"csim" in $steps}} {{ csim_design -argv {{{vectors}}} }}',
        'if {"synth" in $steps} { csynth_design }',
        f'if {{"cosim" in $steps}} {{ cosim_design -rtl verilog -argv {{{vectors}}} }}',
        'if {"package" in $steps} { export_design -format ip_catalog }',
        "exit",
        "",
    ])


def testbench(job):
    """testbench.cpp: one call of the top for each call in the vectors."""
    ports = ports_of(job.top.header, job.top.name)
    listed = {*job.top.inputs, *job.top.outputs, *job.top.scalars}
    if {port.name for port in ports} != listed:
        raise Fault(f"{job.top.header}: the ports of {job.top.name} are not those of tops.csv")
    lines = ["// Written by scripts/vitis/generate.py.", f'#include "{job.top.header.name}"', '#include "testbench.hpp"',
             "", "int main(int argc, char** argv) {", "  sailmap::vitis::Vectors vectors(argc, argv);",
             "  while (vectors.next_call()) {"]
    for port in ports:
        if port.kind == "stream":
            lines.append(f"    sailmap::hls::stream<{port.type} > {port.name};")
        elif port.kind == "array":
            lines.append(f"    static {port.type} {port.name}[{port.extent}];")  # too large for the stack
    lines += [f'    vectors.fill("{name}", {name});' for name in job.top.inputs]
    arguments = [f'vectors.scalar("{port.name}")' if port.kind == "scalar" else port.name for port in ports]
    lines.append(f"    {job.top.name}({', '.join(arguments)});")
    streams = {port.name for port in ports if port.kind == "stream"}
    lines += [f'    vectors.expect_read("{name}", {name});' for name in job.top.inputs if name in streams]
    lines += [f'    vectors.check("{name}", {name});' for name in job.top.outputs]
    return "\n".join(lines + ["  }", "  return vectors.finish();", "}", ""])


def write(job):
    """All files of a job but the vectors. Throws OSError."""
    contents = {"hls.cfg": configuration(job), "hls.tcl": tcl(job), "testbench.cpp": testbench(job)}
    job.folder.mkdir(parents=True, exist_ok=True)
    for name, text in contents.items():
        job.path(name).write_text(text, encoding="utf-8")


def add_options(parser):
    """The options that choose device and configuration."""
    parser.add_argument("--part", default="zynq7020", help="short name in parts.csv (default %(default)s)")
    parser.add_argument("--clock", type=int, default=150, help="MHz, 150 or 200 (default %(default)s)")
    parser.add_argument("--preset", default="vga", help="largest frame: " + ", ".join(PRESETS) + " (default %(default)s)")
    parser.add_argument("--beat", type=int, default=4, help="pixels a beat, 1, 2, 4 or 8 (default %(default)s)")
    parser.add_argument("--double-buffer", action="store_true", help="store a frame while the last one is replayed")
    parser.add_argument("--folder", default=ROOT / "build" / "vitis", help="where the jobs' folders go (default build/vitis)")


def main():
    parser = argparse.ArgumentParser(description="Writes the Vitis HLS files of one top.")
    parser.add_argument("top", help="a top in tops.csv")
    add_options(parser)
    options = parser.parse_args()
    job = job_from(options, options.top)
    write(job)
    print(job.folder)


if __name__ == "__main__":
    try:
        main()
    except (Fault, OSError) as fault:
        sys.exit(f"generate.py: {fault}")
