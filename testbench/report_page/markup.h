// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cbvh::testbench {

/// HTML, or SVG inside of it, whose elements all close and whose text and attributes are escaped: there is no other way
/// to make one.
class Markup {
 public:
  Markup() = default;
  /// Text as people read it. Characters that HTML cannot hold become U+FFFD.
  static Markup text(std::string_view text);
  /// A style sheet of ours, as it is. Throws std::invalid_argument when it would end its element.
  static Markup style_sheet(std::string_view css);

  Markup& operator+=(const Markup& next) {
    html_ += next.html_;
    return *this;
  }
  const std::string& html() const { return html_; }
  bool empty() const { return html_.empty(); }

 private:
  friend Markup element(std::string_view, const std::vector<struct Attribute>&, const Markup&);
  std::string html_;
};

/// One attribute of an element. An empty value is written as such.
struct Attribute {
  std::string name;
  std::string value;
};

using Attributes = std::vector<Attribute>;

/// An element with its content. One that HTML closes by itself, such as img, has none.
Markup element(std::string_view name, const Attributes& attributes, const Markup& content = {});
Markup element(std::string_view name, const Attributes& attributes, std::string_view text);
Markup element(std::string_view name, std::string_view text);

/// "<!DOCTYPE html>" and the document's element.
std::string html_document(const Markup& head, const Markup& body);

}  // namespace cbvh::testbench
