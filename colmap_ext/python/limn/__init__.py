# SPDX-License-Identifier: BSD-3-Clause
"""3D drawings from COLMAP projects: graphs of curves in space that meet at nodes.

    import limn
    drawing = limn.draw("my_project")
    for link in drawing.links:
        print(link.kind, link.points.shape)
    drawing.save("house.dxf")

Options are those of the commands of `limn`, with the same names, ranges and defaults: names in snake case are keyword
arguments, options of a group a dictionary: `limn.draw("my_project", max_image_size=800, Drawing={"method": "paper"})`.

Units: px are pixels of the images as used (after max_image_size; sharp photographs are used as if enlarged, up to 1.5
times with quality medium, twice with high), and the center of the top-left pixel is (0, 0); coordinates in space are
the model's.

Long functions take `progress`, called as progress(stage, done, total) by the calling thread, at most 20 times a
second. They release the GIL; in the main thread Ctrl-C stops them within two seconds. Errors are
limn.Error; the text is the line that the program would print.
"""

import json
import os
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple, Optional, Union

from limn import _limn
from limn._limn import (Alignment, Camera, Curves, Drawing, Edges, Face, Faces, ImageCurves, ImageEdges, Link, Links,
                        Node, Nodes, Primitive, RoundBody, Scene, Sketch, SketchCurve)
from limn._memory import scene_from_arrays, scene_from_reconstruction
from limn._options import texts_of
from limn.errors import Error, InputError, IoError, OptionError

__all__ = [
    "Alignment", "Camera", "Curves", "Drawing", "Edges", "Error", "Face", "Faces", "ImageCurves", "ImageEdges",
    "InputError", "IoError", "Length", "Link", "Links", "Node", "Nodes", "OptionError", "Primitive", "RoundBody",
    "Scene", "Sketch", "SketchCurve", "align", "draw", "edit", "evaluate", "export", "extract_edges", "find_faces",
    "fuse", "link", "measure", "open", "read_drawing", "refine", "refine_cameras", "regularize", "run", "sketch",
]

__version__: str = _limn.__version__

setattr(Scene, "from_arrays", staticmethod(scene_from_arrays))
setattr(Scene, "from_reconstruction", staticmethod(scene_from_reconstruction))

Path = Union[str, "os.PathLike[str]"]
Progress = Optional[Callable[[str, int, int], object]]


def open(workspace: Path, *, progress: Progress = None, **options: Any) -> Scene:
    """Reads the cameras and checks the images of a COLMAP project: a folder as of --workspace_path.

    Options are those of automatic_drawer on images (max_image_size, mask_path, model_index, ...), and any others: they
    become the defaults of the stages. Writes nothing.
    """
    return _limn.open(texts_of(options, workspace_path=workspace), progress)


def _scene(source: Union[Path, Scene], options: dict[str, Any], progress: Progress) -> tuple[Scene, dict[str, Any]]:
    """The scene, and the options that are left for its stage: a project is opened with all of them."""
    if isinstance(source, Scene):
        return source, texts_of(options)
    return open(source, progress=progress, **options), {}


def extract_edges(source: Union[Path, Scene], *, progress: Progress = None, **options: Any) -> Edges:
    """Finds the edgels (oriented edge points) of all images of a project or a scene.

    Options: EdgeDetection, and for a project those of open(). Writes nothing.
    """
    return _limn.extract_edges(*_scene(source, options, progress), progress)


def link(source: Union[Path, Scene], *, progress: Progress = None, **options: Any) -> Curves:
    """Finds the curves of all images of a project or a scene: chains of edgels.

    Options: EdgeDetection, Linking, and for a project those of open(). Writes nothing.
    """
    return _limn.link(*_scene(source, options, progress), progress)


def sketch(source: Union[Path, Scene, Curves], *, progress: Progress = None, **options: Any) -> Sketch:
    """Reconstructs unconnected curves in space, of a project or a scene, or from curves in its images.

    Options: box, mode, ViewSelection, Sketch, and of the stages that are still to run. Writes nothing.
    """
    if isinstance(source, Curves):
        return _limn.sketch(source, texts_of(options), progress)
    scene, left = _scene(source, options, progress)
    return _limn.sketch(_limn.link(scene, {}, progress), left, progress)


