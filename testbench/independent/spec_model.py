#!/usr/bin/python3
"""The algorithm's specification, sections 1 to 8, once more: straight from the text, by numpy and scipy.

Nothing here was taken from the project's own code, so that agreement means something: filters are scipy.ndimage's with
mode='nearest', interpolation is map_coordinates, orientations are plain two-dimensional 9x9 kernels.

    spec_model.py IMAGE OUTDIR [--descriptor conspicuity|background]

writes one <name>.npy (float64, shape height x width of the base level) for each of the ten feature maps, the three
conspicuity maps and `saliency`; regions.json {width, height, regions: [{x, y, saliency, descriptor}]}; and
maps.json {name: {maximum, maxima}} for the maps that section 7 normalises.

The specification speaks of real numbers, this of doubles. Whether two values are equal (section 7, local maxima;
section 8, the first arg-max in raster order), and whether a value is zero at all, would be decided by rounding noise,
so values nearer than TIE count as equal.
"""

import argparse
import json
import pathlib
import sys

import cv2
import numpy as np
from scipy import ndimage

LEVELS = (2, 3, 4)
RADII = (3, 7)
INTENSITY = ("intensity_on", "intensity_off")
COLOUR = ("green", "blue", "red", "yellow")
ORIENTATION = {"ori_0": 0, "ori_45": 45, "ori_90": 90, "ori_135": 135}
FEATURES = (*INTENSITY, *COLOUR, *ORIENTATION)
KINDS = {"conspicuity_intensity": INTENSITY, "conspicuity_colour": COLOUR,
         "conspicuity_orientation": tuple(ORIENTATION)}
MAPS = (*FEATURES, *KINDS, "saliency")

# Doubles are within about 1e-14 of the real numbers here, and maps that matter are above 1e-4.
TIE = 1e-12


def read_rgb(path):
    """Section 1: 8-bit RGB, H x W x 3, doubles 0..255."""
    bgr = cv2.imread(str(path), cv2.IMREAD_COLOR)
    if bgr is None:
        raise SystemExit(f"{path}: no image")
    height, width = bgr.shape[:2]
    if not (64 <= width <= 4096 and 64 <= height <= 4096):
        raise SystemExit(f"{path}: {width}x{height} is outside 64..4096")
    return bgr[:, :, ::-1].astype(np.float64)


def channels(rgb):
    """Section 2: I and the broadly tuned R, G, B, Y."""
    total = rgb.sum(axis=2)
    bright = total > 76.5
    share = np.where(bright[:, :, None], 3 * rgb / np.where(bright, total, 1)[:, :, None], 0)
    r, g, b = share[:, :, 0], share[:, :, 1], share[:, :, 2]
    tuned = {
        "red": r - (g + b) / 2,
        "green": g - (r + b) / 2,
        "blue": b - (r + g) / 2,
        "yellow": (r + g) / 2 - np.abs(r - g) / 2 - b,
    }
    return {"intensity": total / 765, **{name: np.maximum(0, plane) for name, plane in tuned.items()}}


def pyramid(plane, top):
    """Section 3: levels 0..top of one channel."""
    binomial = np.array([1, 4, 6, 4, 1]) / 16
    levels = [plane]
    for _ in range(top):
        blurred = ndimage.correlate1d(levels[-1], binomial, axis=0, mode="nearest")
        blurred = ndimage.correlate1d(blurred, binomial, axis=1, mode="nearest")
        levels.append(blurred[::2, ::2])
    return levels


def centre_surround(plane):
    """Section 4: (on, off), summed over the radii."""
    on, off = np.zeros_like(plane), np.zeros_like(plane)
    for radius in RADII:
        side = 2 * radius + 1
        ones = np.ones(side)
        window = ndimage.correlate1d(plane, ones, axis=0, mode="nearest")
        window = ndimage.correlate1d(window, ones, axis=1, mode="nearest")
        surround = (window - plane) / (side * side - 1)
        on += np.maximum(0, plane - surround)
        off += np.maximum(0, surround - plane)
    return on, off


def gabor_pair(degrees):
    """Section 5: the even and odd 9x9 kernels of one orientation."""
    y, x = np.mgrid[-4:5, -4:5].astype(np.float64)
    theta = np.deg2rad(degrees)
    u = x * np.cos(theta) + y * np.sin(theta)
    gauss = np.exp(-(x * x + y * y) / (2 * (7 / 3) ** 2))
    even = gauss * np.cos(2 * np.pi * u / 7)
    even -= gauss * even.sum() / gauss.sum()
    odd = gauss * np.sin(2 * np.pi * u / 7)
    return even / np.abs(even).sum(), odd / np.abs(odd).sum()


def orientation_energy(plane, degrees):
    """Section 5: |even| + |odd|."""
    return sum(np.abs(ndimage.correlate(plane, kernel, mode="nearest")) for kernel in gabor_pair(degrees))


