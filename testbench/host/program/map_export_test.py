"""sailmap map export, each format read by something that is not sailmap's: graphviz, networkx, Python's csv and json,
and the rules of evo (evo/tools/file_interface.py, evo/core/trajectory.py) and g2o (types/slam3d/edge_se3.cpp)."""

import csv
import io
import json
import os
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

import networkx
import numpy as np
from program_case import ProgramCase, scene, simulated
from scipy.spatial.transform import Rotation

LAPS = [0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5]
ODD_NAMES = ['quote".png', "<&>'.png", "a,b;c.png", "line\nend.png", "back\\slash.png", "&amp;.png", "ü🗺.png"]


def evo_matrix(text, columns):
    """What evo demands of a text trajectory: so many numbers a row, one blank between them, none at the end."""
    rows = list(csv.reader((line for line in text.splitlines() if not line.startswith("#")), delimiter=" "))
    assert rows and all(len(row) == columns for row in rows), rows
    return np.array(rows).astype(float)


def is_rotation(matrix):
    """As evo's is_so3."""
    return np.isclose(np.linalg.det(matrix), 1, atol=1e-6) and np.allclose(matrix @ matrix.T, np.eye(3), atol=1e-6)


def se3(x, y, z, qx, qy, qz, qw):
    out = np.eye(4)
    out[:3, :3] = Rotation.from_quat([qx, qy, qz, qw]).as_matrix()
    out[:3, 3] = x, y, z
    return out


def read_g2o(text):
    """Vertices and edges (from, to, measurement, information) of a 3D pose graph."""
    vertices, edges = {}, []
    for line in text.splitlines():
        tag, *words = line.split(" ")
        if tag == "VERTEX_SE3:QUAT":
            assert len(words) == 8 and abs(np.linalg.norm(np.array(words[4:], float)) - 1) < 1e-9, line
            vertices[int(words[0])] = se3(*map(float, words[1:]))
        else:
            assert tag == "EDGE_SE3:QUAT" and len(words) == 2 + 7 + 21, line
            assert abs(np.linalg.norm(np.array(words[5:9], float)) - 1) < 1e-9, line
            information = np.zeros((6, 6))
            information[np.triu_indices(6)] = np.array(words[9:], float)
            information += np.triu(information, 1).T
            assert np.all(np.linalg.eigvalsh(information) > 0), line
            edges.append((int(words[0]), int(words[1]), se3(*map(float, words[2:9])), information))
    return vertices, edges


class Export(ProgramCase):
    def export(self, *arguments):
        return self.run_program("map", "export", "m.map", *arguments)


