// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/map_items.h"

#include <string>

#include "limn/util/team.h"

namespace limn {
namespace {

// Items between two exchanges: what keeps messages small beside the scene.
constexpr size_t kBlock = 1024;

// The items of [begin, end) that a rank makes: every Size()-th, so that all have about the same to
// do.
std::vector<size_t> ItemsOf(const Team& team, int rank, size_t begin, size_t end) {
  std::vector<size_t> items;
  for (size_t i = begin + rank; i < end; i += team.Size()) items.push_back(i);
  return items;
}

}  // namespace

namespace internal {

void ShareOut(const RunContext& context, const char* stage, size_t count,
              const std::function<void(size_t)>& make,
              const std::function<void(size_t, ByteWriter*)>& put,
              const std::function<void(size_t, ByteReader*)>& get) {
  if (!context.team) {
    ParallelFor(context, stage, count, make);
    return;
  }
  Team& team = *context.team;
  for (size_t begin = 0; begin < count; begin += kBlock) {
    const size_t end = std::min(begin + kBlock, count);
    const std::vector<size_t> mine = ItemsOf(team, team.Rank(), begin, end);
    ParallelFor(PartOf(context, begin, count), stage, mine.size(),
                [&](size_t m) { make(mine[m]); });
    ByteWriter out;
    for (const size_t i : mine) put(i, &out);
    const std::vector<std::string> results = team.Exchange(out.bytes());
    for (int rank = 0; rank < team.Size(); ++rank) {
      if (rank == team.Rank()) continue;
      ByteReader in("results of rank " + std::to_string(rank), results[rank]);
      for (const size_t i : ItemsOf(team, rank, begin, end)) get(i, &in);
      in.ExpectEnd();
    }
  }
}

}  // namespace internal

}  // namespace limn
