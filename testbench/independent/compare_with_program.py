#!/usr/bin/python3
"""Holds the program's reference front end to the independent model of spec_model.py.

    compare_with_program.py SAILMAP_BINARY IMAGE... [--descriptor conspicuity|background]

For each image, runs `sailmap detect IMAGE --frontend reference --save-maps` and compares all fourteen maps (within 1e-9
of each map's maximum, which all but nearly flat images keep), the numbers of local maxima, and the regions. Prints one
line per image with each map's largest error relative to its maximum, and what differs beneath. Exit code 1 when
anything differs, 2 when the program fails.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

import spec_model

TOLERANCE = 1e-9
SINGLE = 2.0**-24  # the program keeps saliency and descriptors in single precision, rounded to nearest


class ProgramFailed(Exception):
    pass


def run_program(binary, image, descriptor, folder):
    command = [binary, "detect", image, "--frontend", "reference", "--save-maps", "--descriptor", descriptor,
               "--out", folder]
    try:
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as fault:
        raise ProgramFailed(fault) from fault
    if run.returncode != 0:
        raise ProgramFailed(f"exit code {run.returncode}: {run.stderr.strip()}")


def relative_error(actual, expected):
    """Of the expected map's maximum; infinite where sizes differ, or a map that should be zero is not."""
    if actual.shape != expected.shape or not np.isfinite(actual).all():
        return np.inf
    error, maximum = np.abs(actual - expected).max(), expected.max()
    return error / maximum if maximum > 0 else (0.0 if error == 0 else np.inf)


def compare_maps(folder, maps):
    errors = {name: relative_error(np.load(folder / f"{name}.npy"), maps[name]) for name in spec_model.MAPS}
    faults = [f"{name} is off by {error:.2e} of its maximum" for name, error in errors.items()
              if not error <= TOLERANCE]
    return errors, faults


def compare_statistics(folder, statistics):
    actual = json.loads((folder / "maps.json").read_text())
    return [f"{name} has {actual[name]['maxima']} local maxima, not {statistics[name]['maxima']}"
            for name in spec_model.FEATURES if actual[name]["maxima"] != statistics[name]["maxima"]]


def descriptor_tolerances(region, maps, descriptor):
    """Both means of a quotient may be off by TOLERANCE of their map's maximum."""
    saliency = maps["saliency"]
    box = spec_model.region_box((region["y"] // 4, region["x"] // 4), saliency.shape)
    outside = np.ones(saliency.shape, bool)
    outside[box] = False
    for kind, features in spec_model.KINDS.items():
        for name in features:
            scale, part = (maps[kind], box) if descriptor == "conspicuity" else (maps[name], outside)
            mean = scale[part].mean()
            yield TOLERANCE * scale.max() / mean if mean > 0 else 0.0


def compare_region(number, actual, expected, maps, descriptor):
    where = [(region["x"], region["y"]) for region in (actual, expected)]
    if where[0] != where[1]:
        return [f"region {number} is at {where[0]}, not {where[1]}"]
    faults = []
    if not abs(actual["saliency"] - expected["saliency"]) <= (TOLERANCE + SINGLE) * maps["saliency"].max():
        faults.append(f"region {number} has saliency {actual['saliency']}, not {expected['saliency']}")
    v, w = np.array(actual["descriptor"]), np.array(expected["descriptor"])
    allowed = np.array(list(descriptor_tolerances(expected, maps, descriptor))) * (1 + w) + SINGLE * w
    if v.shape != w.shape or not (np.abs(v - w) <= allowed).all():
        faults.append(f"region {number} has descriptor {v.tolist()}, not {w.tolist()}")
    return faults


def compare_signatures(actual, expected, maps, descriptor):
    faults = [f"{side} is {actual[side]}, not {expected[side]}" for side in ("width", "height")
              if actual[side] != expected[side]]
    ours, theirs = expected["regions"], actual["regions"]
    if len(ours) != len(theirs):
        return [*faults, f"{len(theirs)} regions, not {len(ours)}"]
    for number, (a, e) in enumerate(zip(theirs, ours)):
        faults += compare_region(number, a, e, maps, descriptor)
    return faults


def compare(binary, image, descriptor):
    """({map: relative error}, faults)"""
    maps, statistics, signature = spec_model.compute(spec_model.read_rgb(image), descriptor)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run_program(binary, image, descriptor, folder)
        errors, faults = compare_maps(folder, maps)
        faults += compare_statistics(folder, statistics)
        actual = json.loads((folder / "regions.json").read_text())
        return errors, faults + compare_signatures(actual, signature, maps, descriptor)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("binary")
    parser.add_argument("images", nargs="+")
    parser.add_argument("--descriptor", choices=("conspicuity", "background"), default="conspicuity")
    arguments = parser.parse_args()

    differing = 0
    for image in arguments.images:
        try:
            errors, faults = compare(arguments.binary, image, arguments.descriptor)
        except ProgramFailed as fault:
            print(f"{image}: {fault}", file=sys.stderr)
            return 2
        differing += bool(faults)
        listed = " ".join(f"{name} {error:.1e}" for name, error in errors.items())
        print(f"{image}: {'DIFFERS' if faults else 'equal'}, {listed}")
        for fault in faults:
            print(f"  {fault}")
    print(f"{len(arguments.images) - differing} of {len(arguments.images)} images equal")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
