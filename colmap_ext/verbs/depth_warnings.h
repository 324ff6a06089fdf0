// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/dense_files/products.h"
#include "limn/dense/depth_trust.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// What to say about dense results that are not those of the drawing, with the likely cause and what
// to do; empty if all are.
std::string DepthWarning(const DepthTrust& trust, const DenseProducts& products,
                         const std::vector<View>& views);

}  // namespace limn::colmap_ext
