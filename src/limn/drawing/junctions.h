#pragma once

#include <memory>
#include <vector>

#include "limn/drawing/link_ends.h"
#include "limn/support/view_evidence.h"

namespace limn {

struct JunctionCounts {
  int64_t continued = 0;               // pairs of ends joined into one link
  int64_t corners = 0;                 // nodes made of two or more ends
  int64_t t_junctions = 0;             // ends joined to the inside of a link
  int64_t joined_nodes = 0;            // ends joined to a node that was there
  int64_t without_image_evidence = 0;  // meetings in space that the images do not show
};

// Find where links meet although they share no samples (algorithm.md 0.1 item 1): free ends that
// continue each other across a gap become one link, free ends whose lines meet become a corner, a
// free end whose line meets another link becomes a T junction; always within max_junction_gap_px
// and max_junction_miss_px, and only where in min_junction_views views image curves that support
// both links come near the projected meeting point. Node positions are fitted to the lines of all
// their links.
// The counts are added to what was joined before; meetings without evidence are those of this call.
void JoinLinks(const SampleSet& samples, const std::vector<View>& views,
               const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
               const DrawingOptions& options, Draft* draft, JunctionCounts* counts);

// The steps of JoinLinks, in their order. Free ends that continue each other across a gap become
// one link.
void JoinContinuations(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                       JunctionCounts* counts);
// Free ends whose lines meet become a node, fitted to the lines of all its links.
void JoinCorners(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                 JunctionCounts* counts);
// A free end whose line passes a node ends there.
void JoinToNodes(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                 JunctionCounts* counts);
// A free end whose line meets the inside of another link cuts it: a T junction.
void JoinToInteriors(const DrawingOptions& options, LinkEnds& ends, Draft* draft,
                     JunctionCounts* counts);

}  // namespace limn
