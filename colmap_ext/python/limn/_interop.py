# SPDX-License-Identifier: BSD-3-Clause
"""Drawings in the types of other packages, which are imported when they are needed."""

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from limn._limn import Drawing


def to_networkx(drawing: "Drawing") -> Any:
    try:
        import networkx  # type: ignore[import]
    except ImportError:
        raise ImportError("Drawing.to_networkx needs the package networkx (Debian: python3-networkx)") from None
    graph = networkx.MultiGraph()
    for node in drawing.nodes:
        graph.add_node(node.id, position=node.position, kind=node.kind)
    for link in drawing.links:
        graph.add_edge(link.node0, link.node1, key=link.id, link=link.id, points=link.points, length=link.length,
                       kind=link.kind, tentative=link.tentative)
    return graph


def _colors(count: int) -> Any:
    """Colors that differ between neighbors: hues at steps of the golden angle. count x 3, 0 to 1."""
    hue = np.arange(count) * 0.381966 % 1.0
    offsets = np.array([0.0, 1 / 3, 2 / 3])
    return np.clip(np.abs((hue[:, None] + offsets) % 1.0 * 6 - 3) - 1, 0, 1)


def to_open3d(drawing: "Drawing") -> Any:
    try:
        import open3d  # type: ignore[import]
    except ImportError:
        raise ImportError("Drawing.to_open3d needs the package open3d (pip install open3d)") from None
    points, segments, colors, begin = [], [], [], 0
    for link, color in zip(drawing.links, _colors(len(drawing.links))):
        steps = np.arange(begin, begin + len(link) - 1)
        points.append(link.points)
        segments.append(np.column_stack([steps, steps + 1]))
        colors.append(np.tile(color, (len(link) - 1, 1)))
        begin += len(link)
    lines = open3d.geometry.LineSet()
    if points:
        lines.points = open3d.utility.Vector3dVector(np.concatenate(points))
        lines.lines = open3d.utility.Vector2iVector(np.concatenate(segments))
        lines.colors = open3d.utility.Vector3dVector(np.concatenate(colors))
    return lines
