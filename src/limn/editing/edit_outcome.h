// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include <Eigen/Core>

namespace limn {

enum class EditStatus {
  kApplied,
  kPartly,     // to some of its links, or to a part of them
  kNotFound,   // what it refers to is not in the drawing, or has changed
  kAmbiguous,  // it may mean one of several links
  kNoSense,    // found, but there is nothing that could be done
};

struct EditOutcome {
  EditStatus status = EditStatus::kApplied;
  std::string text;  // what was done, or why not
  // A warning about an edit that was applied; may be empty.
  std::string warning = "";
};

// A stretch that an edit has closed, from end to end or from an end to its node.
struct BridgedGap {
  size_t edit = 0;  // its index
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double length_px = 0;
};

}  // namespace limn
