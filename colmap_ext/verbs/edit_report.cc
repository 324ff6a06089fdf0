// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/edit_report.h"

#include <algorithm>
#include <iterator>

#include "limn/util/name_list.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

// More with one outcome share a line.
constexpr size_t kMaxLines = 10;

struct Told {
  EditStatus status;
  const char* count;  // "applied 3"
  const char* name;   // before what the outcome says
};

constexpr Told kTold[] = {{EditStatus::kApplied, "applied", ""},
                          {EditStatus::kPartly, "in part", "applied in part: "},
                          {EditStatus::kNotFound, "not found", "not found: "},
                          {EditStatus::kAmbiguous, "ambiguous", "ambiguous: "},
                          {EditStatus::kNoSense, "without sense", "makes no sense: "}};

// A line to show at the place of an edit.
struct Line {
  size_t edit;
  std::string text;
};

class Report {
 public:
  Report(const std::vector<Edit>& edits, const std::vector<EditOutcome>& outcomes)
      : edits_(edits), outcomes_(outcomes) {}

  void AddOutcomes(const Told& told) {
    std::vector<size_t> chosen;
    for (size_t e = 0; e < outcomes_.size(); ++e) {
      if (outcomes_[e].status == told.status) chosen.push_back(e);
    }
    const std::string warning = told.status == EditStatus::kApplied ? "" : "WARNING: ";
    Add(chosen, warning, told.count, [&](size_t e) { return told.name + outcomes_[e].text; });
  }

  void AddWarnings() {
    std::vector<size_t> chosen;
    for (size_t e = 0; e < outcomes_.size(); ++e) {
      if (!outcomes_[e].warning.empty()) chosen.push_back(e);
    }
    Add(chosen, "WARNING: ", "applied with warnings",
        [&](size_t e) { return outcomes_[e].warning; });
  }

  // In the order of the edits.
  std::vector<std::string> Lines() {
    std::ranges::stable_sort(lines_, {}, &Line::edit);
    std::vector<std::string> texts;
    for (Line& line : lines_) texts.push_back(std::move(line.text));
    return texts;
  }

 private:
  std::string Place(size_t e) const {
    return "edits[" + std::to_string(e) + "] (" + EditName(edits_[e]) + ")";
  }

  template <typename TextOf>
  void Add(const std::vector<size_t>& chosen, const std::string& begin, const std::string& outcome,
           const TextOf& text_of) {
    if (chosen.size() > kMaxLines) {
      std::vector<std::string> names;
      for (const size_t e : chosen) names.push_back(Place(e));
      lines_.push_back({chosen.front(), begin + WithCommas(std::ssize(chosen)) + " edits " +
                                            outcome + ": " + ListNames(names) +
                                            "; the first: " + text_of(chosen.front())});
      return;
    }
    for (const size_t e : chosen) lines_.push_back({e, begin + Place(e) + ": " + text_of(e)});
  }

  const std::vector<Edit>& edits_;
  const std::vector<EditOutcome>& outcomes_;
  std::vector<Line> lines_;
};

}  // namespace

std::vector<std::string> LinesOfEdits(const std::vector<Edit>& edits,
                                      const std::vector<EditOutcome>& outcomes) {
  std::string counts = "edits: " + std::to_string(edits.size()) + ";";
  Report report(edits, outcomes);
  for (const Told& told : kTold) {
    const auto count = std::ranges::count(outcomes, told.status, &EditOutcome::status);
    counts += std::string(&told == kTold ? " " : ", ") + told.count + " " + std::to_string(count);
    report.AddOutcomes(told);
  }
  report.AddWarnings();
  std::vector<std::string> lines = {std::move(counts)};
  std::ranges::move(report.Lines(), std::back_inserter(lines));
  return lines;
}

}  // namespace limn::colmap_ext
