#include "limn/edges/edge_detection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "limn/edges/edge_refinement.h"
#include "limn/edges/edgel_selection.h"
#include "limn/edges/gaussian_derivatives.h"
#include "limn/edges/gradient_noise.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// A pixel up to 0.7 px beside the edge sees at least this share of its strength.
constexpr double kGridStrengthShare = 0.85;
// The parabola through three grid values errs; the exact refinement decides.
constexpr double kMaxGridOffsetPx = 1.0;
constexpr double kSimilarDirectionRad = 0.6;

// One channel prepared for detection.
struct Channel {
  PaddedPlane plane;
  GradientField gradient;
  std::vector<float> magnitude;
  NoiseModel noise;
};

std::vector<float> ExtractChannel(const Image& image, int channel) {
  const size_t size = static_cast<size_t>(image.width) * image.height;
  std::vector<float> values(size);
  for (size_t i = 0; i < size; ++i) values[i] = image.data[i * image.channels + channel];
  return values;
}

// Rec. 601 luma.
std::vector<float> Luminance(const Image& image) {
  const size_t size = static_cast<size_t>(image.width) * image.height;
  std::vector<float> values(size);
  for (size_t i = 0; i < size; ++i) {
    const float* rgb = image.data.data() + 3 * i;
    values[i] = 0.299f * rgb[0] + 0.587f * rgb[1] + 0.114f * rgb[2];
  }
  return values;
}

Channel PrepareChannel(const std::vector<float>& values, int width, int height, double sigma_px) {
  Channel channel;
  channel.plane = MakePaddedPlane(values, width, height, GaussianPadding(sigma_px));
  channel.gradient = SmoothedGradient(channel.plane, sigma_px);
  channel.magnitude.resize(values.size());
  for (size_t i = 0; i < values.size(); ++i) {
    const float dx = channel.gradient.dx[i];
    const float dy = channel.gradient.dy[i];
    channel.magnitude[i] = std::sqrt(dx * dx + dy * dy);
  }
  channel.noise = MeasureNoise(channel.plane, channel.gradient, sigma_px);
  return channel;
}

// Magnitude where the ray from pixel i in direction (dx, dy) leaves the 3 x 3 neighbourhood,
// linearly interpolated between the two border pixels.
float MagnitudeAhead(const Channel& channel, size_t i, float dx, float dy) {
  const int width = channel.plane.width;
  const bool steep = std::abs(dy) > std::abs(dx);
  const std::ptrdiff_t major = steep ? (dy > 0 ? width : -width) : (dx > 0 ? 1 : -1);
  const float slope = steep ? dx / std::abs(dy) : dy / std::abs(dx);
  const std::ptrdiff_t minor = (slope > 0 ? 1 : -1) * (steep ? 1 : width);
  const float share = std::abs(slope);
  const float* at = channel.magnitude.data() + i + major;
  return (1 - share) * at[0] + share * at[minor];
}

// Is the grid magnitude at pixel i near a maximum along the gradient? Needs a 1 px border.
bool NearMaximum(const Channel& channel, size_t i) {
  const float dx = channel.gradient.dx[i];
  const float dy = channel.gradient.dy[i];
  const float here = channel.magnitude[i];
  const float ahead = MagnitudeAhead(channel, i, dx, dy);
  const float behind = MagnitudeAhead(channel, i, -dx, -dy);
  const double reach = here / std::max(std::abs(dx), std::abs(dy));
  const double bend = ahead + behind - 2 * here;
  if (!(bend < 0)) return false;
  const double offset = -0.5 * (ahead - behind) / bend * reach;
  return std::abs(offset) <= kMaxGridOffsetPx;
}

