"""Map files in bad circumstances, as a user meets them: damage, full disks, folders that cannot be written."""

import json
import os
import pathlib
import resource
import shutil
import subprocess
import unittest

import cv2
from program_case import SAILMAP, ProgramCase, scene

LAPS = [0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5]


def own_mounts():
    """Whether this user may mount file systems in a namespace of their own."""
    return subprocess.run(["unshare", "-rm", "true"], capture_output=True).returncode == 0


class Upkeep(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence(LAPS)
        self.run_program("run", "images", "--map", "m.map", "--exclude-recent", "3")

    def test_check(self):
        self.assertEqual(self.run_program("map", "check", "m.map"), "m.map: sound, 12 images, 6 nodes\n")
        result = json.loads(self.run_program("map", "check", "m.map", "--json"))
        self.assertEqual((result["sound"], result["images"], result["faults"]), (True, 12, []))
        self.fails("map", "check", "gone.map", says="gone.map: no such file")

    def test_damage_is_found_and_the_rest_recovered(self):
        path = self.folder / "m.map"
        whole = bytearray(path.read_bytes())
        at = whole.rindex(b"images/7.png")
        whole[at + 7] = ord("8")
        path.write_bytes(whole)
        self.fails("map", "info", "m.map", says="m.map: row 7 of table image is damaged")
        self.fails("map", "check", "m.map", says="m.map: damaged, 1 faults; 'sailmap map recover' saves")
        self.fails("run", "images", "--map", "m.map", says="row 7 of table image is damaged")
        printed = self.run_program("map", "recover", "m.map", "--out", "r.map")
        self.assertEqual(printed, "r.map: 11 images and 6 nodes recovered, 1 rows lost\n")
        self.assertIn("sound, 11 images", self.run_program("map", "check", "r.map"))
        self.fails("map", "recover", "m.map", "--out", "r.map", says="r.map: exists already")

    def test_a_log_left_by_a_killed_run_is_read(self):
        running = self.start_program("run", "images", "--map", "k.map", "--exclude-recent", "3")
        running.kill()
        running.communicate()
        self.assertIn("loop closure: image 6", running.first_line)  # committed before it was told
        result = json.loads(self.run_program("map", "check", "k.map", "--json"))
        self.assertTrue(result["sound"])
        self.assertGreaterEqual(result["images"], 7)
        printed = self.run_program("run", "images", "--map", "k.map", "--resume")
        self.assertIn("k.map: 12 images, 6 nodes, 11 edges, 6 loops", printed)

    def test_merge(self):
        self.write_sequence([9, 8, 2, 3], "other")
        self.run_program("run", "other", "--map", "o.map", "--exclude-recent", "3")
        result = json.loads(self.run_program("map", "merge", "m.map", "o.map", "--out", "n.map", "--json"))
        self.assertEqual((result["images_added"], result["loops_across"]), (4, 2))
        info = json.loads(self.run_program("map", "info", "n.map", "--json"))
        self.assertEqual((info["images"], info["nodes"]), (16, 8))
        self.assertEqual([s["source"] for s in info["sessions"]], ["images", "other"])
        self.run_program("run", "other", "--map", "p.map", "--exclude-recent", "4")
        self.fails("map", "merge", "m.map", "p.map", "--out", "q.map", says="exclude_recent (3 and 4)")

    def test_prune(self):
        self.write_sequence([3, 4, 5], "later")
        self.run_program("run", "later", "--map", "m.map")
        printed = self.run_program("map", "prune", "m.map", "--unvisited", "1", "--out", "n.map")
        self.assertEqual(printed, "n.map: 3 nodes; 0 joined with the one before, 3 dropped\n")
        self.run_program("map", "prune", "m.map", "--similar", "1e6")
        self.fails("map", "prune", "m.map", says="say --similar or --unvisited", code=2)
        self.run_program("map", "check", "m.map")


class Disks(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write_sequence(LAPS * 3)

    def in_namespace(self, script):
        """Runs a shell script that may mount; sailmap is $0."""
        if not own_mounts():
            self.skipTest("no mounts in a namespace of one's own here")
        return subprocess.run(["unshare", "-rm", "sh", "-c", script, SAILMAP], cwd=self.folder, capture_output=True, text=True)

    def test_a_full_disk_ends_the_run_and_keeps_what_was_written(self):
        (self.folder / "disk").mkdir()
        # 200 kB take the first images; the map is copied out, since the disk goes with the namespace.
        done = self.in_namespace(
            "mount -t tmpfs -o size=400k none disk && $0 run images --map disk/m.map --exclude-recent 3 --thumbnails 400;"
            " code=$?; cp disk/m.map* . ; exit $code"
        )
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("disk/m.map: the disk is full", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        result = json.loads(self.run_program("map", "check", "m.map", "--json"))
        self.assertTrue(result["sound"])
        told = [int(line.split()[3]) for line in done.stdout.splitlines()]
        self.assertGreater(result["images"], max(told, default=0))
        self.run_program("run", "images", "--map", "m.map", "--resume")

    def test_a_limit_on_the_size_of_files_is_told(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (400000, 400000))

        done = subprocess.run([SAILMAP, "run", "images", "--map", "m.map", "--thumbnails", "400"], cwd=self.folder,
                              capture_output=True, text=True, preexec_fn=limit)
        self.assertEqual(done.returncode, 1)
        self.assertIn("m.map: ", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.run_program("map", "check", "m.map")

    def test_a_folder_that_cannot_be_written(self):
        self.run_program("run", "images", "--map", "m.map", "--exclude-recent", "3")
        done = self.in_namespace(
            "mkdir disk && cp m.map disk && mount --bind disk disk && mount -o remount,bind,ro disk &&"
            " $0 map info disk/m.map && $0 run images --map disk/m.map --localise | tail -1; $0 run images --map disk/m.map;"
            " $0 run images --map disk/new.map; $0 map prune disk/m.map --unvisited 1"
        )
        self.assertIn("nodes      6", done.stdout)
        self.assertIn("of 36 images located", done.stdout)
        self.assertEqual(done.stderr.splitlines(), [
            f"sailmap: error: disk/{name}: cannot be written: Read-only file system" for name in ("m.map", "new.map", "m.map")
        ])

    def test_a_map_that_goes_away_during_a_run(self):
        running = self.start_program("run", "images", "--map", "m.map", "--exclude-recent", "3")
        shutil.move(self.folder / "m.map", self.folder / "moved.map")
        running.communicate(timeout=60)
        # On Linux the open file goes on under its new name.
        self.assertTrue(pathlib.Path(self.folder / "moved.map").exists())


class Sources(ProgramCase):
    def test_a_video_that_was_cut_off(self):
        video = cv2.VideoWriter(str(self.folder / "v.avi"), cv2.VideoWriter_fourcc(*"MJPG"), 10, (160, 120))
        for place in range(40):
            video.write(scene(place))
        video.release()
        self.run_program("run", "v.avi", "--map", "whole.map")
        self.assertEqual(self.errors, "")
        whole = (self.folder / "v.avi").read_bytes()
        (self.folder / "v.avi").write_bytes(whole[: len(whole) * 6 // 10])
        self.run_program("run", "v.avi", "--map", "m.map")
        self.assertRegex(self.errors, r"^sailmap: warning: v.avi: ends after \d+ frames, its header says 40\n$")
        images = json.loads(self.run_program("map", "check", "m.map", "--json"))["images"]
        self.assertTrue(10 < images < 40, images)

    def test_a_polite_end(self):
        self.write_sequence([i % 100 for i in range(300)])
        running = self.start_program("run", "images", "--map", "m.map")
        running.terminate()
        rest = running.communicate(timeout=60)[0]
        self.assertEqual(running.returncode, 0)
        images = json.loads(self.run_program("map", "check", "m.map", "--json"))["images"]
        self.assertIn(f"m.map: {images} images", rest)
        self.assertEqual([p.name for p in self.folder.glob("m.map*")], ["m.map"])

    def test_images_that_vanish_during_a_run(self):
        (self.folder / "list.txt").write_text("".join(f"images/{i}.png\n" for i in range(300)))
        self.write_sequence([i % 100 for i in range(300)])
        for options, code in ((["--skip-bad"], 0), ([], 1)):
            with self.subTest(options):
                self.write_sequence([i % 100 for i in range(290, 300)], "again")
                for image in (self.folder / "again").iterdir():
                    shutil.copy(image, self.folder / "images" / f"{290 + int(image.stem)}.png")
                name = f"m{code}.map"
                running = self.start_program("run", "list.txt", "--map", name, *options)  # image 100 or later was used
                for i in range(290, 300):
                    os.remove(self.folder / f"images/{i}.png")
                errors = running.communicate(timeout=120)[1]
                self.assertEqual(running.returncode, code, errors)
                self.assertIn("images/290.png", errors)
                result = json.loads(self.run_program("map", "check", name, "--json"))
                self.assertEqual((result["sound"], result["images"]), (True, 290))


if __name__ == "__main__":
    unittest.main()
