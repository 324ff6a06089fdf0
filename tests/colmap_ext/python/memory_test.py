#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras and images from memory give the drawing of the files, to the byte."""

import pickle
import struct
import tempfile
import types
import unittest
from pathlib import Path

import numpy as np

import limn
import scenes

NO_POINT = 2**64 - 1
# Of COLMAP's cameras.bin.
MODELS = {0: ("SIMPLE_PINHOLE", 3), 1: ("PINHOLE", 4), 2: ("SIMPLE_RADIAL", 4), 3: ("RADIAL", 5), 4: ("OPENCV", 8)}


class Rotation:
    def __init__(self, wxyz, has_quat):
        self._wxyz = np.array(wxyz)
        if has_quat:
            self.quat = self._wxyz[[1, 2, 3, 0]]

    def matrix(self):
        w, x, y, z = self._wxyz / np.linalg.norm(self._wxyz)
        return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class Reconstruction:
    """A stand-in for pycolmap.Reconstruction: reads the binary files of a model. `poses` are "qvec" and tvec in old
    versions of pycolmap, then "attributes", since 3.12 "methods"; models of cameras have "names", are "strings", or
    are in "model_name"."""

    def __init__(self, folder, poses="attributes", has_quat=True, models="names"):
        self.cameras, self.images, self.points3D = {}, {}, {}
        with open(folder / "cameras.bin", "rb") as file:
            for _ in range(self._read(file, "<Q")[0]):
                camera_id, model, width, height = self._read(file, "<iiQQ")
                name, count = MODELS[model]
                camera = types.SimpleNamespace(width=width, height=height,
                                               params=np.array(self._read(file, f"<{count}d")))
                if models == "model_name":
                    camera.model_name = name
                else:
                    camera.model = name if models == "strings" else types.SimpleNamespace(name=name)
                self.cameras[camera_id] = camera
        with open(folder / "images.bin", "rb") as file:
            for _ in range(self._read(file, "<Q")[0]):
                image_id, *pose, camera_id = self._read(file, "<I7dI")
                name = b""
                while (byte := file.read(1)) != b"\0":
                    name += byte
                transform = types.SimpleNamespace(rotation=Rotation(pose[:4], has_quat), translation=np.array(pose[4:]))
                points2D = []
                for _ in range(self._read(file, "<Q")[0]):
                    x, y, point_id = self._read(file, "<2dQ")
                    points2D.append(types.SimpleNamespace(xy=np.array([x, y]), point3D_id=point_id,
                                                          has_point3D=lambda value=point_id: value != NO_POINT))
                image = types.SimpleNamespace(name=name.decode(), camera_id=camera_id, points2D=points2D)
                if poses == "qvec":
                    image.qvec, image.tvec = np.array(pose[:4]), np.array(pose[4:])
                else:
                    image.cam_from_world = (lambda value=transform: value) if poses == "methods" else transform
                self.images[image_id] = image
        with open(folder / "points3D.bin", "rb") as file:
            for _ in range(self._read(file, "<Q")[0]):
                point_id, *xyz = self._read(file, "<Q3d")
                color, (error,) = self._read(file, "<3B"), self._read(file, "<d")
                track = [self._read(file, "<II") for _ in range(self._read(file, "<Q")[0])]
                elements = [types.SimpleNamespace(image_id=a, point2D_idx=b) for a, b in track]
                self.points3D[point_id] = types.SimpleNamespace(
                    xyz=np.array(xyz), color=np.array(color, dtype=np.uint8), error=error,
                    track=types.SimpleNamespace(elements=elements))

    @staticmethod
    def _read(file, form):
        return struct.unpack(form, file.read(struct.calcsize(form)))


def compose(one, other):
    """The transform of `other`, then `one`, as w, x, y, z and translation."""
    (w, x, y, z), (a, b, c, d) = one[0], other[0]
    rotation = [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c,
                w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a]
    return rotation, Rotation(one[0], False).matrix() @ other[1] + one[1]


def inverse(pose):
    rotation = np.array(pose[0]) * [1, -1, -1, -1]
    return rotation, -Rotation(rotation, False).matrix() @ pose[1]


