"""scripts/vitis without Vitis: its tables against the sources, what it writes, and how it calls the tools."""

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
import vector_writer  # noqa: E402
from needs import skip_without  # noqa: E402

# Keys of UG1399, "HLS Config File Commands", from 2023.2 to 2026.1.
MANUAL_KEYS = {"part", "clock", "syn.top", "syn.file", "syn.file_cflags", "tb.file", "tb.file_cflags", "csim.argv",
               "cosim.argv", "cosim.rtl", "package.output.format", "package.output.syn"}


def call(program, *arguments, **environment):
    """Exit code, stdout and stderr of a script."""
    run = subprocess.run([sys.executable, "-B", SCRIPTS / program, *map(str, arguments)], capture_output=True, text=True,
                         check=False, env={**os.environ, **environment})
    return run.returncode, run.stdout, run.stderr


def definitions():
    """(function, file, text of the parameters, text of the body) of every top in hls/top."""
    pattern = re.compile(r"^void (sailmap_\w+)\(([^{;]*)\) \{\n(.*?)^\}", re.MULTILINE | re.DOTALL)
    for file in sorted((ROOT / "hls" / "top").glob("*.cpp")):
        for found in pattern.finditer(file.read_text()):
            yield found[1], file, found[2], found[3]


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name).resolve()

    def generated(self, top, part="zynq7020", clock=150, *more):
        code, out, err = call("generate.py", top, "--part", part, "--clock", clock, "--folder", self.folder, *more)
        self.assertEqual((code, err), (0, ""))
        return Path(out.strip())

    def one_line(self, result, *parts):
        code, out, err = result
        self.assertNotEqual(code, 0)
        self.assertEqual(out, "")
        self.assertEqual(len(err.splitlines()), 1, err)
        for part in parts:
            self.assertIn(part, err)


class Tables(unittest.TestCase):
    def test_every_top_is_in_the_table_and_the_other_way_round(self):
        sources = {name: file for name, file, _, _ in definitions()}
        self.assertGreater(len(sources), 10)
        self.assertEqual({top.name: top.source for top in tables.read_tops().values()}, sources)

    def test_ports_are_those_of_the_sources(self):
        for name, file, parameters, body in definitions():
            top = tables.read_tops()[name]
            with self.subTest(top=name):
                self.assertEqual(tables.ports_of(top.header, name), tables.ports_of(file, name))
                streams = re.findall(r"stream<[^&]*>& (\w+)", parameters)
                arrays = re.findall(r"(\w+)\[", parameters)
                everything = re.findall(r"(\w+)(?:\[[^\]]*\])?(?:,|$)", re.sub(r"<[^&]*>", "", parameters))
                self.assertEqual(sorted(top.inputs + top.outputs), sorted(streams + arrays))
                self.assertEqual(sorted(top.scalars), sorted(set(everything) - set(streams) - set(arrays)))
                axis = re.findall(r"#pragma HLS interface mode = axis port = (\w+)", body)
                self.assertEqual(axis, streams)

    def test_presets_are_those_of_the_kernels(self):
        text = (ROOT / "hls/include/sailmap/hls/config.hpp").read_text()
        found = re.findall(r"using (\w+) = Config<(\d+), (\d+), Beat", text)
        names = {"Qvga": "qvga", "Vga": "vga", "Hd720": "720p", "Hd1080": "1080p"}
        self.assertEqual({names[n]: (int(w), int(h)) for n, w, h in found}, tables.PRESETS)


