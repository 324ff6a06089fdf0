// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "bench/kernel_images.h"
#include "limn/linking/curvelets.h"
#include "limn/linking/link_graph.h"
#include "limn/linking/linking.h"
#include "limn/linking/tangent_fit.h"

namespace limn::bench {
namespace {

void LinkEdgels(benchmark::State& state) {
  const EdgeMap& edgels = SampleEdgels();
  for (auto _ : state) {
    benchmark::DoNotOptimize(limn::LinkEdgels(edgels, {}).curves.fragments.data());
  }
  ReportPerMegapixel(state);
}
BENCHMARK(LinkEdgels)->Unit(benchmark::kMillisecond);

void BuildLinkGraph(benchmark::State& state) {
  const EdgeMap& edgels = SampleEdgels();
  for (auto _ : state) {
    benchmark::DoNotOptimize(limn::BuildLinkGraph(edgels.edgels, {}, nullptr).data());
  }
  ReportPerMegapixel(state);
}
BENCHMARK(BuildLinkGraph)->Unit(benchmark::kMillisecond);

void RefitTangents(benchmark::State& state) {
  ImageCurves curves = limn::LinkEdgels(SampleEdgels(), {}).curves;
  for (auto _ : state) {
    for (const CurveFragment& fragment : curves.fragments) {
      limn::RefitTangents(fragment, kTangentArmPx, &curves.edge_map.edgels);
    }
  }
  ReportPerMegapixel(state);
}
BENCHMARK(RefitTangents)->Unit(benchmark::kMillisecond);

// Time of one edgel.
void CurveletsAround(benchmark::State& state) {
  const std::vector<Edgel>& edgels = SampleEdgels().edgels;
  const LinkingOptions options;
  CurveletBuilder builder(edgels, options);
  size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(builder.Around(static_cast<EdgelId>(i)));
    i = (i + 1) % edgels.size();
  }
}
BENCHMARK(CurveletsAround);

}  // namespace
}  // namespace limn::bench