class MountedInPairs:
    """The images of a reconstruction, each with a camera of its own, as frames of two on a rig: as files, and as in
    pycolmap from 3.12 on, without its sets of sensors and data. The poses of the images are a little off those that
    rigs and frames compose, to show which are used."""

    def __init__(self, folder):
        self.plain = Reconstruction(folder, poses="qvec")
        self.ids = sorted(self.plain.images)
        self.poses = {i: (list(image.qvec), image.tvec) for i, image in self.plain.images.items()}
        self.pairs = list(zip(self.ids[::2], self.ids[1::2]))
        self.right_from_left = {pair: compose(self.poses[pair[1]], inverse(self.poses[pair[0]])) for pair in self.pairs}
        self.given = {i: (rotation, translation + 0.01) for i, (rotation, translation) in self.poses.items()}

    def reconstruction(self):
        def transform(pose):
            return types.SimpleNamespace(rotation=Rotation(pose[0], True), translation=np.array(pose[1]))

        camera = next(iter(self.plain.cameras.values()))
        cameras = {i: types.SimpleNamespace(**vars(camera), sensor_id=types.SimpleNamespace(type=0, id=i))
                   for i in self.ids}
        images, rigs, frames = {}, {}, {}
        for left, right in self.pairs:
            for i in (left, right):
                images[i] = types.SimpleNamespace(
                    name=self.plain.images[i].name, camera_id=i, frame_id=left + 1000, has_pose=True,
                    cam_from_world=lambda i=i: transform(self.given[i]))
            rigs[left + 500] = types.SimpleNamespace(
                ref_sensor_id=cameras[left].sensor_id,
                is_ref_sensor=lambda sensor, i=left: sensor.id == i,
                sensor_from_rig=lambda sensor, pair=(left, right): transform(self.right_from_left[pair]))
            frames[left + 1000] = types.SimpleNamespace(rig_id=left + 500, rig_from_world=transform(self.poses[left]))
        return types.SimpleNamespace(cameras=cameras, images=images, rigs=rigs, frames=frames)

    def write(self, folder):
        folder.mkdir()
        camera = next(iter(self.plain.cameras.values()))
        model = next(number for number, (name, _) in MODELS.items() if name == camera.model.name)
        count = len(self.ids)
        (folder / "cameras.bin").write_bytes(struct.pack("<Q", count) + b"".join(
            struct.pack(f"<iiQQ{len(camera.params)}d", i, model, camera.width, camera.height, *camera.params)
            for i in self.ids))
        (folder / "images.bin").write_bytes(struct.pack("<Q", count) + b"".join(
            struct.pack("<I7dI", i, *self.given[i][0], *self.given[i][1], i) + self.plain.images[i].name.encode() +
            struct.pack("<xQ", 0) for i in self.ids))
        (folder / "points3D.bin").write_bytes(struct.pack("<Q", 0))
        (folder / "rigs.bin").write_bytes(struct.pack("<Q", len(self.pairs)) + b"".join(
            struct.pack("<IIiIiIB7d", pair[0] + 500, 2, 0, pair[0], 0, pair[1], 1, *pose[0], *pose[1])
            for pair, pose in self.right_from_left.items()))
        (folder / "frames.bin").write_bytes(struct.pack("<Q", len(self.pairs)) + b"".join(
            struct.pack("<II7dIiIQiIQ", left + 1000, left + 500, *self.poses[left][0], *self.poses[left][1], 2,
                        0, left, left, 0, right, right) for left, right in self.pairs))


def links_of(drawing):
    with tempfile.TemporaryDirectory() as folder:
        drawing.save(Path(folder, "drawing.obj"))
        return Path(folder, "drawing.obj").read_bytes()


