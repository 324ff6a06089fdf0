# SPDX-License-Identifier: BSD-3-Clause
"""Builds the sample scene in Blender and renders it with Cycles. Blender 3.4 (Debian 12).

  blender --background --python render.py -- --light day --output /tmp/frames/day [--views 0,6] [--samples 64]
          [--panorama 2010 | [--distorted] [--scale 1.0]] [--long]

Writes one lossless PNG per view. Existing frames are kept, so that an interrupted run can be resumed.
"""

import argparse
import math
import os
import sys

import bpy
import mathutils

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import lens  # noqa: E402
import scene as sample  # noqa: E402

SENSOR_MM = 36.0


class Nodes:
    """Small helper to write shader node trees as expressions."""

    def __init__(self, tree):
        self.tree = tree
        tree.nodes.clear()

    def add(self, kind, **properties):
        node = self.tree.nodes.new(kind)
        for key, value in properties.items():
            setattr(node, key, value)
        return node

    def connect(self, source, target):
        self.tree.links.new(source, target)

    def math(self, operation, a, b):
        node = self.add("ShaderNodeMath", operation=operation)
        for socket, value in zip(node.inputs, (a, b)):
            self._feed(socket, value)
        return node.outputs[0]

    def mix(self, factor, a, b):
        node = self.add("ShaderNodeMixRGB")
        for socket, value in zip(node.inputs, (factor, a, b)):
            self._feed(socket, value)
        return node.outputs[0]

    def _feed(self, socket, value):
        if isinstance(value, bpy.types.NodeSocket):
            self.connect(value, socket)
        else:
            socket.default_value = value


def rgba(color):
    return (*color, 1.0)


def new_material(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    return material, Nodes(material.node_tree)


def finish_material(nodes, color):
    """Matt surface: no highlight ever moves an edge."""
    diffuse = nodes.add("ShaderNodeBsdfDiffuse")
    nodes._feed(diffuse.inputs["Color"], color)
    output = nodes.add("ShaderNodeOutputMaterial")
    nodes.connect(diffuse.outputs[0], output.inputs["Surface"])


def solid_material(solid):
    material, nodes = new_material(solid.name)
    coordinates = nodes.add("ShaderNodeTexCoord").outputs["Object"]
    color = nodes.add("ShaderNodeRGB")
    color.outputs[0].default_value = rgba(solid.color)
    value = color.outputs[0]
    for paint in solid.paints:
        value = nodes.mix(paint_mask(nodes, coordinates, paint), value, rgba(paint.color))
    finish_material(nodes, value)
    return material


def paint_mask(nodes, coordinates, paint):
    """1 inside the painted region, 0 outside: an exact step."""
    if paint.center is not None:
        distance = nodes.add("ShaderNodeVectorMath", operation="DISTANCE")
        nodes.connect(coordinates, distance.inputs[0])
        distance.inputs[1].default_value = paint.center
        return nodes.math("LESS_THAN", distance.outputs["Value"], paint.radius)
    separate = nodes.add("ShaderNodeSeparateXYZ")
    nodes.connect(coordinates, separate.inputs[0])
    mask = None
    for axis in range(3):
        for operation, bound in (("GREATER_THAN", paint.low[axis]), ("LESS_THAN", paint.high[axis])):
            if math.isfinite(bound):
                test = nodes.math(operation, separate.outputs[axis], float(bound))
                mask = test if mask is None else nodes.math("MULTIPLY", mask, test)
    return mask


def ground_material():
    """Strong but soft blobs at two scales: food for SIFT, without long hard edges."""
    material, nodes = new_material("ground")
    coordinates = nodes.add("ShaderNodeTexCoord").outputs["Object"]
    value = None
    for scale, seed in ((7.0, 3.1), (19.0, 11.7)):
        noise = nodes.add("ShaderNodeTexNoise", noise_dimensions="4D")
        nodes.connect(coordinates, noise.inputs["Vector"])
        noise.inputs["W"].default_value = seed
        noise.inputs["Scale"].default_value = scale
        noise.inputs["Detail"].default_value = 1.0
        value = noise.outputs["Fac"] if value is None else nodes.math("ADD", value, noise.outputs["Fac"])
    ramp = nodes.add("ShaderNodeValToRGB")
    nodes.connect(nodes.math("MULTIPLY", value, 0.5), ramp.inputs[0])
    ramp.color_ramp.interpolation = "EASE"
    ramp.color_ramp.elements[0].position, ramp.color_ramp.elements[0].color = 0.36, rgba((0.025, 0.04, 0.02))
    ramp.color_ramp.elements[1].position, ramp.color_ramp.elements[1].color = 0.64, rgba((0.36, 0.30, 0.18))
    finish_material(nodes, ramp.outputs[0])
    return material


def add_mesh(name, vertices, faces, material, pose=None):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(map(float, v)) for v in vertices], [], faces)
    mesh.update()
    for polygon in mesh.polygons:
        polygon.use_smooth = True
    mesh.use_auto_smooth = True
    mesh.auto_smooth_angle = math.radians(20)
    mesh.materials.append(material)
    item = bpy.data.objects.new(name, mesh)
    if pose is not None:
        matrix = mathutils.Matrix.Identity(4)
        for r in range(3):
            for c in range(3):
                matrix[r][c] = pose.rotation[r, c]
            matrix[r][3] = pose.translation[r]
        item.matrix_world = matrix
    bpy.context.scene.collection.objects.link(item)
    return item


