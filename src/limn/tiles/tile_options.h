#pragma once

namespace limn {

struct TileOptions {
  // A scene of more views is drawn in tiles of at most so many, one after the other, so that memory
  // does not grow with the scene; 0 = in one piece, however large.
  int max_views = 150;
  // How far beyond its borders a tile is drawn, so that its curves near them know their
  // surroundings, px.
  double reach_px = 200;

  // Throws OptionError.
  void Check() const;
};

}  // namespace limn
