// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limn/geometry/triangle_mesh.h"
#include "limn/model/faces.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// A face is right if more than this share of its area is.
constexpr double kRightShare = 0.5;
// A smooth region of the truth is covered if more than this share of its visible area is found.
constexpr double kCoveredShare = 0.8;

struct FaceScoreOptions {
  // Distances up to which a place of a surface is found, pixel footprints; one row each.
  std::vector<double> taus = {0.5, 1, 2, 4, 8};
  // The other surface must also have this direction there; orientations do not matter.
  double max_angle_deg = 10;
  // The truth counts where at least this many views see it.
  int min_views = 2;
  // A view does not see a surface at a smaller angle to its rays.
  double min_grazing_deg = 10;
  // How far behind the surface a visible place may be, px: rounding of depth images.
  double occlusion_px = 1;
  // Surfaces are cut into triangles whose sides are at most this long, px. Lower: exacter, slower.
  double spacing_px = 2;
  // Smooth regions of the truth bend by less than this between two triangles.
  double max_bend_deg = 5;
  // They count if the visible part is at least as large as a square of this side, px.
  double min_region_px = 20;
  // Only what is inside counts; distances are to all of the other surface. None: everything counts.
  std::optional<Eigen::AlignedBox3d> region;

  // Throws OptionError.
  void Check() const;
};

// Triangles, each of one part of the surface, such as a face of a drawing.
struct PartedSurface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> part_of_triangle;
  int num_parts = 0;
};

PartedSurface SurfaceOf(const std::vector<DrawingFace>& faces);
// One part.
PartedSurface SurfaceOf(const TriangleMesh& mesh);

// Shares are in [0, 1], and absent if the total is zero.
struct FaceTauResult {
  double tau = 0;
  // Share of the area of the faces that is within tau of the truth.
  std::optional<double> precision;
  // Share of the visible area of the truth that is within tau of a face.
  std::optional<double> recall;
  // Harmonic mean of the two.
  std::optional<double> f;
  int num_right_faces = 0;
  int num_covered_regions = 0;
};

// Of a face or a smooth region of the truth.
struct PartScore {
  int part = -1;
  // That counts: inside the region of interest and, in the truth, visible; square world units.
  double area = 0;
  // Per tau, the share of it that is within tau of the other surface.
  std::vector<double> within;
};

struct FaceScores {
  std::vector<FaceTauResult> rows;  // as options.taus
  double max_angle_deg = 0;
  // Of the faces, and of the truth where it is visible, inside the region; square world units.
  double area = 0;
  double true_area = 0;
  // Faces, and regions of the truth that are large enough, ascending; without those of which
  // nothing counts.
  std::vector<PartScore> faces;
  std::vector<PartScore> regions;
};

// Compares a surface with the true one, in pixel footprints (PixelFootprint at the place that is
// measured from). A place is within tau of a surface if that has a triangle so near and at most
// max_angle_deg from its direction. Copies of a face count again. A view sees a place that is in
// its image, not hidden by the truth (IsVisible, 2 depth pixels per pixel), and not at a grazing
// angle. Throws OptionError, or InputError if there is no view, more views are asked for than there
// are, or a surface is too large for its footprints (SampleArea).
// Time: places times (views + log triangles), and rendering the truth for each view.
FaceScores ScoreFaces(const PartedSurface& surface, const TriangleMesh& truth,
                      const std::vector<View>& views, const FaceScoreOptions& options,
                      const RunContext& context = {});

}  // namespace limn
