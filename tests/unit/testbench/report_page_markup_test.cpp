// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/markup.h"

#include <gtest/gtest.h>

namespace cbvh::testbench {
namespace {

TEST(Markup, text_and_attributes_are_escaped) {
  EXPECT_EQ(element("td", "<b>&\"'").html(), "<td>&lt;b&gt;&amp;&quot;&#39;</td>");
  EXPECT_EQ(element("a", {{"href", "\"><script>"}}, "x").html(), "<a href=\"&quot;&gt;&lt;script&gt;\">x</a>");
}

TEST(Markup, elements_nest_and_those_without_content_do_not_close) {
  Markup row = element("td", "1");
  row += element("td", "2");
  EXPECT_EQ(element("tr", Attributes{}, row).html(), "<tr><td>1</td><td>2</td></tr>");
  EXPECT_EQ(element("img", {{"alt", ""}}).html(), "<img alt=\"\">");
  EXPECT_EQ(element("i", Attributes{}).html(), "<i></i>");
}

TEST(Markup, what_html_cannot_hold_is_replaced) {
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(Markup::text(std::string("a\0b\x1b\x7f", 5)).html(), "a" + replaced + "b" + replaced + replaced);
  EXPECT_EQ(Markup::text("\tx\n").html(), "\tx\n");
  // Alone, overlong, a surrogate, beyond U+10FFFF, cut short.
  EXPECT_EQ(Markup::text("\xFFx").html(), replaced + "x");
  EXPECT_EQ(Markup::text("\xC0\xBC").html(), replaced + replaced);
  EXPECT_EQ(Markup::text("\xE0\x80\xBC").html(), replaced + replaced + replaced);
  EXPECT_EQ(Markup::text("\xED\xA0\x80").html(), replaced + replaced + replaced);
  EXPECT_EQ(Markup::text("\xF4\x90\x80\x80").html(), replaced + replaced + replaced + replaced);
  EXPECT_EQ(Markup::text("\xE2\x9C").html(), replaced + replaced);
}

TEST(Markup, every_well_formed_character_stays) {
  for (const char* const text : {"\u00e9", "\u07ff", "\u0800", "\u2713", "\uffff", "\U00010000", "\U0010ffff"})
    EXPECT_EQ(Markup::text(text).html(), text);
}

TEST(Markup, a_style_sheet_cannot_end_its_element) {
  EXPECT_EQ(Markup::style_sheet("a > b {}").html(), "a > b {}");
  EXPECT_THROW(Markup::style_sheet("</style>"), std::invalid_argument);
}

}  // namespace
}  // namespace cbvh::testbench
