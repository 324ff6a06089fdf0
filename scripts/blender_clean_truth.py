"""Clean curves of a ground truth by hand in Blender (3.4 or newer), over the registered photographs.

  blender --python scripts/blender_clean_truth.py -- --curves truth.ply --model sparse/0 --images images \
      --export clean.ply

Creates a mesh of edges, "truth", and a camera for every image of the COLMAP model (text or binary, pinhole:
undistort others first) with its photograph behind the scene. Frame 1, 2, ... of the timeline looks through the
first, second, ... camera (0 on the number pad). In edit mode delete, add and move what is wrong; then
File > Export > Limn curves (.ply), or --background to export at once. All edges of all visible mesh objects are
written. Vertices that were not moved keep their exact coordinates.
"""

import argparse
import sys
from pathlib import Path

import bmesh
import bpy
import mathutils
from bpy_extras.io_utils import ExportHelper

sys.path.insert(0, str(Path(__file__).resolve().parent))

from blender_truth_files import (SENSOR_WIDTH, InputError, camera_matrix, lens_settings,  # noqa: E402
                                 original_or, read_cameras, read_curves, read_images, write_curves)


def import_curves(path):
    """A mesh object of edges; what its elements came from is kept in its attributes."""
    vertices, edges, links = read_curves(path)
    mesh = bpy.data.meshes.new("truth")
    mesh.from_pydata(vertices, edges, [])
    # One more than the index, or the link's id: elements made by hand have 0.
    mesh.attributes.new("source", "INT", "POINT").data.foreach_set("value", range(1, len(vertices) + 1))
    mesh.attributes.new("link", "INT", "EDGE").data.foreach_set("value", [link + 1 for link in links])
    thing = bpy.data.objects.new("truth", mesh)
    thing["source_path"] = str(path.resolve())
    thing.show_in_front = True
    bpy.context.scene.collection.objects.link(thing)
    return thing


def import_cameras(model, images):
    """One camera per image, bound to a frame each."""
    cameras, scene = read_cameras(model), bpy.context.scene
    views = read_images(model)
    if not views:
        raise InputError(f"{model}: has no images")
    collection = bpy.data.collections.new("photographs")
    scene.collection.children.link(collection)
    for frame, (name, number, quaternion, translation) in enumerate(views, 1):
        if number not in cameras:
            raise InputError(f"{model}: image {name} has the unknown camera {number}")
        if not (images / name).is_file():
            raise InputError(f"{images / name}: there is no such image")
        data = bpy.data.cameras.new(name)
        settings = lens_settings(cameras[number])
        data.sensor_fit, data.sensor_width, data.lens = "HORIZONTAL", SENSOR_WIDTH, settings["lens"]
        data.shift_x, data.shift_y = settings["shift_x"], settings["shift_y"]
        data.clip_start, data.clip_end = 1e-3, 1e5
        _put_photograph(data, images / name)
        thing = bpy.data.objects.new(name, data)
        thing.matrix_world = mathutils.Matrix(camera_matrix(quaternion, translation))
        thing["frame_of_image"] = [*cameras[number][:2], settings["pixel_aspect_x"], settings["pixel_aspect_y"]]
        collection.objects.link(thing)
        scene.timeline_markers.new(name, frame=frame).camera = thing
    scene.frame_start, scene.frame_end = 1, len(views)
    bpy.app.handlers.frame_change_post.append(fit_frame)
    scene.frame_set(1)
    return list(collection.objects)


def _put_photograph(camera, path):
    camera.show_background_images = True
    background = camera.background_images.new()
    background.image = bpy.data.images.load(str(path), check_existing=True)
    background.frame_method, background.alpha, background.display_depth = "STRETCH", 1.0, "BACK"


def fit_frame(scene, _=None):
    """Resolution and pixel aspect of the camera of this frame."""
    # Blender switches the camera only after its handlers have run.
    camera = next((marker.camera for marker in scene.timeline_markers if marker.frame == scene.frame_current), None)
    if camera is not None and "frame_of_image" in camera:
        width, height, aspect_x, aspect_y = camera["frame_of_image"]
        render = scene.render
        render.resolution_x, render.resolution_y, render.resolution_percentage = int(width), int(height), 100
        render.pixel_aspect_x, render.pixel_aspect_y = aspect_x, aspect_y


def export_curves(path):
    """Edges of all visible mesh objects, in the world. Returns their number."""
    vertices, edges, links = [], [], []
    for thing in bpy.context.scene.objects:
        if thing.type != "MESH" or thing.hide_get():
            continue
        _append_edges(thing, vertices, edges, links)
    if not edges:
        raise InputError("no visible mesh object has an edge: nothing was written")
    write_curves(path, vertices, edges, links)
    return len(edges)


def _append_edges(thing, vertices, edges, links):
    if thing.mode == "EDIT":
        mesh = bmesh.from_edit_mesh(thing.data)
    else:
        mesh = bmesh.new()
        mesh.from_mesh(thing.data)
    source, link = mesh.verts.layers.int.get("source"), mesh.edges.layers.int.get("link")
    # Objects do not share links.
    first, first_link, originals = len(vertices), max(links, default=-1) + 1, _originals(thing)
    for index, vertex in enumerate(mesh.verts):
        vertex.index = index
        number = vertex[source] if source else 0
        vertices.append(original_or(thing.matrix_world @ vertex.co, number - 1, originals))
    for edge in mesh.edges:
        edges.append(tuple(first + vertex.index for vertex in edge.verts))
        links.append(first_link + (edge[link] if link else 0))


def _originals(thing):
    path = Path(thing.get("source_path", ""))
    if path.suffix and path.is_file():
        return read_curves(path)[0]
    if "source_path" in thing:
        print(f"WARNING: {path} is gone: vertices of {thing.name} have single precision")
    return []


def add_export_menu(default_path):
    """File > Export > Limn curves (.ply)."""
    class ExportLimnCurves(bpy.types.Operator, ExportHelper):
        bl_idname, bl_label = "export_scene.limn_curves", "Limn curves (.ply)"
        filename_ext = ".ply"

        def execute(self, _):
            try:
                self.report({"INFO"}, f"{export_curves(Path(self.filepath))} edges written")
            except InputError as error:
                self.report({"ERROR"}, str(error))
                return {"CANCELLED"}
            return {"FINISHED"}

    def draw(menu, _):
        menu.layout.operator(ExportLimnCurves.bl_idname).filepath = str(default_path)

    bpy.utils.register_class(ExportLimnCurves)
    bpy.types.TOPBAR_MT_file_export.append(draw)


def main(arguments):
    parser = argparse.ArgumentParser(prog="blender_clean_truth.py")
    parser.add_argument("--curves", type=Path, required=True, help="PLY file of curves")
    parser.add_argument("--model", type=Path, required=True, help="folder of COLMAP's cameras and images")
    parser.add_argument("--images", type=Path, required=True, help="folder of the photographs")
    parser.add_argument("--export", type=Path, default=Path("clean.ply"), help="where the curves go")
    options = parser.parse_args(arguments)
    for thing in list(bpy.data.objects):  # the cube and the lamp that Blender starts with
        bpy.data.objects.remove(thing)
    import_cameras(options.model, options.images)
    import_curves(options.curves)
    if bpy.app.background:
        print(f"{options.export}: {export_curves(options.export)} edges written")
    else:
        add_export_menu(options.export)


if __name__ == "__main__":
    try:
        main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    except InputError as problem:
        print(f"ERROR: {problem}", file=sys.stderr)
        sys.exit(1)
