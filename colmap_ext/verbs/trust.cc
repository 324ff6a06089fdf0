// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/trust.h"

#include <algorithm>
#include <string>

#include "colmap_ext/host/provenance.h"
#include "limn/belief/still_edgels.h"
#include "limn/evaluation/explained_edgels.h"
#include "limn/evaluation/quantiles.h"
#include "limn/evaluation/view_agreement.h"
#include "limn/evaluation/weak_cut.h"
#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/model/link_selection.h"
#include "limn/model/view_subset.h"
#include "limn/util/median.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

// An image with fewer edgels says nothing.
constexpr int64_t kMinEdgelsOfImage = 100;
// Chance alone explains less than 1 % of the edges. A box leaves most of an image out.
constexpr double kNextToNothing = 0.02;
constexpr double kNextToNothingInBox = 0.0005;
// An image that agrees less than this much of the median is named.
constexpr double kMuchLess = 1.0 / 3;
// More of the length than this without measured depth is worth a warning; this much, and the
// drawing is a cloud of spikes.
constexpr double kMuchUnmeasured = 0.1;
constexpr double kMostUnmeasured = 0.5;
// Some edgels seem to stand still by chance; more than this is worth a warning.
constexpr double kMuchStill = 0.1;
// However much stands still, this share of the edges must be explained as usual.
constexpr double kLeastMoving = 0.25;
// With right cameras and enough photographs some percent are doubtful.
constexpr double kMuchTentative = 0.4;
// Some edges are seen behind others by chance; more of those drawn than this at several depths are
// worth a warning.
constexpr double kMuchAtOtherDepths = 0.04;
// A drawing of which more than this is expected to be right is good, one with less than the other
// is nonsense (algorithm/belief.md#verdict).
constexpr double kGoodShare = 0.5;
constexpr double kNonsenseShare = 0.03;
// Of the length found, below which a drawing that is not nonsense must not be trusted either.
constexpr double kFewRight = 0.3;

std::string Percent(double share) { return ShortNumber(100 * share) + " %"; }

struct ImageAgreement {
  std::string name;
  ViewAgreement agreement;
};

// Parts of a panorama together. They are neighbors.
std::vector<ImageAgreement> OfImages(const ViewSet& set,
                                     const std::vector<ViewAgreement>& of_views) {
  std::vector<ImageAgreement> images;
  for (size_t v = 0; v < of_views.size(); ++v) {
    const std::string& name = set.ImageName(static_cast<ViewId>(v));
    if (images.empty() || images.back().name != name) images.push_back({name, {}});
    ViewAgreement& sum = images.back().agreement;
    const int64_t count = sum.num_edgels + of_views[v].num_edgels;
    if (count == 0) continue;
    const auto drawn = [](const ViewAgreement& a) {
      return a.share * static_cast<double>(a.num_edgels);
    };
    sum = {count, (drawn(sum) + drawn(of_views[v])) / static_cast<double>(count)};
  }
  return images;
}

// Names of the images for which `select`, those that agree least first.
template <typename Select>
std::vector<NamedNumber> NamesOf(const std::vector<ImageAgreement>& images, const Select& select) {
  std::vector<NamedNumber> names;
  for (const auto& [name, agreement] : images) {
    if (select(agreement)) names.push_back({name, 100 * agreement.share});
  }
  std::ranges::stable_sort(names, {}, &NamedNumber::number);
  return names;
}

void AddAgreement(const std::vector<ImageAgreement>& images, Trust* trust) {
  const auto has_edges = [](const ViewAgreement& image) {
    return image.num_edgels >= kMinEdgelsOfImage;
  };
  std::vector<double> shares;
  for (const ImageAgreement& image : images) {
    if (has_edges(image.agreement)) shares.push_back(image.agreement.share);
  }
  const double median = Median(shares);
  trust->explained = median;
  trust->without_edges = NamesOf(images, [&](const auto& image) { return !has_edges(image); });
  trust->agree_less = NamesOf(images, [&](const auto& image) {
    return has_edges(image) && image.share < kMuchLess * median;
  });
}

void AddExplanations(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                     const DrawingGraph& graph, const RunContext& context, Trust* trust) {
  const auto explained = FindExplainedEdgels(views, curves, graph, context);
  StillEdgels still = FindStillEdgels(views, curves, graph);
  for (size_t v = 0; v < views.size(); ++v) {
    for (size_t e = 0; e < still[v].size(); ++e) {
      if (explained[v][e].is_firm) still[v][e] = 0;
    }
  }
  trust->still = StillShare(still);
  trust->at_other_depths = ShareAtOtherDepths(explained);
}