// 1 where edgels may be: inside the margin and away from masked pixels.
std::vector<unsigned char> UsablePixels(const Image& image, const EdgeDetectionOptions& options) {
  const int width = image.width;
  const int height = image.height;
  // The grid test needs one pixel on each side.
  const int margin = std::max(1, static_cast<int>(std::ceil(options.margin_px)));
  std::vector<unsigned char> usable(static_cast<size_t>(width) * height, 0);
  for (int y = margin; y < height - margin; ++y) {
    for (int x = margin; x < width - margin; ++x) usable[static_cast<size_t>(y) * width + x] = 1;
  }
  if (image.mask.empty()) return usable;
  const int reach = static_cast<int>(std::ceil(options.sigma_px));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (image.mask[static_cast<size_t>(y) * width + x] != 0) continue;
      for (int v = std::max(0, y - reach); v <= std::min(height - 1, y + reach); ++v) {
        const auto row = usable.begin() + static_cast<std::ptrdiff_t>(v) * width;
        std::fill(row + std::max(0, x - reach), row + std::min(width - 1, x + reach) + 1, 0);
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

// All refined edgels of a channel, unsorted and with duplicates. `skip(x, y, tangent)` tells which
// grid candidates not to refine.
template <typename Skip>
std::vector<RefinedEdgel> DetectInChannel(const Channel& channel, const RefinementContext& context,
                                          const std::vector<unsigned char>& usable,
                                          const Skip& skip) {
  const SubpixelDerivatives derivatives(channel.plane, context.sigma_px);
  const int width = channel.plane.width;
  // Below this nowhere an edge.
  double lowest = std::numeric_limits<double>::max();
  for (const double level : context.noise.level) {
    lowest = std::min(lowest, kGridStrengthShare * context.ThresholdAt(level));
  }
  if (context.noise.level.empty()) lowest = kGridStrengthShare * context.ThresholdAt(0);
  std::vector<RefinedEdgel> edgels;
  for (int y = 0; y < channel.plane.height; ++y) {
    for (int x = 0; x < width; ++x) {
      const size_t i = static_cast<size_t>(y) * width + x;
      if (!usable[i] || !(channel.magnitude[i] > lowest) || !NearMaximum(channel, i)) continue;
      const double threshold = context.ThresholdAt(channel.gradient.smooth[i]);
      if (channel.magnitude[i] < kGridStrengthShare * threshold) continue;
      if (skip(x, y, std::atan2(channel.gradient.dx[i], -channel.gradient.dy[i]))) continue;
      const auto refined = RefineEdgel(derivatives, x, y, context);
      if (refined && InUsablePixel(usable, width, refined->edgel)) edgels.push_back(*refined);
    }
  }
  return edgels;
}

// Edges of equal brightness: edgels of red and blue that no main edgel accounts for. The two
// channels see the same edge up to 2 px apart, so the one that sees more claims its neighbourhood.
void AddIsoluminantEdgels(const Image& image, const EdgeDetectionOptions& options,
                          const std::vector<unsigned char>& usable, EdgelRaster* raster) {
  const double near_px = options.isoluminant_distance_px;
  const auto explained = [near_px](const EdgelRaster& by, double x, double y, double tangent_rad) {
    return by.HasParallelNear(x, y, tangent_rad, near_px, kSimilarDirectionRad);
  };
  std::vector<RefinedEdgel> of_channel[2];
  double total_strength[2] = {0, 0};
  for (int k = 0; k < 2; ++k) {
    const Channel channel = PrepareChannel(ExtractChannel(image, k == 0 ? 0 : 2), image.width,
                                           image.height, options.sigma_px);
    const RefinementContext context{options.sigma_px, channel.noise,
                                    options.isoluminant_noise_factor,
                                    options.isoluminant_min_strength};
    of_channel[k] = DetectInChannel(channel, context, usable, [&](int x, int y, double tangent) {
      return explained(*raster, x, y, tangent);
    });
    for (const RefinedEdgel& refined : of_channel[k]) total_strength[k] += refined.edgel.strength;
  }
  const int first = total_strength[1] > total_strength[0] ? 1 : 0;
  raster->AddStrongestFirst(of_channel[first]);
  std::vector<RefinedEdgel>& rest = of_channel[1 - first];
  std::erase_if(rest, [&](const RefinedEdgel& refined) {
    const Edgel& edgel = refined.edgel;
    return explained(*raster, edgel.position_px.x(), edgel.position_px.y(), edgel.tangent_rad);
  });
  raster->AddStrongestFirst(rest);
  raster->DropWeakShortRuns(options.strong_ratio, options.min_run_px);
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

void EdgeDetectionOptions::Check() const {
  if (channel != "green" && channel != "luminance") {
    throw OptionError("channel = " + channel + ": must be green or luminance");
  }
  LIMN_CHECK_OPTION(sigma_px, >= 0.8);
  LIMN_CHECK_OPTION(sigma_px, <= 5);
  LIMN_CHECK_OPTION(noise_factor, > 0);
  LIMN_CHECK_OPTION(noise_factor, <= 100);
  LIMN_CHECK_OPTION(min_strength, >= 0);
  LIMN_CHECK_OPTION(min_run_px, >= 0);
  LIMN_CHECK_OPTION(strong_ratio, >= 1);
  LIMN_CHECK_OPTION(isoluminant_noise_factor, > 0);
  LIMN_CHECK_OPTION(isoluminant_min_strength, >= 0);
  LIMN_CHECK_OPTION(isoluminant_distance_px, >= 0);
  LIMN_CHECK_OPTION(margin_px, >= 0);
}

EdgeMap DetectEdges(const Image& image, const EdgeDetectionOptions& options) {
  options.Check();
  CheckImage(image);
  const bool colour = image.channels == 3;
  const std::vector<float> values = !colour                      ? image.data
                                    : options.channel == "green" ? ExtractChannel(image, 1)
                                                                 : Luminance(image);
  const Channel channel = PrepareChannel(values, image.width, image.height, options.sigma_px);
  const RefinementContext context{options.sigma_px, channel.noise, options.noise_factor,
                                  options.min_strength};
  const std::vector<unsigned char> usable = UsablePixels(image, options);

  EdgelRaster raster(image.width, image.height);
  raster.AddStrongestFirst(
      DetectInChannel(channel, context, usable, [](int, int, double) { return false; }));
  raster.DropWeakShortRuns(options.strong_ratio, options.min_run_px);
  if (colour && options.find_isoluminant) AddIsoluminantEdgels(image, options, usable, &raster);

  EdgeMap map;
  map.width = image.width;
  map.height = image.height;
  map.edgels = raster.InPixelOrder();
  map.gradient_noise = channel.noise.Mean();
  return map;
}

}  // namespace limn
