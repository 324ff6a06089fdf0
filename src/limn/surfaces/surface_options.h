#pragma once

namespace limn {

struct SurfaceOptions {
  // Shorter links bound no face, px.
  double min_length_px = 6;
  // The links of a face are within this of its plane, px.
  double plane_tolerance_px = 2;
  // Ends and links nearer than this are joined where a face asks for it, px.
  double max_bridge_px = 10;
  // A link goes straight on beyond its end for at most this, px, and this share of its length, if
  // it meets another one there.
  double max_extension_px = 150;
  double max_extension_share = 1;
  // A face is at least this wide, px: twice its area by its perimeter.
  double min_width_px = 2;
  // A place of a face is seen if that share of the border around it is shown, in so many views.
  double min_shown_share = 0.7;
  int min_views = 2;
  // Share of the places of a face that must be seen.
  double min_seen_share = 0.5;
  // Evidence of occlusion, natural logarithm, that counts for every face before the images are
  // asked.
  double prior_evidence = 2;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
