// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/recognise.h"

#include <gtest/gtest.h>

#include <boost/crc.hpp>
#include <set>

#include "golden/input_error.h"
#include "testbench/report_page/document.h"
#include "testbench/report_page/table.h"

namespace cbvh::testbench {
namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  boost::crc_32_type crc;
  crc.process_bytes((type + data).data(), type.size() + data.size());
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc.checksum());
}

std::string header(std::uint32_t width, std::uint32_t height) {
  return chunk("IHDR", big_endian(width) + big_endian(height) + std::string("\x08\x02\0\0\0", 5));
}

const std::string kSignature = "\x89PNG\r\n\x1a\n";
const std::string kEnd = chunk("IEND", "");

std::string refusal(const std::string& bytes) {
  Contents contents;
  try {
    recognise("file", bytes, contents);
  } catch (const golden::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Recognise, pictures_have_their_size_and_stay_as_they_are) {
  Contents contents;
  const std::string bytes = kSignature + header(640, 480) + chunk("tEXt", "a") + chunk("IDAT", "x") + kEnd;
  recognise("a.png", bytes, contents);
  ASSERT_EQ(contents.pictures.size(), 1);
  EXPECT_EQ(contents.pictures[0].width, 640);
  EXPECT_EQ(contents.pictures[0].height, 480);
  EXPECT_NE(show_picture(contents.pictures[0], "").html().find(base64(bytes)), std::string::npos);
}

TEST(Recognise, broken_pictures_are_refused_by_offset) {
  const std::string data = chunk("IDAT", "x");
  const std::string whole = kSignature + header(2, 2) + data + kEnd;
  for (std::size_t length = kSignature.size(); length < whole.size(); ++length)
    EXPECT_EQ(refusal(whole.substr(0, length)).substr(0, 12), "file:offset ") << length;
  for (std::size_t i = kSignature.size(); i < whole.size(); ++i) {
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 1);
    EXPECT_NE(refusal(flipped), "accepted") << i;
  }
  EXPECT_EQ(refusal(whole), "accepted");
  EXPECT_EQ(refusal(kSignature + header(0, 2) + data + kEnd), "file:offset 8: PNG: found 0 x 2 pixels, want 1 or more");
  EXPECT_EQ(refusal(kSignature + header(2, 2) + kEnd), "file:offset 45: PNG: found no pixels, want an IDAT chunk");
  EXPECT_NE(refusal(kSignature + data + kEnd), "accepted");
  EXPECT_NE(refusal(kSignature + header(2, 2) + header(2, 2) + data + kEnd), "accepted");
  EXPECT_EQ(refusal(whole + "x"), "file:offset 58: PNG: found 1 bytes behind the end, want none");
}

TEST(Recognise, text_that_is_no_json_is_refused_by_line_and_column) {
  EXPECT_EQ(refusal(""), "file:1:1: found the end of the file, want JSON that cbvh wrote, or a PNG picture");
  EXPECT_EQ(refusal("GIF89a"), "file:1:1: found byte 0x47, want JSON that cbvh wrote, or a PNG picture");
  EXPECT_EQ(refusal("{\n  \"a\": ?}").substr(0, 25), "file:2:8: found byte 0x3f");
}

TEST(Recognise, a_number_beyond_binary64_is_refused) {
  EXPECT_NE(refusal(R"({"tables": 1e999})").find("want numbers that binary64 can hold"), std::string::npos);
}

TEST(Recognise, json_of_others_is_refused_with_what_it_has) {
  EXPECT_EQ(refusal("[]").substr(0, 35), "file: found JSON that is an array, ");
  EXPECT_EQ(refusal("1").substr(0, 34), "file: found JSON that is number, w");
  EXPECT_EQ(refusal("{}").substr(0, 35), "file: found an object with no keys,");
  EXPECT_NE(refusal(R"({"a": 1, "frames": []})").find("with a, frames, want the JSON of one of: "), std::string::npos);
}

