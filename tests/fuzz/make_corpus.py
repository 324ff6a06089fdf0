#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Write the seeds of the fuzzers, small valid files, to tests/fuzz/corpus/<target>/.

Run again after a change of a format; the files are committed.
"""

import struct
import zlib
from math import cos, sin
from pathlib import Path

CORPUS = Path(__file__).parent / "corpus"
IDENTITY = (1.0, 0.0, 0.0, 0.0, 0.1, -0.2, 3.0)
NO_POINT = 2**64 - 1


def put(target, name, content):
    folder = CORPUS / target
    folder.mkdir(parents=True, exist_ok=True)
    data = content.encode() if isinstance(content, str) else content
    (folder / name).write_bytes(data)


def counted(items):
    return struct.pack("<Q", len(items)) + b"".join(items)


def camera(camera_id, model, *params):
    return struct.pack(f"<IiQQ{len(params)}d", camera_id, model, 640, 480, *params)


def image(image_id, name, points):
    record = struct.pack("<I7dI", image_id, *IDENTITY, 1) + name.encode() + b"\0"
    return record + counted([struct.pack("<ddQ", *point) for point in points])


def point(point_id, *track):
    record = struct.pack("<Q3d3Bd", point_id, 0.5, 0.25, 1.0, 10, 20, 30, 0.7)
    return record + counted([struct.pack("<II", *element) for element in track])


def models():
    put("cameras_bin", "two", counted([
        camera(1, 1, 500, 500, 320, 240), camera(2, 2, 500, 320, 240, 0.01)]))
    put("cameras_bin", "fisheyes", counted([
        camera(1, 5, 500, 500, 320, 240, 0.01, 0, 0, 0),
        camera(2, 11, 500, 500, 320, 240, *[0.001] * 12),
        camera(3, 12, 500, 320, 240, -0.1), camera(4, 16, 500, 500, 320, 240, 0.6, 1.1)]))
    put("cameras_txt", "three", "# cameras\n1 PINHOLE 640 480 500 500 320 240\n"
        "2 FULL_OPENCV 640 480 500 500 320 240 .1 .05 .001 -.0015 .01 .2 .06 .008\n"
        "3 FOV 640 480 500 500 320 240 0.9\n")
    put("cameras_txt", "spherical", "7 EQUIRECTANGULAR 640 320 640 320\r\n")
    put("images_bin", "two", counted([
        image(1, "a.png", [(10.5, 20.5, 1), (1, 2, NO_POINT)]), image(2, "sub/b c.png", [])]))
    put("images_txt", "two", "# images\n1 1 0 0 0 0.1 -0.2 3 1 a.png\n10.5 20.5 1 1 2 -1\n"
        "2 1 0 0 0 0.1 -0.2 3 1 sub/b c.png\n\n")
    put("points3D_bin", "two", counted([point(1, (1, 0), (2, 1)), point(9)]))
    put("points3D_txt", "two", "# points\n1 0.5 0.25 1 10 20 30 0.7 1 0 2 1\n9 1 2 3 0 0 0 -1\n")


def rigs():
    sensor = struct.pack("<iIB7d", 0, 2, 1, *IDENTITY)
    unknown = struct.pack("<iIB", 1, 5, 0)
    put("rigs_bin", "one", counted([struct.pack("<IIiI", 1, 3, 0, 1) + sensor + unknown]))
    put("rigs_txt", "one", "1 3 CAMERA 1 CAMERA 2 1 1 0 0 0 0.1 -0.2 3 IMU 5 0\n")
    put("frames_bin", "one", counted([
        struct.pack("<II7dI", 1, 1, *IDENTITY, 2) + struct.pack("<iIQ", 0, 1, 1) +
        struct.pack("<iIQ", 0, 2, 2)]))
    put("frames_txt", "one", "1 1 1 0 0 0 0.1 -0.2 3 2 CAMERA 1 1 CAMERA 2 2\n")


def line_maps():
    ends = (0.0, 0.0, 0.0, 1.0, 0.5, 0.25)
    put("limap_lines", "two", counted([
        struct.pack("<Q6d", 7, *ends) + counted([struct.pack("<II", 3, 0), struct.pack("<II", 3, 1)]) +
        struct.pack("<d", 0.01), struct.pack("<Q6d", 8, *ends) + counted([]) + struct.pack("<d", -1)]))
    put("limap_lines_txt", "two", "2\n7\n0 0 0 1 0.5 0.25\n2\n3 0\n3 1\n0.01\n8\n1 0 0 1 1 0\n0\n-1\n")
    put("limap_wireframe", "two", counted([struct.pack("<QQd", 9, 7, 2), struct.pack("<QQd", 10, 7, 0.5)]))
    members = counted([struct.pack("<Qd", 9, 1), struct.pack("<Qd", 10, 0.5)])
    put("limap_groups", "one", counted([
        struct.pack("<Qi", 2, 1) + members + counted([struct.pack("<Qd", 7, 1)]) +
        counted([struct.pack("<II", 3, 0)]) + counted([struct.pack("<d", 1)] * 3)]))
    segments = counted([struct.pack("<5dQ", 1.5, 2, 3, 4, -1, 7), struct.pack("<5dQ", 1, 2, 3, 4, 0.5, NO_POINT)])
    group = struct.pack("<i", 1) + counted([struct.pack("<Id", 0, 1)]) + counted([]) + struct.pack("<Q", 2)
    put("limap_images", "one", counted([
        struct.pack("<II", 3, 1) + segments + counted([group]) + counted([struct.pack("<IId", 0, 1, 1)])]))
    put("limap_tracks", "one", "1\n0 2 2\n1.0 2.0     3.0\n4 5 6\n3 4 \n0 1 \n")
    put("line3dpp", "two", "1 0 0 0 1 0 0.5 1 4 17 1.5 2 3 4 \n2 1 2 3 4 5 6 7 8 9 7 8 10 0 \n")
    put("line3dpp_stl", "one", "solid lineModel\n facet normal 1.0e+000 0.0e+000 0.0e+000\n  outer loop\n"
        "   vertex 0 0 0\n   vertex 1 0 0.5\n   vertex 0 0 0\n  endloop\n endfacet\nendsolid lineModel\n")


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def segment(marker, data):
    return struct.pack(">BBH", 0xFF, marker, len(data) + 2) + data


def workspaces():
    put("depth_map", "depth", b"3&2&1&" + struct.pack("<6f", 1, 2, 0, 4, -1, 6))
    put("depth_map", "normal", b"1&2&3&" + struct.pack("<6f", *[0.5] * 6))
    put("pmvs_contour", "one", "CONTOUR\n-160.21 317.61 -28.6522 451.535\n"
        "-19.2325 20.1974 -341.33 408.955\n-0.952495 -0.0104537 -0.304375 2.92417\n")
    put("image_header", "png", b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", 4, 3, 8, 0, 0, 0, 0)) +
        chunk(b"IDAT", zlib.compress(bytes(15))) + chunk(b"IEND", b""))
    put("image_header", "jpeg", b"\xff\xd8" + segment(0xE0, b"JFIF\0") +
        segment(0xC0, struct.pack(">BHHB", 8, 3, 4, 0)) + segment(0xDA, b"\0") + b"\1\xff\0\2\xff\xd9")
    put("image_header", "tiff", b"II*\0" + struct.pack("<IH2HI2H2HII", 8, 2, 256, 3, 1, 4, 0, 257, 4, 1, 3))
    put("image_header", "bmp", b"BM" + bytes(12) + struct.pack("<3i", 40, 4, -3))
    put("image_header", "webp", b"RIFF\x16\0\0\0WEBPVP8X\x0a\0\0\0" + bytes(4) + b"\3\0\0\2\0\0")
    put("image_header", "jp2", struct.pack(">I4s4sI4s", 12, b"jP  ", b"\r\n\x87\n", 0, b"jp2c") +
        b"\xff\x4f\xff\x51" + struct.pack(">2H4I", 47, 0, 4, 3, 0, 0))
    put("image_header", "pgm", "P5 # gray\n4 3\n255\n")
    for name, tables in ("one_block", 0), ("no_table", 4):
        put("jpeg_check", name, b"\xff\xd8" + segment(0xDB, bytes(1) + b"\1" * 64) +
            segment(0xC0, struct.pack(">BHHB", 8, 8, 8, 1) + b"\1\x11\0") +
            b"".join(segment(0xC4, bytes([kind, 1]) + bytes(16)) for kind in (0, 0x10)) +
            segment(0xDA, bytes([1, 1, tables, 0, 63, 0])) + b"\x3f\xff\xd9")
    put("project_ini", "project", "# options\nworkspace_path = a b\n[Sketch]\nmax_gap_px = 3\n")


def image_lists():
    put("image_list", "pmvs", "a.png\nsub/b c.png\nc.png\n")
    put("image_list", "bundler", "./a.jpg\r\n\nb.jpg 0 600.25\nmy holidays 2.jpg\n  d 7.jpg  \n")
    put("image_list", "long_line", "a" * 2000 + " 0 600\n" + "1 2 " * 200 + "\n")


def imports():
    put("pmvs_bundle", "three", "# Bundle file v0.3\n3 2\n" + "60 0 0\n1 0 0\n0 1 0\n0 0 1\n0.5 1 3\n" * 3 +
        "0.5 1 2\n255 0 10\n2 0 7 1.5 -2.5 2 8 3 4\n1 1 1\n0 0 0\n0\n")
    put("projection_matrices", "contour", "CONTOUR\n50 0 20 1\n0 50 15 2\n0 0 1 3\n")
    put("projection_matrices", "numbers", "-160.21 317.61 -28.6522 451.535\n"
        "-19.2325, 20.1974, -341.33, 408.955\n-0.952495 -0.0104537 -0.304375 2.92417\n")
    put("intrinsic_extrinsic", "one", "60 0 20\n0 61 15\n0 0 1\n|0 1 0\n-1 0 0\n0 0 1\n0.5 -2 3e1\n")
    put("middlebury", "two", "2\na.png 60 0 20 0 60 15 0 0 1 1 0 0 0 1 0 0 0 1 0.5 1 3\n"
        "b.png 60 0 20 0 60 15 0 0 1 0 1 0 -1 0 0 0 0 1 0.5 1 3\n")
    put("bundler", "two", "# Bundle file v0.3\n2 2\n60 0 0\n1 0 0\n0 1 0\n0 0 1\n0.5 1 3\n"
        "60 0.1 -0.01\n0 1 0\n-1 0 0\n0 0 1\n0.5 1 3\n"
        "0.5 1 2\n255 0 10\n2 0 7 1.5 -2.5 1 8 3 4\n1 1 1\n0 0 0\n0\n")
    put("bundler", "without_pose", "# Bundle file v0.3\n2 0\n" + "0 0 0\n" * 5 +
        "60 0 0\n1 0 0\n0 1 0\n0 0 1\n0.5 1 3\n")
    put("nvm", "two", "NVM_V3\n\n2\na.png\t60 1 0 0 0 0.5 1 3 0 0\n"
        "b.png\t60 0.5 0.5 0.5 0.5 0.5 1 3 -0.05 0\n\n"
        "1\n0.5 1 2 255 0 10 2 0 7 1.5 -2.5 1 8 3 4\n\n0\n")
    put("nvm", "two_models", "NVM_V3 \n1\nsub/my\"a.png 60 1 0 0 0 0.5 1 3 0 0\n0\n"
        "1\nb.png 60 1 0 0 0 0.5 1 3 0 0\n1\n0.5 1 2 255 0 10 0\n0\n")
    matrix = "[[1,0,0,0.5],[0,1,0,1],[0,0,1,3],[0,0,0,1]]"
    put("nerf_transforms", "blender", '{"camera_angle_x": 0.69, "frames": [\n'
        f'{{"file_path": "./train/a", "transform_matrix": {matrix}}}]}}\n')
    put("nerf_transforms", "colmap", '{"fl_x": 60, "fl_y": 61, "cx": 20, "cy": 15, "w": 40, "h": 30,\n'
        '"k1": 0.01, "k2": 0, "p1": 0.001, "p2": 0, "camera_model": "OPENCV", "frames": [\n'
        f'{{"file_path": "images/a.png", "transform_matrix": {matrix}}},\n'
        f'{{"file_path": "b.png", "is_fisheye": true, "p1": 0, "k4": 0.1, "transform_matrix": {matrix}}}]}}\n')
    put("opensfm", "two", '[{"cameras": {"c": {"projection_type": "brown", "width": 40, "height": 30, "focal_x": 1.5,\n'
        '"focal_y": 1.5, "c_x": 0.01, "c_y": 0, "k1": 0.1, "k2": 0, "p1": 0, "p2": 0.001, "k3": 0.01}, "d": {"focal": 1}},\n'
        '"shots": {"a.png": {"rotation": [0.1, 0, 3], "translation": [1, 2, 3], "camera": "c"},\n'
        '"b.png": {"rotation": [0, 0, 0], "translation": [1, 2, 3], "camera": "d"}},\n'
        '"points": {"7": {"coordinates": [1, 2, 3], "color": [1, 2, 255.5]}}}]\n')
    put("openmvg", "one", '{"sfm_data_version": "0.3", "root_path": "images", "views": [{"key": 0, "value":\n'
        '{"polymorphic_id": 1073741824, "ptr_wrapper": {"id": 1, "data": {"local_path": "", "filename": "a.png",\n'
        '"width": 40, "height": 30, "id_view": 0, "id_intrinsic": 1, "id_pose": 2}}}}], "intrinsics": [{"key": 1, "value":\n'
        '{"polymorphic_id": 2147483649, "polymorphic_name": "pinhole_radial_k3", "ptr_wrapper": {"id": 2, "data": {\n'
        '"width": 40, "height": 30, "focal_length": 60, "principal_point": [20, 15], "disto_k3": [0.1, 0, 0.01]}}}}],\n'
        '"extrinsics": [{"key": 2, "value": {"rotation": [[0, 1, 0], [-1, 0, 0], [0, 0, 1]], "center": [1, 2, 3]}}],\n'
        '"structure": [{"key": 0, "value": {"X": [1, 2, 9], "observations": [{"key": 0, "value": {"id_feat": 3,\n'
        '"x": [4.5, 6]}}]}}]}\n')
    put("metashape", "two", '<?xml version="1.0" encoding="UTF-8"?>\n<document version="2.0.0"><chunk><sensors>\n'
        '<sensor id="0" type="frame"><resolution width="40" height="30"/><calibration type="frame" class="adjusted">\n'
        '<f>60</f><cx>1</cx><b1>0.1</b1><k1>0.1</k1><k4>0.01</k4><p1>0.001</p1></calibration></sensor></sensors>\n'
        '<components><component id="1"><transform><scale>2</scale></transform></component></components><cameras>\n'
        '<camera id="0" sensor_id="0" component_id="1" label="a"><transform>1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1</transform>\n'
        '</camera><group><camera id="1" sensor_id="0" label="b.png&#65;"/></group></cameras></chunk></document>\n')
    put("realitycapture", "two", "#cameras 2\n#name,x,y,alt,heading,pitch,roll,f,px,py,k1,k2,k3,k4,t1,t2\n"
        "a.png,1,2,3,10,20,30,35,0.01,0,0.1,0,0.01,0.001,0,0.001\nb.png,1,2,-3e1,-170,0,90,35,0,0,0,0,0,0,0,0\n")


def dense():
    lists = ((0, 1, 2), (1,), ())
    put("visibility", "three", counted([struct.pack(f"<{len(l) + 1}I", len(l), *l) for l in lists]))
    put("patch", "two", "PATCHES\n2\nPATCHS\n0.5 -1 2e-3 1\n0 0 1 0\n0.9 0.1 0.2\n2\n3 0 \n0\n\n\n"
        "PATCHA\n0.5 1 2 1\n0.6 0 0.8 0\n0.7 0 0\n1\n1 0 0 0\n1\n0 \n2\n1 4 \n\n")
    put("ply_points", "float_colours", "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\n"
        "property double y\nproperty double z\nproperty float red\nproperty float green\nproperty float blue\n"
        "end_header\n0 1 2 0.5 255.5 -1\n")
    header = ("ply\nformat {}\ncomment made by hand\nelement vertex 2\nproperty float x\nproperty float y\n"
              "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
              "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty short quality\n"
              "end_header\n")
    put("ply_points", "ascii", header.format("ascii 1.0") +
        "0 0 0 0 0 1 255 0 1 7\r\n\n1.5 -2e-3 3 0 1 0 1 2 3 -1\n")
    for name, order in (("little", "<"), ("big", ">")):
        put("ply_points", name, header.format(f"binary_{name}_endian 1.0").encode() +
            struct.pack(order + "6f3Bh", 0, 0, 0, 0, 0, 1, 255, 0, 1, 7) * 2)


def meshes():
    header = ("ply\nformat {}\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
              "element face 2\nproperty list uchar int {}\nproperty uchar flags\nend_header\n")
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1))
    put("mesh_ply", "ascii", header.format("ascii 1.0", "vertex_indices") +
        "".join("%d %d %d\n" % corner for corner in corners) + "4 0 1 2 3 0\n3 0 1 4 0\n")
    for name, order in (("little", "<"), ("big", ">")):
        rows = b"".join(struct.pack(order + "3f", *corner) for corner in corners)
        rows += struct.pack(order + "B4iB", 4, 0, 1, 2, 3, 0) + struct.pack(order + "B3iB", 3, 0, 1, 4, 0)
        put("mesh_ply", name, header.format(f"binary_{name}_endian 1.0", "vertex_index").encode() + rows)
    put("mesh_obj", "faces", "# mesh\no body\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\n"
        "vt 0 0\ns off\nf 1 2 3 4\nf 1//1 -4/1/1 5\nf 1 2 3\nl 1 2\n")
    put("mesh_obj", "star", "v 0 3 0\nv 1 1 0\nv 3 1 0\nv 1 0 0\nv 2 -2 0\nv 0 -1 0\nv -2 -2 0\n"
        "v -1 0 0\nv -3 1 0\nv -1 1 0\nf 1 2 3 4 5 6 7 8 9 10\n")
    radii = [(1 + 0.02 * i, 0.3 * i) for i in range(40)] + [(1.1 + 0.02 * i, 0.3 * i) for i in range(39, -1, -1)]
    put("mesh_obj", "spiral", "".join(f"v {r * cos(a):.3f} {r * sin(a):.3f} 0\n" for r, a in radii) +
        "f " + " ".join(str(i + 1) for i in range(len(radii))) + "\n")


def curves():
    header = ("ply\nformat {}\nelement vertex 3\nproperty double x\nproperty double y\n"
              "property double z\nproperty uchar red\nelement edge 2\nproperty int vertex1\n"
              "property int vertex2\nproperty int link\nelement face 1\n"
              "property list uchar int vertex_indices\nend_header\n")
    put("ply", "ascii", header.format("ascii 1.0") +
        "0 0 0 255\n1 0 0 255\n1 1 0 255\n0 1 0\n1 2 0\n3 0 1 2\n")
    for name, order in (("little", "<"), ("big", ">")):
        rows = b"".join(struct.pack(order + "3dB", i, 1, 0, 255) for i in range(3))
        rows += struct.pack(order + "6i", 0, 1, 0, 1, 2, 0) + struct.pack(order + "B3i", 3, 0, 1, 2)
        put("ply", name, header.format(f"binary_{name}_endian 1.0").encode() + rows)
    put("obj", "lines", "# curves\no link_0\nv 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n"
        "g b\nl -1 1/2\np 2\nvn 0 0 1\n")
    put("points_txt", "points", "# truth\n0 0 0\n1.5 -2e-3 3 255 0 0\n")
    put("points_txt", "gzip", zlib.compress(b"0 0 0\n1 2 3\n", wbits=31))
    put("edges_txt", "edges", "1 2\n2 3\n4 5\n")
    put("wireframe_json", "roof", '{"order_id": "a", "wf_vertices": [[0, 0, 3], [4, 0, 3], [2, 1, 5.5]],\n'
        '"wf_edges": [[0, 1], [1, 2], [2, 0]], "wf_classifications": [1, 2, 2]}')
    put("wireframe_json", "list", '[{"wf_vertices": [[0, 0, 0], [0, 0, 0]], "wf_edges": [[0, 1], [1, 1]]}]')
    put("junctions_json", "two", '{"junctions": [{"position": [0, 1, 2], "degree": 3},\n'
        '{"position": [0.5, 1, 2], "degree": 1, "kind": "end"}]}\n')
    ref = '{"id": %d, "closed": false, "points": [[0, 0, 0], [1, 0, 0], [2, 0.5, 0]]}'
    place = '{"link": ' + ref % -1 + ', "at": [1, 0, 0]}'
    put("edits_json", "all", '{"format": "limn_edits", "format_version": 1, "edits": [\n'
        f'{{"edit": "delete", "links": [{ref % 1}, {ref % 2}]}},\n{{"edit": "restore", "links": [{ref % 1}]}},\n'
        f'{{"edit": "set_kind", "links": [{ref % 1}], "kind": "paint"}},\n'
        f'{{"edit": "split", "link": {ref % 1}, "at": [1, 0, 0]}},\n'
        f'{{"edit": "join", "ends": [{{"link": {ref % 1}, "end": 0}}, {{"link": {ref % 2}, "end": 1}}]}},\n'
        f'{{"edit": "merge", "links": [{ref % 1}, {ref % 2}]}},\n'
        f'{{"edit": "dimension", "from": {place}, "to": {place}, "shift": [0, 0, 1]}},\n'
        '{"edit": "remove_dimension", "from": [0, 0, 0], "to": [1, 0, 0]}]}\n')
    header = (b'{"format":"limn-viewer","version":1,"center":[0,0,0],"shownFromModel":{"scale":1,"rotation":'
              b'[1,0,0,0,1,0,0,0,1],"translation":[0,0,0]},"detail":"normal","views":[{"name":"a","width":4,"height":3,'
              b'"fx":4,"fy":4,"cx":2,"cy":1,"region":{"min":[0,0],"max":[3,2]},"thumbnail":{"offset":0,"length":4,'
              b'"min":[0,0],"max":[3,2]}}],"report":{},"settings":{},"arrays":{"cloudPositions":{"type":"f32","offset":0,'
              b'"length":3},"cloudColors":{"type":"u8","offset":16,"length":3},"thumbnails":{"type":"u8","offset":24,'
              b'"length":4}}}')
    put("viewer_payload", "point", struct.pack("<I", len(header)) + header + bytes(28))
    put("drawing_json", "corner", """{"format": "limn-drawing", "format_version": 1,
"views": ["a.png", "b.png"], "options": {"Sketch": {"max_gap_px": 3}},
"nodes": [
{"id":0,"position":[0,0,0],"kind":"end","incident":[[0,0]],"continuations":[]},
{"id":1,"position":[1,0,0],"kind":"end","incident":[[0,1],[1,0]],"continuations":[[[0,1],[1,0]]]},
{"id":2,"position":[1,1,0],"kind":"end","incident":[[1,1]],"continuations":[]},
{"id":3,"position":[5,5,5],"kind":"loop_anchor","incident":[[2,0],[2,1]],"continuations":[]}],
"links": [
{"id":0,"node0":0,"node1":1,"closed":false,"residual_px":0.5,"supporting_views":["a.png"],
 "members":[[0,0,1]],"points":[[0,0,0],[1,0,0]],"sigma":[0.1,null]},
{"id":1,"node0":1,"node1":2,"closed":false,"residual_px":0.5,"supporting_views":["b.png"],
 "members":[],"points":[[1,0,0],[1,1,0]],"sigma":[0.1,0.1]},
{"id":2,"node0":3,"node1":3,"closed":true,"residual_px":0,"supporting_views":[],
 "members":[],"points":[[5,5,5],[6,5,5],[5,5,5]],"sigma":[1,1,1]}]}
