"""The FIFOs between the stages of a region: Bambu's, changed in three things.

- Bambu's puts out zeros while it is empty, which costs a LUT for two bits of every word. Its readers look at `empty_n` first
  (their `done_port` waits for it), so this one puts out whatever is in its memory.
- Bambu's are three words deep, whatever a pragma says. That is enough for every one but two: a row of the base level comes in
  the time of one row of level 0, in four of which there is no other. Where it can wait in front of the base level, the stages
  there have all that time for it, and need a filter where they else had four.
- A read that does not wait (try_read in stream.hpp) and finds nothing is forgotten. Bambu's goes on by itself: it takes the
  next word when it comes, for nobody, and the word is lost.
"""

import re

from parts import Modules

FIFO = """module dataflow_fifo(clock, reset, write, read, din, empty_n, full_n, dout);
  parameter QUEUESIZE_LOG=2, BITSIZE_din=1, BITSIZE_dout=1;
  input clock;
  input reset;
  input write;
  input read;
  input [BITSIZE_din-1:0] din;
  output empty_n;
  output full_n;
  output [BITSIZE_dout-1:0] dout;
  reg [QUEUESIZE_LOG-1:0] read_idx, write_idx;
  (* ram_style = "distributed" *) reg [BITSIZE_din-1:0] words [0:((1<<QUEUESIZE_LOG)-1)];
  wire [QUEUESIZE_LOG-1:0] after_write = write_idx + 1'b1;

  assign full_n = after_write != read_idx;
  assign empty_n = write_idx != read_idx;
  assign dout = words[read_idx];

  always @(posedge clock)
    if (write && full_n) words[write_idx] <= din;

  always @(posedge clock)
    if (reset == 1'b0) begin
      read_idx <= 'd0;
      write_idx <= 'd0;
    end else begin
      if (write && full_n) write_idx <= after_write;
      if (read && empty_n) read_idx <= read_idx + 1'b1;
    end
endmodule"""
# The first stage of the base level, and how it reads a FIFO.
FIRST_OF_BASE = re.compile(r"__ZN7sailmap3hls10fork_levelI.*ELi2EEEv\w+")
READER = re.compile(r"(\w+)_bambu_artificial_ParmMgr_Read_fifo_modgen")
# A reader that finds nothing; its argument `in1` is 1 of a read that does not wait.
GOES_ON = re.compile(r"started_0 = \(started \| start_port\) & ~(\w+_empty_n);")
FORGETS = r"started_0 = (started | (start_port & ~in1[0])) & ~\1;"


def address_bits(row):
    """Of a FIFO for a row of the base level: a quarter of it is read while it comes."""
    return max(2, (3 * row // 4).bit_length())


def changed(verilog, row):
    """The Verilog of a region with these FIFOs; `row` is the longest one of the base level."""
    modules = Modules(verilog)
    deep = {reader[1] for stage in modules.stages_named(FIRST_OF_BASE) for module in modules.names_below(stage)
            if (reader := READER.fullmatch(module))}
    verilog = verilog.replace(modules.text["dataflow_fifo"], FIFO)
    for name in sorted(deep):
        verilog, found = re.subn(r"QUEUESIZE_LOG\(2\)(,[^;]*?\) " + name + r" \()", rf"QUEUESIZE_LOG({address_bits(row)})\1",
                                 verilog)
        if found != 1:
            raise ValueError(f"{name}: {found} FIFOs")
    if len(deep) != 2:
        raise ValueError(f"{len(deep)} FIFOs in front of the base level")
    verilog, found = GOES_ON.subn(FORGETS, verilog)
    if found == 0:
        raise ValueError("no FIFO has a reader")
    return verilog
