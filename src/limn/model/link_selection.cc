// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/link_selection.h"

#include <sstream>
#include <vector>

#include "limn/util/errors.h"
#include "limn/util/name_table.h"

namespace limn {
namespace {

constexpr NameTable<Detail, kNumDetails> kDetails = {{"coarse", "normal", "all"}};
constexpr double kCoarseCurvePx = 80;

}  // namespace

const char* DetailName(Detail detail) { return kDetails.Of(detail); }

Detail DetailFromName(const std::string& name) {
  const auto detail = kDetails.Find(name);
  if (!detail) throw OptionError("detail = " + name + ": must be coarse, normal or all");
  return *detail;
}

LinkSelection::LinkSelection() {
  kinds.fill(true);
  kinds[static_cast<int>(LinkKind::kContour)] = false;
  kinds[static_cast<int>(LinkKind::kTexture)] = false;
}

LinkSelection LinkSelection::AsSeen() {
  LinkSelection selection;
  selection.rods_as_outlines = true;
  return selection;
}

void LinkSelection::Set(Detail detail) {
  if (detail == Detail::kNormal) return;
  kinds[static_cast<int>(LinkKind::kTexture)] = detail == Detail::kAll;
  min_curve_px = detail == Detail::kCoarse ? kCoarseCurvePx : 0;
}

bool LinkSelection::Has(const DrawingLink& link) const {
  if (link.curve_px > 0 && link.curve_px < min_curve_px) return false;
  const auto has = [&](LinkKind kind) { return kinds[static_cast<int>(kind)]; };
  if (rods_as_outlines && link.kind == LinkKind::kRod) return false;
  if (rods_as_outlines && link.doubt == LinkDoubt::kRodOutline) return has(LinkKind::kRod);
  return has(link.kind) && (tentative || !link.tentative);
}

std::array<bool, kNumLinkKinds> KindsFromNames(const std::string& names) {
  if (names == "default") return LinkSelection().kinds;
  std::array<bool, kNumLinkKinds> kinds = {};
  if (names == "all") {
    kinds.fill(true);
    return kinds;
  }
  // A comma at the end, so that an empty last name is one.
  std::istringstream list(names + ',');
  for (std::string name; std::getline(list, name, ',');) {
    const auto kind = LinkKindNamed(name);
    if (!kind) {
      throw OptionError("kinds = " + names + ": \"" + name +
                        "\" is none of edge, paint, shadow, contour, rod, texture, unknown");
    }
    kinds[static_cast<int>(*kind)] = true;
  }
  return kinds;
}

DrawingGraph Selected(DrawingGraph graph, const LinkSelection& selection) {
  std::vector<uint8_t> keep;
  for (const DrawingLink& link : graph.links) keep.push_back(selection.Has(link));
  for (size_t id = 0; id < graph.links.size(); ++id) {
    graph.links[id].number = NumberOfLink(graph, id);
  }
  for (size_t id = 0; id < graph.nodes.size(); ++id) {
    graph.nodes[id].number = NumberOfNode(graph, id);
  }
  RemoveLinks(keep, &graph);
  return graph;
}

}  // namespace limn
