// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/listed_images.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <unordered_map>
#include <vector>

#include "colmap_ext/model/image_name.h"
#include "colmap_ext/workspace/name_encoding.h"
#include "limn/files/text_file.h"

namespace limn::colmap_ext {
namespace {

std::vector<std::string> ReadLines(const std::string& path) {
  std::istringstream in(ReadTextFile(path, kMaxListBytes));
  std::vector<std::string> lines;
  const char* space = " \t\r";
  for (std::string line; std::getline(in, line);) {
    const size_t begin = line.find_first_not_of(space);
    if (begin == std::string::npos) continue;
    lines.push_back(line.substr(begin, line.find_last_not_of(space) + 1 - begin));
  }
  return lines;
}

// Of one name; what has more slashes is no name.
constexpr size_t kMaxEnds = 64;

// The text and what follows its first folder, its second and so on: longest first.
std::vector<std::string> EndsOf(const std::string& text) {
  std::vector<std::string> ends = {text};
  if (static_cast<size_t>(std::ranges::count(text, '/')) >= kMaxEnds) return ends;
  for (size_t slash = text.find('/'); slash != std::string::npos;
       slash = text.find('/', slash + 1)) {
    ends.push_back(text.substr(slash + 1));
  }
  return ends;
}

// Finds images by their names and by the ends of these, read in one encoding.
class NameIndex {
 public:
  NameIndex(const SparseModel& model, const NameEncoding& encoding) {
    for (const ModelImage& image : model.images) {
      const auto text = TextOfName(image.StoredName(), encoding);
      if (!text) continue;
      Add(*text, image.name, &by_name_);
      for (const std::string& end : EndsOf(*text)) Add(end, image.name, &by_end_);
    }
  }

  // Null if the text names no image, or several.
  const std::string* Find(const std::string& text) const {
    for (const std::string& end : EndsOf(text)) {
      if (const std::string* name = Get(end, by_name_)) return name;
    }
    return Get(text, by_end_);
  }

 private:
  using Names = std::unordered_map<std::string, std::string>;

  // What names several images gets an empty name.
  static void Add(const std::string& text, const std::string& name, Names* names) {
    const auto [item, is_new] = names->emplace(text, name);
    if (!is_new && item->second != name) item->second.clear();
  }
  static const std::string* Get(const std::string& text, const Names& names) {
    const auto found = names.find(text);
    return found == names.end() || found->second.empty() ? nullptr : &found->second;
  }

  Names by_name_, by_end_;
};

using Found = std::vector<std::optional<std::string>>;

size_t CountFound(const Found& found) {
  return static_cast<size_t>(
      std::ranges::count_if(found, [](const auto& name) { return name.has_value(); }));
}

Found FindUnder(const std::vector<std::optional<std::string>>& texts, const NameIndex& index) {
  Found found(texts.size());
  for (size_t i = 0; i < texts.size(); ++i) {
    const std::string* name = texts[i] ? index.Find(*texts[i]) : nullptr;
    if (name) found[i] = *name;
  }
  return found;
}

// Those that names of images may be in.
std::vector<NameEncoding> EncodingsOf(const SparseModel& model) {
  std::vector<NameEncoding> encodings = NameEncodings();
  const bool are_utf8 = std::ranges::all_of(
      model.images, [](const ModelImage& image) { return image.name_bytes.empty(); });
  std::erase_if(encodings, [&](const NameEncoding& encoding) {
    return !encoding.mistaken_for.empty() || (are_utf8 && !encoding.code_page.empty());
  });
  return encodings;
}

// More lines than that are no list of the images of this model.
size_t MostLines(const SparseModel& model) { return 1000 + 4 * model.images.size(); }

// Under the encodings of lines and of names that find most; UTF-8 comes first.
Found FindAll(const std::vector<std::string>& lines, const SparseModel& model) {
  Found best(lines.size());
  if (lines.empty()) return best;
  std::vector<NameIndex> indices;
  for (const NameEncoding& encoding : EncodingsOf(model)) indices.emplace_back(model, encoding);
  for (const NameEncoding& encoding : NameEncodings()) {
    if (!encoding.code_page.empty() && lines.size() > MostLines(model)) return best;
    std::vector<std::optional<std::string>> texts;
    for (const std::string& line : lines) texts.push_back(TextOfName(line, encoding));
    for (const NameIndex& index : indices) {
      Found found = FindUnder(texts, index);
      if (CountFound(found) > CountFound(best)) best = std::move(found);
      if (CountFound(best) == lines.size()) return best;
    }
  }
  return best;
}

}  // namespace

ListedImages ReadListedImages(const std::string& path, const SparseModel& model) {
  std::unordered_map<std::string, const std::string*> exact;
  for (const ModelImage& image : model.images) {
    exact.emplace(image.StoredName(), &image.name);
    exact.emplace(image.name, &image.name);
  }
  ListedImages listed;
  std::vector<std::string> others;
  for (std::string& line : ReadLines(path)) {
    const auto found = exact.find(line);
    if (found != exact.end()) {
      listed.names.insert(*found->second);
    } else {
      others.push_back(std::move(line));
    }
  }
  const Found found = FindAll(others, model);
  for (size_t i = 0; i < others.size(); ++i) {
    if (found[i]) {
      listed.names.insert(*found[i]);
    } else if (listed.unknown.empty()) {
      listed.unknown = Utf8Name(others[i]);
    }
  }
  return listed;
}

}  // namespace limn::colmap_ext
