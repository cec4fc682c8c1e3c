// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/markup.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace cbvh::testbench {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// Bytes of the well-formed UTF-8 character that `text` begins with; 0 when there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first <= 0xDF ? 2 : first >= 0xE0 && first <= 0xEF ? 3 : 4;
  if (first < 0xC2 || first > 0xF4) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool surrogate = first == 0xED && byte(1) > 0x9F;
  const bool beyond = first == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

bool is_control(char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7F; }

std::string escape(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const char c = text[0];
    if (length == 0 || is_control(c)) {
      escaped += kReplacement;
    } else if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else if (c == '\'') {
      escaped += "&#39;";
    } else {
      escaped += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return escaped;
}

bool closes_itself(std::string_view name) {
  constexpr std::array<std::string_view, 4> kNames = {"img", "meta", "br", "link"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

}  // namespace

Markup Markup::text(std::string_view text) {
  Markup markup;
  markup.html_ = escape(text);
  return markup;
}

Markup Markup::style_sheet(std::string_view css) {
  if (css.find("</") != std::string_view::npos) throw std::invalid_argument("a style sheet with </");
  Markup markup;
  markup.html_ = css;
  return markup;
}

Markup element(std::string_view name, const Attributes& attributes, const Markup& content) {
  Markup markup;
  std::string& html = markup.html_;
  html.append("<").append(name);
  for (const Attribute& attribute : attributes)
    html.append(" ").append(attribute.name).append("=\"").append(escape(attribute.value)).append("\"");
  html += '>';
  if (!closes_itself(name)) html.append(content.html_).append("</").append(name).append(">");
  return markup;
}

Markup element(std::string_view name, const Attributes& attributes, std::string_view text) {
  return element(name, attributes, Markup::text(text));
}

Markup element(std::string_view name, std::string_view text) { return element(name, Attributes{}, text); }

std::string html_document(const Markup& head, const Markup& body) {
  Markup both = element("head", Attributes{}, head);
  both += element("body", Attributes{}, body);
  return "<!DOCTYPE html>\n" + element("html", {{"lang", "en"}}, both).html() + "\n";
}

}  // namespace cbvh::testbench
