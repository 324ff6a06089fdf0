// SPDX-License-Identifier: BSD-3-Clause
#include "limn/edges/edge_detection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "limn/edges/edge_refinement.h"
#include "limn/edges/edge_signal.h"
#include "limn/edges/edgel_selection.h"
#include "limn/edges/gaussian_derivatives.h"
#include "limn/edges/grid_maxima.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using Eigen::Vector2d;

// A pixel up to 0.7 px beside the edge sees at least this share of its strength.
constexpr double kGridStrengthShare = 0.85;
const double kSimilarDirectionCosine = std::cos(0.6);
// Edgels of the main scale this near to one of the fine scale show the same edge, displaced by its
// neighbors or rounded at a corner, px.
constexpr double kSameEdgePx = 2;

// Three channels have more noise together than each has along the edge. With this factor as many
// false edgels are found in white noise as in one channel.
constexpr double kJointNoiseFactor = 1.35;

// Weakest edge of the finer scale at any noise, gray levels per px: 8-bit banding is weaker.
constexpr double kFineMinStrength = 1;
// An edgel weaker than this multiple of its threshold is dropped unless it belongs to a run of at
// least this length: noise makes weak edgels in short runs.
constexpr double kStrongRatio = 1.75;
constexpr double kMinRunPx = 7;
// Like the factors of the main channel; higher, as red and blue are noisier.
constexpr double kIsoluminantNoiseFactor = 3.5;
constexpr double kIsoluminantMinStrength = 1.5;
// Red and blue edgels within this of a similar main one show the same edge, dispersed by the lens.
constexpr double kIsoluminantDistancePx = 3;
// Beside a step that files show blurred in color (4:2:0), red and blue have slopes of the other
// sense. They are this near, px of the photograph,
constexpr double kEchoDistancePx = 4;
// and so many times weaker. The step may have been found at the fine scale, where it is stronger.
constexpr double kEchoRatio = 2;

// Per pixel of the view, 1 where edgels may be: inside the margin and away from masked pixels.
std::vector<unsigned char> UsablePixels(const Image& image, const EdgeDetectionOptions& options) {
  const int width = image.ViewWidth();
  const int height = image.ViewHeight();
  // The grid test needs one pixel on each side.
  const int margin =
      std::max(1, static_cast<int>(std::ceil(options.margin_px * image.scale.mean())));
  std::vector<unsigned char> usable(static_cast<size_t>(width) * height, 0);
  for (int y = margin; y < height - margin; ++y) {
    for (int x = margin; x < width - margin; ++x) usable[static_cast<size_t>(y) * width + x] = 1;
  }
  if (image.mask.empty()) return usable;
  const double reach = std::ceil(options.sigma_px);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (image.mask[static_cast<size_t>(y) * image.width + x] != 0) continue;
      const Eigen::Array2d half = 0.5 * image.scale.array() - 0.5 + reach;
      const Eigen::Array2d center = image.ToView({x, y}).array();
      const Eigen::Array2i low = (center - half).ceil().cast<int>().max(0);
      const Eigen::Array2i high =
          (center + half).floor().cast<int>().min(Eigen::Array2i(width, height) - 1);
      for (int v = low.y(); v <= high.y(); ++v) {
        const auto row = usable.begin() + static_cast<std::ptrdiff_t>(v) * width;
        std::fill(row + low.x(), row + high.x() + 1, 0);
      }
    }
  }
  return usable;
}

bool InUsablePixel(const std::vector<unsigned char>& usable, int width, const Edgel& edgel) {
  const auto x = std::lround(edgel.position_px.x());
  const auto y = std::lround(edgel.position_px.y());
  return usable[static_cast<size_t>(y) * width + x] != 0;
}

RefinementContext ContextOf(const EdgeSignal& signal, double noise_factor, double min_strength) {
  if (signal.planes.size() > 1) noise_factor *= kJointNoiseFactor;
  // The share of pixels where noise makes an edgel falls as exp(-factor^2 / 2): as many of them in
  // the image at any scale.
  const double more_pixels = std::max(1.0, signal.scale.prod());
  noise_factor = std::sqrt(noise_factor * noise_factor + 2 * std::log(more_pixels));
  return {signal.scale.mean(), signal.sigma_px, signal.noise, noise_factor, min_strength};
}

