"""The program that writes the words of a top's test bench, from the quantised reference (testbench/vitis)."""

import os

from tables import ROOT

SOURCES = ("write_vectors", "kernel_writers", "front_end_writers")
INCLUDES = ("hls/include", "hls/csim/include", "ref/include", "testbench")


def compilation(program):
    """The command that compiles it to `program`: any C++20 compiler, no library."""
    includes = [f"-I{ROOT / path}" for path in INCLUDES]
    return [os.environ.get("CXX", "g++"), "-std=c++20", "-O1", "-Wno-unknown-pragmas", *includes,
            *(ROOT / f"testbench/vitis/{name}.cpp" for name in SOURCES), "-o", program]
