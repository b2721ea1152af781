"""One map and its queries in many orders: where the temporal filter could harm."""

import pathlib

from measuring import eval_table

# Without and with the filter.
FILTER = [
    {"name": "`context`", "method": "context"},
    {"name": "`context`, filter of 10", "method": "context", "temporal": 10},
]


def sequence(name, folder, exclude):
    """A data set of `eval --table`: the images of `folder`/images, in the order of the way."""
    return {"name": name, "folder": str(folder), "source": "images", "ground_truth": "ground_truth.txt",
            "exclude_recent": exclude}  # fmt: skip


def truth_of(folder):
    lines = (pathlib.Path(folder) / "ground_truth.txt").read_text().splitlines()
    pairs = [line.split(":") for line in lines if line and not line.startswith("#")]
    return {int(query): [int(match) for match in matches.split()] for query, matches in pairs}


def traverses(scratch, entry, name, references, queries):
    """A range of images as the map and the `queries` in the order given."""
    folder = pathlib.Path(entry["folder"])
    images = sorted((folder / "images").iterdir())
    truth = truth_of(folder)
    base = scratch / name.replace(" ", "_").replace(",", "")
    for part, numbers in (("reference", references), ("query", queries)):
        base.with_suffix(f".{part}.txt").write_text("".join(f"{images[i]}\n" for i in numbers))
    matches = [[m - references.start for m in truth.get(q, []) if m in references] for q in queries]
    lines = [f"{k}: {' '.join(map(str, numbers))}\n" for k, numbers in enumerate(matches)]
    base.with_suffix(".truth.txt").write_text("".join(lines))
    return {"name": name, "reference": f"{base}.reference.txt", "query": f"{base}.query.txt",
            "ground_truth": f"{base}.truth.txt"}  # fmt: skip


def pieces(numbers, length, chance):
    """Cut into pieces, shuffled, some reversed."""
    parts = [numbers[i : i + length] for i in range(0, len(numbers), length)]
    parts = [part[::-1] if chance.random() < 0.5 else part for part in parts]
    chance.shuffle(parts)
    return [number for part in parts for number in part]


def misleading(first, numbers, chance):
    """What could mislead a filter, by name: (map, queries). The map is the first lap, or the part of it that a robot leaves
    and comes back to."""
    lap = range(first)
    cut = {f"pieces of {length}": (lap, pieces(numbers, length, chance)) for length in (1, 3, 6, 12)}
    return {
        "as it is": (lap, numbers),
        "backwards": (lap, numbers[::-1]),
        "the map's middle alone": (lap[first // 7 : first - first // 5], numbers),
        "the map's first half alone": (lap[: first // 2], numbers),
        "every image twice": (lap, [n for number in numbers for n in (number, number)]),
        "every third image": (lap, numbers[::3]),
        "40 % dropped": (lap, [number for number in numbers if chance.random() >= 0.4]),
        **cut,
    }


def precisions(results):
    """(AP without, AP with the filter) of each data set."""
    return {name: tuple(figures[method["name"]]["average_precision"] for method in FILTER)
            for name, figures in results.items()}  # fmt: skip


def misled(scratch, entry, first, last, chance):
    """{order of the queries: (AP without, AP with the filter)} of a sequence whose first lap is the map, up to image `first`,
    and whose queries are the images from there to `last`."""
    sets = [
        traverses(scratch, entry, f"{entry['name']} {kind}", references, queries)
        for kind, (references, queries) in misleading(first, list(range(first, last)), chance).items()
    ]
    found = precisions(eval_table(scratch, FILTER, sets))
    return {name.removeprefix(entry["name"] + " "): pair for name, pair in found.items()}
