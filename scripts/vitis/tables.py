"""What can be built and for what: tops.csv and parts.csv, and the ports of a top as its header declares them."""

import csv
import re
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TOPS = ROOT / "hls" / "top"

# The presets of hls/include/sailmap/hls/config.hpp: the largest frame.
PRESETS = {"qvga": (320, 240), "vga": (640, 480), "720p": (1280, 720), "1080p": (1920, 1080)}
BEATS = (1, 2, 4, 8)
CLOCKS = (150, 200)  # MHz


class Fault(Exception):
    """One line that names the input and what is wrong with it."""


@dataclass(frozen=True)
class Port:
    name: str
    kind: str  # "stream", "scalar" or "array"
    type: str  # of a word
    extent: str = ""  # of an array


@dataclass(frozen=True)
class Top:
    name: str
    source: Path
    header: Path
    inputs: tuple  # names of streams and arrays
    outputs: tuple  # names of streams and arrays
    scalars: tuple
    what: str


def read_tops():
    """The rows of tops.csv by name."""
    with open(HERE / "tops.csv", newline="", encoding="utf-8") as file:
        return {
            row["top"]: Top(row["top"], TOPS / row["source"], TOPS / row["header"], tuple(row["inputs"].split()),
                            tuple(row["outputs"].split()), tuple(row["scalars"].split()), row["what"])
            for row in csv.DictReader(file)
        }


def read_parts():
    """Device part numbers by short name."""
    with open(HERE / "parts.csv", newline="", encoding="utf-8") as file:
        return {row["name"]: row["part"] for row in csv.DictReader(file)}


def chosen(table, name, what):
    """table[name]; a Fault that lists the names otherwise."""
    if name not in table:
        raise Fault(f"unknown {what} '{name}': one of {', '.join(str(key) for key in table)}")
    return table[name]


def split_parameters(text):
    """The parameters of a declaration: split at the commas outside <>, () and []."""
    parameters, depth = [""], 0
    for character in text:
        depth += {"<": 1, "(": 1, "[": 1, ">": -1, ")": -1, "]": -1}.get(character, 0)
        if character == "," and depth == 0:
            parameters.append("")
        else:
            parameters[-1] += character
    return [" ".join(parameter.split()) for parameter in parameters]


def ports_of(file, function):
    """The ports of `function` as declared or defined in `file`; a Fault when it is not there."""
    text = re.sub(r"//[^\n]*", "", Path(file).read_text(encoding="utf-8"))
    found = re.search(rf"\bvoid\s+{re.escape(function)}\s*\(([^;{{]*)\)\s*[;{{]", text)
    if not found:
        raise Fault(f"{file}: no function {function}")
    return [port_of(parameter, file) for parameter in split_parameters(found.group(1))]


def port_of(parameter, file):
    for kind, pattern in (("stream", r"sailmap::hls::stream<(?P<type>.+)>\s*&\s*(?P<name>\w+)"),
                          ("array", r"(?:const )?(?P<type>\w+) (?P<name>\w+)\[(?P<extent>.+)\]"),
                          ("scalar", r"(?P<type>\w+) (?P<name>\w+)")):
        found = re.fullmatch(pattern, parameter)
        if found:
            return Port(found["name"], kind, found["type"].strip(), found.groupdict().get("extent", ""))
    raise Fault(f"{file}: cannot read the parameter '{parameter}'")