class Generated(WithFolder):
    def test_configuration_of_every_top_part_and_clock(self):
        parts = {"zynq7020": "xc7z020clg400-1", "zu3eg": "xczu3eg-sbva484-1-e", "k26": "xck26-sfvc784-2LV-c",
                 "u50": "xcu50-fsvh2104-2-e", "u250": "xcu250-figd2104-2L-e"}
        self.assertEqual(tables.read_parts(), parts)
        # Every top once, on part and clock in turn: each pair of them occurs.
        pairs = [(part, clock) for part in parts for clock in (150, 200)]
        self.assertGreaterEqual(len(tables.read_tops()), len(pairs))
        for i, top in enumerate(tables.read_tops()):
            part, clock = pairs[i % len(pairs)]
            with self.subTest(top=top, part=part, clock=clock):
                self.check_configuration(self.generated(top, part, clock), top, parts[part], clock)

    def check_configuration(self, folder, top, part, clock):
        general, hls = (folder / "hls.cfg").read_text().split("[hls]\n")
        self.assertEqual(general.split(), [f"part={part}"])
        entries = dict(line.split("=", 1) for line in hls.splitlines())
        self.assertEqual(set(entries), MANUAL_KEYS - {"part"})
        self.assertEqual(entries["clock"], f"{clock}MHz")
        self.assertEqual(entries["syn.top"], top)
        self.assertRegex(Path(entries["syn.file"]).read_text(), rf"void {top}\(")
        self.assertRegex(Path(entries["tb.file"]).read_text(), rf"\n    {top}\(")
        for kind in ("syn", "tb"):
            file, flags = entries[f"{kind}.file_cflags"].split(",", 1)
            self.assertEqual(file, entries[f"{kind}.file"])
            self.assert_flags(flags)
        for step in ("csim", "cosim"):
            self.assertEqual(entries[f"{step}.argv"], str(folder / "vectors.txt"))
        self.assertEqual(entries["package.output.format"], "ip_catalog")

    def assert_flags(self, flags):
        words = flags.split()
        self.assertIn("-std=c++14", words)
        self.assertIn(f"-I{ROOT}/hls/include", words)
        for word in words:
            if word.startswith("-I"):
                self.assertTrue(Path(word[2:]).is_dir(), word)
        macros = {word[2:].split("=")[0] for word in words if word.startswith("-D")}
        known = set(re.findall(r"#ifndef (\w+)", (ROOT / "hls/top/configuration.hpp").read_text()))
        self.assertEqual(macros, known)

    def test_preset_beat_and_double_buffer_reach_the_compiler(self):
        folder = self.generated("sailmap_axi", "u50", 200, "--preset", "1080p", "--beat", "8", "--double-buffer")
        for name in ("hls.cfg", "hls.tcl"):
            text = (folder / name).read_text()
            for macro in ("MAX_WIDTH=1920", "MAX_HEIGHT=1080", "BEAT=8", "DOUBLE_BUFFER=true"):
                self.assertEqual(text.count(f"-DSAILMAP_{macro}"), 2, name)

    @skip_without(shutil.which("tclsh"), "tclsh")
    def test_tcl_gives_the_tool_these_commands(self):
        folder = self.generated("sailmap_front_end", "k26", 200)
        commands = ("open_project set_top add_files open_solution set_part create_clock csim_design csynth_design "
                    "cosim_design export_design")
        stubs = f"foreach c {{{commands}}} {{ proc $c args \"puts \\[list $c {{*}}\\$args\\]\" }}\nsource {folder}/hls.tcl\n"
        (self.folder / "stubs.tcl").write_text(stubs)

        def ran(**environment):
            run = subprocess.run(["tclsh", self.folder / "stubs.tcl"], capture_output=True, text=True, check=True,
                                 env={**os.environ, **environment})
            return run.stdout.splitlines()

        lines = ran()
        self.assertEqual([line.split()[0] for line in lines],
                         commands.replace("add_files", "add_files add_files").split())
        self.assertIn("set_top sailmap_front_end", lines)
        self.assertIn("set_part xck26-sfvc784-2LV-c", lines)
        self.assertIn("create_clock -period 200MHz -name default", lines)
        self.assertIn("open_solution solution -flow_target vivado", lines)
        self.assertIn("export_design -format ip_catalog", lines)
        self.assertIn(f"csim_design -argv {folder}/vectors.txt", lines)
        for line in lines:
            if line.startswith("add_files"):
                file, flags = re.fullmatch(r"add_files (?:-tb )?(\S+) -cflags \{(.*)\}", line).groups()
                self.assertTrue(Path(file).is_file(), file)
                self.assert_flags(flags)
        self.assertEqual([line for line in ran(SAILMAP_STEPS="synth") if "design" in line], ["csynth_design"])

    def test_wrong_choices_are_one_line(self):
        self.one_line(call("generate.py", "sailmap_sails"), "sailmap_sails", "sailmap_axi")
        self.one_line(call("generate.py", "sailmap_axi", "--part", "xc2064"), "xc2064", "zynq7020")
        self.one_line(call("generate.py", "sailmap_axi", "--clock", 151), "151", "150, 200")
        self.one_line(call("generate.py", "sailmap_axi", "--preset", "cga"), "cga", "qvga")
        self.one_line(call("generate.py", "sailmap_axi", "--beat", 3), "'3'", "1, 2, 4, 8")