def draw(source: Union[Path, Scene, Sketch], *, output_path: Optional[Path] = None, progress: Progress = None,
         **options: Any) -> Drawing:
    """The 3D drawing of a COLMAP project (as of automatic_drawer), of a scene, or of a sketch (as of curve_drawer).

    Options are those of automatic_drawer on images and on the algorithms: box, quality, max_image_size, Drawing and so
    on; for a scene or a sketch those that come after it. Writes nothing, unless `output_path` names a folder: then a
    project is drawn as by the command, including its options about files (overwrite, page, account,
    align, truth_path, ...). It resumes a stopped run, and writes drawing.json, drawing.html, overlays and so on there.
    Its cameras are the refined ones, if refine_cameras has refined them: by default only with `output_path`. With
    output_cameras="given" they are refined by default, but those of the drawing are the given ones, which it fits.
    """
    if isinstance(source, Sketch):
        _no_output(output_path, "a sketch")
        return _limn.draw_sketch(source, texts_of(options), progress)
    if isinstance(source, Scene):
        _no_output(output_path, "a scene")
    if isinstance(source, Scene) or output_path is None:
        return _limn.draw_scene(*_scene(source, options, progress), progress)
    texts = texts_of(options, workspace_path=source, output_path=output_path)
    return _limn.draw_in_folder(texts, progress)


def _no_output(output_path: Optional[Path], of: str) -> None:
    if output_path is not None:
        raise OptionError(f"output_path = {os.fsdecode(output_path)}: the drawing of {of} is saved by Drawing.save()")


def refine(drawing: Drawing, *, progress: Progress = None, **options: Any) -> Drawing:
    """The drawing fitted to all images, judged and described by primitives, as by drawing_refiner.

    The drawing needs its scene: read_drawing(path, scene). Options: DrawingRefinement, Belief, Primitives. Writes
    nothing.
    """
    return _limn.apply("refine", drawing, texts_of(options), progress)


def refine_cameras(workspace: Path, output_path: Path, *, progress: Progress = None, **options: Any) -> Scene:
    """The project with cameras refined by the curves in its images, as by camera_refiner.

    Writes the COLMAP model output_path/refined, and output_path/curves/cameras.csv if the cameras moved, without a
    drawing. Options: refine_cameras (1 or auto), hold_images, and those of automatic_drawer on images and on the
    algorithms.
    """
    texts = texts_of(options, workspace_path=workspace, output_path=output_path)
    return _limn.refine_cameras_in_folder(texts, progress)


def regularize(drawing: Drawing, *, progress: Progress = None, **options: Any) -> Drawing:
    """The drawing with exact right angles, parallel lines, planes and equal circles, as by drawing_regularizer.

    Regularities hold only where the images allow them. The drawing needs its scene: read_drawing(path, scene). Options:
    Regularity. Writes nothing.
    """
    return _limn.apply("regularize", drawing, texts_of(options), progress)


def find_faces(drawing: Drawing, *, progress: Progress = None, **options: Any) -> Drawing:
    """The drawing with the surfaces that its curves bound, as by drawing_surfacer: `faces` of the result.

    Curves and nodes stay as they are. The drawing needs its scene: read_drawing(path, scene). Options: Surfaces. Writes
    nothing.
    """
    return _limn.apply("find_faces", drawing, texts_of(options), progress)


def edit(drawing: Drawing, edits: Path, *, progress: Progress = None, **options: Any) -> Drawing:
    """The drawing with edits made by hand (edits.json of drawing.html), as by drawing_editor.

    The links that they touch are fitted to the images again; edits that do not fit the drawing are listed in `warnings`
    of the result. The drawing needs its scene: read_drawing(path, scene). Options: DrawingRefinement, Primitives. Writes
    nothing.
    """
    return _limn.apply("edit", drawing, texts_of(options, edits=edits), progress)


def fuse(drawing: Drawing, *, progress: Progress = None, **options: Any) -> Drawing:
    """The drawing compared with dense results, as by drawing_fuser: its links have a dense_class.

    The drawing needs its scene, which is a project. Options: dense_type, dense_path, remove_occluded, DenseFusion.
    Writes nothing.
    """
    return _limn.apply("fuse", drawing, texts_of(options), progress)


