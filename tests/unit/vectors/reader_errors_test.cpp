// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What is wrong with a file is said with its place.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "vectors/format/crc32c.h"
#include "vectors/format/format.h"
#include "vectors/registry.h"

namespace cbvh::vectors {
namespace {

namespace fs = std::filesystem;

const std::string kHeader =
    "# cbvh-vectors 1 unit=scale_estimator bits=6 treelet=1 seed=1 "
    "fields=lower:upper:registers_min_scale:registers_figure5:registers_relative>scale:lower:status\n";
const std::string kCase = "0 signed-zero 3F800000 40000000 16B 0 0 > 1FB 0000020 0 @3\n";

std::string with_trailer(const std::string& body, const std::string& cases, const std::string& checks) {
  const std::string covered = body + "# end cases=" + cases + " checks=" + checks + " crc32c=";
  Crc32c crc;
  crc.update(covered);
  return covered + fmt::format("{:08X}\n", crc.value());
}

std::string error_of(const std::string& bytes) {
  try {
    parse_set(bytes, "bunny.vec");
  } catch (const golden::InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_of_cases(const std::string& cases) { return error_of(with_trailer(kHeader + cases, "1", "3")); }

TEST(ReaderErrors, the_file_they_start_from_is_right) { EXPECT_EQ(error_of_cases(kCase), "no error"); }

TEST(ReaderErrors, a_field_is_named_with_line_and_column) {
  EXPECT_EQ(error_of_cases("0 signed-zero 3F80000 40000000 16B 0 0 > 1FB 0000020 0 @3\n"),
            "bunny.vec:2:15: field 'lower': 7 hex digits, want 8");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 400000000 16B 0 0 > 1FB 0000020 0 @3\n"),
            "bunny.vec:2:24: field 'upper': 9 hex digits, want 8");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F80000G 40000000 16B 0 0 > 1FB 0000020 0 @3\n"),
            "bunny.vec:2:15: field 'lower': '3F80000G' is not a hex number");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 26B 0 0 > 1FB 0000020 0 @3\n"),
            "bunny.vec:2:33: field 'registers_min_scale': 26B does not fit 9 bits");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 0 > 1FB 0000020 8 @3\n"),
            "bunny.vec:2:55: field 'status': 8 does not fit 3 bits");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 > 1FB 0000020 0 @3\n"),
            "bunny.vec:2:39: field 'registers_relative': missing");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 0 > 1FB 0000020 @3\n"),
            "bunny.vec:2:55: field 'status': missing");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 0 0 > 1FB 0000020 0 @3\n"),
            "bunny.vec:2:40: found ' 0 ', want ' > '");
}

TEST(ReaderErrors, a_latency_is_a_number_or_a_dash) {
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 0 > 1FB 0000020 0\n"),
            "bunny.vec:2:56: found '\\n', want ' '");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 0 > 1FB 0000020 0 @0\n"),
            "bunny.vec:2:58: latency: found 0, want 1 or more, or '-'");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 0 > 1FB 0000020 0 @x\n"),
            "bunny.vec:2:58: latency: found 'x', want a number");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 0 > 1FB 0000020 0 @3 \n"),
            "bunny.vec:2:59: found '', want the end of the line");
  EXPECT_EQ(error_of_cases("0 signed-zero 3F800000 40000000 16B 0 0 > 1FB 0000020 0 @-\n"), "no error");
}

TEST(ReaderErrors, ids_rise_and_classes_are_known) {
  const std::string rest = kCase.substr(1);
  EXPECT_EQ(error_of_cases("5" + rest + "5" + rest), "bunny.vec:3:1: duplicate id 5");
  EXPECT_EQ(error_of_cases("5" + rest + "4" + rest), "bunny.vec:3:1: id 4 comes after 5: ids must rise");
  EXPECT_EQ(error_of_cases("x" + rest), "bunny.vec:2:1: id: found 'x', want a number");
  EXPECT_EQ(error_of_cases("00" + rest), "bunny.vec:2:1: id: a number has no leading zeros");
  EXPECT_EQ(error_of_cases("18446744073709551616" + rest), "bunny.vec:2:1: id: more than 18446744073709551615");
  EXPECT_EQ(error_of_cases("0 signed-zer" + rest.substr(12)),
            "bunny.vec:2:3: unknown class 'signed-zer' of scale_estimator");
}