void AddWeakCut(const ViewSet& set, const std::vector<View>& views, const DrawingGraph& graph,
                Trust* trust) {
  // Parts of panoramas are no images, and have no cameras of their own.
  if (trust->num_images != views.size()) return;
  const auto cut = FindWeakCut(static_cast<int>(views.size()), MeasureSharedSupport(views, graph));
  if (!cut) return;
  for (const ViewId v : cut->smaller) {
    const std::string& name = set.ImageName(v);
    if (trust->apart.empty() || trust->apart.back() != name) trust->apart.push_back(name);
  }
  trust->shared_if_apart = cut->shared;
}

// The length of curves that many views see, and their expected errors in px.
void AddCertainty(const ViewSet& set, const std::vector<View>& views, const DrawingGraph& graph,
                  Trust* trust) {
  const LinkSelection selection;
  const double scale = set.TypicalScale();
  double length = 0, well_seen = 0, tentative = 0, unmeasured = 0, judged = 0, right = 0;
  std::vector<WeightedValue> sigmas_px;
  for (const DrawingLink& link : graph.links) {
    const double of_link = Length(link.points_in_world);
    // A rod stands for its outlines, which are sure.
    if (link.tentative && link.doubt != LinkDoubt::kRodOutline) tentative += of_link;
    if (link.doubt == LinkDoubt::kDepth) unmeasured += of_link;
    // Outlines are another curve for every view, and a rod's are judged with it.
    if (link.confidence >= 0 && link.IsAlongEdgels() && link.doubt != LinkDoubt::kRodOutline) {
      judged += of_link;
      right += of_link * link.confidence;
    }
    if (!selection.Has(link)) continue;
    length += of_link;
    if (set.CountImages(link.supporting_views) >= kManyImages) well_seen += of_link;
    const double footprint = scale * LinkFootprint(link, views);
    if (!(footprint > 0)) continue;
    for (const double sigma : link.sigma) {
      sigmas_px.emplace_back(sigma / footprint, of_link / static_cast<double>(link.sigma.size()));
    }
  }
  if (length > 0) trust->well_seen = well_seen / length;
  if (judged > 0) trust->right = right / judged;
  if (const double found = length + tentative; found > 0) {
    trust->tentative = tentative / found;
    trust->unmeasured = unmeasured / found;
  }
  trust->error_px = WeightedQuantile(sigmas_px, 0.5);
  trust->error_90_px = WeightedQuantile(sigmas_px, 0.9);
}

// Of the edges that do not stand still: the others are not of the scene, as the background before
// which an object turned.
bool ExplainsNothing(const Trust& trust, bool has_box) {
  const double moving_share = std::max(kLeastMoving, 1 - trust.still.value_or(0));
  return trust.explained &&
         *trust.explained < moving_share * (has_box ? kNextToNothingInBox : kNextToNothing);
}

void SayAgreement(const Trust& trust, bool has_box, Console* console) {
  const auto count_of = [&](const std::vector<NamedNumber>& names) {
    return "WARNING: " + std::to_string(names.size()) + " of " + std::to_string(trust.num_images) +
           " images";
  };
  console->Say("The drawing explains " + Percent(*trust.explained) +
               " of the edges of an image (median)");
  if (!trust.without_edges.empty()) {
    console->Say(count_of(trust.without_edges) +
                 " have next to no edges: " + ListNumbers(trust.without_edges, "% of them drawn"));
  }
  if (ExplainsNothing(trust, has_box)) return;
  if (trust.agree_less.empty()) return;
  console->Say(count_of(trust.agree_less) +
               " agree much less with the drawing: " + ListNumbers(trust.agree_less, "%") +
               ". Their poses are wrong, or they show other things");
}

// Says why, and what to look at.
void WarnNotToTrust(const Trust& trust, bool has_box, Console* console) {
  const std::string finding = ExplainsNothing(trust, has_box)
                                  ? "the drawing explains next to nothing of the images"
                                  : "only " + Percent(trust.right.value_or(0)) +
                                        " of the length found is expected to be right";
  console->Say("WARNING: " + finding +
               ": do not trust it. Usual causes: poses that belong to other images, wrong focal "
               "lengths or lenses, axes of another convention, images of other things or without "
               "edges, too few views or too different ones" +
               (has_box ? ", a box beside the scene" : ""));
}

void SayApart(const Trust& trust, Console* console) {
  console->Say("WARNING: the cameras of " + std::to_string(trust.apart.size()) + " of " +
               std::to_string(trust.num_images) +
               " images do not fit those of the others: " + ListNames(trust.apart) +
               ". Images of the two groups share " + Percent(trust.shared_if_apart) +
               " of the curves that they would share if all fitted, so that lines may be drawn "
               "twice. Usual causes: models that were merged wrongly, a loop that was not closed. "
               "Make the model anew, or draw the groups one by one (--image_list_path)");
}

