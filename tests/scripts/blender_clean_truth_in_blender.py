# SPDX-License-Identifier: BSD-3-Clause
"""Tests of scripts/blender_clean_truth.py inside Blender:

  blender --background --factory-startup --python-exit-code 1 --python blender_clean_truth_in_blender.py
"""

import gzip
import math
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True

import bmesh  # noqa: E402
import bpy  # noqa: E402
from bpy_extras.object_utils import world_to_camera_view  # noqa: E402
from mathutils import Quaternion, Vector  # noqa: E402

import blender_clean_truth as script  # noqa: E402
import blender_truth_files as files  # noqa: E402

SAMPLE = ROOT / "datasets" / "sample"


def colmap_pixel(camera, quaternion, translation, point):
    """The pixel by COLMAP's definition, with Blender's quaternions for the rotation."""
    width, height, fx, fy, cx, cy = camera
    x, y, z = Quaternion(quaternion).normalized().to_matrix() @ Vector(point) + Vector(translation)
    return fx * x / z + cx, fy * y / z + cy


def check_cameras(model, images):
    cameras, views = files.read_cameras(model), files.read_images(model)
    things = script.import_cameras(model, images)
    assert len(things) == len(views) == bpy.context.scene.frame_end
    scene, worst = bpy.context.scene, 0
    for frame, (name, number, quaternion, translation) in enumerate(views, 1):
        scene.frame_set(frame)
        assert scene.camera.name == name, (scene.camera.name, name)
        width, height = cameras[number][:2]
        assert (scene.render.resolution_x, scene.render.resolution_y) == (width, height)
        background = scene.camera.data.background_images[0]
        assert background.image.filepath.endswith(name) and tuple(background.image.size) == (width, height)
        assert background.frame_method == "STRETCH" and scene.camera.data.show_background_images
        for point in ((0, 0, 0.3), (0.5, -0.4, 0.1), (-0.6, 0.2, 0.5)):
            seen = world_to_camera_view(scene, scene.camera, Vector(point))
            x, y = colmap_pixel(cameras[number], quaternion, translation, point)
            worst = max(worst, math.hypot(seen.x * width - x, (1 - seen.y) * height - y))
    # Single precision.
    assert worst < 2e-3, worst
    print(f"cameras: {len(views)}, worst pixel {worst:.6f}")


def check_curves(folder):
    source, target = SAMPLE / "truth" / "curves-visible.ply", folder / "clean.ply"
    thing = script.import_curves(source)
    vertices, edges, links = files.read_curves(source)
    assert script.export_curves(target) == len(edges)
    again, again_edges, again_links = files.read_curves(target)
    assert sorted(again) == sorted(vertices), "coordinates changed"
    assert length(again, again_edges) == length(vertices, edges) and len(set(again_links)) == len(set(links))

    # By hand: the first edge is deleted, a vertex moved.
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.mode_set(mode="EDIT")
    mesh = bmesh.from_edit_mesh(thing.data)
    mesh.edges.ensure_lookup_table()
    mesh.verts.ensure_lookup_table()
    moved = mesh.edges[5].verts[0]
    moved.co = (7.0, 7.0, 7.0)
    bmesh.ops.delete(mesh, geom=[mesh.edges[0]], context="EDGES_FACES")
    bmesh.update_edit_mesh(thing.data)
    assert script.export_curves(target) == len(edges) - 1
    cleaned = files.read_curves(target)
    assert (7.0, 7.0, 7.0) in cleaned[0]
    assert len(set(vertices) - set(cleaned[0])) in (1, 2, 3), "more vertices changed than were touched"

    # A hidden object is left out.
    bpy.ops.object.mode_set(mode="OBJECT")
    thing.hide_set(True)
    refused(lambda: script.export_curves(target), "no visible mesh object has an edge")
    assert files.read_curves(target) == cleaned


def refused(call, reason):
    try:
        call()
    except files.InputError as error:
        assert reason in str(error), error
        return
    raise AssertionError(f"not refused: {reason}")