def build_solids():
    for solid in sample.solids():
        vertices, faces = solid.mesh()
        add_mesh(solid.name, vertices, faces, solid_material(solid), solid.pose)
    half = 60.0
    corners = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
    add_mesh("ground", corners, [[0, 1, 2, 3]], ground_material())


def build_light(light):
    if light in sample.SUNS:
        options = sample.SUNS[light]
        data = bpy.data.lights.new("sun", "SUN")
        data.energy, data.angle = options["strength"], math.radians(options["angle"])
        direction = mathutils.Vector(sample.sun_direction(light))
        item = bpy.data.objects.new("sun", data)
        item.rotation_euler = direction.to_track_quat("-Z", "Y").to_euler()
    else:
        options = sample.LAMPS[light]
        data = bpy.data.lights.new("lamp", "POINT")
        data.energy, data.shadow_soft_size = options["power"], options["radius"]
        item = bpy.data.objects.new("lamp", data)
        item.location = options["position"]
    data.color = options["color"]
    bpy.context.scene.collection.objects.link(item)


def build_sky(light):
    """Fill light that depends on direction, so that faces in the shade still differ."""
    options = sample.SKIES[light]
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    bpy.context.scene.world = world
    nodes = Nodes(world.node_tree)
    direction = nodes.add("ShaderNodeTexCoord").outputs["Generated"]
    dot = nodes.add("ShaderNodeVectorMath", operation="DOT_PRODUCT")
    nodes.connect(direction, dot.inputs[0])
    dot.inputs[1].default_value = mathutils.Vector(options["bright"]).normalized()
    factor = nodes.math("MULTIPLY_ADD", dot.outputs["Value"], options["contrast"])
    factor.node.inputs[2].default_value = 1.0
    background = nodes.add("ShaderNodeBackground")
    background.inputs["Color"].default_value = rgba(options["color"])
    nodes.connect(nodes.math("MULTIPLY", factor, options["strength"]), background.inputs["Strength"])
    output = nodes.add("ShaderNodeOutputWorld")
    nodes.connect(background.outputs[0], output.inputs["Surface"])


