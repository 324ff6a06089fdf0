# SPDX-License-Identifier: BSD-3-Clause
"""Tests of scripts/blender_truth_files.py: the parts of the Blender script that need no Blender."""

import gzip
import math
import struct
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True

import blender_truth_files as files  # noqa: E402

SAMPLE = ROOT / "datasets" / "sample"


def blender_pixel(settings, size, matrix, point):
    """The pixel, from the top left corner of the frame, at which Blender's camera shows a point. Written from Blender's
    definition: the frame's width is the sensor's, lens and sensor in mm, shifts in widths, y up."""
    offset = [point[i] - matrix[i][3] for i in range(3)]
    x, y, z = (sum(matrix[i][k] * offset[i] for i in range(3)) for k in range(3))
    aspect = settings["pixel_aspect_y"] / settings["pixel_aspect_x"]
    scale = settings["lens"] / files.SENSOR_WIDTH
    right = scale * x / -z - settings["shift_x"]
    up = scale * y / -z - settings["shift_y"]
    return size[0] * (0.5 + right), size[1] / 2 - size[0] * up / aspect


class Cameras(unittest.TestCase):
    def check(self, camera):
        width, height, fx, fy, cx, cy = camera
        quaternion, translation = (0.8, 0.3, -0.4, 0.2), (0.3, -0.2, 1.5)
        matrix = files.camera_matrix(quaternion, translation)
        settings = files.lens_settings(camera)
        for in_cam in ((0, 0, 2), (0.4, -0.3, 1.7), (-0.5, 0.6, 3.1)):
            # A point there in the world: the camera's axes are x, -y, -z of the frame looked along -z.
            point = [matrix[i][3] + in_cam[0] * matrix[i][0] - in_cam[1] * matrix[i][1] - in_cam[2] * matrix[i][2]
                     for i in range(3)]
            x, y = blender_pixel(settings, (width, height), matrix, point)
            self.assertAlmostEqual(x, fx * in_cam[0] / in_cam[2] + cx, places=8)
            self.assertAlmostEqual(y, fy * in_cam[1] / in_cam[2] + cy, places=8)
        self.assertGreaterEqual(min(settings["pixel_aspect_x"], settings["pixel_aspect_y"]), 1)

    def test_principal_point_and_focal_lengths(self):
        self.check((640, 480, 640.0, 640.0, 320.0, 240.0))
        self.check((640, 480, 640.0, 640.0, 316.0, 244.0))
        self.check((480, 640, 700.0, 650.0, 250.5, 300.25))
        self.check((640, 480, 600.0, 690.0, 100.0, 400.0))

    def test_pose_is_that_of_the_world(self):
        w, x, y, z = 0.8, 0.3, -0.4, 0.2
        matrix = files.camera_matrix((w, x, y, z), (0.3, -0.2, 1.5))
        norm = w * w + x * x + y * y + z * z
        # The third row of the rotation is the direction of view in the world: minus Blender's z axis.
        forward = (2 * (x * z - w * y) / norm, 2 * (y * z + w * x) / norm, 1 - 2 * (x * x + y * y) / norm)
        for i in range(3):
            self.assertAlmostEqual(matrix[i][2], -forward[i])
        for k in range(3):
            self.assertAlmostEqual(math.hypot(*(matrix[i][k] for i in range(3))), 1)


