# SPDX-License-Identifier: BSD-3-Clause
"""Clean curves or points of a ground truth by hand in Blender (3.4 or newer), over the registered photographs.

  blender --python scripts/blender_clean_truth.py -- --curves truth.ply --model sparse/0 --images images \
      --export clean.ply
  blender --python scripts/blender_clean_truth.py -- --cloud scan.txt.gz --near near.ply --model sparse/0 \
      --images images --export points.ply

Creates a mesh, "truth", and a camera for every image of the COLMAP model (text or binary, pinhole: undistort others
first) with its photograph behind the scene. Frame 1, 2, ... of the timeline looks through the first, second, ...
camera (0 on the number pad).

Curves: in edit mode delete, add and move what is wrong; then File > Export > Limn curves (.ply). All edges of all
visible mesh objects are written.

A cloud (.ply, .txt, .xyz, also .gz) is opened in edit mode with those points selected that are within --distance of
the points or curves of --near, or all. With distance 0 these are the points themselves that
"limn truth_extractor --cloud_path scan.txt.gz --output_path near.ply" found near the edges of the images; of a
drawing or other curves give a distance, which Select > Near truth (Limn) can change later. Change the selection (box
B, circle C, lasso; with Ctrl or the middle button to deselect) or delete points; then File > Export > Limn points
(.ply, .txt). The selected points of all visible mesh objects are written. To go on later open the export as a cloud.

With --background the export is made at once. What was not moved keeps its exact coordinates.
"""

import argparse
import sys
from pathlib import Path

import bmesh
import bpy
import mathutils
from mathutils.bvhtree import BVHTree
from bpy_extras.io_utils import ExportHelper

sys.path.insert(0, str(Path(__file__).resolve().parent))

from blender_truth_files import (SENSOR_WIDTH, InputError, camera_matrix, lens_settings,  # noqa: E402
                                 original_or, read_cameras, read_cloud, read_curves, read_images, read_shapes,
                                 write_cloud, write_curves)


def import_curves(path):
    """A mesh object of edges; what its elements came from is kept in its attributes."""
    vertices, edges, links = read_curves(path)
    thing = _add_mesh(path, vertices, edges)
    thing.data.attributes.new("link", "INT", "EDGE").data.foreach_set("value", [link + 1 for link in links])
    return thing


def import_cloud(path):
    """A mesh object of vertices alone, all selected."""
    thing = _add_mesh(path, read_cloud(path), [])
    thing["is_cloud"] = True
    return thing


def _add_mesh(path, vertices, edges):
    mesh = bpy.data.meshes.new("truth")
    mesh.from_pydata(vertices, edges, [])
    # One more than the index, or the link's id: elements made by hand have 0.
    mesh.attributes.new("source", "INT", "POINT").data.foreach_set("value", range(1, len(vertices) + 1))
    thing = bpy.data.objects.new("truth", mesh)
    thing["source_path"] = str(path.resolve())
    thing.show_in_front = True
    bpy.context.scene.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    return thing


def tree_of(path):
    """The points and curves of a file, to find the nearest."""
    vertices, edges, _ = read_shapes(path)
    if not vertices:
        raise InputError(f"{path}: has no points")
    in_edges = {end for edge in edges for end in edge}
    # Triangles without an area.
    triangles = [(a, b, b) for a, b in edges] + [(i, i, i) for i in range(len(vertices)) if i not in in_edges]
    return BVHTree.FromPolygons(vertices, triangles, all_triangles=True)


def select_near(thing, tree, distance):
    """Selects the visible vertices of a mesh object that are at most so far from the tree, no others. Returns their
    number."""
    mesh = _mesh_of(thing)
    for vertex in mesh.verts:
        vertex.select_set(not vertex.hide and tree.find_nearest(thing.matrix_world @ vertex.co)[3] <= distance)
    mesh.select_flush_mode()
    count = sum(vertex.select for vertex in mesh.verts)
    if thing.mode == "EDIT":
        bmesh.update_edit_mesh(thing.data)
    else:
        mesh.to_mesh(thing.data)
    return count


def _mesh_of(thing):
    """Its geometry, in edit mode that under the user's hands."""
    if thing.mode == "EDIT":
        return bmesh.from_edit_mesh(thing.data)
    mesh = bmesh.new()
    mesh.from_mesh(thing.data)
    return mesh


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
    for thing in _visible_meshes(path):
        _append_edges(thing, vertices, edges, links)
    if not edges:
        raise InputError("no visible mesh object has an edge: nothing was written")
    write_curves(path, vertices, edges, links)
    return len(edges)


def export_cloud(path):
    """The selected vertices of all visible mesh objects, in the world. Returns their number."""
    points = []
    for thing in _visible_meshes(path):
        mesh = _mesh_of(thing)
        points += [point for vertex, point in zip(mesh.verts, _positions(thing, mesh)) if vertex.select]
    if not points:
        raise InputError("no visible point is selected: nothing was written")
    write_cloud(path, points)
    return len(points)