class Memory(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.options = scenes.small_options()
        cls.scene = limn.open(scenes.DAY, **cls.options)
        cls.of_files = links_of(limn.draw(cls.scene))
        whole = limn.open(scenes.DAY, quality="low", max_image_size=-1)  # images as stored
        cls.images = {name: np.rint(whole.image(name)).astype(np.uint8) for name in whole.names}

    def test_reconstruction_with_files(self):
        reconstruction = Reconstruction(scenes.DAY / "sparse")
        scene = limn.Scene.from_reconstruction(reconstruction, scenes.DAY / "images", **self.options)
        self.assertEqual(links_of(limn.draw(scene)), self.of_files)

    def test_forms_of_reconstructions(self):
        for form in ({"poses": "methods"}, {"poses": "qvec"}, {"has_quat": False}, {"models": "strings"},
                     {"models": "model_name"}):
            for lost in ({"registered": False}, {"has_pose": False}, {"has_pose": lambda: False}):
                with self.subTest(form=form, lost=lost):
                    reconstruction = Reconstruction(scenes.DAY / "sparse", **form)
                    reconstruction.images[1000] = types.SimpleNamespace(name="lost.jpg", **lost)
                    scene = limn.Scene.from_reconstruction(reconstruction, scenes.DAY / "images", **self.options)
                    self.assertEqual((scene.names, scene.num_points), (self.scene.names, self.scene.num_points))
                    for one, other in zip(scene.cameras, self.scene.cameras):
                        np.testing.assert_array_equal(one.K, other.K)
                        np.testing.assert_allclose(one.R, other.R, rtol=0, atol=1e-15)
                        np.testing.assert_array_equal(one.t, other.t)

    def test_rigs(self):
        mounted = MountedInPairs(scenes.DAY / "sparse")
        options = {**self.options, "refine_cameras": 1}
        with tempfile.TemporaryDirectory() as folder:
            mounted.write(Path(folder, "sparse"))
            of_files = limn.open(folder, image_path=scenes.DAY / "images", **options)
            drawing = links_of(limn.draw(of_files))
        scene = limn.Scene.from_reconstruction(mounted.reconstruction(), scenes.DAY / "images", **options)
        for one, other, as_given in zip(scene.cameras, of_files.cameras, self.scene.cameras):
            np.testing.assert_array_equal(one.R, other.R)
            np.testing.assert_array_equal(one.t, other.t)
            np.testing.assert_allclose(one.t, as_given.t, rtol=0, atol=1e-9)
        self.assertEqual(links_of(limn.draw(scene)), drawing)

    def test_panoramas(self):
        width, height = 512, 256
        tiles = (np.arange(width) // 32 + np.arange(height)[:, None] // 32) % 2
        image = (40 + 160 * tiles).astype(np.uint8)
        reconstruction = types.SimpleNamespace(
            cameras={1: types.SimpleNamespace(model_name="EQUIRECTANGULAR", width=width, height=height,
                                              params=[width, height])},
            images={1: types.SimpleNamespace(name="all.pgm", camera_id=1, qvec=[1, 0, 0, 0], tvec=[0, 0, 0])})
        scene = limn.Scene.from_reconstruction(reconstruction, images={"all.pgm": image})
        self.assertEqual(scene.names, [f"all.pgm.part{i:02d}" for i in range(12)])
        edges = limn.extract_edges(scene)
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "all.pgm").write_bytes(b"P5 %d %d 255\n" % (width, height) + image.tobytes())
            of_files = limn.Scene.from_reconstruction(reconstruction, folder)
            for name, camera, other in zip(scene.names, scene.cameras, of_files.cameras):
                self.assertTrue(camera.has_lens)
                np.testing.assert_array_equal(camera.R, other.R)
                np.testing.assert_array_equal(scene.image(name), of_files.image(name))
                self.assertGreater(len(edges[name]), 100)

    def test_reconstruction_with_images_in_memory(self):
        reconstruction = Reconstruction(scenes.DAY / "sparse")
        images = {name: image.copy() for name, image in self.images.items()}
        scene = limn.Scene.from_reconstruction(reconstruction, images=images, **self.options)
        images["view_02.jpg"][:] = 0  # it has copies
        self.assertTrue(np.array_equal(scene.image("view_02.jpg"), self.scene.image("view_02.jpg")))
        self.assertEqual(links_of(limn.draw(scene)), self.of_files)

    def test_arrays(self):
        names = self.scene.names
        as_stored = {"quality": "low", "max_image_size": -1}
        cameras = limn.open(scenes.DAY, image_list_path=self.options["image_list_path"], **as_stored).cameras
        K, R, t = ([getattr(camera, one) for camera in cameras] for one in "KRt")
        options = {**self.options, "image_list_path": None}
        images = [self.images[name] for name in names]
        scene = limn.Scene.from_arrays(images, K, R, t, names=names, **options)
        for one, other in zip(scene.cameras, self.scene.cameras):
            self.assertTrue(np.allclose(one.K, other.K, atol=1e-9))
            self.assertTrue(np.allclose(one.R, other.R, atol=1e-12))
        drawing = limn.draw(scene, box=(-1.25, 1.25, -0.95, 0.95, 0.04, 1.05))
        self.assertGreater(len(drawing.links), 10)
        self.assertIn(names[0], {name for link in drawing.links for name in link.tracks})
        self.assertEqual(limn.align(drawing).alignment.unit, "none")
        # As floating-point numbers and as 16 bits, in COLMAP's pixels: the same.
        half = np.array([[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]])
        again = limn.Scene.from_arrays([image.astype(np.uint16) * 257 for image in images], [k + half for k in K], R,
                                       np.array(t)[:, :, None], names=names, pixel_centers="half", **options)
        self.assertTrue(np.array_equal(again.image(names[0]), scene.image(names[0])))
        self.assertTrue(np.allclose(again.cameras[0].K, scene.cameras[0].K))
        floats = limn.Scene.from_arrays([image / 255.0 for image in images], K, R, t, names=names, **options)
        self.assertTrue(np.allclose(floats.image(names[0]), scene.image(names[0]), atol=1e-3))

    def test_pictures_it_returns_are_pictures_it_takes(self):
        images = [self.scene.image(name) for name in self.scene.names]
        self.assertGreater(max(image.max() for image in images), 1)
        images[0] = images[0] / 300  # a dark one among them
        cameras = self.scene.cameras
        scene = limn.Scene.from_arrays(images, *([getattr(camera, one) for camera in cameras] for one in "KRt"),
                                       names=self.scene.names, **{**self.options, "image_list_path": None})
        for name, image in zip(scene.names, images):
            np.testing.assert_allclose(scene.image(name), image, atol=1e-3)
        with self.assertRaisesRegex(limn.InputError, "a Scene in memory cannot be pickled: "):
            pickle.dumps(scene)

    def test_bad_input(self):
        image, K, R, t = np.zeros((40, 60), np.uint8), np.diag([50, 50, 1]), np.eye(3), np.zeros(3)
        for arrays, text in ((([image], K, 2 * R, [t]), "arrays: image 0: "),
                             (([image], K, R, np.zeros((2, 3))), "^t: must be 1 x 3, not 2 x 3$"),
                             (([image], K, R, 5), "^t: must be 1 x 3, not one number$"),
                             (([image], [[50, 0, 1], [0, 50]], R, t), "^K: must be 1 x 3 x 3 numbers$"),
                             (([image], K, "one", t), "^R: must be 1 x 3 x 3 numbers$"),
                             (([[[1, 2], [3]]], K, R, t), "^image image-0000: must be an array of H x W or"),
                             (([image.astype(int)], K, R, [t]), "^image image-0000: values must be uint8, uint16 or"),
                             (([image - 1.0], K, R, [t]), "^image image-0000: floating-point values must be 0 to 1, or"),
                             (([image + 300.0], K, R, [t]), "^image image-0000: floating-point values must be 0 to 1, or"),
                             (([np.broadcast_to(np.uint8(0), (20000, 20000, 3))] * 9, K, [R] * 9, [t] * 9),
                              "^image image-0000: too large to decode: 20000 x 20000 pixels"),
                             (([np.broadcast_to(np.float32(0), (10**6, 10**6))], K, R, [t]), "too large to decode"),
                             (([np.zeros((4, 5, 2), np.uint8)], K, R, [t]), "must be an array of H x W or H x W x 3$")):
            with self.subTest(text=text), self.assertRaisesRegex(limn.InputError, text):
                limn.Scene.from_arrays(*arrays)
        reconstruction = Reconstruction(scenes.DAY / "sparse")
        with self.assertRaisesRegex(limn.InputError, '^images: none has the name "view_'):
            limn.Scene.from_reconstruction(reconstruction, images={})
        with self.assertRaisesRegex(limn.OptionError, "either image_path or images must be given"):
            limn.Scene.from_reconstruction(reconstruction)
        for name in ("workspace_path", "input_path", "output_path", "model_index"):
            with self.assertRaisesRegex(limn.OptionError, f"^Scene: option '{name}' has no use here$"):
                limn.Scene.from_reconstruction(reconstruction, scenes.DAY / "images", **{name: 0})
        next(iter(reconstruction.cameras.values())).model.name = "MAGIC"
        with self.assertRaisesRegex(limn.InputError, "unknown camera model 'MAGIC'"):
            limn.Scene.from_reconstruction(reconstruction, scenes.DAY / "images")


if __name__ == "__main__":
    unittest.main()
