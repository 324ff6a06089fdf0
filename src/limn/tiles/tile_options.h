#pragma once

namespace limn {

struct TileOptions {
  // A scene of more views is drawn in tiles of at most this many, one at a time, so that memory
  // does not grow with the scene. 0: always in one piece.
  int max_views = 150;
  // Margin around its core within which a tile is drawn, so that curves near the border have their
  // surroundings, px.
  double reach_px = 200;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
