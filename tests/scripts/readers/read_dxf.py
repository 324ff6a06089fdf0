# SPDX-License-Identifier: BSD-3-Clause
"""Prints the content of a DXF file as JSON, read and audited by ezdxf: read_dxf.py file

Points along entities are computed by ezdxf, with its object coordinate systems for arcs and circles.
"""

import json
import math
import sys

import ezdxf
import ezdxf.path
from ezdxf.lldxf.encoding import decode_dxf_unicode


def is_face(entity):
    return entity.dxftype() == "POLYLINE" and entity.is_poly_face_mesh


def is_curve(entity):
    return not is_face(entity) and entity.dxftype() in ("LINE", "ARC", "CIRCLE", "SPLINE", "POLYLINE", "LWPOLYLINE", "ELLIPSE")


def points_and_length(entity):
    """Points from end to end, in world coordinates, and the length."""
    kind = entity.dxftype()
    if kind == "LINE":
        points = [entity.dxf.start, entity.dxf.end]
    elif kind == "POLYLINE":
        points = [vertex.dxf.location for vertex in entity.vertices]
        points += points[:1] if entity.is_closed else []
    elif kind in ("LWPOLYLINE", "ELLIPSE"):
        points = list(ezdxf.path.make_path(entity).flattening(1e-6))
    elif kind == "SPLINE":
        points = list(entity.construction_tool().approximate(20000))
    else:
        points = list(entity.flattening(1e-4))
    length = sum(a.distance(b) for a, b in zip(points, points[1:]))
    if kind in ("ARC", "CIRCLE"):
        turn = 360 if kind == "CIRCLE" else (entity.dxf.end_angle - entity.dxf.start_angle) % 360
        length = entity.dxf.radius * math.radians(turn)
    return points, length


def describe(entity):
    extended = dict(entity.get_xdata("LIMN"))
    record = {"type": entity.dxftype(), "layer": entity.dxf.layer, "id": extended[1071],
              "ids": [tag.value for tag in entity.get_xdata("LIMN") if tag.code == 1071],
              "rod_radius": extended.get(1041), "owner": entity.dxf.owner}
    if is_curve(entity):
        points, record["length"] = points_and_length(entity)
        record["samples"] = [list(point) for point in points[:-1:max(1, len(points) // 50)] + points[-1:]]
    if entity.dxftype() in ("ARC", "CIRCLE"):
        record["center"] = list(entity.ocs().to_wcs(entity.dxf.center))
        record["radius"] = entity.dxf.radius
    if entity.dxftype() == "SPLINE":
        record["degree"] = entity.dxf.degree
        record["knots"] = list(entity.knots)
        record["control_points"] = [list(point) for point in entity.control_points]
    if is_face(entity):
        record["type"] = "FACE"
        # Corners, and which of the edges that begin there are visible.
        record["triangles"] = [
            {"corners": [list(vertex.dxf.location) for vertex in face[:-1]],
             "visible": [face[-1].dxf.get(f"vtx{corner}") > 0 for corner in range(3)]}
            for face in entity.faces()]
    elif entity.dxftype() == "POLYLINE":
        record["is_3d"], record["closed"] = entity.is_3d_polyline, entity.is_closed
        record["points"] = [list(vertex.dxf.location) for vertex in entity.vertices]
    if entity.dxftype() == "LWPOLYLINE":
        record["closed"], record["points"] = entity.closed, [list(point) for point in entity.get_points("xyb")]
    if entity.dxftype() == "DIMENSION":
        factor = entity.override().get("dimlfac", 1)
        record["remeasured"] = factor * entity.dxf.defpoint2.distance(entity.dxf.defpoint3)
        record["text"], record["measured"] = decode_dxf_unicode(entity.dxf.text), entity.dxf.actual_measurement
        record["places"] = [list(entity.dxf.defpoint2), list(entity.dxf.defpoint3), list(entity.dxf.defpoint)]
        # What programs show.
        record["picture"] = [part.dxftype() for part in entity.virtual_entities()]
        record["texts"] = [part.dxf.text for part in entity.virtual_entities() if part.dxftype() == "TEXT"]
    if entity.dxftype() == "POINT":
        record["location"] = list(entity.dxf.location)
    return record


def describe_sheet(document):
    """The paper space: its texts, and the scale of its window."""
    layout = document.layout()
    window = [entity for entity in layout.query("VIEWPORT") if entity.dxf.id > 1]
    return {"size": [layout.dxf.paper_width, layout.dxf.paper_height],
            "texts": [entity.dxf.text for entity in layout.query("TEXT")],
            "layers": sorted({entity.dxf.layer for entity in layout}),
            "frames": len(layout.query("LWPOLYLINE")),
            "units_per_mm": [entity.dxf.view_height / entity.dxf.height for entity in window],
            "center": [list(entity.dxf.view_center_point)[:2] for entity in window]}


def raw_handles(path):
    """All handles of the file as it is, and the one it says is free."""
    lines = open(path, encoding="ascii").read().split("\n")
    tags = list(zip((int(code) for code in lines[0:-1:2]), lines[1::2]))
    assert len(lines) % 2 == 1 and lines[-1] == "" and tags[-1] == (0, "EOF")
    handles, seed, kind = [], None, None
    for (code, value), (_, before) in zip(tags, [(0, "")] + tags):
        kind = value if code == 0 else kind
        if before == "$HANDSEED":
            seed = int(value, 16)
        elif code == (105 if kind == "DIMSTYLE" else 5):
            handles.append(int(value, 16))
    return handles, seed


def main():
    handles, seed = raw_handles(sys.argv[1])
    document = ezdxf.readfile(sys.argv[1])
    auditor = document.audit()
    print(json.dumps({
        "version": document.dxfversion,
        "errors": [error.message for error in auditor.errors],
        "fixes": [fix.message for fix in auditor.fixes],
        "handles": handles, "seed": seed,
        "unit": document.header["$INSUNITS"],
        "extent": [list(document.header["$EXTMIN"]), list(document.header["$EXTMAX"])],
        "layers": {layer.dxf.name: layer.dxf.color for layer in document.layers},
        "line_types": {layer.dxf.name: layer.dxf.linetype for layer in document.layers},
        "line_weights": {layer.dxf.name: layer.dxf.lineweight for layer in document.layers},
        "plot_styles": sorted({layer.dxf.get("plotstyle_handle", "") for layer in document.layers}),
        "default_plot_style": document.rootdict["ACAD_PLOTSTYLENAME"].dxf.default,
        "line_type_scale": document.header["$LTSCALE"],
        "sheet": describe_sheet(document) if len(document.layout()) else None,
        "model_space": document.modelspace().layout_key,
        "entities": [describe(entity) for entity in document.modelspace()],
    }))


main()
