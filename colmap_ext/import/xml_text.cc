// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/xml_text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "limn/files/text_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

constexpr int kMaxXmlDepth = 100;
constexpr std::string_view kXmlSpace = " \t\r\n";
constexpr std::string_view kNameEnd = " \t\r\n=/>";

void AppendUtf8(uint32_t code, std::string* text) {
  const auto put = [&](uint32_t byte) { text->push_back(static_cast<char>(byte)); };
  const auto put_rest = [&](int shift) { put(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | (code >> 6));
    put_rest(0);
  } else if (code < 0x10000) {
    put(0xE0 | (code >> 12));
    put_rest(6);
    put_rest(0);
  } else {
    put(0xF0 | (code >> 18));
    put_rest(12);
    put_rest(6);
    put_rest(0);
  }
}

class XmlScanner {
 public:
  XmlScanner(const std::string& path, std::string_view text) : path_(path), text_(text) {}

  XmlElement Document() {
    at_ = MarkLength(path_, text_);
    SkipMisc();
    XmlElement root = Element(1);
    SkipMisc();
    if (at_ < text_.size()) Fail("text behind the last element");
    return root;
  }

 private:
  [[noreturn]] void Fail(const std::string& reason) {
    FilePlace{path_, "line", static_cast<uint64_t>(Line())}.Fail("not XML: " + reason);
  }

  int Line() {
    line_ += static_cast<int>(std::count(text_.begin() + counted_, text_.begin() + at_, '\n'));
    counted_ = at_;
    return line_;
  }

  bool Starts(std::string_view with) const { return text_.substr(at_).starts_with(with); }
  void SkipSpace() { at_ = std::min(text_.find_first_not_of(kXmlSpace, at_), text_.size()); }

  // Behind the next `end`; what is before it.
  std::string_view Until(std::string_view end) {
    const size_t found = text_.find(end, at_);
    if (found == text_.npos) Fail("\"" + std::string(end) + "\" is missing");
    const std::string_view before = text_.substr(at_, found - at_);
    at_ = found + end.size();
    return before;
  }

  // A comment, instruction or DOCTYPE at the place; returns whether there is one.
  bool SkipOne() {
    if (Starts("<!--")) {
      Until("-->");
    } else if (Starts("<?")) {
      Until("?>");
    } else if (Starts("<!DOCTYPE")) {
      if (Until(">").find('[') != std::string_view::npos) Fail("a DOCTYPE with definitions");
    } else {
      return false;
    }
    return true;
  }

  void SkipMisc() {
    SkipSpace();
    while (SkipOne()) SkipSpace();
  }

  std::string Name() {
    const size_t end = std::min(text_.find_first_of(kNameEnd, at_), text_.size());
    if (end == at_) Fail("a name is missing");
    const std::string name(text_.substr(at_, end - at_));
    at_ = end;
    return name;
  }

  void AppendEntity(std::string_view entity, std::string* out) {
    static constexpr std::pair<std::string_view, char> kKnown[] = {
        {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
    for (const auto& [name, character] : kKnown) {
      if (entity == name) return out->push_back(character);
    }
    const bool is_hex = entity.starts_with("#x");
    const std::string_view digits = entity.substr(std::min<size_t>(is_hex ? 2 : 1, entity.size()));
    uint32_t code = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, is_hex ? 16 : 10);
    if (!entity.starts_with("#") || error != std::errc() || end != digits.data() + digits.size() ||
        code == 0 || code > 0x10FFFF) {
      Fail("unknown entity \"" + std::string(entity.substr(0, 20)) + "\"");
    }
    AppendUtf8(code, out);
  }

  void AppendDecoded(std::string_view raw, std::string* out) {
    while (true) {
      const size_t entity = raw.find('&');
      out->append(raw.substr(0, entity));
      if (entity == raw.npos) return;
      const size_t end = raw.find(';', entity);
      if (end == raw.npos) Fail("\"&\" without \";\"");
      AppendEntity(raw.substr(entity + 1, end - entity - 1), out);
      raw = raw.substr(end + 1);
    }
  }

  void Attributes(XmlElement* element) {
    for (SkipSpace(); !Starts("/") && !Starts(">"); SkipSpace()) {
      const std::string name = Name();
      SkipSpace();
      if (!Starts("=")) Fail("\"=\" is missing");
      ++at_;
      SkipSpace();
      if (!Starts("\"") && !Starts("'")) Fail("an attribute without quotes");
      const std::string_view quote = text_.substr(at_++, 1);
      std::string value;
      AppendDecoded(Until(quote), &value);
      element->attributes.emplace_back(name, std::move(value));
    }
  }

  // The place is behind the start of the element; moves it behind its end.
  void Content(XmlElement* element, int depth) {
    while (true) {
      const size_t markup = text_.find('<', at_);
      if (markup == text_.npos) Fail("<" + element->name + "> is not closed");
      AppendDecoded(text_.substr(at_, markup - at_), &element->text);
      at_ = markup;
      if (Starts("</")) break;
      if (Starts("<![CDATA[")) {
        at_ += 9;
        element->text += Until("]]>");
      } else if (!SkipOne()) {
        element->children.push_back(Element(depth + 1));
      }
    }
    at_ += 2;
    const std::string name = Name();
    SkipSpace();
    if (name != element->name || !Starts(">")) Fail("<" + element->name + "> is not closed");
    ++at_;
  }

  XmlElement Element(int depth) {
    if (depth > kMaxXmlDepth) Fail("nested more than " + std::to_string(kMaxXmlDepth) + " deep");
    if (!Starts("<")) Fail("\"<\" expected");
    XmlElement element;
    element.line = Line();
    ++at_;
    element.name = Name();
    Attributes(&element);
    if (Starts("/>")) {
      at_ += 2;
    } else if (Starts(">")) {
      ++at_;
      Content(&element, depth);
    } else {
      Fail("<" + element.name + " is not closed");
    }
    return element;
  }

  const std::string& path_;
  std::string_view text_;
  size_t at_ = 0;
  size_t counted_ = 0;
  int line_ = 1;
};

}  // namespace

const XmlElement* XmlElement::Child(const std::string& child) const {
  const auto found = std::ranges::find(children, child, &XmlElement::name);
  return found == children.end() ? nullptr : &*found;
}

std::string XmlElement::Attribute(const std::string& attribute) const {
  for (const auto& [name_of, value] : attributes) {
    if (name_of == attribute) return value;
  }
  return "";
}

XmlElement ParseXml(const std::string& path, const std::string& text) {
  return XmlScanner(path, text).Document();
}

}  // namespace limn::colmap_ext
