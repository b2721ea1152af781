"""One top for Bambu: its configuration, its folder, and its Verilog."""

import hashlib
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "vitis"))
import fifos  # noqa: E402
from tables import ROOT, Fault  # noqa: E402

# The part of the Zynq-7020 boards; with VVD Bambu has its delays as Vivado reports them.
DEVICE = "xc7z020-1clg484-VVD"
PERIOD = 10  # ns
# Functions that take turns (SAILMAP_SHARED), by their mangled names: each begins anew every cycle. In a header Bambu finds no
# pragma that says so; names that a top does not have it passes over.
SHARED = [f"_ZN7sailmap3hls{name}" for level in (2, 3, 4) for name in (
    f"15shared_contrastILi{level}EEEjtjjj", f"12gabor_filterILi{level}ELi0EEEijsssssiiiiiiiii",
    f"12gabor_filterILi{level}ELi1EEEijsssssiiiiiiiii")]
SHARED += [f"_ZN7sailmap3hls13shared_columnILi{level}ELi{channel}EEEyytttttj" for level in range(4) for channel in (0, 1)]


def checked(command, log, folder, seconds):
    """Runs a command with its output in a log; a Fault when it fails or lasts too long."""
    words = [str(word) for word in command]
    with open(log, "w", encoding="utf-8") as file:
        try:
            code = subprocess.run(words, check=False, cwd=folder, stdin=subprocess.DEVNULL, stdout=file,
                                  stderr=subprocess.STDOUT, timeout=seconds).returncode
        except subprocess.TimeoutExpired:
            raise Fault(f"{words[0]}: no end after {seconds} s, see {log}") from None
    if code != 0:
        raise Fault(f"{words[0]}: failed, see {log}")


@dataclass(frozen=True)
class Job:
    top: object  # tables.Top
    width: int  # the largest frame
    height: int
    beat: int
    folder: Path
    double_buffer: bool = False

    @property
    def is_network(self):
        """Whether the top is a dataflow region; its stages then start themselves again (bench.hpp)."""
        return "HLS dataflow" in self.top.source.read_text(encoding="utf-8")

    @property
    def takes_ahead(self):
        """Whether the top may take words of the next call (store.hpp)."""
        return self.top.name == "sailmap_store"

    @property
    def verilog(self):
        return self.folder / f"{self.top.name}.v"

    @property
    def options(self):
        macros = {"MAX_WIDTH": self.width, "MAX_HEIGHT": self.height, "BEAT": self.beat,
                  "DOUBLE_BUFFER": str(self.double_buffer).lower()}
        return ["--compiler=I386_CLANG16", "-O2", "--std=c++14", f"-I{ROOT / 'hls/include'}", f"-I{ROOT / 'hls/top'}",
                *(f"-DSAILMAP_{name}={value}" for name, value in macros.items()), f"--top-fname={self.top.name}",
                "--generate-interface=INFER", f"--device-name={DEVICE}", f"--clock-period={PERIOD}", "--hls-div=nr1",
                "--pipelining=" + ",".join(f"{name}=1" for name in SHARED)]

    def digest(self):
        """Of all that the Verilog depends on."""
        hashed = hashlib.sha256(repr(self.options).encode() + Path(fifos.__file__).read_bytes())
        for file in sorted((ROOT / "hls").glob("**/*.[hi]*")) + [self.top.source]:
            hashed.update(file.read_bytes())
        return hashed.hexdigest()

    def generate(self, seconds):
        """C++ to Verilog; nothing when the Verilog of these sources is there already."""
        stamp = self.folder / "digest"
        if self.verilog.exists() and stamp.exists() and stamp.read_text(encoding="utf-8") == self.digest():
            return
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        checked(["bambu", self.top.source, *self.options, "-v2"], self.folder / "bambu.log", self.folder, seconds)
        if not self.verilog.exists():
            raise Fault(f"bambu: no Verilog, see {self.folder / 'bambu.log'}")
        if self.is_network:
            try:
                changed = fifos.changed(self.verilog.read_text(encoding="utf-8"), (self.width + 3) // 4)
            except ValueError as error:
                raise Fault(f"bambu: {error}") from None
            self.verilog.write_text(changed, encoding="utf-8")
        stamp.write_text(self.digest(), encoding="utf-8")

    def module(self):
        """The name of the top module: Bambu keeps the compiler's mangled name. It is the last of the file."""
        return re.findall(r"^module (\S+?)\(", self.verilog.read_text(encoding="utf-8"), re.MULTILINE)[-1]
