// SPDX-License-Identifier: BSD-3-Clause
#include "bench/kernel_images.h"

#include "colmap_ext/workspace/image_reader.h"
#include "limn/edges/edge_detection.h"

namespace limn::bench {

const Image& SamplePhotograph() {
  static const Image image = colmap_ext::ReadImage(LIMN_SAMPLE_DIR "/day/images/view_00.jpg");
  return image;
}

const EdgeMap& SampleEdgels() {
  static const EdgeMap edgels = DetectEdges(SamplePhotograph(), {});
  return edgels;
}

void ReportPerMegapixel(benchmark::State& state) {
  const double megapixels = 1e-6 * SamplePhotograph().width * SamplePhotograph().height;
  const double sum = megapixels * static_cast<double>(state.iterations());
  state.counters["MP_per_s"] = benchmark::Counter(sum, benchmark::Counter::kIsRate);
  state.counters["s_per_MP"] =
      benchmark::Counter(sum, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace limn::bench