// Below this magnitude the pixel grid shows no edge at any gray level.
double LowestMagnitude(const RefinementContext& context) {
  double lowest_noise = std::numeric_limits<double>::infinity();
  for (const NoiseModel& model : context.noise) {
    const auto& noise = model.noise;
    const double lowest = noise.empty() ? 0 : *std::min_element(noise.begin(), noise.end());
    lowest_noise = std::min(lowest_noise, lowest);
  }
  return kGridStrengthShare * context.ThresholdFor(lowest_noise);
}

// Edgels are told to this, far below what noise does to them; finer bits would only fill the cache.
constexpr double kPlaceStepPx = 1.0 / 256;
constexpr double kTangentStepRad = 1.0 / 512;  // pi is rounded down
constexpr int kStrengthBits = 7;
constexpr int kSigmaBits = 5;

double RoundedTo(double value, double step) { return step * std::round(value / step); }

float WithBits(float value, int num_bits) {
  int exponent = 0;
  const float mantissa = std::frexp(value, &exponent);
  return std::ldexp(std::round(std::ldexp(mantissa, num_bits)), exponent - num_bits);
}

// Stays in its pixel: edgels of an edge through the corners of pixels would share one.
double RoundedPlace(double coordinate_px) {
  const double pixel = std::round(coordinate_px);
  return pixel +
         std::clamp(RoundedTo(coordinate_px - pixel, kPlaceStepPx), -0.5, 0.5 - kPlaceStepPx);
}

void RoundEdgel(Edgel* edgel) {
  for (double& coordinate : edgel->position_px) coordinate = RoundedPlace(coordinate);
  edgel->stored_px = edgel->position_px.cast<float>();
  edgel->tangent_rad = RoundedTo(edgel->tangent_rad, kTangentStepRad);
  edgel->strength = WithBits(edgel->strength, kStrengthBits);
  edgel->position_sigma_px = WithBits(edgel->position_sigma_px, kSigmaBits);
}

// All refined edgels of a signal, unsorted and with duplicates. `skip(position, tangent)`, where
// the tangent has any length, tells which grid candidates not to refine.
template <typename Skip>
std::vector<RefinedEdgel> DetectInSignal(const EdgeSignal& signal, const RefinementContext& context,
                                         const std::vector<unsigned char>& usable,
                                         const Skip& skip) {
  std::vector<SubpixelDerivatives> derivatives;
  for (const PaddedPlane& plane : signal.planes) {
    derivatives.emplace_back(plane, *signal.kernels, signal.scale.array());
  }
  const GradientField& gradient = signal.gradient;
  const int width = gradient.width;
  const float lowest = static_cast<float>(LowestMagnitude(context));
  std::vector<int32_t> near_maximum(width);
  std::vector<RefinedEdgel> edgels;
  for (int y = 1; y < gradient.height - 1; ++y) {
    FindGridMaxima(gradient, signal.magnitude, y, lowest, near_maximum.data());
    for (int x = 1; x < width - 1; ++x) {
      const size_t i = static_cast<size_t>(y) * width + x;
      if (!near_maximum[x] || !usable[i]) continue;
      const double threshold =
          context.ThresholdFor(context.NoiseOf(gradient.smooth[i], signal.SharesAt(i)));
      if (signal.magnitude[i] < kGridStrengthShare * threshold) continue;
      if (skip(Vector2d(x, y), Vector2d(-gradient.dy[i], gradient.dx[i]))) continue;
      auto refined = RefineEdgel(derivatives, x, y, context);
      if (!refined) continue;
      RoundEdgel(&refined->edgel);
      if (InUsablePixel(usable, width, refined->edgel)) edgels.push_back(*refined);
    }
  }
  return edgels;
}

bool HasFineScale(const EdgeDetectionOptions& options) {
  return options.fine_sigma_px > 0 && options.fine_sigma_px < options.sigma_px;
}

// Are there channels to search beside those of the main search?
bool HasMoreColors(const Image& image, const EdgeDetectionOptions& options) {
  return options.find_isoluminant && image.channels == 3 && options.channel != EdgeChannel::kColor;
}

void AddFineEdgels(const Image& image, const std::vector<ChannelValues>& channels,
                   const EdgeDetectionOptions& options, const std::vector<unsigned char>& usable,
                   EdgelRaster* raster) {
  const EdgeSignal signal = PrepareSignal(channels, image, options.fine_sigma_px);
  const RefinementContext context = ContextOf(signal, options.fine_noise_factor, kFineMinStrength);
  raster->AddStrongestFirst(
      DetectInSignal(signal, context, usable, [](const auto&, const auto&) { return false; }));
  raster->DropWeakShortRuns(kStrongRatio, kMinRunPx);
}