def build_camera(distorted, panorama):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.sensor_width = "HORIZONTAL", SENSOR_MM
    data.clip_start, data.clip_end = 0.05, 500.0
    if panorama:
        data.type = "PANO"
        data.cycles.panorama_type = "EQUIRECTANGULAR"
    elif distorted:
        data.type = "PANO"
        data.cycles.panorama_type = "FISHEYE_LENS_POLYNOMIAL"
        data.cycles.fisheye_fov = math.pi
        # Cycles: angle from the axis = sum of k_i r^i, r in millimeters on the sensor; its sign is negative.
        pixel_mm = SENSOR_MM / sample.WIDTH
        for power, k in enumerate(lens.angle_polynomial()):
            setattr(data.cycles, f"fisheye_polynomial_k{power}", -k / pixel_mm ** power)
    else:
        data.lens = sample.FOCAL_PX * SENSOR_MM / sample.WIDTH
        cx, cy = sample.PRINCIPAL_POINT
        data.shift_x = (sample.WIDTH / 2 - cx) / sample.WIDTH
        data.shift_y = (cy - sample.HEIGHT / 2) / sample.WIDTH
    item = bpy.data.objects.new("camera", data)
    bpy.context.scene.collection.objects.link(item)
    bpy.context.scene.camera = item
    return item


def place_camera(item, rotation, center):
    matrix = mathutils.Matrix.Identity(4)
    for r in range(3):
        for c in range(3):
            matrix[r][c] = rotation[c, r] * (1 if c == 0 else -1)
        matrix[r][3] = center[r]
    item.matrix_world = matrix


def set_up_render(samples, size):
    scene = bpy.context.scene
    render = scene.render
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = size
    render.resolution_percentage = 100
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGB"
    render.use_persistent_data = True
    scene.view_settings.view_transform = "Standard"
    cycles = scene.cycles
    cycles.device, cycles.samples = "CPU", samples
    cycles.use_adaptive_sampling, cycles.use_denoising = False, False
    cycles.max_bounces, cycles.diffuse_bounces = 1, 1
    cycles.sample_clamp_indirect = 4.0
    cycles.pixel_filter_type, cycles.filter_width = "BLACKMAN_HARRIS", 1.5


def parse_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--light", choices=sample.LIGHTS, required=True)
    parser.add_argument("--output", required=True)
    parser.add_argument("--views", help="numbers with commas between; default: all")
    parser.add_argument("--long", action="store_true", help="on the long path")
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--scale", type=float, default=1.0)
    lens_group = parser.add_mutually_exclusive_group()
    lens_group.add_argument("--distorted", action="store_true")
    lens_group.add_argument("--panorama", type=int, help="width of an image of all directions, instead of photographs")
    arguments = parser.parse_args(sys.argv[sys.argv.index("--") + 1:])
    if arguments.panorama and arguments.scale != 1:
        parser.error("argument --scale: not allowed with argument --panorama, which is a size")
    return arguments


def views_of(arguments):
    if arguments.views:
        return list(map(int, arguments.views.split(",")))
    if arguments.long:
        # Every fourth first, then every second: a broken run has paths of their own, too.
        return sorted(range(sample.LONG_VIEW_COUNT), key=lambda i: (i % 4 != 0, i % 2 != 0, i))
    return range(sample.VIEW_COUNT)


def main():
    arguments = parse_arguments()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    build_solids()
    build_light(arguments.light)
    build_sky(arguments.light)
    camera = build_camera(arguments.distorted, arguments.panorama)
    if arguments.panorama:
        size = arguments.panorama, arguments.panorama // 2
    else:
        size = int(sample.WIDTH * arguments.scale), int(sample.HEIGHT * arguments.scale)
    set_up_render(arguments.samples, size)
    os.makedirs(arguments.output, exist_ok=True)
    center_of = sample.long_camera_center if arguments.long else sample.camera_center
    pose_of = sample.long_camera_pose if arguments.long else sample.camera_pose
    for index in views_of(arguments):
        path = os.path.join(arguments.output, f"view_{index:02d}.png")
        if os.path.exists(path):
            continue
        place_camera(camera, pose_of(index)[0], center_of(index))
        bpy.context.scene.cycles.seed = 1000 * sample.LIGHTS.index(arguments.light) + index
        bpy.context.scene.render.filepath = path + ".tmp.png"
        bpy.ops.render.render(write_still=True)
        os.replace(path + ".tmp.png", path)


main()
