// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "bench/kernel_images.h"
#include "colmap_ext/workspace/image_reader.h"
#include "limn/edges/edge_detection.h"
#include "limn/edges/gaussian_derivatives.h"
#include "limn/edges/gradient_noise.h"
#include "limn/edges/grid_maxima.h"

namespace limn::bench {
namespace {

constexpr double kSigmaPx = 1.5;

// The first channel.
PaddedPlane SamplePlane() {
  const Image& image = SamplePhotograph();
  std::vector<float> values(static_cast<size_t>(image.width) * image.height);
  for (size_t i = 0; i < values.size(); ++i) values[i] = image.data[i * image.channels];
  return MakePaddedPlane(values, image.width, image.height, GaussianPadding(kSigmaPx, 1));
}

void ReadImage(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        colmap_ext::ReadImage(LIMN_SAMPLE_DIR "/day/images/view_00.jpg").data.data());
  }
  ReportPerMegapixel(state);
}
BENCHMARK(ReadImage)->Unit(benchmark::kMillisecond);

void DetectEdges(benchmark::State& state) {
  const Image& image = SamplePhotograph();
  for (auto _ : state) benchmark::DoNotOptimize(limn::DetectEdges(image, {}).edgels.data());
  ReportPerMegapixel(state);
}
BENCHMARK(DetectEdges)->Unit(benchmark::kMillisecond);

void SmoothedGradient(benchmark::State& state) {
  const PaddedPlane plane = SamplePlane();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        limn::SmoothedGradient(plane, GaussianKernels(kSigmaPx, 1), plane.width, plane.height)
            .dx.data());
  }
  ReportPerMegapixel(state);
}
BENCHMARK(SmoothedGradient)->Unit(benchmark::kMillisecond);

void MeasureNoise(benchmark::State& state) {
  const PaddedPlane plane = SamplePlane();
  const GradientField gradient =
      limn::SmoothedGradient(plane, GaussianKernels(kSigmaPx, 1), plane.width, plane.height);
  for (auto _ : state) benchmark::DoNotOptimize(limn::MeasureNoise(plane, gradient, kSigmaPx));
  ReportPerMegapixel(state);
}
BENCHMARK(MeasureNoise)->Unit(benchmark::kMillisecond);

void FindGridMaxima(benchmark::State& state) {
  const PaddedPlane plane = SamplePlane();
  const GradientField gradient =
      limn::SmoothedGradient(plane, GaussianKernels(kSigmaPx, 1), plane.width, plane.height);
  const std::vector<float> magnitude = GradientMagnitude(gradient);
  std::vector<int32_t> near_maximum(plane.width);
  for (auto _ : state) {
    for (int y = 1; y < plane.height - 1; ++y) {
      limn::FindGridMaxima(gradient, magnitude, y, 1, near_maximum.data());
      benchmark::DoNotOptimize(near_maximum.data());
    }
  }
  ReportPerMegapixel(state);
}
BENCHMARK(FindGridMaxima)->Unit(benchmark::kMillisecond);

// Time of one point.
void SubpixelDerivatives(benchmark::State& state) {
  const PaddedPlane plane = SamplePlane();
  const GaussianKernels kernels(kSigmaPx, 1);
  const limn::SubpixelDerivatives derivatives(plane, kernels, Eigen::Array2d::Ones());
  double x = 100;
  for (auto _ : state) {
    benchmark::DoNotOptimize(derivatives.At({x, 200.25}));
    x = x < 200 ? x + 1.0 / GaussianKernels::kNodesPerPx : 100;
  }
}
BENCHMARK(SubpixelDerivatives);

}  // namespace
}  // namespace limn::bench
