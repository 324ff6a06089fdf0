// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/util/team.h"

namespace limn::colmap_ext {

// The processes that mpirun or srun started together, by MPI (mpi_backend.h). A process started on
// its own is rank 0 of 1.

// Initializes MPI during its lifetime; for main.
class MpiSession {
 public:
  // Throws OptionError if the process was started by MPI but there is no plug-in for it.
  MpiSession();
  // Waits for the other ranks.
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

int Rank();
int NumRanks();

// Waits until all ranks have called it, each with the error in its part of the work, or an empty
// text. After an error, rank 0 throws std::runtime_error with the first text, its rank and host,
// and the others wait for AbortRanks, so that one line is printed however many ranks failed. A
// process on its own throws its own text.
void MeetAllRanks(const std::string& error);

// What rank 0 tells the others, once: whether there is work for them. They wait for it.
enum class RankOrder { kWork, kEnd };
void TellOtherRanks(RankOrder order);
RankOrder WaitForRankZero();

// All ranks, as a team that exchanges results.
class RankTeam : public Team {
 public:
  int Rank() const override;
  int Size() const override;
  std::vector<std::string> Exchange(const std::string& mine) override;

  // Bytes sent by all ranks together to each of the others.
  size_t bytes_exchanged() const { return bytes_exchanged_; }

 private:
  size_t bytes_exchanged_ = 0;
};

// Ends the processes of all ranks with this exit code; returns if there is only one.
void AbortRanks(int exit_code);

}  // namespace limn::colmap_ext