void SayCertainty(const Trust& trust, Console* console) {
  console->Say(
      Percent(*trust.well_seen) + " of the drawing's length is seen by " +
      std::to_string(kManyImages) + " or more images; expected error, " +
      (trust.has_share_of_cameras ? "refined cameras included: " : "if the cameras are right: ") +
      ShortNumber(*trust.error_px) + " px (median), " + ShortNumber(*trust.error_90_px) +
      " px (90 %)");
}

bool IsMuchTentative(const Trust& trust) {
  return trust.tentative.value_or(0) - trust.unmeasured.value_or(0) > kMuchTentative;
}

bool HasNoDepth(const Trust& trust) { return trust.unmeasured.value_or(0) > kMostUnmeasured; }

void SayVerdict(const Trust& trust, bool has_box, Console* console) {
  const Verdict verdict = VerdictOf(trust, has_box);
  if (!trust.right && verdict != Verdict::kNonsense) return;
  std::string line = std::string("Verdict: ") + VerdictName(verdict);
  if (trust.right)
    line += ", " + Percent(*trust.right) + " of the length found is expected to be right";
  console->Say(line);
  // Without depth all links are tentative and explain nothing; that cause has been told.
  const bool is_few = trust.right.value_or(1) < kFewRight && !IsMuchTentative(trust);
  if ((verdict == Verdict::kNonsense || is_few) && !HasNoDepth(trust)) {
    WarnNotToTrust(trust, has_box, console);
  }
}

}  // namespace

Trust MeasureTrust(const ViewSet& set, const std::vector<View>& views,
                   const std::vector<ImageCurves>& curves, const DrawingGraph& graph,
                   const RunContext& context) {
  Trust trust;
  trust.num_images = set.CountImages(IdsOf(std::nullopt, views.size()));
  if (!curves.empty()) {
    AddAgreement(OfImages(set, MeasureAgreement(views, curves, graph)), &trust);
    AddExplanations(views, curves, graph, context, &trust);
  }
  AddWeakCut(set, views, graph, &trust);
  AddCertainty(set, views, graph, &trust);
  return trust;
}

const char* VerdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::kGood:
      return "good";
    case Verdict::kDoubtful:
      return "doubtful";
    case Verdict::kNonsense:
      return "nonsense";
  }
  return "";
}

Verdict VerdictOf(const Trust& trust, bool has_box) {
  if (ExplainsNothing(trust, has_box) || HasNoDepth(trust)) return Verdict::kNonsense;
  if (!trust.right) return Verdict::kDoubtful;
  if (*trust.right < kNonsenseShare) return Verdict::kNonsense;
  return *trust.right > kGoodShare && trust.apart.empty() ? Verdict::kGood : Verdict::kDoubtful;
}

void SayTrust(const Trust& trust, bool has_box, Console* console) {
  if (trust.explained) SayAgreement(trust, has_box, console);
  if (trust.tentative) {
    const bool is_much = IsMuchTentative(trust);
    console->Say((is_much ? "WARNING: " : "") + Percent(*trust.tentative) +
                 " of the length found is doubtful, hence tentative and not exported" +
                 (is_much
                      ? ": the images do not agree about it. Look at the cameras first, or take "
                        "photographs farther apart"
                      : ""));
  }
  if (trust.unmeasured.value_or(0) > kMuchUnmeasured) {
    console->Say("WARNING: the depth of " + Percent(*trust.unmeasured) +
                 " of the length found was not measured: its images were taken from nearly the "
                 "same place. Take photographs from places farther apart, or, if the object turned "
                 "before the camera, mask what stood still (--mask_path)");
  }
  if (trust.still.value_or(0) > kMuchStill) {
    console->Say("WARNING: " + Percent(*trust.still) +
                 " of the edges stand at the same pixels in images from different places, as text "
                 "in the pictures does, or the background if the object turned before the camera: "
                 "mask them (--mask_path)" +
                 (trust.right ? ". Curves along them are drawn only where they are sure" : ""));
  }
  if (trust.at_other_depths.value_or(0) > kMuchAtOtherDepths) {
    console->Say(
        "WARNING: " + Percent(*trust.at_other_depths) +
        " of the edges that are drawn fit curves at several depths, as stripes, fences and "
        "grids do that repeat in step with the cameras: those curves may be wrong by whole "
        "steps. Add photographs from other distances or directions");
  }
  if (!trust.apart.empty()) SayApart(trust, console);
  if (trust.error_px && trust.error_90_px) SayCertainty(trust, console);
  SayVerdict(trust, has_box, console);
}

Trust ReportTrust(const ViewSet& set, const DrawingInScene& drawing, Console* console) {
  static const std::vector<ImageCurves> unknown;
  const auto& curves = drawing.curves ? *drawing.curves : unknown;
  Trust trust = MeasureTrust(set, drawing.views, curves, drawing.graph, console->context());
  trust.has_share_of_cameras = drawing.has_share_of_cameras;
  SayTrust(trust, HasBox(drawing.metadata.options_json), console);
  return trust;
}

}  // namespace limn::colmap_ext
