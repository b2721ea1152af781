"""The words that a top is fed and must put out: from frames, by the quantised reference."""

import os
import subprocess
from pathlib import Path

from job import ROOT, Fault, checked
from vector_writer import compilation

# Crops of real images, one call after another; widths fit every beat. A kernel takes another size with each call; the
# frames of a network overlap when they have one size.
CROPS = {False: ((96, 80), (72, 67), (128, 64)), True: ((96, 80), (96, 80), (96, 80), (72, 67), (72, 67))}
FULL = (640, 480)  # of the frames whose cycles are counted


def data_folder():
    return Path(os.environ.get("SAILMAP_DATA", ROOT.parent / "shared" / "data"))


def real_images():
    """The first images of the real sequences that are there."""
    images = []
    for sequence in ("rtabmap_corridor", "gardens_point"):
        images += sorted((data_folder() / sequence / "images").rglob("*.[jp][pn]g"))[:3]
    return images


def crop(image, size, path):
    """The middle of an image, enlarged first where it is too small, as PPM."""
    import cv2  # only here: nothing else needs OpenCV

    pixels = cv2.imread(str(image))
    if pixels is None:
        raise Fault(f"{image}: cannot be read")
    width, height = size
    scale = max(1.0, width / pixels.shape[1], height / pixels.shape[0])
    if scale > 1:
        pixels = cv2.resize(pixels, None, fx=scale, fy=scale, interpolation=cv2.INTER_CUBIC)
    y, x = (pixels.shape[0] - height) // 2, (pixels.shape[1] - width) // 2
    cv2.imwrite(str(path), pixels[y:y + height, x:x + width])


def noise(size, seed, path):
    """A frame of a linear congruential generator's bytes."""
    state, samples = seed, bytearray()
    for _ in range(3 * size[0] * size[1]):
        state = (state * 1664525 + 1013904223) % 2**32
        samples.append(state >> 24)
    path.write_bytes(b"P6\n%d %d\n255\n" % size + samples)


class Vectors:
    """Files of vectors in a folder, made when they are asked for."""

    def __init__(self, folder, seconds):
        self.folder, self.seconds = folder, seconds
        folder.mkdir(parents=True, exist_ok=True)
        self.writer = folder / "write_vectors"
        checked(compilation(self.writer), folder / "write_vectors.log", folder, seconds)

    def write(self, job, name, images):
        path = self.folder / f"{job.folder.name}-{name}.txt"
        run = subprocess.run([str(word) for word in (self.writer, job.top.name, job.beat, path, *images)], check=False,
                             capture_output=True, text=True, timeout=self.seconds)
        if run.returncode != 0:
            raise Fault(run.stderr.strip())
        return path

    def small(self, job):
        """Hard edges, noise and a constant frame."""
        return self.write(job, "small", [])

    def real(self, job):
        """Crops of different real images; None where there are none."""
        images = real_images()
        sizes = CROPS[job.is_network]
        if len(images) < len(sizes):
            return None
        crops = [self.folder / f"crop-{i}-{width}x{height}.ppm" for i, (width, height) in enumerate(sizes)]
        for image, size, path in zip(images, sizes, crops):
            crop(image, size, path)
        return self.write(job, "real", crops)

    def full(self, job):
        """A frame of full size, of a network three; real where there are images."""
        images = real_images()
        paths = [self.folder / f"full-{i}.ppm" for i in range(3 if job.is_network else 1)]
        for i, path in enumerate(paths):
            if images:
                crop(images[i], FULL, path)
            else:
                noise(FULL, i, path)
        return self.write(job, "full", paths)