""")
    dense = ('"dense":{"class":"surface","added_share":0,"occluded_share":0.25,'
             '"behind_surface":false,"fold_deg":90.5}')
    free = '"dense":{"class":"free","added_share":1,"occluded_share":0,"behind_surface":true}'
    ends = '"incident":[[%d,%d]],"continuations":[]'
    link = ('{"id":%d,"node0":%d,"node1":%d,"closed":false,"residual_px":0.5,"supporting_views":["a.png"],'
            '%s,"members":[],"points":[[%d,0,0],[%d,1,0]],"sigma":[0.1,0.1]}')
    nodes = [f'{{"id":{i},"position":[{i // 2},{i % 2},0],"kind":"end",{ends % (i // 2, i % 2)}}}'
             for i in range(4)]
    put("drawing_json", "fused", '{"format": "limn-drawing", "format_version": 1,\n"views": ["a.png"], '
        '"options": {},\n"nodes": [' + ",\n".join(nodes) + '],\n"links": [' +
        link % (0, 0, 1, dense, 0, 0) + ",\n" + link % (1, 2, 3, free, 1, 1) + "]}\n")
    # A plane between two links and two bridges, and the same as ruled surface and as patch.
    border = ('[[{"link":0,"from":0,"to":1},{"bridge":[[0,1,0],[1,1,0]]},{"link":1,"from":1,"to":0},'
              '{"bridge":[[1,0,0],[0.5,0,0.1],[0,0,0]]}]]')
    face = ('{"id":%d,"surface":"%s","area":1,"confidence":0.5,%s"views":["a.png"],"loops":' + border +
            '%s,"vertices":[[0,0,0],[0,1,0],[1,1,0],[1,0,0]],"triangles":[[0,1,2],[0,2,3]]}')
    put("drawing_json", "faces", '{"format": "limn-drawing", "format_version": 1,\n"views": ["a.png"], '
        '"options": {},\n"nodes": [' + ",\n".join(nodes) + '],\n"links": [' +
        link % (0, 0, 1, dense, 0, 0) + ",\n" + link % (1, 2, 3, free, 1, 1) + '],\n"faces": [' +
        face % (0, "plane", '"normal":[0,0,-1],"offset":0,', "") + ",\n" +
        face % (1, "ruled", "", ',"side_starts":[0,1,2,3]') + ",\n" +
        face % (2, "patch", "", ',"side_starts":[0,2]') + "]}\n")


def edges():
    put("edg", "two", "# EDGE_MAP v3.0\n\nWIDTH=64\nHEIGHT=48\nEDGE_COUNT=2\n\n"
        "[3, 4]    0.5 12   [3.25, 4.5]   0.5 12 0.1\n[5, 4]    6 12   [5, 4]   6 12 0.1\n")
    put("edg", "old", "# EDGE_MAP v2.0\nWIDTH=64\nHEIGHT=48\nEDGE_COUNT=1\n"
        "EDGE : [3, 4]    0.5 12   [3.25, 4.5]   0.5 12\n")
    put("cem", "two", ".CEM v2.0\nsize=[64 48]\n[Edgemap]\ncount=3\n(1, 2)\t0.5\t9\t0\n"
        "(2, 2)\t0.5\t9\t0\n(3, 2)\t0.5\t9\t0\n[Contours]\ncount=2\n[0 1 2 ]\n[0 1 2 0 ]\n"
        "[Contour Properties]\n# <len>\n3 9 0 0 0 0 0 0\n")
    put("image_polylines", "two", "# x1 y1 x2 y2 ...\n1 2 30.5 2\n\n3,4, 10,4, 10,12, 3,4\n")


def text(string):
    return struct.pack("<Q", len(string)) + string.encode()


def counted_bytes(values):
    """Bytes that are not deflated."""
    return struct.pack("<QB", len(values), 0) + bytes(values)


def packed(kind, values):
    """Packed numbers of which no plane is deflated."""
    items = struct.pack(f"<{len(values)}{kind}", *values)
    size = struct.calcsize(kind)
    return struct.pack("<Q", len(values)) + b"".join(b"\0" + items[k::size] for k in range(size))


def stages():
    # Of the scene of sketched_scene.h.
    def sample(i):
        return struct.pack("<7dBI4i", 0, (i - 5) / 25, 0, 0, 1, 0, 0.1, 1, 2, 0, i, 1, i)

    curve = struct.pack("<3iB", 0, 0, 1, 0) + counted([sample(i) for i in range(1, 10)])
    sketch = text("{}") + counted([text("a.png"), text("b.png")]) + counted([curve])
    put("curve_sketch", "one", sketch)
    depths = struct.pack("<d", 3) + packed("B", [1]) + packed("B", [96] * 4)
    depths += packed("d", [1] * 4) + packed("d", [2] * 4) + packed("d", [80] * 4)
    put("view_sketch", "one", depths + counted_bytes([2, 10, 0, 0] + [2] * 9 + [0, 0]))
    ids = counted_bytes([0, 1, 0, 3, 0, 2, 2]) + struct.pack("<i", 0)
    for name, as_stored in (("lens", 0), ("no_lens", 1)):
        edgels = packed("d", [1, 2, 3]) + packed("d", [2] * 3) + packed("d", [0.5] * 3)
        edgels += packed("f", [9] * 3) + packed("f", [0.1] * 3)
        if not as_stored:
            edgels += b"".join(packed("f", [number] * 3) for number in (1, 2, 1, 0, 0, 1))
        put("image_curves", name, struct.pack("<iidiB", 64, 48, 0.5, 0, as_stored) + edgels + ids)
    stage = b"limnfile" + struct.pack("<II", 6, 2) + text("identity")
    stage += struct.pack("<Q", len(sketch)) + sketch
    put("stage_file", "sketch", stage + struct.pack("<I", zlib.crc32(stage)))


if __name__ == "__main__":
    models()
    rigs()
    workspaces()
    image_lists()
    imports()
    dense()
    meshes()
    curves()
    line_maps()
    edges()
    stages()
