"""Lint of the Verilog of a top, and its area by Yosys."""

import json
import re
from dataclasses import dataclass, fields

from job import Fault, checked
from parts import Modules, anonymous

# What the components of Bambu's library and its names cause in every design, whatever the source is:
WAIVED = {
    "DECLFILENAME": "file and module have different names: modules have the compiler's mangled names",
    "PINMISSING": "library components with ports that a use of them leaves open",
    "SYNCASYNCNET": "the reset of the controller is asynchronous, that of the streams synchronous",
    "UNUSEDPARAM": "library components are written for more than a use of them needs",
    "UNUSEDSIGNAL": "the same",
    "WIDTH": "library components leave it to Verilog to extend and cut numbers",
}
# Registers of pipelined functions have no enable; Bambu leaves the wires for it open.
WAIVED_WIRES = """`verilator_config
lint_off -rule UNDRIVEN -file "*" -match "Signal is not driven: 'wrenable_reg_*"
"""


def lint(job, seconds):
    """Verilator's warnings of other classes than WAIVED, one a line; a Fault when there are any."""
    waivers = [f"-Wno-{name}" for name in WAIVED]
    wires = job.folder / "waived.vlt"
    wires.write_text(WAIVED_WIRES, encoding="utf-8")
    try:
        checked(["verilator", "--lint-only", "-Wall", *waivers, "--top-module", job.module(), wires, job.verilog],
                job.folder / "lint.log", job.folder, seconds)
    except Fault:
        text = (job.folder / "lint.log").read_text(encoding="utf-8")
        classes = sorted(set(re.findall(r"%(?:Warning|Error)[-\w]*", text)))
        raise Fault(f"{job.top.name}: lint: {', '.join(classes)}, see {job.folder / 'lint.log'}") from None


@dataclass(frozen=True)
class Area:
    """Of a whole design; block memories in units of 36 Kbit (xc7) or 18 Kbit (ecp5)."""

    lut: int
    ff: int
    bram: float
    dsp: int
    sites: int = 0  # of LUTs, xc7 alone: lut_sites()


def sum_of(areas):
    areas = list(areas)
    return Area(*(sum(getattr(area, field.name) for area in areas) for field in fields(Area)))


def lut_sites(luts):
    """Yosys's estimate of the sites that LUTs fill, in pairs where they are small ("Estimated number of LCs" of its `stat -tech
    xilinx`, which it does not write as JSON). `luts`: number of LUTs by inputs, 0 to 6."""
    left = list(luts)
    sites = 0
    for larger, smaller in ((6, ()), (5, (1,)), (4, (1, 2)), (3, (1, 2))):
        sites += left[larger]
        for partner in smaller:
            pairs = min(left[larger], left[partner])
            left[larger] -= pairs
            left[partner] -= pairs
    return sites + (left[2] + left[1] + 1) // 2


def xc7(cells):
    """LUTs that are memory or shift registers are LUTs: one a RAM32X1D half, four a RAM32M, and so on."""
    as_memory = {"RAM32X1D": 2, "RAM64X1D": 2, "RAM32X1S": 1, "RAM64X1S": 1, "RAM128X1D": 4, "RAM128X1S": 2, "RAM32M": 4,
                 "RAM64M": 4, "RAM256X1S": 4, "SRL16E": 1, "SRLC32E": 1}
    memory = sum(cells.get(name, 0) * luts for name, luts in as_memory.items())
    logic = [cells.get(f"LUT{n}", 0) for n in range(7)]
    logic[1] += cells.get("INV", 0)
    return Area(lut=sum(logic) + memory, sites=lut_sites(logic) + memory,
                ff=sum(number for name, number in cells.items() if re.fullmatch(r"FD[RSCP]E(_1)?", name)),
                bram=cells.get("RAMB36E1", 0) + cells.get("RAMB18E1", 0) / 2, dsp=cells.get("DSP48E1", 0))


def ecp5(cells):
    """A carry of two bits (CCU2C) is two LUTs; 16 words of four bits (DPR16X4) are four and two for the addresses."""
    return Area(lut=cells.get("LUT4", 0) + 2 * cells.get("CCU2C", 0) + 6 * cells.get("TRELLIS_DPR16X4", 0),
                ff=cells.get("TRELLIS_FF", 0), bram=cells.get("DP16KD", 0), dsp=cells.get("MULT18X18D", 0))


# Memories of so many words are in LUTs, as the memory table of docs/fpga.md has them: by itself Yosys puts rows of 160 words
# into block RAM, of which there is less than of LUTs.
SHALLOW = 192
XC7 = "synth_xilinx -family xc7 -flatten -noiopad"
FAMILIES = {"xc7": (f"{XC7} -top {{top}} -run begin:map_memory; setattr -set ram_style \"distributed\" "
                    f"t:$mem_v2 r:SIZE<={SHALLOW} %i; {XC7} -run map_memory:", xc7),
            "ecp5": ("synth_ecp5 -top {top}", ecp5)}


def cells(job, family, verilog, top, name, seconds):
    """Cells by type of a module, flattened."""
    command = FAMILIES[family][0].format(top=top)
    statistics = job.folder / f"{name}.json"
    if not statistics.exists() or statistics.stat().st_mtime < job.verilog.stat().st_mtime:
        source = job.folder / f"{name}.v"
        source.write_text(verilog, encoding="utf-8")
        # Deferred: components without a use would look for memory files that are not there.
        script = f"read_verilog -defer {source.name}; {command}; tee -q -o {statistics.name}.new stat -json"
        checked(["yosys", "-q", "-p", script], job.folder / f"{name}.log", job.folder, seconds)
        (job.folder / f"{statistics.name}.new").rename(statistics)
        source.unlink()
    return json.loads(statistics.read_text(encoding="utf-8"))["design"]["num_cells_by_type"]


def area(job, family, seconds):
    """The Area of a top in a family, and that of each of its parts (parts.py) where it is a region."""
    count = FAMILIES[family][1]
    verilog = job.verilog.read_text(encoding="utf-8")
    if not job.is_network:
        return count(cells(job, family, verilog, job.module(), family, seconds)), {}
    modules = Modules(verilog)
    stages = modules.stages(job.module())
    counted, parts = {}, {}
    for stage in stages:
        text = modules.below(stage)
        alike = anonymous(text)
        if alike not in counted:
            counted[alike] = count(cells(job, family, text, stage, f"{family}-{len(counted)}", seconds))
        parts[stage] = counted[alike]
    rest = modules.below(job.module(), stages)
    parts["FIFOs and control"] = count(cells(job, family, rest, job.module(), f"{family}-rest", seconds))
    return sum_of(parts.values()), parts
