"""The kernels between memory and memory as Vitis links them: their directives against the register map that host and bare
metal read, the connections of the boards, and how scripts/vitis/link calls the tools."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SCRIPTS = ROOT / "scripts" / "vitis"
sys.path[:0] = [str(SCRIPTS), str(ROOT / "testbench")]

import tables  # noqa: E402
from needs import skip_without  # noqa: E402

HEADER = ROOT / "hls/include/sailmap/hls/memory_registers.h"


@dataclass(frozen=True)
class Kernel:
    name: str
    source: str  # in hls/top; its header has the same name
    registers: str  # how their names in memory_registers.h begin behind SAILMAP_
    memories: tuple
    scalars: tuple


MAPS = Kernel("sailmap_memory", "memory.cpp", "",
              ("pixels", "intensity_maps", "colour_maps", "orientation_maps", "conspicuity_maps", "saliency", "statistics",
               "report"), ("width", "height", "frame"))
SIGNATURE = Kernel("sailmap_signature_memory", "signature_memory.cpp", "SIGNATURE_", ("pixels", "record", "report"),
                   ("width", "height", "frame", "max_regions", "stop_ratio", "box_side"))
KERNELS = (MAPS, SIGNATURE)


def registers_of(kernel):
    """Offsets by the names of memory_registers.h, without what they begin with."""
    found = re.findall(r"SAILMAP_(SIGNATURE_)?(\w+) = (0x\w+)", HEADER.read_text())
    return {name: int(value, 16) for prefix, name, value in found if prefix == kernel.registers and name != "CONTROL"}


def link(*arguments, **environment):
    return subprocess.run([sys.executable, "-B", SCRIPTS / "link", *map(str, arguments)], capture_output=True, text=True,
                          check=False, env={**os.environ, **environment})


class Directives(unittest.TestCase):
    def for_kernels(self, check):
        for kernel in KERNELS:
            with self.subTest(kernel=kernel.name):
                check(kernel, (ROOT / "hls/top" / kernel.source).read_text())

    def test_registers_are_those_of_the_header(self):
        self.for_kernels(self.check_registers)

    def check_registers(self, kernel, source):
        found = re.findall(r"mode = s_axilite port = (\w+) offset = (0x\w+)", source)
        self.assertEqual(tuple(name for name, _ in found), kernel.memories + kernel.scalars)
        registers = registers_of(kernel)
        for name, offset in found:
            self.assertEqual(int(offset, 16), registers[name.upper()], name)
        # But not where v++ links the kernel, which places them itself.
        for_kernels = re.sub(r"#ifndef SAILMAP_VITIS_KERNEL\n.*?#endif\n", "", source, flags=re.DOTALL)
        self.assertNotIn("s_axilite", for_kernels)
        self.assertEqual(for_kernels.count("mode = m_axi"), len(kernel.memories))
        self.assertIn("mode = s_axilite port = return", source)
        # As Vitis lays them out by itself: an address takes 12 bytes and a scalar 8, from 0x10 on.
        offsets = [int(offset, 16) for _, offset in found]
        count = len(kernel.memories)
        self.assertEqual(offsets, [0x10 + 12 * min(i, count) + 8 * max(0, i - count) for i in range(len(found))])
        self.assertEqual(registers["REGISTERS_END"], offsets[-1] + 8)
        self.assertEqual(len(registers), len(found) + 1)

    def test_every_memory_has_a_master_of_its_own(self):
        self.for_kernels(self.check_masters)

    def check_masters(self, kernel, source):
        found = re.findall(r"mode = m_axi port = (\w+) bundle = (\w+) offset = slave", source)
        self.assertEqual(tuple(name for name, _ in found), kernel.memories)
        self.assertEqual(len({bundle for _, bundle in found}), len(kernel.memories))

    def test_arguments_are_in_the_order_of_the_host(self):
        host = (ROOT / "host/src/frontends/xrt/kernel_interface.hpp").read_text()
        names = re.findall(r'"(\w+)"', re.search(r"buffer_names = \{([^}]*)\}", host)[1])
        kinds = re.findall(r"\w+", re.search(r"enum class Buffer \{([^}]*)\}", host)[1])
        self.assertEqual(names, kinds)
        scalars = re.findall(r'"(\w+)"', re.search(r"scalar_names = \{([^}]*)\}", host)[1])
        for kernel, words in ((MAPS, "maps"), (SIGNATURE, "signature")):
            with self.subTest(kernel=kernel.name):
                ports = tables.ports_of((ROOT / "hls/top" / kernel.source).with_suffix(".hpp"), kernel.name)
                self.assertEqual(tuple(port.name for port in ports), kernel.memories + kernel.scalars)
                buffers = re.search(rf"{words}_buffers = \{{([^}}]*)\}}", host)[1]
                self.assertEqual(tuple(re.findall(r"Buffer::(\w+)", buffers)), kernel.memories)
                count = int(re.search(rf"{words}_scalars = (\d+)", host)[1])
                self.assertEqual(tuple(scalars[:count]), kernel.scalars)


class Document(unittest.TestCase):
    def setUp(self):
        self.text = (ROOT / "docs/fpga.md").read_text()

    def test_the_register_maps_are_the_headers(self):
        documents = self.text.split("| offset | | offset | |")[1:]
        self.assertEqual(len(documents), len(KERNELS))
        for kernel, text in zip(KERNELS, documents):
            found = {}
            for row in text.split("\n\n")[0].splitlines()[2:]:
                cells = [cell.strip() for cell in row.strip("|").split("|")]
                for offset, what in (cells[:2], cells[2:]):
                    found[re.search(r"`(\w+)`|^(control)", what).group(1) or "control"] = int(offset, 16)
            registers = {name.lower(): value for name, value in registers_of(kernel).items()}
            registers.pop("registers_end")
            self.assertEqual(found, {"control": 0, **registers})

    @skip_without(shutil.which("gcc"), "gcc")
    def test_the_bare_metal_examples_compile(self):
        examples = re.findall(r"```c\n(.*?)```", self.text, re.DOTALL)
        self.assertEqual(len(examples), len(KERNELS))
        with tempfile.TemporaryDirectory() as folder:
            # What AMD's standalone library declares of this.
            Path(folder, "xil_cache.h").write_text("#include <stdint.h>\ntypedef uintptr_t UINTPTR;\n"
                                                   "void Xil_DCacheFlushRange(UINTPTR, uint32_t);\n"
                                                   "void Xil_DCacheInvalidateRange(UINTPTR, uint32_t);\n")
            Path(folder, "xparameters.h").write_text(
                "#define XPAR_SAILMAP_MEMORY_0_S_AXI_CONTROL_BASEADDR 0x43C00000\n"
                "#define XPAR_SAILMAP_SIGNATURE_MEMORY_0_S_AXI_CONTROL_BASEADDR 0x43C10000\n")
            for example in examples:
                Path(folder, "example.c").write_text(example)
                run = subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Wno-int-to-pointer-cast", "-Werror",
                                      "-fsyntax-only", f"-I{folder}", f"-I{ROOT}/hls/include", f"-I{ROOT}/hls/bare_metal",
                                      Path(folder, "example.c")], capture_output=True, text=True, check=False)
                self.assertEqual(run.returncode, 0, run.stderr)


class Boards(unittest.TestCase):
    def test_connections(self):
        folder = SCRIPTS / "boards"
        names = {path.relative_to(folder).as_posix() for path in folder.rglob("*.cfg")}
        self.assertEqual(names, {f"{board}/{kernel.name}.cfg" for board in ("u50", "u250", "k26") for kernel in KERNELS})
        for board in ("u50", "u250", "k26"):
            self.assertIn(board, tables.read_parts())
            placed = [self.check_connections(board, kernel) for kernel in KERNELS]
            # Both fit into one xclbin: each in a part of the device of its own, with memory of its own.
            if board != "k26":
                self.assertEqual(len({slr for slr, _ in placed}), len(KERNELS))
                self.assertEqual(placed[0][1] & placed[1][1], set())

    def check_connections(self, board, kernel):
        """Where the kernel goes, and the memories that it is connected with."""
        text = (SCRIPTS / "boards" / board / f"{kernel.name}.cfg").read_text()
        with self.subTest(board=board, kernel=kernel.name):
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            self.assertEqual(lines[:2], ["[connectivity]", f"nk={kernel.name}:1:{kernel.name}_1"])
            region, ports, banks = None, [], set()
            for line in lines[2:]:
                if line.startswith("slr="):
                    region = re.fullmatch(rf"slr={kernel.name}_1:(SLR\d)", line)[1]
                    continue
                port, kind, number = re.fullmatch(rf"sp={kernel.name}_1\.(\w+):(\w+)\[(\d+)\]", line).groups()
                ports.append(port)
                banks.add(number)
                self.assertEqual(kind, {"u50": "HBM", "u250": "DDR"}[board])
            self.assertEqual(tuple(ports), () if board == "k26" else kernel.memories)
        return region, banks


class Link(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name).resolve()

    def tool(self, exit_code=0):
        path = self.folder / "bin" / "v++"
        path.parent.mkdir()
        path.write_text(f'#!/bin/sh\necho "$*" >> {self.folder}/log\nexit {exit_code}\n')
        path.chmod(0o755)

    def linked(self, *arguments):
        return link(*arguments, "--folder", self.folder / "jobs", PATH=str(self.folder / "bin"))

    def test_compiles_then_links(self):
        self.tool()
        for words, kernel in (("maps", MAPS), ("signature", SIGNATURE)):
            with self.subTest(kernel=kernel.name):
                (self.folder / "log").unlink(missing_ok=True)
                done = self.linked("u50", "--platform", "xilinx_u50_gen3x16_xdma", "--preset", "720p", "--beat", "8",
                                   *(("--kernel", words) if kernel is not MAPS else ()))
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                job = self.folder / "jobs" / f"{kernel.name}-u50-200MHz-720p-8"
                self.assertEqual(done.stdout, f"{job}/{kernel.name}.xclbin\n")
                self.assertEqual((self.folder / "log").read_text().splitlines(), [
                    f"-c --mode hls --config {job}/kernel.cfg --work_dir {job}/work",
                    "--link -t hw --platform xilinx_u50_gen3x16_xdma "
                    f"--config {SCRIPTS}/boards/u50/{kernel.name}.cfg --clock.freqHz 200000000:{kernel.name}_1 "
                    f"-o {job}/{kernel.name}.xclbin {job}/{kernel.name}.xo"])
                self.check_kernel_configuration(kernel, job)

    def check_kernel_configuration(self, kernel, job):
        general, hls = (job / "kernel.cfg").read_text().split("[hls]\n")
        self.assertEqual(general.split(), ["part=xcu50-fsvh2104-2-e"])
        entries = dict(line.split("=", 1) for line in hls.splitlines())
        self.assertEqual(entries["syn.top"], kernel.name)
        self.assertEqual(entries["syn.file"], str(ROOT / "hls/top" / kernel.source))
        self.assertEqual(entries["package.output.format"], "xo")
        self.assertEqual(entries["package.output.file"], f"{job}/{kernel.name}.xo")
        self.assertEqual(entries["flow_target"], "vitis")
        self.assertIn("-DSAILMAP_VITIS_KERNEL", entries["syn.file_cflags"].split())
        for macro in ("MAX_WIDTH=1280", "MAX_HEIGHT=720", "BEAT=8"):
            self.assertIn(f"-DSAILMAP_{macro}", entries["syn.file_cflags"])

    def test_both_kernels_in_one_xclbin(self):
        self.tool()
        done = self.linked("u250", "--platform", "p", "--kernel", "both", "--preset", "vga")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        jobs = {kernel: self.folder / "jobs" / f"{kernel.name}-u250-200MHz-vga-4" for kernel in KERNELS}
        self.assertEqual(done.stdout, f"{jobs[MAPS]}/sailmap_both.xclbin\n")
        boards = SCRIPTS / "boards" / "u250"
        self.assertEqual((self.folder / "log").read_text().splitlines(), [
            *(f"-c --mode hls --config {job}/kernel.cfg --work_dir {job}/work" for job in jobs.values()),
            "--link -t hw --platform p "
            f"--config {boards}/sailmap_memory.cfg --clock.freqHz 200000000:sailmap_memory_1 "
            f"--config {boards}/sailmap_signature_memory.cfg --clock.freqHz 200000000:sailmap_signature_memory_1 "
            f"-o {jobs[MAPS]}/sailmap_both.xclbin {jobs[MAPS]}/sailmap_memory.xo "
            f"{jobs[SIGNATURE]}/sailmap_signature_memory.xo"])
        for kernel, job in jobs.items():
            self.assertIn(f"syn.top={kernel.name}\n", (job / "kernel.cfg").read_text())

    def test_faults_are_one_line(self):
        for arguments, says in ((("u51", "--platform", "p"), "u51"), (("u50", "--platform", "p"), "no v++")):
            done = self.linked(*arguments)
            self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (1, "", 1), done.stderr)
            self.assertIn(says, done.stderr)
        self.tool(3)
        done = self.linked("k26", "--platform", "p")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("failed: v++ -c --mode hls", done.stderr)
        self.assertEqual(len((self.folder / "log").read_text().splitlines()), 1)


if __name__ == "__main__":
    unittest.main()
