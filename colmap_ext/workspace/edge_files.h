// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/workspace/to_views.h"
#include "limn/edges/ridge_detection.h"
#include "limn/model/given_edges.h"

namespace limn::colmap_ext {

// Files with the edges of images, made by other programs or by Limn. Positions are pixels of the
// image before undistortion, with the center of the top-left pixel at (0, 0). A file is of the size
// of its image as stored or, for those of Limn with --max_image_size, as used.

// The file of each view in a folder: the only one of the names `<image name>.<extension>` and
// `<image name without its extension>.<extension>`, folders included, with an extension that
// ReadEdgeFile knows. The photographs themselves, which may be in the same folder, do not count.
// Throws IoError if there is no such folder, an image has no file or several, or a file is that of
// several images.
std::vector<std::string> FindEdgeFiles(const std::string& folder, const ViewSet& set);

// The edges of a view, at the size of the view, without those in masked pixels. By extension:
//   .edg           edgels (ReadEdg)
//   .cem           linked curves (ReadCem)
//   .txt           linked curves, line segments (ReadImagePolylines), of the image as stored; the
//                  brighter side is that of the photograph
//   .png .tif .tiff .bmp .pgm .webp .jpg .jpeg
//                  probabilities of edges, bright on dark, 8 or 16 bits (DetectRidges); the
//                  brighter side is that of the photograph
// Texts may be gzipped: .edg.gz and so on. Throws IoError, with the line where there is one, if the
// file is damaged or of another size.
GivenEdges ReadEdgeFile(const std::string& path, const ViewSet& set, ViewId view,
                        const RidgeOptions& maps);

}  // namespace limn::colmap_ext
