// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/ranks.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "colmap_ext/host/interrupt.h"
#include "colmap_ext/host/plugin.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// By Open MPI's mpirun, by others with PMI, or by srun.
bool IsStartedByMpi() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMIX_RANK");
}

// None: the process was started on its own.
std::unique_ptr<MpiBackend>& Backend() {
  static std::unique_ptr<MpiBackend> backend;
  return backend;
}

void MeetOtherRanks(const std::string& error) {
  const std::string place =
      "rank " + std::to_string(Rank()) + " on " + Backend()->HostName() + ": ";
  const auto errors = RankTeam().Exchange(error.empty() ? "" : place + error);
  const auto first = std::find_if(errors.begin(), errors.end(),
                                  [](const std::string& text) { return !text.empty(); });
  if (first == errors.end()) return;
  if (Rank() == 0) throw std::runtime_error(*first);
  Backend()->Wait();  // which rank 0 never does
}

// What rank 0 sends, on every rank.
RankOrder OrderOfRankZero(RankOrder sent) {
  if (NumRanks() == 1) return sent;
  return static_cast<RankOrder>(Backend()->Broadcast(static_cast<int>(sent)));
}

}  // namespace

MpiSession::MpiSession() {
  if (!IsStartedByMpi()) return;
  const InterruptsBlocked in_its_threads;
  try {
    Backend() = LoadMpi();
  } catch (const IoError& error) {
    throw OptionError(std::string("started by mpirun or srun, but ") + error.what() +
                      "; without MPI, start shards (--shard i/n)");
  }
}
MpiSession::~MpiSession() { Backend().reset(); }

int Rank() { return Backend() ? Backend()->Rank() : 0; }
int NumRanks() { return Backend() ? Backend()->Size() : 1; }

void TellOtherRanks(RankOrder order) { OrderOfRankZero(order); }
RankOrder WaitForRankZero() { return OrderOfRankZero(RankOrder::kEnd); }

std::vector<std::string> RankTeam::Exchange(const std::string& mine) {
  if (!Backend()) return {mine};
  const std::vector<std::string> of_ranks = Backend()->Gather(mine);
  for (const std::string& text : of_ranks) bytes_exchanged_ += text.size() * (of_ranks.size() - 1);
  return of_ranks;
}

void AbortRanks(int exit_code) {
  if (NumRanks() > 1) Backend()->Abort(exit_code);
}

void MeetAllRanks(const std::string& error) {
  if (NumRanks() > 1) return MeetOtherRanks(error);
  if (!error.empty()) throw std::runtime_error(error);
}

int RankTeam::Rank() const { return colmap_ext::Rank(); }
int RankTeam::Size() const { return NumRanks(); }

}  // namespace limn::colmap_ext