class Models(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def write(self, cameras, images="# none\n"):
        (self.folder / "cameras.txt").write_text(cameras)
        (self.folder / "images.txt").write_text(images)
        return self.folder

    def test_binary_and_text_models_of_the_sample_agree(self):
        day, evening = SAMPLE / "day" / "sparse", SAMPLE / "evening" / "sparse" / "0"
        self.assertEqual(list(files.read_cameras(day).values()), [(640, 480, 640.0, 640.0, 316.0, 244.0)])
        self.assertEqual(list(files.read_cameras(evening).values()), list(files.read_cameras(day).values()))
        binary, text = files.read_images(day), files.read_images(evening)
        self.assertEqual([image[0] for image in binary], [f"view_{i:02d}.jpg" for i in range(24)])
        self.assertEqual([image[0] for image in text], [image[0] for image in binary])
        for a, b in zip(binary, text):
            self.assertEqual(a[2:], b[2:])

    def test_text_with_names_of_two_words_and_missing_observations(self):
        folder = self.write("# comment\n7 SIMPLE_PINHOLE 8 6 10 4 3\n",
                            "# comment\n2 1 0 0 0 1 2 3 7 b c.jpg\n\n1 1 0 0 0 4 5 6 7 a.jpg\n1 2 -1 3 4 5\n")
        self.assertEqual(files.read_cameras(folder), {7: (8, 6, 10.0, 10.0, 4.0, 3.0)})
        self.assertEqual([(image[0], image[3]) for image in files.read_images(folder)],
                         [("a.jpg", (4, 5, 6)), ("b c.jpg", (1, 2, 3))])

    def test_distorted_cameras_are_refused(self):
        self.assertEqual(files.read_cameras(self.write("1 OPENCV 8 6 10 11 4 3 0 0 0 0\n"))[1], (8, 6, 10, 11, 4, 3))
        for camera in ("OPENCV 8 6 10 11 4 3 0.1 0 0 0", "OPENCV_FISHEYE 8 6 10 11 4 3 0 0 0 0"):
            with self.assertRaisesRegex(files.InputError, "undistort"):
                files.read_cameras(self.write(f"1 {camera}\n"))

    def test_bad_models_are_refused(self):
        for cameras, reason in (("1 PINHOLE 8 6 10\n", "line 1"), ("1 PINHOLE 8 x 1 2 3 4\n", "line 1"),
                                ("1 SQUARE 8 6 1\n", "SQUARE")):
            with self.assertRaisesRegex(files.InputError, reason):
                files.read_cameras(self.write(cameras))
        with self.assertRaisesRegex(files.InputError, "line 1"):
            files.read_images(self.write("", "1 1 0 0 zero 0 0 0 1 a.jpg\n\n"))
        with self.assertRaisesRegex(files.InputError, "No such file"):
            files.read_images(self.folder / "absent")
        whole = (SAMPLE / "day" / "sparse" / "cameras.bin").read_bytes()
        for length in range(len(whole)):
            (self.folder / "cameras.bin").write_bytes(whole[:length])
            with self.assertRaisesRegex(files.InputError, "ends too early"):
                files.read_cameras(self.folder)
        (self.folder / "cameras.bin").write_bytes(struct.pack("<QIiQQ", 1, 1, 99, 8, 6))
        with self.assertRaisesRegex(files.InputError, "model 99"):
            files.read_cameras(self.folder)


class Curves(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.path = Path(self._folder.name) / "curves.ply"
        self.addCleanup(self._folder.cleanup)

    def test_come_back_as_they_were(self):
        vertices = [(0.1, 2.0, 3.0), (1 / 3, 0.0, 0.0), (9.0, 9.0, 9.0), (1e-9, -5.0, 7.0)]
        files.write_curves(self.path, vertices, [(0, 1), (3, 1)], [4, 6])
        again, edges, links = files.read_curves(self.path)
        self.assertEqual(again, [vertices[0], vertices[1], vertices[3]])
        self.assertEqual((edges, links), ([(0, 1), (2, 1)], [4, 6]))
        self.assertEqual([path.name for path in self.path.parent.iterdir()], ["curves.ply"])

    def test_equal_vertices_become_one(self):
        header = ("ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty uchar red\nproperty float x\n"
                  "property float y\nproperty double z\nelement edge 2\nproperty int vertex1\nproperty uint vertex2\n"
                  "end_header\n")
        rows = b"".join(struct.pack("<Bffd", 7, x, 0, 0) for x in (0, 1, 1, 2))
        self.path.write_bytes(header.encode() + rows + struct.pack("<iIiI", 0, 1, 2, 3))
        self.assertEqual(files.read_curves(self.path),
                         ([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1), (1, 2)], [0, 0]))

    def test_truth_of_the_sample_is_read(self):
        vertices, edges, links = files.read_curves(SAMPLE / "truth" / "curves-visible.ply")
        length = sum(math.dist(vertices[a], vertices[b]) for a, b in edges)
        self.assertGreater(length, 73.4)  # in the region of interest alone
        self.assertEqual(len(edges), len(links))

    def test_bad_files_are_refused(self):
        files.write_curves(self.path, [(0, 0, 0), (1, 1, 1)], [(0, 1)], [0])
        whole = self.path.read_bytes()
        for length in range(len(whole)):
            self.path.write_bytes(whole[:length])
            with self.assertRaises(files.InputError):
                files.read_curves(self.path)
        self.path.write_bytes(whole.replace(b"binary_little_endian", b"ascii"))
        with self.assertRaisesRegex(files.InputError, "binary_little_endian"):
            files.read_curves(self.path)
        self.path.write_bytes(whole.replace(b"int vertex2", b"list int int vertex2"))
        with self.assertRaisesRegex(files.InputError, "list"):
            files.read_curves(self.path)
        for vertex in (-1, 2):
            self.path.write_bytes(whole[:-8] + struct.pack("<ii", vertex, 0))
            with self.assertRaises(files.InputError):
                files.read_curves(self.path)

    def test_unmoved_vertices_keep_their_coordinates(self):
        originals = [(0.1, 1 / 3, 2.0)]
        stored = files.as_floats(originals[0])
        self.assertNotEqual(stored, originals[0])
        self.assertEqual(files.original_or(stored, 0, originals), originals[0])
        self.assertEqual(files.original_or((0.5, 0.5, 0.5), 0, originals), (0.5, 0.5, 0.5))
        for source in (-1, 1):
            self.assertEqual(files.original_or(stored, source, originals), stored)


class Clouds(unittest.TestCase):
    POINTS = [(0.1, 1 / 3, -2.0), (0.1, 1 / 3, -2.0), (1e-9, 5e20, 0.0)]

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def test_come_back_as_they_were(self):
        for name in ("cloud.ply", "cloud.txt"):
            path = self.folder / name
            files.write_cloud(path, self.POINTS)
            self.assertEqual(files.read_cloud(path), self.POINTS)
            packed = self.folder / (name + ".gz")
            packed.write_bytes(gzip.compress(path.read_bytes()))
            self.assertEqual(files.read_cloud(packed), self.POINTS)
            self.assertEqual(files.read_shapes(path)[1:], ([], []))

    def test_faces_and_colors_of_a_scan_are_passed_over(self):
        path = self.folder / "scan.ply"
        header = ("ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                  "property float z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\n"
                  "end_header\n")
        path.write_bytes(header.encode() + struct.pack("<fffBfffB", 1, 2, 3, 9, 4, 5, 6, 9) + b"\1\0\0\0\0")
        self.assertEqual(files.read_cloud(path), [(1, 2, 3), (4, 5, 6)])

    def test_text_with_comments_and_more_columns(self):
        path = self.folder / "cloud.xyz"
        path.write_text("# x y z\n\n1 2 3 255 0 0\n4 5 6\n")
        self.assertEqual(files.read_cloud(path), [(1, 2, 3), (4, 5, 6)])

    def test_bad_files_are_refused(self):
        for name, content, reason in (("a.txt", b"", "no points"), ("a.txt", b"1 2 3\n1 2\n", "line 2"),
                                      ("a.txt", b"1 x 3\n", "line 1"), ("a.txt", b"1 nan 3\n", "point 0"),
                                      ("a.txt.gz", b"1 2 3\n", "gzip"), ("a.ply", b"1 2 3\n", "not a PLY"),
                                      ("a.txt.gz", gzip.compress(b"1 2 3\n" * 99)[:-9], "end")):
            with self.subTest(name=name, content=content), self.assertRaisesRegex(files.InputError, reason):
                (self.folder / name).write_bytes(content)
                files.read_cloud(self.folder / name)
        with self.assertRaisesRegex(files.InputError, "No such file"):
            files.read_cloud(self.folder / "absent.txt")
        for path in (self.folder / "a.obj", self.folder / "absent" / "a.ply"):
            with self.assertRaises(files.InputError):
                files.write_cloud(path, self.POINTS)


if __name__ == "__main__":
    unittest.main()
