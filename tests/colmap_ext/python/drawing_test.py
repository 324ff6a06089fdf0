#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package draws what the program draws; arrays, errors, options. Argument: the program limn."""

import copy
import gc
import json
import os
import pickle
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock
from functools import partial
from pathlib import Path

import numpy as np

import limn
import scenes

PROGRAM = sys.argv.pop(1)
KINDS = ("edge", "paint", "shadow", "contour", "rod", "texture", "unknown")


class Drawings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.before = scenes.files_below(scenes.DAY)
        cls.progress = []
        cls.drawing = limn.draw(scenes.DAY, progress=lambda *state: cls.progress.append(state),
                                **scenes.small_options())
        cls.folder = tempfile.TemporaryDirectory()
        cls.output = Path(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_is_that_of_the_program_to_the_byte(self):
        given = [f"--{name}={value}" for name, value in scenes.small_options().items()]
        subprocess.run([PROGRAM, "automatic_drawer", f"--workspace_path={scenes.DAY}", f"--output_path={self.output}/run",
                        *given], check=True, capture_output=True)
        for name in ("drawing.json", "drawing.ply", "drawing.obj"):
            self.drawing.save(self.output / name)
            self.assertEqual((self.output / name).read_bytes(), (self.output / "run" / name).read_bytes(), name)

    def test_saves_step_by_the_plug_in(self):
        if not (Path(PROGRAM).parent / "lib/limn/plugins/limn_step.so").exists():
            self.skipTest("built without OpenCASCADE")
        self.drawing.save(self.output / "drawing.step")
        self.assertTrue((self.output / "drawing.step").read_bytes().startswith(b"ISO-10303-21;"))

    def test_writes_nothing_unless_told(self):
        self.assertEqual(scenes.files_below(scenes.DAY), self.before)

    def test_writes_like_the_command_with_an_output_path(self):
        folder = self.output / "written"
        drawing = limn.draw(scenes.DAY, output_path=folder, page=False, **scenes.small_options())
        for name in ("drawing.json", "curves/tracks.txt", "curves/project.ini", "curves/overlays/view_00.jpg.png"):
            self.assertTrue((folder / name).exists(), name)
        self.assertEqual(len(drawing.links), len(self.drawing.links))
        self.assertEqual(len(drawing.links[0].tracks), len(self.drawing.links[0].tracks))
        self.assertEqual([one["stage"] for one in drawing.stages], [one["stage"] for one in self.drawing.stages])
        self.assertEqual(drawing.warnings, self.drawing.warnings)
        for name, value in (("project_path", folder / "curves/project.ini"), ("shard", "1/2")):
            with self.assertRaisesRegex(limn.OptionError, f"^{name}: not with output_path"):
                limn.draw(scenes.DAY, output_path=folder, **{name: value})
        self.assertEqual(scenes.files_below(scenes.DAY), self.before)

    def test_tells_progress(self):
        stages = {stage for stage, _, _ in self.progress}
        self.assertGreater(len(stages), 3)
        for stage, done, total in self.progress:
            self.assertIsInstance(stage, str)
            self.assertLessEqual(done, total)

    def test_points_are_read_only_views_that_keep_the_drawing(self):
        drawing = self.drawing.selected("all", tentative=True)
        link = max(drawing.links, key=len)
        points, sigma = link.points, link.sigma
        self.assertEqual((points.dtype, points.shape), (np.float64, (len(link), 3)))
        self.assertEqual(sigma.shape, (len(link),))
        self.assertEqual(points.__array_interface__["data"], link.points.__array_interface__["data"])
        self.assertFalse(points.flags.writeable)
        with self.assertRaises(ValueError):
            points[0, 0] = 1
        copy = points.copy()
        del drawing, link
        gc.collect()
        self.assertTrue(np.array_equal(points, copy))
        length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        self.assertGreater(length, 0)

    def test_links_and_nodes_agree(self):
        drawing = self.drawing
        for link in drawing.links:
            self.assertTrue(np.array_equal(link.points[0], drawing.nodes[link.node0].position))
            self.assertTrue(np.array_equal(link.points[-1], drawing.nodes[link.node1].position))
            self.assertIn((link.id, 0), drawing.nodes[link.node0].link_ends)
            self.assertIn(link.kind, KINDS)
            self.assertEqual(link.rod_radius > 0, link.kind == "rod")
            self.assertTrue(link.confidence == -1 or 0 <= link.confidence <= 1)
            self.assertTrue(link.tri_angle_deg == -1 or 0 <= link.tri_angle_deg <= 90)
            self.assertAlmostEqual(link.length, np.linalg.norm(np.diff(link.points, axis=0), axis=1).sum(), places=9)
        self.assertEqual(sum(node.degree for node in drawing.nodes), 2 * len(drawing.links))
        self.assertEqual(drawing.links[-1].id, len(drawing.links) - 1)
        with self.assertRaises(IndexError):
            drawing.links[len(drawing.links)]
        self.assertIn(f"{len(drawing.links)} links", repr(drawing))

    def test_slices_are_lists(self):
        links = self.drawing.links
        self.assertEqual([link.id for link in links[2:9:3]], [2, 5, 8])
        self.assertEqual([link.id for link in links[::-1]], list(range(len(links)))[::-1])
        self.assertEqual((links[5:5], links[len(links):]), ([], []))
        self.assertEqual([node.id for node in self.drawing.nodes[-2:]], [len(self.drawing.nodes) - k for k in (2, 1)])
        with self.assertRaises(ValueError):
            links[::0]

    def test_objects_come_from_functions_only(self):
        for one in vars(limn._limn).values():
            if isinstance(one, type):
                for make in (one, lambda one=one: one.__new__(one), lambda one=one: object.__new__(one),
                             lambda one=one: type("Mine", (one,), {"__init__": lambda self: None})()):
                    with self.subTest(type=one.__name__), self.assertRaises(TypeError):
                        make()

    def test_copies_are_the_same(self):
        for one in (self.drawing, self.drawing.links, self.drawing.links[0], self.drawing.scene):
            self.assertIs(copy.copy(one), one)
            self.assertIs(copy.deepcopy([one])[0], one)

    def test_pickles(self):
        again = pickle.loads(pickle.dumps(self.drawing))
        for name, drawing in (("one.json", self.drawing), ("other.json", again)):
            drawing.save(self.output / name)
        self.assertEqual((self.output / "one.json").read_bytes(), (self.output / "other.json").read_bytes())
        self.assertIsNone(again.scene)
        links, link, node, shape = pickle.loads(pickle.dumps((self.drawing.links, self.drawing.links[7],
                                                              self.drawing.nodes[3], self.drawing.links[7].primitive)))
        np.testing.assert_array_equal(link.points, self.drawing.links[7].points)
        self.assertEqual((len(links), link.id, node.id), (len(self.drawing.links), 7, 3))
        self.assertEqual(shape.type, self.drawing.links[7].primitive.type)
        camera = pickle.loads(pickle.dumps(self.drawing.cameras[1]))
        for name in ("name", "width", "height", "has_lens"):
            self.assertEqual(getattr(camera, name), getattr(self.drawing.cameras[1], name))
        for name in ("K", "R", "t", "center"):
            np.testing.assert_array_equal(getattr(camera, name), getattr(self.drawing.cameras[1], name))
        scene = pickle.loads(pickle.dumps(self.drawing.scene))
        self.assertEqual(scene.names, self.drawing.scene.names)
        with self.assertRaisesRegex(limn.IoError, "^pickled drawing: "):
            limn._pickles.drawing(b"[]")

    def test_primitives(self):
        lines = [link for link in self.drawing.links if link.primitive and link.primitive.type == "line"]
        self.assertTrue(lines)
        # A line leaves out a hook at a free end of its link.
        shares = []
        for link in lines:
            self.assertIsNone(link.primitive.radius)
            start, end = link.primitive.start, link.primitive.end
            shares.append(np.linalg.norm(start - link.points[0]) / link.length)
            self.assertLess(shares[-1], 0.25)
            self.assertLess(np.linalg.norm(start - link.points[0]), np.linalg.norm(end - link.points[0]))
            if self.drawing.nodes[link.node0].degree > 1:
                self.assertLess(shares[-1], 0.1)
        self.assertLess(np.quantile(shares, 0.9), 0.1)
        for link in self.drawing.links:
            if link.primitive and link.primitive.type == "spline":
                self.assertEqual(len(link.primitive.knots), len(link.primitive.control_points) + 4)

    def test_tracks_are_the_points_in_the_images(self):
        cameras = {camera.name: camera for camera in self.drawing.cameras}
        link = max(self.drawing.links, key=lambda one: len(one.supporting_views))
        self.assertLessEqual(set(link.tracks), set(link.supporting_views))
        compared = 0
        for name, track in link.tracks.items():
            camera = cameras[name]
            in_camera = link.points @ camera.R.T + camera.t
            projected = in_camera @ camera.K.T
            projected = projected[:, :2] / projected[:, 2:]
            # Of the image as it is stored, whatever the size at which it was drawn.
            projected = (projected + 0.5) * np.array([640, 480]) / (camera.width, camera.height) - 0.5
            self.assertEqual(track.shape[1], 2)
            if not np.isnan(track).any() and len(track) == len(projected):
                self.assertLess(np.abs(track - projected).max(), 1e-6)
                compared += 1
        self.assertGreater(compared, 0)
        self.assertEqual(self.drawing.scene.image(name).shape[:2], (camera.height, camera.width))

    def test_refined_cameras_come_with_the_drawing(self):
        folder = self.output / "refined"
        options = scenes.small_options()
        drawing = limn.draw(scenes.DAY, output_path=folder, page=False, refine_cameras=1, **options)
        scene = limn.open(scenes.DAY, **options)
        self.assertFalse(np.array_equal(drawing.cameras[0].t, scene.cameras[0].t))
        read = limn.read_drawing(folder / "drawing.json", scene)
        for camera, again in zip(drawing.cameras, read.cameras):
            self.assertTrue(np.array_equal(camera.t, again.t))
        self.assertTrue(read.links[0].tracks)
        refined = limn.refine_cameras(scenes.DAY, self.output / "cameras", refine_cameras=1, **options)
        for camera, again in zip(drawing.cameras, refined.cameras):
            self.assertTrue(np.array_equal(camera.t, again.t))

    def test_drawing_of_the_given_cameras(self):
        folder = self.output / "given"
        options = dict(scenes.small_options(), refine_cameras=1, output_cameras="given")
        scene = limn.open(scenes.DAY, **scenes.small_options())
        in_folder = limn.draw(scenes.DAY, output_path=folder, page=False, **options)
        for drawing in in_folder, limn.draw(scenes.DAY, **options):
            for camera, given in zip(drawing.cameras, scene.cameras):
                self.assertTrue(np.array_equal(camera.t, given.t))
        self.assertTrue((folder / "refined" / "images.bin").exists())

    def test_read_drawing(self):
        path = self.output / "read.json"
        self.drawing.save(path)
        read = limn.read_drawing(path)
        self.assertEqual(len(read.links), len(self.drawing.links))
        self.assertTrue(np.array_equal(read.links[0].points, self.drawing.links[0].points))
        self.assertEqual(read.options["max_image_size"], 320)
        self.assertEqual(read.cameras, [])
        with self.assertRaisesRegex(limn.InputError, "without its cameras"):
            read.links[0].tracks
        with_scene = limn.read_drawing(path, self.drawing.scene)
        name, track = next(iter(self.drawing.links[0].tracks.items()))
        self.assertTrue(np.allclose(with_scene.links[0].tracks[name], track, equal_nan=True))

    def test_rods_are_center_lines_or_outlines(self):
        path = self.output / "rods.json"
        self.drawing.save(path)
        stored = json.loads(path.read_text())
        rod, outline = stored["links"][:2]
        rod.update(kind="rod", rod_radius=0.125, tentative=False)
        outline.update(kind="edge", tentative=True, doubt="outline of a rod")
        for link in rod, outline:
            link.pop("doubt" if link is rod else "rod_radius", None)
        path.write_text(json.dumps(stored))
        drawing = limn.read_drawing(path)
        self.assertEqual((drawing.links[0].kind, drawing.links[0].rod_radius), ("rod", 0.125))
        self.assertEqual((drawing.links[1].doubt, drawing.links[1].rod_radius), ("outline of a rod", 0))
        rods = drawing.selected("rod").links
        self.assertEqual({link.kind for link in rods}, {"rod"})
        self.assertEqual(rods[0].rod_radius, 0.125)
        outlines = drawing.selected(rods_as_outlines=True).links
        self.assertNotIn("rod", [link.kind for link in outlines])
        self.assertEqual({link.doubt for link in outlines if link.tentative}, {"outline of a rod"})

    def test_contours_tell_round_bodies(self):
        path = self.output / "bodies.json"
        self.drawing.save(path)
        stored = json.loads(path.read_text())
        body = {"shape": "cylinder", "axis": [[0, 0, 1], [0, 0, 3]], "radii": [0.5, 0.5],
                "radius_sigma": 0.125, "rms_px": 0.25}
        stored["links"][0].update(kind="contour", kind_confidence=0.5, body=body, depth_sigma=0.5)
        stored["links"][0].pop("rod_radius", None)
        path.write_text(json.dumps(stored))
        drawing = limn.read_drawing(path)
        contour, other = drawing.links[0], drawing.links[1]
        self.assertEqual((contour.body.shape, contour.body.start_radius, contour.body.end_radius),
                         ("cylinder", 0.5, 0.5))
        self.assertEqual((contour.body.start.tolist(), contour.body.end.tolist()), ([0, 0, 1], [0, 0, 3]))
        self.assertEqual((contour.body.radius_sigma, contour.body.rms_px), (0.125, 0.25))
        self.assertEqual(contour.depth_sigma, 0.5)
        self.assertIsInstance(contour.body, limn.RoundBody)
        self.assertIsNone(other.body)

    def test_detail_is_chosen_by_name(self):
        path = self.output / "texture.json"
        self.drawing.save(path)
        stored = json.loads(path.read_text())
        for link in stored["links"]:
            for name in "tentative", "doubt", "rod_radius":
                link.pop(name, None)
            link.update(kind="edge", curve_px=50)
        stored["links"][0].update(kind="texture", kind_confidence=0.5)
        stored["links"][1].update(curve_px=100.5)
        path.write_text(json.dumps(stored))
        drawing = limn.read_drawing(path)
        self.assertEqual(drawing.links[1].curve_px, 100.5)
        self.assertEqual(len(drawing.selected(detail="all").links), len(drawing.links))
        self.assertEqual({link.kind for link in drawing.selected().links}, {"edge"})
        self.assertEqual([link.curve_px for link in drawing.selected(detail="coarse").links], [100.5])
        with self.assertRaisesRegex(limn.OptionError, "must be coarse, normal or all"):
            drawing.selected(detail="fine")

    def test_export_has_the_options_of_the_command(self):
        path = self.output / "scaled.json"
        limn.export(self.drawing, path, scale=2, kinds="all", tentative=True)
        twice = limn.read_drawing(path)
        self.assertTrue(np.array_equal(twice.links[0].points, 2 * self.drawing.links[0].points))
        limn.export(path, self.output / "of-a-file.dxf", unit="m")
        text = (self.output / "of-a-file.dxf").read_text()
        self.assertRegex(text, r"^ *0\nSECTION\n")
        self.assertRegex(text, r"\n *0\nEOF\n$")
        with self.assertRaisesRegex(limn.OptionError, "^scale = 0: must be >= 1e-12 and <= 1e12$"):
            limn.export(self.drawing, path, scale=0)

    def test_evaluate(self):
        truth = scenes.SAMPLE / "truth/curves-visible.ply"
        report = limn.evaluate(self.drawing, truth, taus=[2, 4], unit="footprint")
        self.assertEqual([row["tau"] for row in report["rows"]], [2, 4])
        self.assertGreater(report["rows"][1]["precision"], 0.5)
        path = self.output / "evaluated.json"
        self.drawing.save(path)
        table = self.output / "table.json"
        subprocess.run([PROGRAM, "drawing_evaluator", f"--input_path={path}", f"--truth_path={truth}", "--taus=0.02",
                        f"--output_json={table}"], check=True, capture_output=True)
        of_file = limn.evaluate(path, truth, taus=0.02)
        self.assertEqual(of_file, json.loads(table.read_text()))
        scores = limn.evaluate(self.drawing, truth, protocol="hss", scale=10)["hss"]
        corners, edges = scores["corner_f1"], scores["edge_iou"]
        self.assertGreater(scores["hss"], 0)
        self.assertAlmostEqual(scores["hss"], 2 * corners * edges / (corners + edges), 12)

    def test_align(self):
        line = next(link for link in self.drawing.links if link.primitive and link.primitive.type == "line")
        length = np.linalg.norm(line.primitive.end - line.primitive.start)
        self.assertIsNone(self.drawing.alignment)
        aligned = limn.align(self.drawing, [f"link {line.id} = {10 * length} m"])
        self.assertEqual((aligned.alignment.unit, aligned.alignment.scale_from), ("m", "lengths"))
        self.assertAlmostEqual(aligned.alignment.scale, 10, delta=1e-6)
        rotation = aligned.alignment.rotation
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-9)
        np.testing.assert_array_equal(aligned.links[0].points, self.drawing.links[0].points)
        path = self.output / "aligned.json"
        aligned.save(path)
        np.testing.assert_array_equal(limn.read_drawing(path).alignment.translation, aligned.alignment.translation)
        limn.export(aligned, self.output / "aligned.obj", aligned=True)
        with self.assertRaisesRegex(limn.InputError, "align: the drawing was read without its workspace"):
            limn.align(limn.read_drawing(path))
        with self.assertRaisesRegex(limn.OptionError, "known_length"):
            limn.align(self.drawing, "link one is long")
        with self.assertRaisesRegex(limn.InputError, "has no alignment"):
            limn.export(self.drawing, self.output / "aligned.obj", aligned=np.True_)
        for stage in (limn.align, limn.refine, limn.regularize, limn.find_faces, limn.fuse):
            with self.assertRaises(TypeError):
                stage(None)

    def test_measure(self):
        link = max((link for link in self.drawing.links if link.primitive and link.primitive.type == "line"), key=lambda link: link.length)
        in_model = limn.measure(self.drawing, f"link {link.id}")
        self.assertEqual(in_model.unit, "none")
        self.assertAlmostEqual(in_model.length, link.length, delta=0.01 * link.length)
        self.assertGreater(in_model.sigma, 0)
        nodes = [self.drawing.nodes[node] for node in (link.node0, link.node1)]
        way = nodes[1].position - nodes[0].position
        way /= np.linalg.norm(way)
        variance = way @ (nodes[0].covariance + nodes[1].covariance) @ way
        self.assertAlmostEqual(in_model.sigma, np.sqrt(variance), delta=0.05 * in_model.sigma)
        between = limn.measure(self.drawing, f"from {link.node0} to {link.node1}")
        self.assertAlmostEqual(between.length, in_model.length, delta=0.01 * link.length)

        aligned = limn.align(self.drawing, [f"link {link.id} = {10 * in_model.length} m"])
        self.assertAlmostEqual(aligned.alignment.scale_sigma, in_model.sigma / in_model.length, delta=1e-9)
        in_world = limn.measure(aligned, f"link {link.id}")
        self.assertEqual(in_world.unit, "m")
        self.assertAlmostEqual(in_world.length, 10 * in_model.length, delta=1e-6)
        # The scale is from the same length: its error once more.
        self.assertAlmostEqual(in_world.sigma, np.sqrt(2) * 10 * in_model.sigma, delta=1e-6)
        self.assertRegex(str(in_world), r"^\S+ \+- \S+ m$")

        name = link.supporting_views[0]
        track = link.tracks[name]
        seen = track[np.isfinite(track).all(axis=1)]
        ends = " to ".join(f"{name} {x + 0.5},{y + 0.5}" for x, y in (seen[0], seen[-1]))
        clicked = limn.measure(self.drawing, ends)
        self.assertAlmostEqual(clicked.length, np.linalg.norm(link.points[-1] - link.points[0]), delta=0.1 * link.length)
        with self.assertRaisesRegex(limn.OptionError, "^measure: link one: must be like"):
            limn.measure(self.drawing, "link one")
        with self.assertRaisesRegex(limn.InputError, "no link 99999"):
            limn.measure(self.drawing, "link 99999")
        unknown = pickle.loads(pickle.dumps(self.drawing))
        with self.assertRaisesRegex(limn.InputError, "pixels need the scene"):
            limn.measure(unknown, ends)

    def test_pickled_alignment(self):
        aligned = limn.align(self.drawing)
        one, other = aligned.alignment, pickle.loads(pickle.dumps(aligned.alignment))
        np.testing.assert_array_equal(one.rotation, other.rotation)
        self.assertEqual((one.scale, one.unit, one.up_from), (other.scale, other.unit, other.up_from))

    def test_regularize(self):
        path, folder = self.output / "irregular.json", self.output / "regular"
        self.drawing.save(path)
        regular = limn.regularize(self.drawing, Regularity={"max_shift_px": 1})
        limn.run("drawing_regularizer", workspace_path=scenes.DAY, drawing_path=path, output_path=folder,
                 Regularity={"max_shift_px": 1}, **scenes.small_options())
        stored = limn.read_drawing(folder / "drawing.json")
        self.assertEqual([link.points.tobytes() for link in stored.links],
                         [link.points.tobytes() for link in regular.links])
        at_once = limn.draw(scenes.DAY, regularize=True, Regularity={"max_shift_px": 1}, **scenes.small_options())
        self.assertEqual([link.points.tobytes() for link in at_once.links],
                         [link.points.tobytes() for link in regular.links])
        regular.save(self.output / "regular.json")
        self.assertEqual(json.loads((self.output / "regular.json").read_text())["regularities"],
                         json.loads((folder / "drawing.json").read_text())["regularities"])

    def test_find_faces(self):
        path, folder = self.output / "faceless.json", self.output / "faced"
        self.drawing.save(path)
        faced = limn.find_faces(self.drawing, Surfaces={"min_width_px": 3})
        self.assertEqual((len(self.drawing.faces), len(faced.links)), (0, len(self.drawing.links)))
        self.assertTrue(faced.faces)
        limn.run("drawing_surfacer", workspace_path=scenes.DAY, drawing_path=path, output_path=folder,
                 Surfaces={"min_width_px": 3}, **scenes.small_options())
        faced.save(self.output / "faced.json")
        self.assertEqual((self.output / "faced.json").read_bytes(), (folder / "drawing.json").read_bytes())
        for face in faced.faces:
            corners = face.vertices[face.triangles]
            self.assertEqual(corners.shape, (len(face.triangles), 3, 3))
            areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
            self.assertAlmostEqual(np.linalg.norm(areas, axis=1).sum(), face.area, places=9)
            self.assertTrue(set(face.views) <= set(faced.views) and 0 < face.confidence <= 1)
            for link, *places in (edge for loop in face.loops for edge in loop if edge[0] is not None):
                self.assertTrue(0 <= min(places) and max(places) <= len(faced.links[link]) - 1)
            if face.surface != "plane":
                self.assertIsNone(face.normal)
                continue
            np.testing.assert_allclose(face.vertices @ face.normal, face.offset, atol=1e-9)
            self.assertGreater(areas.sum(axis=0) @ face.normal, 0)
        with self.assertRaises(ValueError):
            faced.faces[0].triangles[0, 0] = 1
        with self.assertRaisesRegex(limn.OptionError, "^Surfaces.min_views = 0: must be"):
            limn.find_faces(self.drawing, Surfaces={"min_views": 0})
        with self.assertRaisesRegex(limn.InputError, "find_faces: the drawing was read without its workspace"):
            limn.find_faces(limn.read_drawing(path))

    def test_edit(self):
        path, folder = self.output / "unedited.json", self.output / "edited"
        self.drawing.save(path)
        ends = np.linspace(0, 1, 16)
        def ref(points):
            lengths = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
            evenly = [np.interp(ends * lengths[-1], lengths, points[:, axis]) for axis in range(3)]
            return {"id": -1, "closed": False, "points": np.transpose(evenly).tolist()}
        long = max((link for link in self.drawing.links if link.primitive and link.primitive.type == "line"),
                   key=lambda link: link.length)
        middle = ref(long.points)["points"][7]
        edits = self.output / "edits.json"
        edits.write_text(json.dumps({"format": "limn_edits", "format_version": 1, "edits": [
            {"edit": "split", "link": ref(long.points), "at": middle},
            {"edit": "delete", "links": [{"id": 0, "closed": False, "points": [[99, 0, 0], [99, 1, 0]]}]}]}))
        edited = limn.edit(self.drawing, edits)
        self.assertEqual(len(edited.links), len(self.drawing.links) + 1)
        self.assertRegex("\n".join(edited.warnings), r"edits\[1\] \(delete\): not found")
        limn.run("drawing_editor", workspace_path=scenes.DAY, drawing_path=path, output_path=folder, edits=edits,
                 **scenes.small_options())
        stored = limn.read_drawing(folder / "drawing.json")
        self.assertEqual([link.points.tobytes() for link in stored.links],
                         [link.points.tobytes() for link in edited.links])
        with self.assertRaisesRegex(limn.IoError, "nothing.json"):
            limn.edit(self.drawing, self.output / "nothing.json")

    def test_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            limn.run("curve_linker", workspace_path=scenes.DAY, output_path=folder, format="cem", **scenes.small_options())
            self.assertTrue(os.path.exists(os.path.join(folder, "curves/fragments/view_00.jpg.cem")))
            path, table = (os.path.join(folder, name) for name in ("drawing.json", "table.csv"))
            self.drawing.save(path)
            limn.run("drawing_evaluator", input_path=path, truth_path=scenes.SAMPLE / "truth/curves-visible.ply",
                     taus=0.02, output_csv=table)
            self.assertTrue(os.path.exists(table))
            with self.assertRaisesRegex(limn.OptionError, "output_path must be given"):
                limn.run("model_importer", input_path=folder)
        with self.assertRaisesRegex(limn.OptionError, "^unknown command 'nonsense'$"):
            limn.run("nonsense")

    def test_networkx(self):
        try:
            import networkx
        except ImportError:
            with self.assertRaisesRegex(ImportError, "networkx"):
                self.drawing.to_networkx()
            self.skipTest("networkx is not installed")
        graph = self.drawing.to_networkx()
        self.assertEqual(graph.number_of_edges(), len(self.drawing.links))
        self.assertEqual(graph.number_of_nodes(), len(self.drawing.nodes))
        self.assertEqual(dict(graph.degree()), {node.id: node.degree for node in self.drawing.nodes})
        self.assertIsInstance(graph, networkx.MultiGraph)

    def test_open3d(self):
        # Debian has no such package: a stand-in for what is used of it.
        stand_in = types.SimpleNamespace(
            geometry=types.SimpleNamespace(LineSet=types.SimpleNamespace),
            utility=types.SimpleNamespace(Vector3dVector=np.asarray, Vector2iVector=np.asarray))
        with unittest.mock.patch.dict(sys.modules, {"open3d": stand_in}):
            lines = self.drawing.to_open3d()
        ends = lines.points[lines.lines]
        self.assertEqual(len(lines.colors), len(lines.lines))
        self.assertAlmostEqual(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum(),
                               sum(link.length for link in self.drawing.links))
        with unittest.mock.patch.dict(sys.modules, {"open3d": None}), self.assertRaisesRegex(ImportError, "open3d"):
            self.drawing.to_open3d()

    def test_step_by_step_gives_the_drawing_of_one_go(self):
        scene = limn.open(scenes.DAY, **scenes.small_options())
        self.assertEqual((len(scene), scene.names[0]), (scenes.NUM_IMAGES, "view_00.jpg"))
        edges = limn.extract_edges(scene)
        self.assertEqual(list(edges), scene.names)
        of_image = edges["view_03.jpg"]
        self.assertEqual(of_image.positions.shape, (len(of_image), 2))
        self.assertLess(of_image.positions[:, 0].max(), of_image.width)
        self.assertEqual(of_image.directions.shape, (len(of_image),))
        curves = limn.link(scene)
        fragments = curves["view_03.jpg"].fragments
        self.assertGreater(len(fragments), 10)
        self.assertLess(max(ids.max() for ids in fragments), len(curves["view_03.jpg"].edges))
        sketch = limn.sketch(curves)
        self.assertEqual(sketch[0].points.shape, sketch[0].tangents.shape)
        self.assertIn(sketch[0].view, scene.names)
        rough = limn.draw(sketch)
        self.assertGreater(len(rough.links), 10)
        drawing = limn.refine(rough)
        whole = limn.draw(scene)
        with tempfile.TemporaryDirectory() as folder:
            for one, name in ((drawing, "steps.obj"), (whole, "whole.obj")):
                one.save(os.path.join(folder, name))
            self.assertEqual(Path(folder, "steps.obj").read_bytes(), Path(folder, "whole.obj").read_bytes())

    def test_options_of_earlier_stages_cannot_change(self):
        scene = limn.open(scenes.DAY, **scenes.small_options())
        with self.assertRaisesRegex(limn.OptionError, "the images and their size"):
            limn.link(scene, max_image_size=200)
        curves = limn.link(scene)
        with self.assertRaisesRegex(limn.OptionError, "another value of EdgeDetection"):
            limn.sketch(curves, EdgeDetection={"sigma_px": 2})
        with self.assertRaisesRegex(limn.OptionError, "Drawing.method"):
            limn.sketch(curves, Drawing={"method": "paper"})

    def test_fuse(self):
        drawing = limn.draw(scenes.DAY, **scenes.small_options())
        self.assertIsNone(drawing.links[0].dense_class)
        fused = limn.fuse(drawing, dense_path=scenes.SAMPLE / "truth/mesh.ply", dense_type="mesh")
        self.assertIn("surface", {link.dense_class for link in fused.links})


    def test_options_without_use(self):
        drawing, truth = self.drawing, scenes.SAMPLE / "truth/curves-visible.ply"
        unknown = self.output / "unknown.json"
        for function, arguments, unused in (
                (limn.open, (scenes.DAY,), ["output_path"]),
                (limn.extract_edges, (drawing.scene,), ["output_path"]),
                (limn.link, (drawing.scene,), ["output_path"]),
                (limn.refine, (drawing,), ["output_path"]),
                (limn.regularize, (drawing,), ["output_path"]),
                (limn.find_faces, (drawing,), ["output_path"]),
                (limn.edit, (drawing, unknown), ["output_path", "drawing_path"]),
                (limn.fuse, (drawing,), ["output_path", "drawing_path", "sparse_spacing_px"]),
                (limn.evaluate, (drawing, truth, 1), ["input_path", "workspace_path", "image_path", "model_index"]),
                (limn.export, (drawing, unknown), ["input_path"])):
            for name in unused:
                text = f"^{function.__name__}: option '{name}' has no use here$"
                with self.subTest(text=text), self.assertRaisesRegex(limn.OptionError, text):
                    function(*arguments, **{name: 1})
        self.assertFalse(unknown.exists())

    def test_options_that_the_function_gives(self):
        file, truth = self.output / "x.json", scenes.SAMPLE / "truth/curves-visible.ply"
        for function, arguments, name in ((limn.open, (scenes.DAY,), "workspace_path"),
                                          (limn.draw, (scenes.DAY,), "workspace_path"),
                                          (partial(limn.draw, output_path=file), (scenes.DAY,), "workspace_path"),
                                          (limn.evaluate, (file, truth, 1), "input_path"),
                                          (limn.export, (file, file), "input_path")):
            with self.assertRaisesRegex(limn.OptionError, f"^option '{name}' is given twice$"):
                function(*arguments, **{name: "b"})

    def test_paths_that_are_no_text(self):
        folder = os.fsencode(self.output) + b"/\xff"
        os.symlink(scenes.DAY, folder)
        for path in (folder, os.fsdecode(folder)):
            self.assertEqual(len(limn.open(path, **scenes.small_options())), scenes.NUM_IMAGES)
        file = os.fsencode(self.output) + b"/\xff.json"
        self.drawing.save(file)
        for path in (file, os.fsdecode(file)):
            self.assertEqual(len(limn.read_drawing(path).links), len(self.drawing.links))
        for path in (b"/nowhere\xff\n", "/nowhere\udcff\n"):
            with self.assertRaisesRegex(limn.IoError, r"^/nowhere\\xff\\x0a: ."):
                limn.read_drawing(path)