TEST(ReaderErrors, the_header_says_what_the_file_is) {
  const auto header_error = [](const std::string& from, const std::string& to) {
    std::string header = kHeader;
    header.replace(header.find(from), from.size(), to);
    return error_of(with_trailer(header + kCase, "1", "3"));
  };
  EXPECT_EQ(header_error("vectors 1", "vectors 2"), "bunny.vec:1:16: version: found 2, want 1");
  std::string names;
  for (const UnitDescription& unit : units()) names += (names.empty() ? "" : ", ") + std::string(unit.name);
  EXPECT_EQ(header_error("scale_estimator", "scale"),
            "bunny.vec:1:23: unit: unknown unit 'scale', want one of " + names);
  EXPECT_EQ(header_error("bits=6", "bits=9"),
            fmt::format("bunny.vec:1:44: bits: found 9, want {} for scale_estimator", fmt::join(kBuiltBits, ", ")));
  EXPECT_EQ(header_error("treelet=1", "treelet=2"), "bunny.vec:1:44: treelet: found 2, want 1 for scale_estimator");
  EXPECT_EQ(header_error(">scale:lower", ">scale:floor"),
            "bunny.vec:1:145: the fields of scale_estimator are "
            "lower:upper:registers_min_scale:registers_figure5:registers_relative>scale:lower:status");
}

TEST(ReaderErrors, the_trailer_must_agree) {
  EXPECT_EQ(error_of(kHeader), "bunny.vec:2:1: the file ends here, want a case or '# end'");
  EXPECT_EQ(error_of(kHeader + kCase), "bunny.vec:3:1: the file ends here, want a case or '# end'");
  EXPECT_EQ(error_of(with_trailer(kHeader, "0", "0")), "bunny.vec:2:13: no cases");
  EXPECT_EQ(error_of(with_trailer(kHeader + kCase, "2", "3")),
            "bunny.vec:3:13: the trailer says 2 cases, the file has 1");
  EXPECT_EQ(error_of(with_trailer(kHeader + kCase, "1", "4")),
            "bunny.vec:3:22: the trailer says 4 checks, the file has 3");
  EXPECT_EQ(error_of(with_trailer(kHeader + kCase, "1", "3") + "x"), "bunny.vec:4:1: bytes after the trailer");
  std::string bytes = with_trailer(kHeader + kCase, "1", "3");
  bytes.replace(bytes.find("3F8"), 3, "3F9");
  EXPECT_TRUE(error_of(bytes).starts_with("bunny.vec:3:31: crc32c: found ")) << error_of(bytes);
}

TEST(ReaderErrors, an_episode_has_the_lines_it_announces) {
  const auto set = generate_set("context_stack", {}, 7, 3);
  const std::string text = serialize(*set, Format::text);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string bytes = text;
    bytes.replace(bytes.find(from), from.size(), to);
    return error_of(bytes);
  };
  EXPECT_NE(changed("three-pops episode ", "three-pops episode 9").find("want '< '"), std::string::npos);
  EXPECT_NE(changed("single-operation episode 1 1", "single-operation episode 1 2").find("want '> '"),
            std::string::npos);
  EXPECT_NE(changed("single-operation episode 1 1", "single-operation episode 0 1").find("without stimuli"),
            std::string::npos);
}

TEST(ReaderErrors, what_is_no_vector_file_is_refused_by_name) {
  EXPECT_EQ(error_of(""), "bunny.vec: the file is empty");
  EXPECT_EQ(error_of("hello"),
            "bunny.vec: not a vector file: it starts with neither '# cbvh-vectors', '// cbvh-vectors' nor 'cbvh-vec'");
  const auto read_error = [](const std::string& path) -> std::string {
    try {
      read_set(path);
    } catch (const golden::InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(read_error("/nonexistent.vec"), "/nonexistent.vec: cannot read: No such file or directory");
  EXPECT_EQ(read_error("vectors"), "vectors: cannot read: it is a directory");
}

TEST(Writing, is_by_extension_and_atomic) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("cbvh_writing.{}", getpid());
  fs::create_directories(folder);
  const auto set = generate_set("axis_compressor", {}, 100, 1);
  for (const char* name : {"a.vec", "a.hex", "a.bin"}) {
    const std::string path = folder / name;
    write_set(*set, path);
    EXPECT_TRUE(read_set(path)->equals(*set));
    EXPECT_TRUE(open_set(path)->empty_set()->empty());
  }
  EXPECT_THROW(write_set(*set, folder / "a.txt"), golden::InputError);
  EXPECT_THROW(write_set(*set, folder / "missing" / "a.vec"), golden::InputError);
  EXPECT_THROW(write_set(*generate_set("axis_compressor", {}, 0, 1), folder / "a.vec"), golden::InputError);
  fs::create_directories(folder / "d.vec");
  EXPECT_THROW(write_set(*set, folder / "d.vec"), golden::InputError);
  EXPECT_TRUE(read_set(folder / "a.vec")->equals(*set)) << "a failed write leaves the old file";
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder)) ++files;
  EXPECT_EQ(files, 4U) << "no temporary file stays";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace cbvh::vectors
