#pragma once

#include <cstdint>
#include <vector>

namespace limn {

// How far an edgel came as a sample of its own view's curves, and what stopped it.
enum class EdgelFate : uint8_t {
  kNotLinked,         // in no fragment
  kNotSketched,       // in a view that only confirms the curves of others
  kFragmentTooShort,  // in a fragment too short to be matched
  kNoPartner,         // no curve of another view fits it at any depth
  kTooFewViews,       // at no depth do enough views support it
  kInconsistent,      // supported, but not at a depth that goes along with its neighbors'
  kPieceTooShort,     // what was reconstructed around it is too short
  kSketched,          // in a curve of the sketch
  kLostSupport,       // of the sketch, but too few views support it where all its edgels agree
  kDoubtfulLink,      // in a link with too little support: see topology/verify_links.h
  kPrunedLink,        // in a link that was too short, or ran along another
  kDrawn,             // merged into a link of the drawing
  kExplained,         // not drawn itself, but a link of the drawing projects onto it
};
constexpr int kNumEdgelFates = static_cast<int>(EdgelFate::kExplained) + 1;

// In words, for tables.
const char* EdgelFateName(EdgelFate fate);

// Per view, per edgel of its edge map.
using EdgelFates = std::vector<std::vector<EdgelFate>>;
// Per curve of the sketch, per sample of the curve.
using SampleFates = std::vector<std::vector<EdgelFate>>;

}  // namespace limn
