#pragma once

#include <functional>
#include <string>
#include <vector>

#include "limn/util/byte_stream.h"
#include "limn/util/parallel.h"

namespace limn {

// Processes that run the same stages on the same input and share out the long loops.
class Team {
 public:
  virtual ~Team() = default;
  virtual int Rank() const = 0;
  virtual int Size() const = 0;
  // What each rank calls it with, by rank. All of them must, in the same order.
  virtual std::vector<std::string> Exchange(const std::string& mine) = 0;
};

// ParallelFor over the items of the context's team: body(i) runs on one rank, which writes what it
// made with put(i, out); the others take it over with get(i, in). Without a team put and get are
// not called. Results are those of one process if bodies write only what belongs to their item, and
// put and get carry all of it.
void TeamFor(const RunContext& context, const char* stage, size_t count,
             const std::function<void(size_t)>& body,
             const std::function<void(size_t, ByteWriter*)>& put,
             const std::function<void(size_t, ByteReader*)>& get);

}  // namespace limn
