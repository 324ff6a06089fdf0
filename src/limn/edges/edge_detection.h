#pragma once

#include <string>

#include "limn/model/edge_map.h"
#include "limn/model/image.h"

namespace limn {

struct EdgeDetectionOptions {
  // Channel that positions and orientations come from: "green", "luminance", or "color", which is
  // L, a and b jointly. Green agrees best with the true edges where the lens disperses colors. A
  // gray image has one channel only.
  std::string channel = "green";

  // Scale of the Gaussian derivatives, px, [0.8, 5]. Larger: less noise, weaker edges found, but
  // strands closer than about 3 sigma merge and corners are rounded.
  double sigma_px = 1.5;

  // Finer scale, for edges that rise enough above the noise there, px, 0.8 to 5; not used if it is
  // 0 or not below sigma_px. It separates strands down to about 2 times this. sigma_px then adds
  // the other edges.
  double fine_sigma_px = 1.0;

  // Weakest edge at the finer scale, in multiples of the gradient noise there, (0, 100], and in
  // gray levels per px, >= 0. At 8 times the noise the direction of an edgel errs by 6 degrees.
  double fine_noise_factor = 8;
  double fine_min_strength = 1;

  // Weakest edge in multiples of the gradient noise measured in the image, (0, 100]. Smaller:
  // weaker edges and more false edgels (together with min_run_px: in white noise 3 per 1,000 px^2).
  double noise_factor = 2.3;

  // Weakest edge at any noise, gray levels per px, >= 0. Below 0.6, the 8-bit banding of smooth
  // shading causes edges.
  double min_strength = 0.6;

  // An edgel weaker than strong_ratio times its threshold is dropped unless it belongs to a run of
  // edgels that continue each other over at least this length, px, >= 0. Noise makes short runs.
  double min_run_px = 7;
  double strong_ratio = 1.75;

  // Also search the red and blue channels, for edges that the main channel does not show. Not with
  // color, which shows them.
  bool find_isoluminant = true;

  // Like noise_factor and min_strength, for edges found only in red or blue.
  double isoluminant_noise_factor = 3.5;
  double isoluminant_min_strength = 1.5;

  // A red or blue edgel is dropped if an edgel of the main channel with a similar direction is
  // within this distance, px, >= 0. Must exceed the lens's dispersion, or edges are doubled.
  double isoluminant_distance_px = 3.0;

  // Edgels count as texture, and are not linked, where short runs of mixed directions have at least
  // this many per px^2, [0, 1]; 0 = off (FindDenseTexture). 0.18 finds leaves. Off: drawings are no
  // better with it (algorithm/edges.md#what-was-measured).
  double texture_density = 0;

  // Border of the image without edgels, px, >= 0.
  double margin_px = 8.0;

  // Throws OptionError.
  void Check() const;
};

// Finds the edgels of an image: the local maxima of the gradient magnitude along the gradient, that
// is, the zeros of the second directional derivative I_nn, with a sub-pixel position and an
// orientation that uses derivatives up to third order (Tamrakar and Kimia, "No grouping left
// behind", ICCV 2007).
//
// Candidates come from the gradient on the pixel grid. Each is refined with derivatives evaluated
// at the sub-pixel position by Newton steps on the logarithm of the gradient's profile along the
// normal, which is a parabola for a blurred step, then shifted against the bias that smoothing
// causes at curved edges. At most one edgel per pixel, none closer than 0.35 px to another. Weak
// edgels must be part of a run: see min_run_px. Those of dense texture are listed in
// EdgeMap::texture.
//
// With color, the gradient is the joint one of L, a and b (times 2.55, see LabChannels): the edge
// is where its magnitude is largest along its direction. That magnitude is the strength; between
// grays it is about that of one channel. Everything else is the same.
//
// Edges that rise enough above the noise of a finer scale are found there, as it separates
// neighboring edges and hardly displaces corners; the main scale finds the others (after the
// minimum reliable scale of Elder and Zucker, "Local scale control for edge detection and blur
// estimation", PAMI 1998).
//
// Positions are in the image as stored (stored_from_virtual is the identity, position_px =
// stored_px). Pixels where the mask is 0 hold no edgel, nor do those within sigma of one. Throws
// OptionError on bad options and InputError on an image whose data do not match its size. An image
// too small for the margin, or narrower than 6 px, has no edgels. Time: linear in pixels, plus
// about half a microsecond per candidate.
EdgeMap DetectEdges(const Image& image, const EdgeDetectionOptions& options);

}  // namespace limn
