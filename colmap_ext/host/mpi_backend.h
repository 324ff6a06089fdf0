// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace limn::colmap_ext {

// What ranks need of MPI. It is initialized during the lifetime of the object, whose end waits for
// the other ranks. For the main thread only.
class MpiBackend {
 public:
  virtual ~MpiBackend() = default;

  virtual int Rank() const = 0;
  virtual int Size() const = 0;
  virtual std::string HostName() const = 0;
  // Each of these is called by all ranks. What rank 0 has given, on every rank.
  virtual int Broadcast(int value) const = 0;
  // What all ranks have given, by rank.
  virtual std::vector<std::string> Gather(const std::string& mine) const = 0;
  virtual void Wait() const = 0;
  // Ends the processes of all ranks.
  virtual void Abort(int exit_code) const = 0;
};

}  // namespace limn::colmap_ext