TEST(Recognise, every_kind_is_told_from_all_others) {
  std::set<std::string> names;
  for (const ResultKind& kind : result_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(kind.keys.empty()) << kind.name;
    // Its keys alone are recognised as this kind, and then found broken.
    Json json = Json::object();
    for (const std::string& key : kind.keys) json[key] = 1;
    EXPECT_NE(refusal(json.dump()).find("found a broken " + kind.name + ":"), std::string::npos)
        << refusal(json.dump());
  }
  EXPECT_EQ(names.size(), 10);
}

TEST(Recognise, figures_that_are_missing_only_from_a_plot_are_refused) {
  const Json row = {{"scene", "s"}, {"triangles", 1}, {"identical", true}};
  const Json bench = {
      {"axis_compressor", {{"cases", 1}, {"failures", 0}}}, {"build", row}, {"scaling", {row}}, {"sim", {row}}};
  EXPECT_NE(
      refusal(bench.dump()).find("found a broken benchmark: [json.exception.out_of_range.403] key 'seconds' not found"),
      std::string::npos);
}

TEST(Recognise, what_is_no_count_is_refused) {
  Report report;
  report.sets = {SetReport{}};
  Json json = to_json(report);
  EXPECT_EQ(refusal(json.dump()), "accepted");
  json["sets"][0]["checks"] = -1;
  EXPECT_NE(refusal(json.dump()).find("'checks' is -1, no count"), std::string::npos) << refusal(json.dump());
}

Json table(const Json& rows) {
  return {
      {"title", "T"},
      {"labels", 1},
      {"columns",
       {{{"key", "name"}, {"title", "name"}, {"decimals", 0}}, {{"key", "paper_x"}, {"title", "x"}, {"decimals", 2}}}},
      {"rows", rows},
      {"notes", {"a note"}}};
}

TEST(Recognise, tables_are_shown_as_the_text_rounds_them) {
  const Json rows = {{{"name", "a<b"}, {"paper_x", 1.236}}, {{"name", "c"}, {"paper_x", nullptr}}};
  const std::string html = result_table(table(rows)).html();
  EXPECT_NE(html.find("<th scope=\"row\" class=\"\">a&lt;b</th><td class=\"number paper\">1.24</td>"),
            std::string::npos)
      << html;
  EXPECT_NE(html.find("<td class=\"number paper\">-</td>"), std::string::npos);
  EXPECT_NE(html.find("<li>a note</li>"), std::string::npos);
  EXPECT_THROW(result_table(table({{{"name", "a"}}})), Json::exception);
}

std::string page_of(const Json& json) {
  Contents contents;
  recognise("result.json", json.dump(), contents);
  return report_page(contents);
}

Json evaluation(std::uint64_t checks, const std::vector<std::string>& failures) {
  return {{"checks", checks}, {"failures", failures}, {"tables", {{"t", table(Json::array())}}}};
}

TEST(Document, zero_checks_are_never_green) {
  EXPECT_NE(page_of(evaluation(3, {})).find("banner passed"), std::string::npos);
  EXPECT_NE(page_of(evaluation(0, {})).find("banner none"), std::string::npos);
  EXPECT_NE(page_of(evaluation(3, {"<x> differs"})).find("banner failed"), std::string::npos);
  EXPECT_NE(page_of(evaluation(3, {"<x> differs"})).find("&lt;x&gt; differs"), std::string::npos);
  EXPECT_NE(report_page({}).find("banner none"), std::string::npos);
  const std::string page = page_of(evaluation(0, {"one"}));
  EXPECT_NE(page.find("banner failed"), std::string::npos) << "a failure without a check";
}

TEST(Document, says_which_command_and_version_made_a_file) {
  Json json = evaluation(1, {});
  EXPECT_EQ(page_of(json).find("<code>cbvh eval"), std::string::npos);
  json["made_by"] = {{"version", "9.8.7"}, {"command_line", "cbvh eval 'a&b'"}};
  EXPECT_NE(page_of(json).find("<td>9.8.7</td><td><code>cbvh eval &#39;a&amp;b&#39;</code></td>"), std::string::npos);
}

