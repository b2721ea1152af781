#!/usr/bin/env python3
"""Prints the two image files of the strongest loop closure in a map's CSV export, separated by a tab.

Prints nothing when the map has no loop closure or its images are not files (frames of a video or camera).
"""

import csv
import os
import sys


def strongest_loop(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    first_of_node = {row["node"]: row["name"] for row in reversed(rows) if row["new_node"] == "1"}
    loops = [row for row in rows if row["reason"] == "accepted"]
    if not loops:
        return None
    best = max(loops, key=lambda row: float(row["similarity"]))
    pair = (best["name"], first_of_node[best["best_node"]])
    return pair if all(map(os.path.isfile, pair)) else None


if __name__ == "__main__":
    found = strongest_loop(sys.argv[1])
    if found:
        print("\t".join(found))
