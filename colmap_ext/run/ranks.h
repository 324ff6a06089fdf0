#pragma once

#include <string>
#include <vector>

#include "limn/util/team.h"

namespace limn::colmap_ext {

// The processes that mpirun or srun started together: a thin layer over Boost.MPI. A process that
// was started by itself is rank 0 of 1.

// For main: joins the others for as long as it lives.
class MpiSession {
 public:
  // Throws OptionError if it was started by MPI and Limn is built without.
  MpiSession();
  // Waits for the others.
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

int Rank();
int NumRanks();

// Wait until all ranks are here.
void WaitForAllRanks();

// Rank 0's word: every rank gets the value that rank 0 calls it with.
bool AsRankZero(bool value);

// All ranks as a team, and what they tell each other.
class RankTeam : public Team {
 public:
  int Rank() const override;
  int Size() const override;
  std::vector<std::string> Exchange(const std::string& mine) override;

  // Of all ranks together, to each of the others.
  size_t bytes_exchanged() const { return bytes_exchanged_; }

 private:
  size_t bytes_exchanged_ = 0;
};

// End the processes of all ranks with this exit code; with one rank it returns.
void AbortRanks(int exit_code);

}  // namespace limn::colmap_ext
