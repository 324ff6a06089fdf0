// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/link_sightings.h"

#include <algorithm>

namespace limn {

std::vector<LinkSighting> SightingsIn(const View& view, ViewId id,
                                      const std::vector<ImageEvidence>& links) {
  std::vector<LinkSighting> sightings(links.size());
  for (size_t l = 0; l < links.size(); ++l) {
    const auto sight = std::ranges::lower_bound(links[l].sights, id, {}, &LinkSight::view);
    if (sight == links[l].sights.end() || sight->view != id) continue;
    LinkSighting& sighting = sightings[l];
    const size_t size = links[l].samples.size();
    sighting.samples.assign(size, Sighting::kOutside);
    sighting.pixels.resize(size);
    for (size_t k = 0; k < size; ++k) {
      const auto pixel = view.Project(links[l].samples[k].position);
      if (!pixel) continue;
      sighting.samples[k] = Sighting::kHidden;
      sighting.pixels[k] = *pixel;
      sighting.extent.extend(*pixel);
    }
    for (const SampleHit& hit : sight->hits) {
      Sighting& sample = sighting.samples[hit.sample];
      if (sample != Sighting::kOutside) sample = hit.own ? Sighting::kShown : Sighting::kOther;
    }
  }
  return sightings;
}

}  // namespace limn