def align(drawing: Drawing, known_length: Union[str, Iterable[str]] = (), *, progress: Progress = None,
          **options: Any) -> Drawing:
    """The drawing with its alignment (up, horizontal axes, scale), as by drawing_aligner.

    `known_length` has measured lengths: "link 12 = 2.40 m", "from 3 to 7 = 31 in" (nodes),
    "a.jpg 120,340 to b.jpg 500,220 = 2.40 m" (pixels of the stored images, x and y; unlike elsewhere in Python the
    center of the top-left one is 0.5,0.5). The drawing needs its scene. Positions stay the model's; save() stores the alignment, and export(..., aligned=True) applies it. Options:
    database_path, use_positions, world. Writes nothing.
    """
    return _limn.apply("align", drawing, texts_of(options, known_length=known_length or None), progress)


class Length(NamedTuple):
    """A length of a drawing, from measure(), in `unit`: 'm', or 'none' (the model's) if the scale is unknown.

    `sigma` is its standard deviation, of the fit, the cameras and the scale, in the same unit; None if unknown. As text
    it is like "2.4 +- 0.003 m".
    """

    length: float
    sigma: Optional[float]
    unit: str

    def __str__(self) -> str:
        spread = "" if self.sigma is None else f" +- {self.sigma:.2g}"
        return f"{self.length:.6g}{spread}" + ("" if self.unit == "none" else f" {self.unit}")


def measure(drawing: Drawing, span: str) -> Length:
    """A length of a drawing, in meters if it is aligned and its scale is known.

    `span` is "link 12", "from 3 to 7" (nodes), or "a.jpg 120,340 to b.jpg 500,220": what photographs show at two pixels,
    as in align(), which needs the scene. Other texts raise OptionError.
    """
    length, sigma, unit = _limn.measure(drawing, span)
    return Length(length, sigma if sigma > 0 else None, unit)


def _drawing_or_path(drawing: Union[Path, Drawing]) -> tuple[Optional[Drawing], Optional[Path]]:
    return (drawing, None) if isinstance(drawing, Drawing) else (None, drawing)


def evaluate(drawing: Union[Path, Drawing], truth_path: Path, taus: Any = None, *, progress: Progress = None,
             **options: Any) -> dict[str, Any]:
    """Precision, recall and more against true curves or points, as of drawing_evaluator.

    `drawing` may be any file of curves. `taus` are distances, one or several, in the model's unit, or in footprints (the
    size of a pixel there) with unit="footprint", which needs a scene or workspace_path. Returns the content of
    --output_json: "rows" has a dictionary per tau with "precision", "recall", "f"; shares are 0 to 1, None where
    undefined. With protocol="hss", and no taus, "hss" has a dictionary with "corner_f1", "edge_iou" and "hss" of
    wireframes. Options: those of drawing_evaluator. Writes nothing but what output_json and output_csv name.
    """
    core, path = _drawing_or_path(drawing)
    texts = texts_of(options, input_path=path, truth_path=truth_path, taus=taus)
    report: dict[str, Any] = json.loads(_limn.evaluate(core, texts, progress))
    return report


def export(drawing: Union[Path, Drawing], output_path: Path, *, progress: Progress = None, **options: Any) -> None:
    """Writes a drawing, or that of a file, for another program, as drawing_exporter does.

    The extension of output_path names the format, unless output_type does. Options: those of drawing_exporter (aligned,
    scale, up_axis, unit, kinds, view, ...); aligned needs a drawing from align().
    """
    core, path = _drawing_or_path(drawing)
    _limn.export_drawing(core, texts_of(options, input_path=path, output_path=output_path), progress)


def read_drawing(path: Path, source: Union[None, Path, Scene] = None) -> Drawing:
    """Reads a drawing.json. With the scene or the project that it was drawn from it has cameras and tracks.

    Of a drawing with refined cameras these are taken from refined/ beside it, if they are there. A scene with other
    images raises IoError.
    """
    return _limn.read_drawing(path, None if source is None else _scene(source, {}, None)[0])


def run(command: str, *, progress: Progress = None, **options: Any) -> None:
    """Runs a command of the program: run("curve_linker", workspace_path="my_project", format="cem").

    It writes what it writes there, but prints nothing. Other names than those of commands raise OptionError.
    """
    _limn.run(command, texts_of(options), progress)
