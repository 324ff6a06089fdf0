# SPDX-License-Identifier: BSD-3-Clause
"""Scenes from cameras and images in memory."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Optional

import numpy as np

from limn._limn import MemoryModel, Scene, memory_model
from limn._options import texts_of
from limn.errors import InputError, OptionError

_NO_POINT = np.iinfo(np.uint64).max


def _by(shape: tuple[int, ...]) -> str:
    return " x ".join(map(str, shape)) or "one number"


def _per_image(name: str, values: Any, shape: tuple[int, ...], count: int) -> Any:
    """count x shape, or with a last dimension of 1 more; one value is that of all images."""
    wanted = (count, *shape)
    try:
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{name}: must be {_by(wanted)} numbers") from None
    if array.shape == (*wanted, 1):
        array = array[..., 0]
    if array.shape == shape:
        array = np.broadcast_to(array, wanted)
    if array.shape != wanted:
        raise InputError(f"{name}: must be {_by(wanted)}, not {_by(array.shape)}")
    return array


def _pixels(model: MemoryModel, name: str, image: Any) -> Any:
    try:
        pixels = np.asarray(image)
    except ValueError:  # rows of different lengths
        pixels = np.empty(0)
    if pixels.ndim < 2:
        raise InputError(f"image {name}: must be an array of H x W or H x W x 3")
    model.check_photo(name, pixels)
    return pixels


def _white(images: Iterable[Any]) -> float:
    """The level of white in pictures of floating-point numbers: 255 if any of them is above 2 (a little above 1 is a mistake that is told). They share it, since a
    dark one does not tell."""
    floats = (image for image in images if image.dtype.kind == "f" and image.size)
    return 255 if any((image > 2).any() for image in floats) else 1


def scene_from_arrays(images: Sequence[Any], K: Any, R: Any, t: Any, names: Optional[Sequence[str]] = None,
                      pixel_centers: str = "integer", progress: Any = None, **options: Any) -> Scene:
    """A scene of N images by pinhole cameras x_px = K (R X + t).

    - `images`: arrays H x W or H x W x 3 (RGB) of uint8, uint16, or floating-point numbers: 0 to 1, or, if one of them
      is above 2, 0 to 255, as of Scene.image(). They are copied, and may be as large as files.
    - `K`: 3 x 3 for all or N x 3 x 3, px; `R`: N x 3 x 3; `t`: N x 3, or N x 3 x 1, in the model's unit.
    - `names`: of the images, in the order of which views are numbered; default image-0000 and so on.
    - `pixel_centers`: "integer" if the center of the top-left pixel is (0, 0), as in OpenCV; "half" if it is (0.5, 0.5),
      as in COLMAP.

    Options as of limn.open(). Arrays of other shapes or types, and images of more than 2 GB, raise InputError.
    """
    if pixel_centers not in ("integer", "half"):
        raise OptionError(f"pixel_centers = {pixel_centers}: must be one of {{integer, half}}")
    count = len(images)
    if names is None:
        digits = max(4, len(str(count)))
        names = [f"image-{i:0{digits}d}" for i in range(count)]
    if len(names) != count:
        raise InputError(f"names: {len(names)} for {count} images")
    calibrations = _per_image("K", K, (3, 3), count)
    rotations = _per_image("R", R, (3, 3), count)
    translations = _per_image("t", t, (3,), count)
    model = memory_model(texts_of(options))
    pictures = [_pixels(model, name, image) for name, image in zip(names, images)]
    white = _white(pictures)
    for name, pixels, calibration, rotation, translation in zip(names, pictures, calibrations, rotations, translations):
        model.add_view(name, calibration, rotation, translation, pixels.shape[1], pixels.shape[0])
        model.add_photo(name, pixels, white)
    return model.open("", pixel_centers == "half", progress)


def _value(attribute: Any) -> Any:
    """What was an attribute in earlier versions of pycolmap may be a method in later ones."""
    return attribute() if callable(attribute) else attribute


def _transform(pose: Any) -> tuple[Any, Any]:
    """Rotation (quaternion w, x, y, z or a matrix) and translation of an object like pycolmap.Rigid3d."""
    quaternion = getattr(pose.rotation, "quat", None)
    if quaternion is None:
        return np.asarray(pose.rotation.matrix()), np.asarray(pose.translation)
    x, y, z, w = np.asarray(quaternion)
    return np.array([w, x, y, z]), np.asarray(pose.translation)


def _pose(image: Any) -> tuple[Any, Any]:
    if hasattr(image, "cam_from_world"):
        return _transform(_value(image.cam_from_world))
    return np.asarray(image.qvec), np.asarray(image.tvec)


def _model_name(camera: Any) -> str:
    if hasattr(camera, "model_name"):
        return str(camera.model_name)
    return str(getattr(camera.model, "name", camera.model))


def _point_ids(points2D: Iterable[Any]) -> Any:
    ids = [point.point3D_id if _value(getattr(point, "has_point3D", True)) else _NO_POINT for point in points2D]
    return np.array(ids, dtype=np.uint64)


def _images_with_pose(reconstruction: Any) -> Iterable[tuple[int, Any]]:
    for image_id, image in sorted(reconstruction.images.items()):
        if _value(getattr(image, "has_pose", getattr(image, "registered", True))):
            yield image_id, image


def _add_images(reconstruction: Any, model: MemoryModel) -> list[str]:
    names = []
    for image_id, image in _images_with_pose(reconstruction):
        points2D = list(getattr(image, "points2D", []))
        positions = np.array([np.asarray(point.xy) for point in points2D], dtype=float).reshape(-1, 2)
        rotation, translation = _pose(image)
        model.add_image(image_id, image.camera_id, image.name, rotation, translation, positions, _point_ids(points2D))
        names.append(image.name)
    return names


def _add_rigs(reconstruction: Any, model: MemoryModel) -> None:
    """Of the images with a pose, in pycolmap from 3.12 on. Its sets of sensors and data cannot be read in all of these
    versions; images, frames and rigs can be asked for their own."""
    images_of_frame: dict[int, list[tuple[int, int]]] = {}
    cameras_of_rig: dict[int, set[int]] = {}
    for image_id, image in _images_with_pose(reconstruction):
        frame = reconstruction.frames[image.frame_id]
        images_of_frame.setdefault(image.frame_id, []).append((image_id, image.camera_id))
        cameras_of_rig.setdefault(frame.rig_id, set()).add(image.camera_id)
    for rig_id, camera_ids in sorted(cameras_of_rig.items()):
        rig = reconstruction.rigs[rig_id]
        reference = rig.ref_sensor_id
        cameras = []
        for camera_id in sorted(camera_ids):
            sensor = reconstruction.cameras[camera_id].sensor_id
            if not rig.is_ref_sensor(sensor):
                cameras.append((camera_id, *_transform(rig.sensor_from_rig(sensor))))
        model.add_rig(rig_id, (int(reference.type), reference.id), cameras)
    for frame_id, images in sorted(images_of_frame.items()):
        frame = reconstruction.frames[frame_id]
        model.add_frame(frame_id, frame.rig_id, *_transform(frame.rig_from_world), images)


def scene_from_reconstruction(reconstruction: Any, image_path: Any = None, images: Optional[Mapping[str, Any]] = None,
                              progress: Any = None, **options: Any) -> Scene:
    """The scene of an object like pycolmap.Reconstruction, which is copied.

    It has the dictionaries cameras (model_name or model, params, width, height), images (name, camera_id,
    cam_from_world, points2D) and points3D (xyz, color, error, track.elements), in COLMAP's conventions; images without a
    pose are left out. From COLMAP 3.12 on also rigs and frames, from which poses of images are composed: images of a
    frame move together when cameras are refined. Either `image_path` is given, the folder of its images, or `images`,
    arrays by name, as of Scene.from_arrays(). Options as of limn.open().
    """
    if (image_path is None) == (images is None):
        raise OptionError("from_reconstruction: either image_path or images must be given")
    model = memory_model(texts_of(options))
    for camera_id, camera in sorted(reconstruction.cameras.items()):
        model.add_camera(camera_id, _model_name(camera), camera.width, camera.height, list(camera.params))
    names = _add_images(reconstruction, model)
    if getattr(reconstruction, "rigs", None):
        _add_rigs(reconstruction, model)
    for point_id, point in sorted(getattr(reconstruction, "points3D", {}).items()):
        track = [(element.image_id, element.point2D_idx) for element in point.track.elements]
        color = [int(value) for value in point.color]
        model.add_point(point_id, point.xyz, color, float(point.error), track)
    if images is not None:
        for name in names:
            if name not in images:
                raise InputError(f"images: none has the name \"{name}\"")
        pictures = {name: _pixels(model, name, images[name]) for name in names}
        white = _white(pictures.values())
        for name, pixels in pictures.items():
            model.add_photo(name, pixels, white)
    return model.open("" if image_path is None else image_path, False, progress)
