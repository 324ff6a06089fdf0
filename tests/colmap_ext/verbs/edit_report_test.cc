// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/edit_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(LinesOfEdits, TellsFewOneByOne) {
  const std::vector<Edit> edits(3, DeleteLinks());
  const std::vector<EditOutcome> outcomes = {{EditStatus::kNotFound, "no link runs along it"},
                                             {EditStatus::kApplied, "1 link", "it was long"},
                                             {EditStatus::kPartly, "1 of 2 links"}};
  EXPECT_THAT(
      LinesOfEdits(edits, outcomes),
      ElementsAre("edits: 3; applied 1, in part 1, not found 1, ambiguous 0, without sense 0",
                  "WARNING: edits[0] (delete): not found: no link runs along it",
                  "edits[1] (delete): 1 link", "WARNING: edits[1] (delete): it was long",
                  "WARNING: edits[2] (delete): applied in part: 1 of 2 links"));
}

TEST(LinesOfEdits, TellsManyOfAKindTogether) {
  const std::vector<Edit> edits(200'000, DeleteLinks());
  std::vector<EditOutcome> outcomes(edits.size(), {EditStatus::kNotFound, "no link runs along it"});
  const auto lines = LinesOfEdits(edits, outcomes);
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_EQ(lines[1],
            "WARNING: 200,000 edits not found: edits[0] (delete), edits[1] (delete), edits[2] "
            "(delete), edits[3] (delete), edits[4] (delete) and 199995 more; the first: not found: "
            "no link runs along it");
  outcomes[7] = {EditStatus::kAmbiguous, "two links"};
  EXPECT_THAT(LinesOfEdits(edits, outcomes),
              ElementsAre(HasSubstr("not found 199999"), HasSubstr("199,999 edits not found"),
                          "WARNING: edits[7] (delete): ambiguous: two links"));
}

}  // namespace
}  // namespace limn::colmap_ext