def across_scales(coarse_to_fine):
    """Section 6: the sum of the levels' maps at the base level."""
    total = coarse_to_fine[0]
    for finer in coarse_to_fine[1:]:
        rows, columns = np.mgrid[: finer.shape[0], : finer.shape[1]] / 2
        total = finer + ndimage.map_coordinates(total, [rows, columns], order=1, mode="nearest")
    return total


def zero_noise(feature):
    return np.where(np.abs(feature) < TIE, 0, feature)


def feature_maps(rgb):
    """Sections 2 to 6: {name: map}, in the order of the specification."""
    levels = {name: pyramid(plane, max(LEVELS)) for name, plane in channels(rgb).items()}
    per_level = {name: [] for name in FEATURES}
    for level in sorted(LEVELS, reverse=True):
        on, off = centre_surround(levels["intensity"][level])
        per_level["intensity_on"].append(on)
        per_level["intensity_off"].append(off)
        for name in COLOUR:
            per_level[name].append(centre_surround(levels[name][level])[0])
        for name, degrees in ORIENTATION.items():
            per_level[name].append(orientation_energy(levels["intensity"][level], degrees))
    return {name: zero_noise(across_scales(maps)) for name, maps in per_level.items()}


def count_maxima(plane, tie=TIE):
    """Section 7: m, the local maxima above half of the map's maximum."""
    height, width = plane.shape
    padded = np.pad(plane, 1, constant_values=-np.inf)

    def neighbour(dy, dx):
        return padded[1 + dy : 1 + dy + height, 1 + dx : 1 + dx + width]

    peak = plane > plane.max() / 2 + tie
    for dy, dx in ((-1, -1), (-1, 0), (-1, 1), (0, -1)):
        peak &= plane > neighbour(dy, dx) + tie
    for dy, dx in ((0, 1), (1, -1), (1, 0), (1, 1)):
        peak &= plane >= neighbour(dy, dx) - tie
    return int(peak.sum())


def normalise(plane):
    """Section 7: (X~, max, m)."""
    maximum = float(plane.max())
    if maximum <= 0:
        return np.zeros_like(plane), 0.0, 0
    m = count_maxima(plane)
    return plane / (maximum * np.sqrt(m)), maximum, m


def region_box(peak, shape):
    """Section 8: the 10x10 box as slices, cut at the border."""
    return tuple(slice(max(0, p - 5), min(n, p + 5)) for p, n in zip(peak, shape))


def find_peaks(saliency):
    """Section 8: [(y, x, S)], box inhibition of return."""
    left = saliency.copy()
    msr = left.max()
    peaks = []
    while len(peaks) < 20:
        best = left.max()
        if best <= 0 or (peaks and best <= msr / 4 + TIE):
            break
        y, x = np.unravel_index(np.argmax(left >= best - TIE), left.shape)
        peaks.append((int(y), int(x), float(saliency[y, x])))
        left[region_box((y, x), left.shape)] = 0
    return peaks


def ratio(numerator, denominator):
    return float(numerator / denominator) if denominator > 0 else 0.0


def describe(normalised, conspicuities, box, kind):
    """Section 8: eq. 3-4 ('conspicuity') or eq. 5 ('background')."""
    values = []
    for conspicuity, features in KINDS.items():
        for name in features:
            inside = normalised[name][box].mean()
            if kind == "conspicuity":
                values.append(ratio(inside, conspicuities[conspicuity][box].mean()))
            else:
                outside = np.ones(normalised[name].shape, bool)
                outside[box] = False
                values.append(ratio(inside, normalised[name][outside].mean()))
    return values


def compute(rgb, descriptor="conspicuity"):
    """Sections 2 to 8 of an RGB image: (maps {name: array}, statistics {name: {maximum, maxima}}, signature)."""
    maps = feature_maps(rgb)
    statistics = {}

    def normalised_of(name, plane):
        result, maximum, m = normalise(plane)
        statistics[name] = {"maximum": maximum, "maxima": m}
        return result

    normalised = {name: normalised_of(name, maps[name]) for name in FEATURES}
    for kind, features in KINDS.items():
        maps[kind] = sum(normalised[name] for name in features)
    maps["saliency"] = sum(normalised_of(kind, maps[kind]) for kind in KINDS)

    regions = [{"x": 4 * x, "y": 4 * y, "saliency": s,
                "descriptor": describe(normalised, maps, region_box((y, x), maps["saliency"].shape), descriptor)}
               for y, x, s in find_peaks(maps["saliency"])]
    return maps, statistics, {"width": rgb.shape[1], "height": rgb.shape[0], "regions": regions}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("image", type=pathlib.Path)
    parser.add_argument("outdir", type=pathlib.Path)
    parser.add_argument("--descriptor", choices=("conspicuity", "background"), default="conspicuity")
    arguments = parser.parse_args()

    maps, statistics, signature = compute(read_rgb(arguments.image), arguments.descriptor)
    arguments.outdir.mkdir(parents=True, exist_ok=True)
    for name in MAPS:
        np.save(arguments.outdir / f"{name}.npy", maps[name])
    (arguments.outdir / "regions.json").write_text(json.dumps(signature, indent=1) + "\n")
    (arguments.outdir / "maps.json").write_text(json.dumps(statistics, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
