#include "limn/model/link_selection.h"

#include <sstream>
#include <vector>

#include "limn/util/errors.h"

namespace limn {

LinkSelection::LinkSelection() {
  kinds.fill(true);
  kinds[static_cast<int>(LinkKind::kContour)] = false;
}

LinkSelection LinkSelection::AsSeen() {
  LinkSelection selection;
  selection.rods_as_outlines = true;
  return selection;
}

bool LinkSelection::Has(const DrawingLink& link) const {
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
                        "\" is none of edge, paint, shadow, contour, rod, unknown");
    }
    kinds[static_cast<int>(*kind)] = true;
  }
  return kinds;
}

DrawingGraph Selected(DrawingGraph graph, const LinkSelection& selection) {
  std::vector<uint8_t> keep;
  for (const DrawingLink& link : graph.links) keep.push_back(selection.Has(link));
  RemoveLinks(keep, &graph);
  return graph;
}

}  // namespace limn