def _visible_meshes(output_path):
    things = [thing for thing in bpy.context.scene.objects if thing.type == "MESH" and not thing.hide_get()]
    for thing in things:
        if thing.get("source_path") == str(output_path.resolve()):
            raise InputError(f"{output_path}: is the input; export to another file")
    return things


def _append_edges(thing, vertices, edges, links):
    mesh = _mesh_of(thing)
    link = mesh.edges.layers.int.get("link")
    # Objects do not share links.
    first, first_link = len(vertices), max(links, default=-1) + 1
    vertices += _positions(thing, mesh)
    mesh.verts.index_update()
    for edge in mesh.edges:
        edges.append(tuple(first + vertex.index for vertex in edge.verts))
        links.append(first_link + (edge[link] if link else 0))


def _positions(thing, mesh):
    """Of all vertices, in the world; exact where they were not moved."""
    source, originals = mesh.verts.layers.int.get("source"), _originals(thing)
    return [original_or(thing.matrix_world @ vertex.co, (vertex[source] if source else 0) - 1, originals)
            for vertex in mesh.verts]


def _originals(thing):
    path = Path(thing.get("source_path", ""))
    if path.suffix and path.is_file():
        return read_cloud(path) if "is_cloud" in thing else read_curves(path)[0]
    if "source_path" in thing:
        print(f"WARNING: {path} is gone: vertices of {thing.name} have single precision")
    return []


def add_export_menu(title, export, default_path):
    """File > Export > `title`: calls export(path), which returns the number of what was written."""
    class ExportLimnTruth(bpy.types.Operator, ExportHelper):
        bl_idname, bl_label = "export_scene.limn_truth", title
        filename_ext, check_extension = ".ply", None

        def execute(self, _):
            try:
                self.report({"INFO"}, f"{export(Path(self.filepath))} written")
            except InputError as error:
                self.report({"ERROR"}, str(error))
                return {"CANCELLED"}
            return {"FINISHED"}

    def draw(menu, _):
        menu.layout.operator(ExportLimnTruth.bl_idname).filepath = str(default_path)

    bpy.utils.register_class(ExportLimnTruth)
    bpy.types.TOPBAR_MT_file_export.append(draw)


def add_select_menu(tree, default_distance):
    """Select > Near truth (Limn), in edit mode; its distance can be changed after it has run."""
    class SelectNear(bpy.types.Operator):
        bl_idname, bl_label, bl_options = "mesh.limn_select_near", "Near truth (Limn)", {"REGISTER", "UNDO"}
        distance: bpy.props.FloatProperty(name="Distance", default=default_distance, min=0, precision=5)

        def execute(self, context):
            self.report({"INFO"}, f"{select_near(context.object, tree, self.distance)} points selected")
            return {"FINISHED"}

    bpy.utils.register_class(SelectNear)
    bpy.types.VIEW3D_MT_select_edit_mesh.append(lambda menu, _: menu.layout.operator(SelectNear.bl_idname))


def main(arguments):
    parser = argparse.ArgumentParser(prog="blender_clean_truth.py")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--curves", type=Path, help="PLY file of curves")
    source.add_argument("--cloud", type=Path, help="or of points, .ply, .txt or .xyz, also .gz")
    parser.add_argument("--near", type=Path, help="points or curves near which points of the cloud are selected")
    parser.add_argument("--distance", type=float, default=0.0, help="how near, in units of the model (0: the same points)")
    parser.add_argument("--model", type=Path, required=True, help="folder of COLMAP's cameras and images")
    parser.add_argument("--images", type=Path, required=True, help="folder of the photographs")
    parser.add_argument("--export", type=Path, default=Path("clean.ply"), help="where the result goes")
    options = parser.parse_args(arguments)
    for thing in list(bpy.data.objects):  # the cube and the lamp that Blender starts with
        bpy.data.objects.remove(thing)
    import_cameras(options.model, options.images)
    if options.curves:
        import_curves(options.curves)
        finish("Limn curves (.ply)", export_curves, "edges", options.export)
    else:
        open_cloud(options.cloud, options.near, options.distance)
        finish("Limn points (.ply, .txt)", export_cloud, "points", options.export)


def open_cloud(path, near, distance):
    """In edit mode, with its points near those of another file selected."""
    thing = import_cloud(path)
    print(f"{path}: {len(thing.data.vertices)} points")
    if near:
        tree = tree_of(near)
        print(f"{near}: {select_near(thing, tree, distance)} points selected")
        if not bpy.app.background:
            add_select_menu(tree, distance)
    bpy.context.tool_settings.mesh_select_mode = (True, False, False)
    bpy.ops.object.mode_set(mode="EDIT")


def finish(title, export, what, path):
    """The result at once in the background, else by the menu."""
    if bpy.app.background:
        print(f"{path}: {export(path)} {what} written")
    else:
        add_export_menu(title, export, path)


if __name__ == "__main__":
    try:
        main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    except InputError as problem:
        print(f"ERROR: {problem}", file=sys.stderr)
        sys.exit(1)