// Those that the fine scale has not found. Returns the mean noise of the gradient.
double AddMainEdgels(const Image& image, const std::vector<ChannelValues>& channels,
                     const EdgeDetectionOptions& options, const std::vector<unsigned char>& usable,
                     EdgelRaster* raster) {
  const EdgeSignal signal = PrepareSignal(channels, image, options.sigma_px);
  const RefinementContext context = ContextOf(signal, options.noise_factor, options.min_strength);
  const auto is_fine = [&](const Vector2d& position, const Vector2d& tangent) {
    return raster->HasParallelNear(position, tangent, kSameEdgePx, /*min_cosine=*/0);
  };
  raster->AddStrongestFirst(DetectInSignal(signal, context, usable, is_fine));
  raster->DropWeakShortRuns(kStrongRatio, kMinRunPx);
  return signal.noise[0].Mean();
}

// Edges of equal brightness: edgels of red and blue that no main edgel accounts for. The two
// channels see the same edge some px apart, so the one that sees more claims its neighborhood.
void AddIsoluminantEdgels(const Image& image, const EdgeDetectionOptions& options,
                          const std::vector<unsigned char>& usable, EdgelRaster* raster) {
  const auto explained = [&](const Vector2d& position, const Vector2d& tangent) {
    return raster->HasParallelNear(position, tangent, kIsoluminantDistancePx,
                                   kSimilarDirectionCosine);
  };
  std::vector<RefinedEdgel> of_channel[2];
  double total_strength[2] = {0, 0};
  for (int k = 0; k < 2; ++k) {
    const EdgeSignal signal =
        PrepareSignal({ExtractChannel(image, k == 0 ? 0 : 2)}, image, options.sigma_px);
    const RefinementContext context =
        ContextOf(signal, kIsoluminantNoiseFactor, kIsoluminantMinStrength);
    of_channel[k] = DetectInSignal(signal, context, usable, explained);
    std::erase_if(of_channel[k], [&](const RefinedEdgel& refined) {
      return raster->HasOppositeNear(refined.edgel, kEchoDistancePx * image.scale.mean(),
                                     kSimilarDirectionCosine, kEchoRatio);
    });
    for (const RefinedEdgel& refined : of_channel[k]) total_strength[k] += refined.edgel.strength;
  }
  const int first = total_strength[1] > total_strength[0] ? 1 : 0;
  raster->AddStrongestFirst(of_channel[first]);
  std::vector<RefinedEdgel>& rest = of_channel[1 - first];
  std::erase_if(rest, [&](const RefinedEdgel& refined) {
    return explained(refined.edgel.position_px, refined.edgel.Tangent());
  });
  raster->AddStrongestFirst(rest);
  raster->DropWeakShortRuns(kStrongRatio, kMinRunPx);
}

void CheckImage(const Image& image) {
  const size_t size = static_cast<size_t>(image.width) * image.height;
  if (image.width <= 0 || image.height <= 0) throw InputError("image has no pixels");
  if (image.channels != 1 && image.channels != 3) {
    throw InputError("image has " + std::to_string(image.channels) + " channels, need 1 or 3");
  }
  if (image.data.size() != size * image.channels) {
    throw InputError("image data do not match the image size");
  }
  if (!image.mask.empty() && image.mask.size() != size) {
    throw InputError("mask does not match the image size");
  }
}

}  // namespace

EdgeMap DetectEdges(const Image& image, const EdgeDetectionOptions& options) {
  options.Check();
  CheckImage(image);
  const std::vector<unsigned char> usable = UsablePixels(image, options);
  EdgeMap map;
  EdgelRaster raster(image.ViewWidth(), image.ViewHeight());
  {
    // One scale after the other, each with its planes.
    const std::vector<ChannelValues> channels = SearchedChannels(image, options.channel);
    if (HasFineScale(options)) AddFineEdgels(image, channels, options, usable, &raster);
    map.gradient_noise = AddMainEdgels(image, channels, options, usable, &raster);
  }
  if (HasMoreColors(image, options)) AddIsoluminantEdgels(image, options, usable, &raster);
  map.width = image.ViewWidth();
  map.height = image.ViewHeight();
  map.edgels = raster.Edgels();
  map.texture = raster.Texture(options.texture_density);
  return map;
}

}  // namespace limn
