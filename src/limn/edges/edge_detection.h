// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/edges/edge_channel.h"
#include "limn/model/edge_map.h"
#include "limn/model/image.h"
#include "limn/util/option_fields.h"
#include "limn/util/option_help.h"

namespace limn {

struct EdgeDetectionOptions {
  EdgeChannel channel = EdgeChannel::kGreen;

  // Larger: less noise, weaker edges found, but strands closer than about 3 sigma merge and corners
  // are rounded.
  double sigma_px = 1.5;

  // Smaller: weaker edges and more false edgels (in white noise 3 per 1,000 px^2).
  double noise_factor = 2.3;

  // At any noise. Below 0.6, the 8-bit banding of smooth shading causes edges.
  double min_strength = 0.6;

  // Not with color, which shows such edges anyway.
  bool find_isoluminant = true;

  // 0.18 finds leaves (FindDenseTexture). Measured, no better: algorithm/edges.md#dense-texture.
  double texture_density = 0;

  double margin_px = 8.0;

  // Finer scale, for edges that rise enough above the noise there, px; not used if it is 0 or not
  // below sigma_px. It separates strands down to about 2 times this. sigma_px then adds the edges
  // that are weaker or blurred. Set by tests only, as the next.
  double fine_sigma_px = 1;
  // Like noise_factor, at the finer scale.
  double fine_noise_factor = 8;

  template <typename Self, typename Visit>
  static void VisitFields(Self& self, const Visit& visit) {
    visit("channel", self.channel, OneOf({"green", "luminance", "color"}),
          "channel of positions and directions");
    visit("sigma_px", self.sigma_px, Between(0.8, 5), "scale of the Gaussian derivatives, px");
    visit("noise_factor", self.noise_factor, Above(0, 100),
          "weakest edge in multiples of the image's gradient noise");
    visit("min_strength", self.min_strength, Between(0, 1e4),
          BasicOption("weakest edge, gray levels per px"));
    visit("find_isoluminant", self.find_isoluminant, OnOrOff(),
          "also find edges in red or blue only");
    visit("texture_density", self.texture_density, Between(0, 1),
          "short edgels per px^2 from which texture is not linked, 0 = all are linked");
    visit("margin_px", self.margin_px, Between(0, 1e5), "unused border of the image, px");
  }
  // Throws OptionError.
  void Check() const { CheckFields(*this); }
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
// edgels must be part of a run of edgels that continue each other: noise makes short runs. Those of
// dense texture are listed in EdgeMap::texture.
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
