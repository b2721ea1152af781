"""The stages of a dataflow region as designs of their own.

Yosys does not end with the whole front end flattened. A stage is a module that nothing but its FIFOs touches, so the area
of the region is that of its stages, each flattened by itself, and of what is left without them: FIFOs and start signals.
"""

import re

MODULE = re.compile(r"^module (\S+?)\s*\(.*?^endmodule", re.MULTILINE | re.DOTALL)
INSTANCE = re.compile(r"^\s*([A-Za-z_]\w*)\s+(?:#\(|[A-Za-z_]\w*\s*\()", re.MULTILINE)
# What Bambu names the module of a stage: the mangled function, with an underscore in front of a whole function.
STAGE = re.compile(r"__ZN7sailmap3hls\w+")


class Modules:
    """The modules of a Verilog file and which of them each one uses."""

    def __init__(self, verilog):
        self.text = {match[1]: match[0] for match in MODULE.finditer(verilog)}
        self.uses = {name: {word for word in INSTANCE.findall(text) if word in self.text and word != name}
                     for name, text in self.text.items()}

    def names_below(self, top, without=()):
        """A module and all below it, but not what is below those in `without`."""
        found, left = set(), [top]
        while left:
            name = left.pop()
            if name not in found:
                found.add(name)
                left += [] if name in without else self.uses[name]
        return found

    def stages_named(self, pattern):
        """The modules whose whole name is such."""
        return [name for name in self.text if pattern.fullmatch(name)]

    def below(self, top, without=()):
        """The text of a module and of all below it; of those in `without` only the ports."""
        found = self.names_below(top, without)
        return "\n".join(ports_alone(text) if name in without else text for name, text in self.text.items()
                         if name in found)

    def stages(self, top):
        """The stages of a region: the topmost modules below it that are made of a kernel's function."""
        found, left, seen = [], [top], set()
        while left:
            name = left.pop()
            if name in seen:
                continue
            seen.add(name)
            if STAGE.fullmatch(name):
                found.append(name)
            else:
                left += self.uses[name]
        return sorted(found)


def ports_alone(text):
    """A module as a box of which nothing is known but its ports."""
    head = text[:text.index(");") + 2]
    ports = re.findall(r"^\s*(?:input|output)\b.*?;", text, re.MULTILINE | re.DOTALL)
    return "\n".join(["(* blackbox *)", head, *ports, "endmodule"])


def anonymous(text):
    """The same for modules that differ in names alone: names with a number in them, numbered as they come."""
    names = {}
    return re.sub(r"\b[A-Za-z_]\w*?\d\w*", lambda match: names.setdefault(match[0], f"n{len(names)}"), text)
