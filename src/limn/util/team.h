// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace limn {

// Processes that run the same stages on the same input and share the loops of MapItems
// (map_items.h).
class Team {
 public:
  virtual ~Team() = default;
  virtual int Rank() const = 0;
  virtual int Size() const = 0;
  // Returns what each rank passed, by rank. All ranks must make the same calls in the same order.
  virtual std::vector<std::string> Exchange(const std::string& mine) = 0;
};

}  // namespace limn
