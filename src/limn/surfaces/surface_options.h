#pragma once

namespace limn {

struct SurfaceOptions {
  // Shorter links bound no face, px.
  double min_length_px = 6;
  // The links of a face are within this of its plane, px.
  double plane_tolerance_px = 2;
  // Gaps between ends and links up to this are bridged if a face needs it, px.
  double max_bridge_px = 10;
  // A link may be extended straight beyond its end by at most this, px, and by this share of its
  // length, if it then meets another link.
  double max_extension_px = 150;
  double max_extension_share = 1;
  // A face is at least this wide, px: twice its area over its perimeter.
  double min_width_px = 2;
  // A place of a face is seen if this share of the border around it is shown, in at least min_views
  // views.
  double min_shown_share = 0.7;
  int min_views = 2;
  // Share of the places of a face that must be seen.
  double min_seen_share = 0.5;
  // Prior evidence for every face, added to that from occlusion; natural logarithm.
  double prior_evidence = 2;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
