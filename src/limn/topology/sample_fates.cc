#include "limn/topology/sample_fates.h"

namespace limn {
namespace {

void SetFates(const DrawingGraph& graph, EdgelFate fate, SampleFates* fates) {
  for (const DrawingLink& link : graph.links) {
    for (const LinkVertex& vertex : link.vertices) {
      for (const SketchSample& from : vertex.samples) (*fates)[from.curve][from.sample] = fate;
    }
  }
}

}  // namespace

SampleLedger::SampleLedger(const CurveSketch& sketch, const DrawingGraph& graph) {
  for (const Curve3D& curve : sketch.curves) {
    fates_.emplace_back(curve.size(), EdgelFate::kLostSupport);
  }
  SetFates(graph, EdgelFate::kDrawn, &fates_);
}

void SampleLedger::Update(const DrawingGraph& graph, EdgelFate fate_of_lost) {
  for (std::vector<EdgelFate>& of_curve : fates_) {
    for (EdgelFate& fate : of_curve) {
      if (fate == EdgelFate::kDrawn) fate = fate_of_lost;
    }
  }
  SetFates(graph, EdgelFate::kDrawn, &fates_);
}

}  // namespace limn
