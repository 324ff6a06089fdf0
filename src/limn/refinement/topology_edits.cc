#include "limn/refinement/topology_edits.h"

namespace limn {

TopologyEditCounts EditTopology(GraphEditor* editor) {
  if (!editor->HasPlaces()) return {};
  TopologyEditCounts counts;
  counts.trimmed = TrimEnds(editor);
  counts.joined = JoinAlignedEnds(editor);
  const SnapCounts snaps = SnapEnds(editor);
  counts.to_nodes = snaps.to_nodes;
  counts.to_links = snaps.to_links;
  counts.corners = SplitAtCorners(editor);
  return counts;
}

}  // namespace limn
