#include "limn/belief/loose_pieces.h"

#include "limn/belief/confidence.h"
#include "limn/util/union_find.h"

namespace limn {
namespace {

// Of a loose piece, px. A link with kSureEvidence holds it.
constexpr double kLoosePx = 60;

struct Piece {
  double length_px = 0;
  bool is_held = false;
};

}  // namespace

void DoubtLoosePieces(const std::vector<double>& length_px, const std::vector<double>& evidence,
                      DrawingGraph* graph) {
  UnionFind nodes(static_cast<int>(graph->nodes.size()));
  for (const DrawingLink& link : graph->links) {
    if (link.doubt == LinkDoubt::kNone) nodes.Union(link.node0, link.node1);
  }
  std::vector<Piece> pieces(graph->nodes.size());
  for (size_t l = 0; l < graph->links.size(); ++l) {
    const DrawingLink& link = graph->links[l];
    if (link.doubt != LinkDoubt::kNone) continue;
    Piece& piece = pieces[nodes.Find(link.node0)];
    piece.length_px += length_px[l];
    piece.is_held |= link.closed || evidence[l] >= kSureEvidence;
  }
  for (DrawingLink& link : graph->links) {
    if (link.doubt != LinkDoubt::kNone) continue;
    const Piece& piece = pieces[nodes.Find(link.node0)];
    if (!piece.is_held && piece.length_px < kLoosePx) link.doubt = LinkDoubt::kChance;
  }
}

}  // namespace limn
