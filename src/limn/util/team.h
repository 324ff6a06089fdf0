#pragma once

#include <string>
#include <vector>

namespace limn {

// Processes that run the same stages on the same input and share out the loops that are run by
// MapItems (map_items.h).
class Team {
 public:
  virtual ~Team() = default;
  virtual int Rank() const = 0;
  virtual int Size() const = 0;
  // What each rank calls it with, by rank. All of them must, in the same order.
  virtual std::vector<std::string> Exchange(const std::string& mine) = 0;
};

}  // namespace limn