def check_cloud(folder):
    # A grid in a plane, whose numbers single precision does not have; the last point is there twice.
    points = [(x / 10, y / 10, 1 / 3) for y in range(10) for x in range(10)] + [(0.9, 0.9, 1 / 3)]
    source, curves, same = folder / "scan.txt.gz", folder / "curves.ply", folder / "same.ply"
    with gzip.open(source, "wt") as file:
        file.write("# x y z intensity\n" + "".join("%r %r %r 7\n" % point for point in points))
    files.write_curves(curves, [(0.0, 0.3, 1 / 3), (0.9, 0.3, 1 / 3)], [(0, 1)], [0])
    files.write_cloud(same, [points[1], points[37]])
    for near, distance, expected in ((None, 0, points),
                                     (same, 0, [points[1], points[37]]),
                                     (same, 0.11, [points[i] for i in (0, 1, 2, 11, 27, 36, 37, 38, 47)]),
                                     (curves, 0.01, points[30:40]),
                                     (curves, 0.11, points[20:50])):
        thing = open_alone(source, near, distance)
        for name in ("out.ply", "out.txt"):
            check_export(folder / name, expected)
    check_editing(thing, points, script.tree_of(curves), folder / "edited.ply")

    # Over the input nothing is written, nor if nothing is selected.
    refused(lambda: script.export_cloud(source), "is the input")
    bpy.ops.mesh.select_all(action="DESELECT")
    refused(lambda: script.export_cloud(folder / "none.ply"), "no visible point is selected")
    assert files.read_cloud(source) == points and not (folder / "none.ply").exists()
    bpy.ops.object.mode_set(mode="OBJECT")
    thing.hide_set(True)


def open_alone(source, near, distance):
    if bpy.context.object.mode == "EDIT":
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.context.object.hide_set(True)
    script.open_cloud(source, near, distance)
    assert bpy.context.object.mode == "EDIT"
    return bpy.context.object


def check_export(path, expected):
    assert script.export_cloud(path) == len(expected)
    assert files.read_cloud(path) == expected, path


def check_editing(thing, points, tree, path):
    """By hand, of the selected points 20 to 49: one less, one moved, one deleted, one hidden; one more."""
    mesh = bmesh.from_edit_mesh(thing.data)
    mesh.verts.ensure_lookup_table()
    mesh.verts[20].select_set(False)
    mesh.verts[21].co.z = 7
    mesh.verts[23].hide_set(True)
    mesh.verts[99].select_set(True)
    bmesh.ops.delete(mesh, geom=[mesh.verts[22]], context="VERTS")
    bmesh.update_edit_mesh(thing.data)
    check_export(path, [files.as_floats((*points[21][:2], 7)), *points[24:50], points[99]])
    # Selected again: what is hidden stays so.
    assert script.select_near(thing, tree, 0.11) == 27
    check_export(path, [points[20], *points[24:50]])


def length(vertices, edges):
    return round(sum(math.dist(vertices[a], vertices[b]) for a, b in edges), 9)


def write_odd_model(folder):
    """Pixels that are not square, a principal point far off, pictures upright and across."""
    (folder / "cameras.txt").write_text("1 PINHOLE 640 480 610 690 250 300\n2 PINHOLE 480 640 700 650 260 300\n")
    lines = []
    for number, (name, size) in enumerate((("a.png", (640, 480)), ("b.png", (480, 640))), 1):
        lines += [f"{number} 0.9 0.2 -0.3 0.1 0.1 -0.2 4 {number} {name}", ""]
        picture = bpy.data.images.new(name, *size)
        picture.filepath_raw, picture.file_format = str(folder / name), "PNG"
        picture.save()
        bpy.data.images.remove(picture)
    (folder / "images.txt").write_text("\n".join(lines) + "\n")
    return folder


def main():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    with tempfile.TemporaryDirectory() as folder:
        check_cameras(SAMPLE / "day" / "sparse", SAMPLE / "day" / "images")
        check_curves(Path(folder))
        check_cloud(Path(folder))
        bpy.context.scene.timeline_markers.clear()
        check_cameras(write_odd_model(Path(folder)), Path(folder))
    script.add_export_menu("Limn points (.ply, .txt)", script.export_cloud, Path("clean.ply"))
    assert bpy.ops.export_scene.limn_truth.get_rna_type().name == "Limn points (.ply, .txt)"
    print("passed")


main()
