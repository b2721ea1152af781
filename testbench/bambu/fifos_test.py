#!/usr/bin/python3
"""scripts/bambu.d/fifos.py without Bambu: what it puts into a Verilog of the same shape, and what it refuses."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "scripts" / "bambu.d"), str(ROOT / "scripts" / "vitis")]

import fifos  # noqa: E402

FORK = "__ZN7sailmap3hls10fork_levelINS0_6ConfigILi640ELi480ELi8ELb0EEELi{level}EEEvR10ac_channelItERS4_"


def reader(name):
    return f"{name}_bambu_artificial_ParmMgr_Read_fifo_modgen"


def module(name, *inside):
    return "\n".join([f"module {name}(clock);", "  input clock;", *inside, "endmodule", ""])


def instance(name, bits):
    return f"  dataflow_fifo #(.QUEUESIZE_LOG(2),\n    .BITSIZE_din({bits}),\n    .BITSIZE_dout({bits})) {name} (.clock(clock));"


def region(level):
    """A region with a fork of this level, which reads two FIFOs of three."""
    fork = FORK.format(level=level)
    return "".join([
        *(module(reader(name), f"    started_0 = (started | start_port) & ~_{name}_empty_n;",
                 f"    done_0 = ( started | start_port) & _{name}_empty_n;") for name in ("DF_1FO0", "DF_2FO0", "DF_3FO0")),
        module(fork, f"  {reader('DF_1FO0')} a (.clock(clock));", f"  {reader('DF_3FO0')} b (.clock(clock));"),
        module("dataflow_fifo", "  assign dout = (write_idx == read_idx) ? 'd0 : circ_fifo[read_idx];"),
        module("top", instance("DF_1FO0", 16), instance("DF_2FO0", 16), instance("DF_3FO0", 64), f"  {fork} f (.clock(clock));")])


class Fifos(unittest.TestCase):
    def test_those_in_front_of_the_base_level_hold_most_of_a_row(self):
        verilog = fifos.changed(region(2), 160)
        for name, log in (("DF_1FO0", 7), ("DF_2FO0", 2), ("DF_3FO0", 7)):
            self.assertRegex(verilog, rf"QUEUESIZE_LOG\({log}\),[^;]*\) {name} \(")

    def test_none_puts_out_zeros(self):
        self.assertNotIn("'d0 : circ_fifo", fifos.changed(region(2), 160))

    def test_a_read_that_does_not_wait_is_forgotten(self):
        verilog = fifos.changed(region(2), 160)
        for name in ("DF_1FO0", "DF_2FO0", "DF_3FO0"):
            self.assertIn(f"started_0 = (started | (start_port & ~in1[0])) & ~_{name}_empty_n;", verilog)
            self.assertIn(f"done_0 = ( started | start_port) & _{name}_empty_n;", verilog)

    def test_readers_of_another_shape_are_refused(self):
        with self.assertRaises(ValueError):
            fifos.changed(region(2).replace("started_0 =", "started_1 ="), 160)

    def test_three_quarters_of_a_row_fit_in(self):
        for row in range(16, 1025):
            self.assertGreaterEqual(2 ** fifos.address_bits(row) - 1, 3 * row // 4)

    def test_a_region_without_that_stage_is_refused(self):
        with self.assertRaises(ValueError):
            fifos.changed(region(3), 160)


if __name__ == "__main__":
    unittest.main()
