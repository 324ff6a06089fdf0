// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/xml_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

TEST(XmlText, HasElementsAttributesAndText) {
  const XmlElement root = ParseXml("a.xml",
                                   "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!-- a --> <!DOCTYPE d>\n"
                                   "<d version='2' label=\"&lt;&#228;&#x20AC;&amp;\">\n"
                                   "  <e id=\"1\"/>one<!-- < -->two<![CDATA[<3>]]>\n"
                                   "  <e id = \"2\" >x</e >\n</d>\n");
  EXPECT_EQ(root.name, "d");
  EXPECT_EQ(root.line, 3);
  EXPECT_EQ(root.Attribute("version"), "2");
  EXPECT_EQ(root.Attribute("label"), "<\xC3\xA4\xE2\x82\xAC&");
  EXPECT_EQ(root.Attribute("none"), "");
  EXPECT_THAT(root.text, HasSubstr("onetwo<3>"));
  ASSERT_EQ(root.children.size(), 2u);
  EXPECT_EQ(root.Child("e"), &root.children[0]);
  EXPECT_EQ(root.Child("f"), nullptr);
  EXPECT_EQ(root.children[1].text, "x");
  EXPECT_EQ(root.children[1].line, 5);
}

TEST(XmlText, MalformedFilesAreRefused) {
  std::string deep;
  for (int i = 0; i < 200; ++i) deep += "<a>";
  for (const std::string& text :
       {std::string(), std::string("text"), std::string("<a>"), std::string("<a></b>"),
        std::string("<a"), std::string("<a b=1/>"), std::string("<a b=\"1/>"),
        std::string("<a>&unknown;</a>"), std::string("<a>&#0;</a>"), std::string("<a>&amp</a>"),
        std::string("<a/><b/>"), std::string("<!DOCTYPE a [<!ENTITY b \"c\">]><a/>"),
        std::string("<!-- <a/>"), std::string("<a><![CDATA[</a>"), deep}) {
    EXPECT_THAT(ErrorText<IoError>([&] { ParseXml("a.xml", text); }),
                HasSubstr("a.xml: line 1: not XML"))
        << text.substr(0, 20);
  }
}

}  // namespace
}  // namespace limn::colmap_ext
