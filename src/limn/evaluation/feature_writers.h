// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include <nlohmann/json_fwd.hpp>

#include "limn/evaluation/feature_scores.h"

namespace limn {

// A table of circles and a line for each kind of other features, of those that there are.
void PrintFeatures(const FeatureScores& scores, double tau, std::ostream& out);

// Adds "circles", "crossings", "t_junctions", "corners", "pairs" and "rods", which is null if there
// are no true ones.
void AddFeatures(const FeatureScores& scores, nlohmann::ordered_json* json);

}  // namespace limn
