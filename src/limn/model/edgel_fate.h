// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace limn {

// The last stage that an edgel reached as a sample of its own view's curves, or why it was dropped.
enum class EdgelFate : uint8_t {
  kNotLinked,         // in no fragment
  kTexture,           // one of dense texture, and therefore in no fragment
  kNotSketched,       // in a view that only confirms curves of other views
  kFragmentTooShort,  // in a fragment too short to be matched
  kNoPartner,         // no curve of another view fits it at any depth
  kTooFewViews,       // at no depth do enough views support it
  kInconsistent,      // supported, but not at a depth consistent with its neighbors'
  kPieceTooShort,     // in a reconstructed piece that is too short
  kSketched,          // in a curve of the sketch
  kLostSupport,       // sketched, but re-triangulated to where too few views support it
  kNotTraced,         // re-triangulated, but no traced curve stands for it
  kDoubtfulLink,      // in a link with too little support: see topology/verify_links.h
  kPrunedLink,        // in a link that was too short, or ran along another
  kDrawn,             // in a link of the drawing
  kExplained,         // not drawn, but a link of the drawing projects onto it
};
constexpr int kNumEdgelFates = static_cast<int>(EdgelFate::kExplained) + 1;

// A description, for tables.
const char* EdgelFateName(EdgelFate fate);

// Per view, per edgel of its edge map.
using EdgelFates = std::vector<std::vector<EdgelFate>>;
// Per curve of the sketch, per sample of the curve.
using SampleFates = std::vector<std::vector<EdgelFate>>;

}  // namespace limn
