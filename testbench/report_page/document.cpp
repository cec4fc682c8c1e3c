// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "testbench/report_page/style.h"
#include "testbench/report_page/table.h"
#include "testbench/report_page/unit_matrix.h"
#include "testbench/version.h"

namespace cbvh::testbench {

namespace {

/// Nothing may be fetched, and no script may run.
constexpr const char* kPolicy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'";

struct ChapterText {
  Chapter chapter;
  const char* id;
  const char* title;
};

constexpr std::array<ChapterText, 6> kChapters = {
    {{Chapter::checks, "checks", "Units and checks"},
     {Chapter::evaluations, "evaluations", "The papers' tables and figures, and ours"},
     {Chapter::runs, "runs", "Single builds, simulations and refits"},
     {Chapter::rays, "rays", "Rays through the trees"},
     {Chapter::animations, "animations", "Moving scenes"},
     {Chapter::speed, "speed", "Speed of the models"}}};

struct VerdictText {
  const char* css_class;
  const char* mark;
  const char* text;
};

VerdictText verdict_of(const Tally& tally) {
  switch (outcome(tally)) {
    case Outcome::passed:
      return {"passed", "\u2713", "all checks passed"};
    case Outcome::failed:
      return {"failed", "\u2717", "checks failed"};
    case Outcome::nothing_checked:
      break;
  }
  return {"none", "\u2013", "nothing was checked"};
}

std::string file_name(const std::string& place) { return std::filesystem::path(place).filename().string(); }

Markup number_of(const std::string& name, std::uint64_t value) {
  Markup item = element("dt", name);
  item += element("dd", count_text(value));
  return element("div", Attributes{}, item);
}

/// "1 result", "2 results".
std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

Markup header(const Contents& contents) {
  const Tally tally = tally_of(contents);
  const VerdictText verdict = verdict_of(tally);
  Markup markup = element("h1", "cbvh report");
  markup += element(
      "p", {{"class", "lead"}},
      fmt::format("Compressed bounding volume hierarchies: {} and {}, put together by cbvh {}",
                  counted(contents.results.size(), "result"), counted(contents.pictures.size(), "picture"), kVersion));
  Markup numbers = number_of("passed", tally.passed);
  numbers += number_of("failed", tally.failed);
  numbers += number_of("skipped", tally.skipped);
  Markup banner = element("p", {{"class", "verdict"}}, fmt::format("{} {}", verdict.mark, verdict.text));
  banner += element("dl", Attributes{}, numbers);
  markup += element("div", {{"class", fmt::format("banner {}", verdict.css_class)}}, banner);
  return element("header", Attributes{}, markup);
}

Markup result_heading(const Result& result) {
  Markup markup = element("span", {{"class", "file"}}, file_name(result.place));
  if (result.command_line != "-") markup += element("code", result.command_line);
  return element("p", {{"class", "source"}}, markup);
}

Markup section(const std::string& id, const std::string& title, const Markup& content) {
  Markup markup = element("h2", title);
  markup += content;
  return element("section", {{"id", id}}, markup);
}

Markup chapter(Chapter which, const Contents& contents, Figures& figures) {
  Markup markup;
  if (which == Chapter::checks) markup += unit_matrix(contents.results);
  for (const Result& result : contents.results) {
    if (result.kind.chapter != which) continue;
    Markup article = result_heading(result);
    article += result.kind.show(result.json, figures);
    markup += element("article", Attributes{}, article);
  }
  return markup;
}

/// The command line of the first result that names the picture's file; empty without one.
std::string maker_of(const Picture& picture, const std::vector<Result>& results) {
  const std::string name = file_name(picture.place);
  const auto names_it = [&](const Result& result) { return result.command_line.find(name) != std::string::npos; };
  const auto found = std::find_if(results.begin(), results.end(), names_it);
  return found == results.end() ? "" : found->command_line;
}

Markup pictures(const Contents& contents) {
  Markup markup;
  for (const Picture& picture : contents.pictures) markup += show_picture(picture, maker_of(picture, contents.results));
  return markup.empty() ? markup : element("div", {{"class", "pictures"}}, markup);
}

Markup file_row(const Result& result) {
  const Tally tally = result.kind.tally(result.json);
  const VerdictText verdict = verdict_of(tally);
  Markup line = element("th", {{"scope", "row"}}, file_name(result.place));
  line += element("td", result.kind.name);
  line += element("td", {{"class", verdict.css_class}}, fmt::format("{} {}", verdict.mark, verdict.text));
  for (const std::uint64_t value : {tally.passed, tally.failed, tally.skipped})
    line += element("td", {{"class", "number"}}, count_text(value));
  line += element("td", result.version);
  line += element("td", Attributes{}, element("code", result.command_line));
  return element("tr", Attributes{}, line);
}

Markup files(const Contents& contents) {
  if (contents.results.empty()) return {};
  Markup head;
  for (const char* const title : {"file", "what", "verdict", "passed", "failed", "skipped", "cbvh", "command"})
    head += element("th", {{"scope", "col"}}, title);
  Markup body;
  for (const Result& result : contents.results) body += file_row(result);
  Markup content = element("caption", "The files of this report");
  content += element("thead", Attributes{}, element("tr", Attributes{}, head));
  content += element("tbody", Attributes{}, body);
  Markup markup = element("div", {{"class", "scroll"}}, element("table", {{"class", "files"}}, content));
  markup += element("p", {{"class", "lead"}},
                    "Skipped: cases that belong to a set but were not run here, as in one shard of many.");
  return markup;
}

/// The chapters that have something in them, with links to them.
Markup chapters(const Contents& contents) {
  Figures figures;
  Markup links;
  Markup sections;
  const auto add = [&](const std::string& id, const std::string& title, const Markup& content) {
    if (content.empty()) return;
    links += element("li", Attributes{}, element("a", {{"href", "#" + id}}, title));
    sections += section(id, title, content);
  };
  for (const ChapterText& text : kChapters) add(text.id, text.title, chapter(text.chapter, contents, figures));
  add("pictures", "Pictures", pictures(contents));
  add("files", "Files, versions and commands", files(contents));
  Markup markup = element("nav", {{"aria-label", "chapters"}}, element("ul", Attributes{}, links));
  markup += element("main", Attributes{}, sections);
  return markup;
}

}  // namespace

Tally tally_of(const Contents& contents) {
  Tally tally;
  for (const Result& result : contents.results) tally += result.kind.tally(result.json);
  return tally;
}

std::string report_page(const Contents& contents) {
  Markup head = element("meta", {{"charset", "utf-8"}});
  head += element("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", kPolicy}});
  head += element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  head += element("meta", {{"name", "color-scheme"}, {"content", "light dark"}});
  head += element("title", "cbvh report");
  head += element("style", Attributes{}, Markup::style_sheet(kReportStyle));
  Markup body = header(contents);
  body += chapters(contents);
  return html_document(head, body);
}

}  // namespace cbvh::testbench
