// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace limn::colmap_ext {

// An element of an XML file.
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::string text;  // all of it, without that of the children
  std::vector<XmlElement> children;
  int line = 1;

  // Null if there is no such child; of several the first.
  const XmlElement* Child(const std::string& child) const;
  // Empty if there is no such attribute.
  std::string Attribute(const std::string& attribute) const;
};

// The root of an XML text in UTF-8: elements, attributes, text, the five entities of XML and
// numeric ones, CDATA; comments, instructions and a DOCTYPE without content are skipped. Throws
// IoError with the line if it is malformed, has entities of its own, or is nested more than 100
// deep. Linear in the text.
XmlElement ParseXml(const std::string& path, const std::string& text);

}  // namespace limn::colmap_ext
