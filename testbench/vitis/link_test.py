"""The kernel sailmap_memory as Vitis links it: its directives against the register map that host and bare metal read,
the connections of the boards, and how scripts/vitis/link calls the tools."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SCRIPTS = ROOT / "scripts" / "vitis"
sys.path[:0] = [str(SCRIPTS), str(ROOT / "testbench")]

import tables  # noqa: E402
from needs import skip_without  # noqa: E402

MEMORIES = ["pixels", "intensity_maps", "colour_maps", "orientation_maps", "conspicuity_maps", "saliency", "statistics",
            "report"]
SCALARS = ["width", "height", "frame"]


def link(*arguments, **environment):
    return subprocess.run([sys.executable, "-B", SCRIPTS / "link", *map(str, arguments)], capture_output=True, text=True,
                          check=False, env={**os.environ, **environment})


class Directives(unittest.TestCase):
    def setUp(self):
        self.source = (ROOT / "hls/top/memory.cpp").read_text()

    def registers(self):
        text = (ROOT / "hls/include/sailmap/hls/memory_registers.h").read_text()
        return {name: int(value, 16) for name, value in re.findall(r"SAILMAP_(\w+) = (0x\w+)", text)}

    def test_registers_are_those_of_the_header(self):
        found = re.findall(r"mode = s_axilite port = (\w+) offset = (0x\w+)", self.source)
        self.assertEqual([name for name, _ in found], MEMORIES + SCALARS)
        registers = self.registers()
        for name, offset in found:
            self.assertEqual(int(offset, 16), registers[name.upper()], name)
        # But not where v++ links the kernel, which places them itself.
        for_kernels = re.sub(r"#ifndef SAILMAP_VITIS_KERNEL\n.*?#endif\n", "", self.source, flags=re.DOTALL)
        self.assertNotIn("s_axilite", for_kernels)
        self.assertEqual(for_kernels.count("mode = m_axi"), len(MEMORIES))
        self.assertIn("mode = s_axilite port = return", self.source)
        # As Vitis lays them out by itself: an address takes 12 bytes and a scalar 8, from 0x10 on.
        offsets = [int(offset, 16) for _, offset in found]
        self.assertEqual(offsets, [0x10 + 12 * min(i, 8) + 8 * max(0, i - 8) for i in range(11)])
        self.assertEqual(registers["REGISTERS_END"], offsets[-1] + 8)

    def test_every_memory_has_a_master_of_its_own(self):
        found = re.findall(r"mode = m_axi port = (\w+) bundle = (\w+) offset = slave", self.source)
        self.assertEqual([name for name, _ in found], MEMORIES)
        self.assertEqual(len({bundle for _, bundle in found}), len(MEMORIES))

    def test_arguments_are_in_the_order_of_the_host(self):
        ports = [port.name for port in tables.ports_of(ROOT / "hls/top/memory.hpp", "sailmap_memory")]
        self.assertEqual(ports, MEMORIES + SCALARS)
        host = (ROOT / "host/src/frontends/xrt/device.hpp").read_text()
        names = re.search(r"argument_names = \{([^}]*)\}", host)[1]
        self.assertEqual(re.findall(r'"(\w+)"', names), ports)


class Document(unittest.TestCase):
    def setUp(self):
        self.text = (ROOT / "docs/fpga.md").read_text()

    def test_the_register_map_is_the_headers(self):
        table = self.text.split("| offset | | offset | |")[1].split("\n\n")[0]
        found = {}
        for row in table.splitlines()[2:]:
            cells = [cell.strip() for cell in row.strip("|").split("|")]
            for offset, what in (cells[:2], cells[2:]):
                found[re.search(r"`(\w+)`|^(control)", what).group(1) or "control"] = int(offset, 16)
        header = (ROOT / "hls/include/sailmap/hls/memory_registers.h").read_text()
        registers = {name.lower(): int(value, 16) for name, value in re.findall(r"SAILMAP_(\w+) = (0x\w+)", header)}
        registers.pop("registers_end")
        self.assertEqual(found, registers)

    @skip_without(shutil.which("gcc"), "gcc")
    def test_the_bare_metal_example_compiles(self):
        example = re.search(r"```c\n(.*?)```", self.text, re.DOTALL)[1]
        with tempfile.TemporaryDirectory() as folder:
            # What AMD's standalone library declares of this.
            Path(folder, "xil_cache.h").write_text("#include <stdint.h>\ntypedef uintptr_t UINTPTR;\n"
                                                   "void Xil_DCacheFlushRange(UINTPTR, uint32_t);\n"
                                                   "void Xil_DCacheInvalidateRange(UINTPTR, uint32_t);\n")
            Path(folder, "xparameters.h").write_text(
                "#define XPAR_SAILMAP_MEMORY_0_S_AXI_CONTROL_BASEADDR 0x43C00000\n")
            Path(folder, "example.c").write_text(example)
            run = subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Wno-int-to-pointer-cast", "-Werror",
                                  "-fsyntax-only", f"-I{folder}", f"-I{ROOT}/hls/include", f"-I{ROOT}/hls/bare_metal",
                                  Path(folder, "example.c")], capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)


class Boards(unittest.TestCase):
    def test_connections(self):
        files = {path.stem: path.read_text() for path in (SCRIPTS / "boards").glob("*.cfg")}
        self.assertEqual(set(files), {"u50", "u250", "k26"})
        for name, text in files.items():
            with self.subTest(board=name):
                self.assertIn(name, tables.read_parts())
                lines = [line for line in text.splitlines() if not line.startswith("#")]
                self.assertEqual(lines[:2], ["[connectivity]", "nk=sailmap_memory:1:sailmap_memory_1"])
                ports = []
                for line in lines[2:]:
                    if line.startswith("slr="):
                        self.assertRegex(line, r"^slr=sailmap_memory_1:SLR\d$")
                        continue
                    port, bank = re.fullmatch(r"sp=sailmap_memory_1\.(\w+):(\w+)\[\d+\]", line).groups()
                    ports.append(port)
                    self.assertEqual(bank, {"u50": "HBM", "u250": "DDR"}[name])
                self.assertEqual(ports, [] if name == "k26" else MEMORIES)


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
        done = self.linked("u50", "--platform", "xilinx_u50_gen3x16_xdma", "--preset", "720p", "--beat", "8")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        job = self.folder / "jobs" / "sailmap_memory-u50-200MHz-720p-8"
        self.assertEqual(done.stdout, f"{job}/sailmap_memory.xclbin\n")
        self.assertEqual((self.folder / "log").read_text().splitlines(), [
            f"-c --mode hls --config {job}/kernel.cfg --work_dir {job}/work",
            "--link -t hw --platform xilinx_u50_gen3x16_xdma "
            f"--config {SCRIPTS}/boards/u50.cfg --clock.freqHz 200000000:sailmap_memory_1 "
            f"-o {job}/sailmap_memory.xclbin {job}/sailmap_memory.xo"])
        general, hls = (job / "kernel.cfg").read_text().split("[hls]\n")
        self.assertEqual(general.split(), ["part=xcu50-fsvh2104-2-e"])
        entries = dict(line.split("=", 1) for line in hls.splitlines())
        self.assertEqual(entries["syn.top"], "sailmap_memory")
        self.assertEqual(entries["syn.file"], str(ROOT / "hls/top/memory.cpp"))
        self.assertEqual(entries["package.output.format"], "xo")
        self.assertEqual(entries["package.output.file"], f"{job}/sailmap_memory.xo")
        self.assertEqual(entries["flow_target"], "vitis")
        self.assertIn("-DSAILMAP_VITIS_KERNEL", entries["syn.file_cflags"].split())
        for macro in ("MAX_WIDTH=1280", "MAX_HEIGHT=720", "BEAT=8"):
            self.assertIn(f"-DSAILMAP_{macro}", entries["syn.file_cflags"])

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
