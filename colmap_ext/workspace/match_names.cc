// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/match_names.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "colmap_ext/model/image_name.h"
#include "colmap_ext/workspace/name_encoding.h"

namespace limn::colmap_ext {
namespace {

// Names of one project are not in more encodings.
constexpr int kMaxRounds = 16;

bool IsAscii(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char c) { return c < 0x80; });
}

// The texts of names under every encoding. Those in ASCII are the same under all.
class NameTexts {
 public:
  explicit NameTexts(const std::vector<std::string>& names) : texts_(NameEncodings().size()) {
    for (size_t e = 0; e < texts_.size(); ++e) {
      for (const std::string& name : names) {
        const bool is_same = e > 0 && IsAscii(name);
        texts_[e].push_back(is_same ? texts_[0][texts_[e].size()]
                                    : TextOfName(name, NameEncodings()[e]).value_or(""));
      }
    }
  }

  // Empty where a name is no text in this encoding.
  const std::vector<std::string>& Under(size_t encoding) const { return texts_[encoding]; }

 private:
  std::vector<std::vector<std::string>> texts_;
};

// By text the place in the list; -1 if several have it.
using Places = std::unordered_map<std::string, int>;

Places PlacesOf(const std::vector<std::string>& texts, const std::vector<char>& is_free) {
  Places places;
  for (size_t i = 0; i < texts.size(); ++i) {
    if (texts[i].empty() || !is_free[i]) continue;
    const auto [place, is_new] = places.emplace(texts[i], static_cast<int>(i));
    if (!is_new) place->second = -1;
  }
  return places;
}

// Encodings of names and of files.
struct Way {
  size_t of_names = 0;
  size_t of_files = 0;
};

// Simple ones first: one side is UTF-8, then both are in code pages.
std::vector<Way> AllWays() {
  const std::vector<NameEncoding>& encodings = NameEncodings();
  std::vector<Way> ways;
  for (size_t e = 0; e < encodings.size(); ++e) {
    ways.push_back({e, 0});
    if (e > 0) ways.push_back({0, e});
  }
  for (size_t a = 1; a < encodings.size(); ++a) {
    for (size_t b = 1; b < encodings.size(); ++b) {
      const bool are_plain = encodings[a].mistaken_for.empty() && encodings[b].mistaken_for.empty();
      if (a != b && are_plain) ways.push_back({a, b});
    }
  }
  return ways;
}

constexpr int kNone = -1;
constexpr int kSeveral = -2;

// Per name the file under one way; kNone, or kSeveral names or files of that text.
std::vector<int> FilesUnder(const std::vector<std::string>& names, const Places& files,
                            const std::vector<char>& is_open) {
  const Places own = PlacesOf(names, is_open);
  std::vector<int> file_of(names.size(), kNone);
  for (size_t i = 0; i < names.size(); ++i) {
    const auto file = is_open[i] ? files.find(names[i]) : files.end();
    if (names[i].empty() || file == files.end()) continue;
    const bool is_one = own.at(names[i]) >= 0 && file->second >= 0;
    file_of[i] = is_one ? file->second : kSeveral;
  }
  return file_of;
}

struct Round {
  Way way;
  std::vector<int> file_of;
  std::vector<AmbiguousName> ambiguous;
  int count = 0;
};

std::string DescribeWay(const Way& way, int count, const std::string& name,
                        const std::string& file) {
  const std::string num = std::to_string(count);
  const std::string example = " (\"" + Utf8Name(name) + "\" is " + Utf8Name(file) + ")";
  if (way.of_names == 0 && way.of_files == 0) {
    return num +
           " names are written with other characters that look the same, or with back slashes" +
           example;
  }
  const auto text_of = [](size_t encoding) { return NameEncodings()[encoding].text; };
  return num + " names are in " + text_of(way.of_names) + ", those of the files in " +
         text_of(way.of_files) + example;
}

class Matcher {
 public:
  Matcher(const std::vector<std::string>& names, const std::vector<std::string>& files)
      : names_(names),
        files_(files),
        texts_of_names_(names),
        texts_of_files_(files),
        is_open_(names.size(), 1),
        is_free_(files.size(), 1) {
    matches_.file_of.assign(names.size(), -1);
  }

  NameMatches Run() {
    // What is ambiguous as it stands is not decided by another encoding.
    Close(FilesUnder(texts_of_names_.Under(0), PlacesOf(texts_of_files_.Under(0), is_free_),
                     is_open_));
    for (int rounds = 0; rounds < kMaxRounds; ++rounds) {
      const Round round = BestRound();
      if (round.count == 0) break;
      Accept(round);
    }
    return std::move(matches_);
  }

 private:
  // Names that fit several files, or share one, have none.
  void Close(const std::vector<int>& file_of) {
    for (size_t i = 0; i < file_of.size(); ++i) {
      if (file_of[i] == kSeveral) is_open_[i] = 0;
    }
  }

  // Of the ways that match most names the first; the others must not contradict it.
  Round BestRound() const {
    Round best;
    std::vector<Places> places;
    for (size_t e = 0; e < NameEncodings().size(); ++e) {
      places.push_back(PlacesOf(texts_of_files_.Under(e), is_free_));
    }
    for (const Way& way : AllWays()) {
      std::vector<int> file_of =
          FilesUnder(texts_of_names_.Under(way.of_names), places[way.of_files], is_open_);
      const auto count =
          static_cast<int>(std::ranges::count_if(file_of, [](int file) { return file >= 0; }));
      if (count > best.count) {
        best = {way, std::move(file_of), {}, count};
      } else if (count == best.count && count > 0) {
        AddContradictions(file_of, &best);
      }
    }
    return best;
  }

  static void AddContradictions(const std::vector<int>& file_of, Round* best) {
    for (size_t i = 0; i < file_of.size(); ++i) {
      const int first = best->file_of[i];
      if (first >= 0 && file_of[i] >= 0 && first != file_of[i]) {
        best->ambiguous.push_back({static_cast<int>(i), first, file_of[i]});
      }
    }
  }

  void Accept(const Round& round) {
    for (const AmbiguousName& name : round.ambiguous) {
      if (is_open_[name.name]) matches_.ambiguous.push_back(name);
      is_open_[name.name] = 0;
    }
    Close(round.file_of);
    int count = 0, example = -1;
    for (size_t i = 0; i < names_.size(); ++i) {
      const int file = round.file_of[i];
      if (file < 0 || !is_open_[i]) continue;
      matches_.file_of[i] = file;
      is_open_[i] = is_free_[file] = 0;
      if (example < 0) example = static_cast<int>(i);
      ++count;
    }
    if (count == 0) return;
    matches_.ways.push_back(
        DescribeWay(round.way, count, names_[example], files_[matches_.file_of[example]]));
  }

  const std::vector<std::string>& names_;
  const std::vector<std::string>& files_;
  NameTexts texts_of_names_, texts_of_files_;
  std::vector<char> is_open_, is_free_;
  NameMatches matches_;
};

}  // namespace

NameMatches MatchNames(const std::vector<std::string>& names,
                       const std::vector<std::string>& files) {
  if (names.empty() || files.empty()) return {std::vector<int>(names.size(), -1), {}, {}};
  return Matcher(names, files).Run();
}

}  // namespace limn::colmap_ext