Json traced(std::uint64_t different) {
  const Json counts = {{"rays", 12}, {"box_tests", 100}, {"triangle_tests", 10}};
  const Json none = {{"rays", 0}, {"box_tests", 0}, {"triangle_tests", 0}};
  const Json through = {{"primary", counts}, {"secondary", none}, {"rays_per_second", 2e6}};
  return {{"scene", "proc:cloth"},
          {"builder", "lbvh"},
          {"compression", "streaming"},
          {"code", "modulo"},
          {"bits", 6},
          {"width", 4},
          {"height", 3},
          {"rays", "primary"},
          {"float", through},
          {"compressed", through},
          {"ratio", {{"primary", {{"box_tests", 1.07}, {"triangle_tests", nullptr}}}}},
          {"different_pixels", different},
          {"tree_checks", 2},
          {"different_trees", different > 0 ? 1 : 0},
          {"made_by", {{"version", "1"}, {"command_line", "cbvh trace proc:cloth -o cloth.png"}}}};
}

TEST(Document, every_pixel_and_every_tree_of_a_traced_picture_is_a_check) {
  Contents contents;
  recognise("a.json", traced(0).dump(), contents);
  EXPECT_EQ(tally_of(contents).passed, 12 + 2);
  recognise("b.json", traced(5).dump(), contents);
  EXPECT_EQ(tally_of(contents).passed, 12 + 2 + 7 + 1);
  EXPECT_EQ(tally_of(contents).failed, 5 + 1);
  const std::string page = report_page(contents);
  EXPECT_NE(page.find("primary rays, box tests: 1.07 (the paper&#39;s average: 1.08)."), std::string::npos);
  EXPECT_EQ(page.find("primary rays, triangle tests"), std::string::npos) << "a ratio there is not";
  EXPECT_EQ(page.find("secondary rays"), std::string::npos) << "rays there are not";
}

TEST(Document, a_picture_has_the_command_that_names_its_file) {
  Contents contents;
  const std::string bytes = kSignature + header(2, 2) + chunk("IDAT", "x") + kEnd;
  recognise("folder/cloth.png", bytes, contents);
  recognise("folder/other.png", bytes, contents);
  recognise("a.json", traced(0).dump(), contents);
  const std::string page = report_page(contents);
  EXPECT_NE(page.find("<strong>cloth.png</strong> 2 \u00d7 2 pixels <code>cbvh trace proc:cloth -o cloth.png</code>"),
            std::string::npos);
  EXPECT_NE(page.find("<strong>other.png</strong> 2 \u00d7 2 pixels </figcaption>"), std::string::npos);
}

TEST(Document, a_unit_that_nobody_checked_says_so) {
  Report report;
  report.command = "regress";
  SetReport set;
  set.unit = "one";
  set.backend = "rtl";
  set.total_cases = 5;
  set.cases = 3;
  set.checks = 1234;
  report.sets = {set};
  Contents contents;
  recognise("a.json", to_json(report).dump(), contents);
  recognise("b.json", R"({"units": [{"name": "two", "faces": [], "latency": "1", "summary": "s"}]})", contents);
  const std::string page = report_page(contents);
  EXPECT_NE(page.find("one</th><td class=\"number passed\">\u2713 1,234</td>"), std::string::npos);
  EXPECT_NE(page.find("two</th><td class=\"number none\">\u2013 not checked</td>"), std::string::npos);
  EXPECT_EQ(tally_of(contents).skipped, 2);
}

TEST(Picture, base64_pads_to_four_digits) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(Table, counts_have_commas) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1000), "1,000");
  EXPECT_EQ(count_text(14725776), "14,725,776");
}

}  // namespace
}  // namespace cbvh::testbench