class Run(WithFolder):
    def tool(self, name, text):
        """A program that stands in for a tool."""
        (self.folder / "bin").mkdir(exist_ok=True)
        path = self.folder / "bin" / name
        path.write_text("#!/bin/sh\n" + text)
        path.chmod(0o755)
        return path

    def run_with(self, tools, step, top, *more, exit_code=0):
        """What `run` with these tools alone on the PATH said, and what they were told."""
        log = self.folder / "log"
        for name in tools:
            self.tool(name, f'echo "{name} $SAILMAP_STEPS $*" >> {log}\nexit {exit_code}\n')
        compiler = self.tool("compiler", 'while [ "$1" != -o ]; do shift; done\n'
                                         'printf \'#!/bin/sh\\necho "$1 $2" > "$3"\\n\' > "$2"\n/bin/chmod +x "$2"\n')
        result = call("run", step, top, "--folder", self.folder / "jobs", *more, PATH=str(self.folder / "bin"),
                      CXX=str(compiler))
        return result, log.read_text().splitlines() if log.exists() else []

    def test_the_vector_writer_is_made_of_the_sources_that_are_tested_here(self):
        cmake = (ROOT / "testbench" / "vitis" / "CMakeLists.txt").read_text()
        target = re.search(r"add_executable\(vitis_write_vectors ([^)]*)\)", cmake)
        self.assertEqual(target[1].split(), [f"{name}.cpp" for name in vector_writer.SOURCES])

    def test_without_a_tool(self):
        for tools in ([], ["v++"], ["vitis-run"]):
            result, _ = self.run_with(tools, "csim", "sailmap_gains")
            self.one_line(result, "no Vitis HLS", "vitis_hls")
            shutil.rmtree(self.folder / "bin")

    def test_unified_flow(self):
        (code, _, err), told = self.run_with(["v++", "vitis-run", "vitis_hls"], "all", "sailmap_gains", "--beat", "2")
        self.assertEqual((code, err), (0, ""))
        job = self.folder / "jobs" / "sailmap_gains-zynq7020-150MHz-vga-2"
        common = f"--mode hls --config {job}/hls.cfg --work_dir {job}/work"
        self.assertEqual(told, [f"vitis-run  {common} --csim", f"v++  -c {common}", f"vitis-run  {common} --cosim",
                                f"vitis-run  {common} --package"])
        self.assertEqual((job / "vectors.txt").read_text(), "sailmap_gains 2\n")

    def test_older_flow_of_all_tops(self):
        (code, _, err), told = self.run_with(["vitis_hls"], "synth", "all", "--part", "u250", "--clock", "200")
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(told, [f"vitis_hls synth -f {self.folder}/jobs/{top}-u250-200MHz-vga-4/hls.tcl"
                                for top in tables.read_tops()])

    def test_a_failing_tool_is_reported(self):
        result, told = self.run_with(["v++", "vitis-run"], "all", "sailmap_gains", exit_code=3)
        self.one_line(result, "failed: vitis-run", "--csim")
        self.assertEqual(len(told), 1)

    def test_wrong_choices_are_one_line(self):
        self.one_line(call("run", "place", "sailmap_gains"), "place", "csim")
        self.one_line(call("run", "csim", "sailmap_sails"), "sailmap_sails")


@unittest.skipUnless("SAILMAP_VITIS_GAINS" in os.environ, "SAILMAP_VITIS_GAINS is not set")
class Testbench(WithFolder):
    """The compiled test bench of the gains sees what is wrong."""

    def bench(self, text=None):
        path = self.folder / "vectors.txt"
        path.write_text(Path(os.environ["SAILMAP_VITIS_VECTORS"]).read_text() if text is None else text)
        run = subprocess.run([os.environ["SAILMAP_VITIS_GAINS"], path], capture_output=True, text=True, check=False)
        return run.returncode, run.stdout + run.stderr

    def vectors(self):
        return Path(os.environ["SAILMAP_VITIS_VECTORS"]).read_text()

    def test_good_vectors(self):
        code, out = self.bench()
        self.assertEqual(code, 0, out)
        self.assertIn("3 calls, 0 ports wrong", out)

    def test_a_wrong_word_is_seen(self):
        line = re.search(r"words colour_gains 8 (\w+)", self.vectors())
        wrong = self.vectors()[: line.start(1)] + f"{int(line[1], 16) ^ 1:x}" + self.vectors()[line.end(1):]
        self.assertEqual(self.bench(wrong)[0], 1)
        self.assertIn("call 1, colour_gains: 1 of 8 words wrong", self.bench(wrong)[1])

    def test_a_word_not_read_and_one_too_few_are_seen(self):
        more = re.sub(r"words orientation 8(.*)", r"words orientation 9\1 0", self.vectors(), count=1)
        self.assertEqual(self.bench(more)[0], 1)
        self.assertIn("call 1, orientation: words not read", self.bench(more)[1])
        fewer = re.sub(r"words colour_gains 8 \w+", "words colour_gains 7", self.vectors(), count=1)
        self.assertIn("call 1, colour_gains: 8 words, not 7", self.bench(fewer)[1])

    def test_broken_files(self):
        for text in ("", "cull\n", self.vectors()[:20], "call\nwords x 1 0\n"):
            code, out = self.bench(text)
            self.assertEqual(code, 2, text)
            self.assertEqual(len(out.splitlines()), 1)


@unittest.skipUnless("SAILMAP_THROUGHPUT" in os.environ, "SAILMAP_THROUGHPUT is not set")
class Document(unittest.TestCase):
    def test_the_quoted_throughput_is_the_programs(self):
        text = (ROOT / "docs" / "fpga.md").read_text()
        quoted = re.search(r"At 150 MHz:\n\n```\n(.*?)```", text, re.DOTALL)[1].splitlines()
        printed = subprocess.run([os.environ["SAILMAP_THROUGHPUT"]], capture_output=True, text=True, check=True).stdout
        at_150 = printed.split("200 MHz")[0].splitlines()
        self.assertTrue(at_150[0].startswith("150 MHz"))
        self.assertGreater(len(quoted), 3)
        self.assertEqual([line for line in quoted if line not in at_150], [])


if __name__ == "__main__":
    unittest.main()