class Errors(unittest.TestCase):
    def test_options(self):
        for options, text in (
                ({"max_image_size": 1}, r"^max_image_size = 1: must be -1 or >= 16 and <= 1e5$"),
                ({"nonsense": 1}, r"unknown option '--nonsense'"),
                ({"Drawing": {"nonsense": 1}}, r"unknown option '--Drawing.nonsense'"),
                ({"Drawing.method": "none"}, r"^Drawing.method = none: must be one of \{traced, paper\}$"),
                ({"a=b": 1}, r"^unknown option 'a=b'$"),
                ({"help": True}, "^unknown option 'help'$"),
                ({"help_all": True}, "^unknown option 'help_all'$"),
                ({"help_format": "man"}, "^unknown option 'help_format'$"),
                ({"mask_path": "a\0b"}, "^mask_path: must be without zero bytes$"),
                ({"mask_path": "\ud800"}, r"^mask_path = '.ud800': cannot be encoded$"),
                ({"Drawing": {"method": "paper"}, "Drawing.method": "ours"}, "^option 'Drawing.method' is given twice$"),
                ({"box": [0, 1]}, r"^box = 2 numbers: must be six"),
                ({"quality": object()}, r"^quality = <object.*: must be a number, a text or a path$")):
            with self.subTest(options=options), self.assertRaisesRegex(limn.OptionError, text) as raised:
                limn.draw(scenes.DAY, **options)
            self.assertIsInstance(raised.exception, ValueError)
            self.assertNotIn("\n", str(raised.exception))

    def test_negative_and_empty_values_are_values(self):
        scene = limn.open(scenes.DAY, box=(-1.5, 1.5, -2, 2, -0.5, 3), mask_path="", max_image_size=None, model_index=-1)
        self.assertEqual(len(scene), 24)

    def test_files(self):
        with self.assertRaisesRegex(limn.IoError, "^/nowhere: no such folder") as raised:
            limn.draw("/nowhere")
        self.assertIsInstance(raised.exception, OSError)
        self.assertIsInstance(raised.exception, limn.Error)
        with self.assertRaises(limn.IoError):
            limn.read_drawing("/nowhere.json")

    def test_errors_of_progress_end_the_run(self):
        def fail(stage, done, total):
            raise ZeroDivisionError(stage)
        with self.assertRaises(ZeroDivisionError):
            limn.draw(scenes.DAY, progress=fail, **scenes.small_options())


if __name__ == "__main__":
    unittest.main(verbosity=1)