class Graphs(Export):
    def setUp(self):
        super().setUp()
        self.write_sequence(LAPS)
        self.run_program("run", "images", "--map", "m.map", "--exclude-recent", "3")

    def test_graphviz_reads_dot(self):
        self.export("--out", "m.dot")
        program = 'N { printf("%s %s\\n", $.name, $.tooltip) } E { printf("%s %s %s\\n", $.tail.name, $.head.name, $.kind) }'
        done = subprocess.run(["gvpr", program, "m.dot"], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        lines = done.stdout.splitlines()
        self.assertEqual([line for line in lines if "png" in line], [f"{i} images/{i}.png" for i in range(6)])
        edges = sorted(line for line in lines if "png" not in line)
        self.assertEqual([e for e in edges if "path" in e], [f"{i} {i + 1} path" for i in range(5)])
        self.assertIn("5 0 loop", edges)

    def test_networkx_reads_graphml(self):
        self.export("--out", "m.graphml")
        graph = networkx.read_graphml(self.folder / "m.graphml")
        whole = json.loads(self.export("--format", "json"))
        self.assertEqual({int(n): d["name"] for n, d in graph.nodes(data=True)}, {n["id"]: n["views"][0]["name"] for n in whole["nodes"]})
        self.assertEqual(
            sorted((*sorted(map(int, e[:2])), e[2]) for e in graph.edges(data="kind")),
            sorted((*sorted((e["from"], e["to"])), e["kind"]) for e in whole["edges"]),
        )

    def test_csv_tables_say_what_json_says(self):
        whole = json.loads(self.export("--format", "json"))
        tables = {}
        for table in ("images", "nodes", "edges", "loops"):
            text = self.export("--format", "csv", "--table", table)
            tables[table] = list(csv.DictReader(io.StringIO(text), strict=True))
        self.assertEqual(self.export("--format", "csv"), self.export("--format", "csv", "--table", "images"))
        self.assertEqual([row["name"] for row in tables["nodes"]], [n["views"][0]["name"] for n in whole["nodes"]])
        self.assertEqual([(int(r["from"]), int(r["to"]), r["kind"]) for r in tables["edges"]], [(e["from"], e["to"], e["kind"]) for e in whole["edges"]])
        self.assertEqual([row["to_name"] for row in tables["edges"]], [f"images/{e['to']}.png" for e in whole["edges"]])
        self.assertEqual([row["reason"] for row in tables["images"]], [i["detection"]["reason"] for i in whole["images"]])
        loops = [i for i in whole["images"] if i["detection"]["reason"] == "accepted"]
        self.assertEqual(len(loops), 6)
        self.assertEqual([float(r["similarity"]) for r in tables["loops"]], [i["detection"]["best"]["similarity"] for i in loops])
        self.assertEqual([(r["image"], r["node"], r["node_name"]) for r in tables["loops"]], [(str(i + 6), str(i), f"images/{i}.png") for i in range(6)])

    def test_g2o_without_poses_is_a_plane_of_unit_steps(self):
        lines = self.export("--format", "g2o").splitlines()
        self.assertEqual(lines[:6], [f"VERTEX_SE2 {i} {i} 0 0" for i in range(6)])
        self.assertEqual(lines[6], "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1")

    def test_options_that_do_not_go_together(self):
        (self.folder / "p.csv").write_text("x,y\n" + "0,0\n" * 12)
        for arguments, fault in {
            ("--format", "tum"): "tum needs --poses",
            ("--out", "m.kitti"): "kitti needs --poses",
            ("--format", "dot", "--poses", "p.csv"): "--poses goes with",
            ("--format", "dot", "--at-nodes"): "--at-nodes",
            ("--format", "dot", "--table", "nodes"): "--table",
            ("--format", "g2o", "--rate", "10"): "--rate goes with --poses",
            ("--format", "g2o", "--join", "time"): "--join goes with --poses",
            ("--format", "dot", "--json"): "--json goes with --out",
            ("--out", "m.xls"): "--format",
        }.items():
            with self.subTest(arguments):
                self.fails("map", "export", "m.map", *arguments, says=fault, code=2)


class OddNames(Export):
    def setUp(self):
        super().setUp()
        for i, name in enumerate(sorted(ODD_NAMES)):
            self.write_image(f"images/{i}.png", scene(i)).rename(self.folder / "images" / name)
        # OpenCV cannot write it and need not.
        self.write_image("images/latin.png", scene(99))
        os.rename(self.folder / "images/latin.png", os.fsencode(self.folder / "images") + b"/caf\xe9.png")
        self.run_program("run", "images", "--map", "m.map")
        self.names = {f"images/{name}" for name in ODD_NAMES} | {"images/caf\ufffd.png"}

    def test_json(self):
        whole = json.loads(self.export("--format", "json"))
        self.assertEqual({i["name"] for i in whole["images"]}, self.names)

    def test_csv(self):
        for table in ("images", "nodes"):
            rows = list(csv.DictReader(io.StringIO(self.export("--format", "csv", "--table", table), newline=""), strict=True))
            self.assertEqual({row["name"] for row in rows}, self.names)
        rows = list(csv.DictReader(io.StringIO(self.export("--format", "csv", "--table", "edges"), newline=""), strict=True))
        self.assertEqual({row["to_name"] for row in rows} | {row["from_name"] for row in rows}, self.names)

    def test_graphml(self):
        self.export("--out", "m.graphml")
        graph = networkx.read_graphml(self.folder / "m.graphml")
        self.assertEqual({name for _, name in graph.nodes(data="name")}, self.names)

    def test_dot_as_graphviz_draws_it(self):
        self.export("--out", "m.dot")
        svg = subprocess.run(["dot", "-Tsvg", "m.dot"], cwd=self.folder, capture_output=True, check=True)
        self.assertEqual(svg.stderr, b"")
        root = xml.etree.ElementTree.fromstring(svg.stdout)
        titles = {a.get("{http://www.w3.org/1999/xlink}title") for a in root.iter("{http://www.w3.org/2000/svg}a")}
        self.assertEqual(titles, self.names)


class Trajectories(Export):
    """A drive with known poses (TUM), as sailmap simulate writes it."""

    @classmethod
    def setUpClass(cls):
        cls.drive = simulated(cls, "--images", "40", "--images-per-lap", "15")

    def setUp(self):
        super().setUp()
        shutil.copytree(self.drive, self.folder / "s")
        self.run_program("run", "s/images", "--map", "m.map", "--exclude-recent", "5")
        self.truth = np.loadtxt(self.folder / "s/poses.txt")
        self.map = json.loads(self.export("--format", "json"))

    def test_tum_as_evo_reads_it(self):
        matrix = evo_matrix(self.export("--format", "tum", "--poses", "s/poses.txt"), 8)
        self.assertEqual(len(matrix), 40)
        np.testing.assert_array_equal(matrix[:, :4], self.truth[:, :4])
        self.assertTrue(np.all(np.diff(matrix[:, 0]) > 0))
        np.testing.assert_allclose(np.linalg.norm(matrix[:, 4:], axis=1), 1, atol=1e-12)
        turn = Rotation.from_quat(matrix[:, 4:]).inv() * Rotation.from_quat(self.truth[:, 4:])
        self.assertLess(turn.magnitude().max(), 1e-9)

    def test_kitti_as_evo_reads_it(self):
        self.export("--out", "m.kitti", "--poses", "s/poses.txt")
        matrices = evo_matrix((self.folder / "m.kitti").read_text(), 12).reshape(-1, 3, 4)
        self.assertEqual(len(matrices), 40)
        self.assertTrue(all(is_rotation(m[:, :3]) for m in matrices))
        np.testing.assert_allclose(matrices[:, :, 3], self.truth[:, 1:4], atol=1e-12)
        np.testing.assert_allclose(matrices[:, :, :3], Rotation.from_quat(self.truth[:, 4:]).as_matrix(), atol=1e-9)

    def test_from_kitti_to_tum_and_back(self):
        self.export("--out", "m.kitti", "--poses", "s/poses.txt")
        self.fails("map", "export", "m.map", "--format", "tum", "--poses", "m.kitti", says="m.kitti: the poses have no times")
        self.export("--out", "m.tum", "--poses", "m.kitti", "--rate", "4")
        matrix = evo_matrix((self.folder / "m.tum").read_text(), 8)
        np.testing.assert_allclose(matrix[:, 0], np.arange(40) / 4)
        self.export("--out", "again.kitti", "--poses", "m.tum")
        first, again = (evo_matrix((self.folder / name).read_text(), 12) for name in ("m.kitti", "again.kitti"))
        np.testing.assert_allclose(first, again, atol=1e-12)
        self.fails("map", "export", "m.map", "--format", "tum", "--poses", "m.tum", "--rate", "4", says="--rate is for those without")

    def test_csv_poses(self):
        matrix = evo_matrix(self.export("--format", "kitti", "--poses", "s/poses.csv"), 12).reshape(-1, 3, 4)
        np.testing.assert_allclose(matrix[:, :2, 3], self.truth[:, 1:3], atol=1e-12)
        heading = np.loadtxt(self.folder / "s/poses.csv", delimiter=",", skiprows=1)[:, 2]
        np.testing.assert_allclose(matrix[:, 0, 0], np.cos(heading), atol=1e-12)
        np.testing.assert_allclose(matrix[:, 1, 0], np.sin(heading), atol=1e-12)

    def test_at_nodes_a_loop_is_where_its_node_is(self):
        matrix = evo_matrix(self.export("--format", "tum", "--poses", "s/poses.txt", "--at-nodes"), 8)
        first = {n["id"]: n["views"][0]["image"] for n in self.map["nodes"]}
        expected = self.truth[[first[i["node"]] for i in self.map["images"]]]
        np.testing.assert_array_equal(matrix[:, 1:4], expected[:, 1:4])
        np.testing.assert_array_equal(matrix[:, 0], self.truth[:, 0])
        self.assertFalse(np.array_equal(expected, self.truth))

    def test_g2o_is_a_pose_graph_whose_edges_agree_with_the_poses(self):
        vertices, edges = read_g2o(self.export("--format", "g2o", "--poses", "s/poses.txt"))
        poses = [se3(*row[1:]) for row in self.truth]
        first = {n["id"]: n["views"][0]["image"] for n in self.map["nodes"]}
        self.assertEqual(set(vertices), set(first))
        for node, pose in vertices.items():
            np.testing.assert_allclose(pose, poses[first[node]], atol=1e-9)
        self.assertEqual([(a, b) for a, b, *_ in edges], [(e["from"], e["to"]) for e in self.map["edges"]])
        nodes = [i["node"] for i in self.map["images"]]
        loops = 0
        for (a, b, motion, information), edge in zip(edges, self.map["edges"]):
            image = next(k for k in range(1, 40) if (nodes[k - 1], nodes[k]) == (a, b))
            np.testing.assert_allclose(motion, np.linalg.inv(poses[image - 1]) @ poses[image], atol=1e-9)
            np.testing.assert_array_equal(information, np.eye(6))
            # The residual of a loop is how far the images of one place lie apart, of the route never more.
            if edge["kind"] == "loop":
                loops += 1
                residual = np.linalg.inv(motion) @ np.linalg.inv(vertices[a]) @ vertices[b]
                self.assertLess(np.linalg.norm(residual[:3, 3]), 8)
        self.assertGreater(loops, 5)

    def test_joined_by_time(self):
        names = {}
        for i, image in enumerate(sorted((self.folder / "s/images").iterdir())):
            names[i] = self.truth[i, 0] + 1305031102.175
        (self.folder / "timed").mkdir()
        for i, image in enumerate(sorted((self.folder / "s/images").iterdir())):
            image.rename(self.folder / f"timed/{names[i] + 0.01:.3f}.png")
        shifted = self.truth.copy()
        shifted[:, 0] += 1305031102.175
        np.savetxt(self.folder / "p.txt", shifted[np.random.default_rng(1).permutation(40)], fmt="%.9f")
        self.run_program("run", "timed", "--map", "t.map", "--exclude-recent", "5")
        export = ["map", "export", "t.map", "--format", "tum", "--poses", "p.txt", "--join", "time"]
        matrix = evo_matrix(self.run_program(*export), 8)
        np.testing.assert_allclose(matrix[:, :4], shifted[:, :4], atol=1e-6)
        self.fails(*export, "--time-tolerance", "0.005", says="no pose within")
        self.fails("map", "export", "m.map", "--format", "tum", "--poses", "p.txt", "--join", "time", says="no pose within")

    def test_faults_name_the_poses(self):
        (self.folder / "few.txt").write_text("0 0 0 0 0 0 0 1\n")
        self.fails("map", "export", "m.map", "--format", "kitti", "--poses", "few.txt", says="few.txt: 1 poses for 40 images")
        self.fails("map", "export", "m.map", "--format", "kitti", "--poses", "gone.txt", says="gone.txt")
        (self.folder / "bad.txt").write_text("0 0 0 0 0 0 0 7\n")
        self.fails("map", "export", "m.map", "--format", "kitti", "--poses", "bad.txt", says="bad.txt:1:")


if __name__ == "__main__":
    unittest.main()
