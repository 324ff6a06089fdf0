// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/depth_warnings.h"

#include "limn/util/name_list.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

std::string WholePercent(double share) { return RoundedText(100 * share, 0) + " %"; }

std::string NotThose(DenseKind kind) {
  switch (kind) {
    case DenseKind::kDepthMaps:
      return "the depth maps are not those of the drawing";
    case DenseKind::kFusedCloud:
    case DenseKind::kPmvs:
      return "the points are not those of the drawing";
    case DenseKind::kMesh:
      return "the mesh is not that of the drawing";
  }
  return "";
}

std::string Pixels(const Eigen::Vector2d& shift) {
  return RoundedText(shift.x(), 0) + ", " + RoundedText(shift.y(), 0) + " px";
}

// What would make them fit.
std::string CauseText(const DepthCause& cause, DenseKind kind, const std::vector<View>& views) {
  switch (cause.kind) {
    case DepthCause::Kind::kUnknown:
      break;
    case DepthCause::Kind::kFactor:
      return "they fit if divided by " + ShortNumber(cause.factor) +
             ": they are of a model of another scale";
    case DepthCause::Kind::kInverse:
      return "their inverses fit: they are disparities, not depths";
    case DepthCause::Kind::kRays:
      return "they are distances from the cameras, not depths along their axes";
    case DepthCause::Kind::kMirrored:
      return "they fit if mirrored in the image: their rows or columns are in another order";
    case DepthCause::Kind::kShifted:
      return "they fit if moved by " + Pixels(cause.shift_px) +
             " in the image: they are of other cut-outs of the images";
    case DepthCause::Kind::kOtherViews:
      return "they fit other images (those of " + views[cause.depths_of].name + " fit " +
             views[cause.fit_view].name + "): their names are exchanged";
  }
  return kind == DenseKind::kDepthMaps
             ? "they may be noise, or of another scene or other cameras"
             : "perhaps of another scene, in other coordinates, or made with other cameras";
}

std::string WayOut(const DepthTrust& trust) {
  return trust.is_believed ? "" : "; make them again from this model, or name others: --dense_path";
}

std::string AgreementText(const DepthAgreement& agreement) {
  return WholePercent(agreement.near) + " of what images show of it is at the depths there (" +
         WholePercent(agreement.chance) + " would be by chance)";
}

}  // namespace

std::string DepthWarning(const DepthTrust& trust, const DenseProducts& products,
                         const std::vector<View>& views) {
  const std::string path = products.path.string() + ": ";
  if (trust.has_few_depths) {
    return path + "a depth is known at only " + RoundedText(100 * trust.agreement.known, 1) +
           " % of what images show of the drawing, so no link is judged: stereo found next to "
           "nothing, or it is of another scene" +
           WayOut(trust);
  }
  if (!trust.is_believed) {
    return path + NotThose(products.kind) +
           ", so no link is judged: " + AgreementText(trust.agreement) + "; " +
           CauseText(trust.cause, products.kind, views) + WayOut(trust);
  }
  if (trust.unfit.empty()) return "";
  std::vector<std::string> names;
  for (const ViewId view : trust.unfit) names.push_back(views[view].name);
  return path + "the depth maps of " + std::to_string(names.size()) + " of " +
         std::to_string(trust.num_views) +
         " images are not used, since the drawing is not at "
         "their depths: " +
         ListNames(names) + "; " + CauseText(trust.cause, products.kind, views);
}

}  // namespace limn::colmap_ext
