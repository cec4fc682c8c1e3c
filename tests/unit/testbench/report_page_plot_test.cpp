// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "testbench/report_page/bars.h"
#include "testbench/report_page/plot.h"
#include "testbench/report_page/scale.h"

namespace cbvh::testbench {
namespace {

using Values = std::vector<double>;

const Axis kLinear{"x"};
const Axis kLogarithmic{"x", true};
const Axis kFromZero{"x", false, true};
const Axis kWhole{"x", false, false, true};

TEST(Scale, linear_ticks_are_round_and_bound_all_values) {
  EXPECT_EQ(Scale(kLinear, {3, 58}, 0, 1).ticks(), Values({0, 10, 20, 30, 40, 50, 60}));
  EXPECT_EQ(Scale(kLinear, {-7, 4}, 0, 1).ticks(), Values({-8, -6, -4, -2, 0, 2, 4}));
  EXPECT_EQ(Scale(kLinear, {100, 101}, 0, 1).ticks().front(), 100);
  EXPECT_EQ(Scale(kFromZero, {100, 101}, 0, 1).ticks(), Values({0, 20, 40, 60, 80, 100, 120}));
  EXPECT_EQ(Scale(kWhole, {1, 3}, 0, 1).ticks(), Values({1, 2, 3}));
}

TEST(Scale, one_value_or_none_still_has_an_extent) {
  EXPECT_EQ(Scale(kLinear, {}, 0, 1).ticks().size(), 6);
  for (const double value : {0.0, 5.0, -3.0, 1e-30}) {
    const Scale scale(kLinear, {value}, 0, 1);
    EXPECT_GE(scale.ticks().size(), 2) << value;
    EXPECT_LT(scale.ticks().front(), scale.ticks().back()) << value;
    EXPECT_TRUE(scale.place(value) >= 0 && scale.place(value) <= 1) << value;
  }
  const Scale scale(kLogarithmic, {10}, 0, 1);
  EXPECT_TRUE(scale.place(10) >= 0 && scale.place(10) <= 1);
}

TEST(Scale, places_go_from_begin_to_end_also_downwards) {
  const Scale up(kLinear, {0, 10}, 20, 120);
  EXPECT_DOUBLE_EQ(up.place(0), 20);
  EXPECT_DOUBLE_EQ(up.place(5), 70);
  EXPECT_DOUBLE_EQ(up.place(10), 120);
  const Scale down(kLinear, {0, 10}, 300, 0);
  EXPECT_DOUBLE_EQ(down.place(0), 300);
  EXPECT_DOUBLE_EQ(down.place(10), 0);
}

TEST(Scale, a_logarithmic_axis_has_powers_of_ten_or_their_1_2_5) {
  EXPECT_EQ(Scale(kLogarithmic, {3, 40000}, 0, 1).ticks(), Values({1, 10, 100, 1000, 10000, 100000}));
  EXPECT_EQ(Scale(kLogarithmic, {1.2, 4}, 0, 1).ticks(), Values({1, 2, 5}));
  EXPECT_LE(Scale(kLogarithmic, {1e-20, 1e20}, 0, 1).ticks().size(), 9);
  const Scale scale(kLogarithmic, {1, 100, 10000}, 0, 1);
  EXPECT_DOUBLE_EQ(scale.place(1), 0);
  EXPECT_DOUBLE_EQ(scale.place(100), 0.5);
  EXPECT_DOUBLE_EQ(scale.place(10000), 1);
}

TEST(Scale, zero_stands_below_the_rest_of_a_logarithmic_axis) {
  const Scale scale(kLogarithmic, {0, 1, 1000}, 0, 1);
  EXPECT_EQ(scale.ticks(), Values({0, 1, 10, 100, 1000}));
  EXPECT_EQ(scale.place(0), 0);
  EXPECT_GT(scale.place(1), 0.05);
  EXPECT_DOUBLE_EQ(scale.place(1000), 1);
  // Without anything positive, or with something negative, it is linear.
  EXPECT_EQ(Scale(kLogarithmic, {0, 0}, 0, 1).place(0), Scale(kLinear, {0, 0}, 0, 1).place(0));
  EXPECT_DOUBLE_EQ(Scale(kLogarithmic, {-10, 10}, 0, 1).place(0), 0.5);
}

TEST(Scale, every_value_of_any_size_stands_between_the_ends) {
  std::uint64_t places = 0;
  for (int exponent = -60; exponent <= 60; exponent += 3) {
    for (const double spread : {1.0, 1.001, 3.0, 1e4, 1e9}) {
      for (const Axis& axis : {kLinear, kLogarithmic, kFromZero}) {
        const double least = 1.7 * std::pow(10, exponent);
        const Scale scale(axis, {least, least * spread}, 0, 1);
        for (const double value : {least, least * spread}) {
          EXPECT_GE(scale.place(value), -1e-6) << least << " " << spread;
          EXPECT_LE(scale.place(value), 1 + 1e-6) << least << " " << spread;
          ++places;
        }
        EXPECT_TRUE(scale.ticks().size() >= 2 && scale.ticks().size() <= 10) << least << " " << spread;
      }
    }
  }
  EXPECT_EQ(places, 41U * 5 * 3 * 2);
}

TEST(Scale, values_that_differ_in_their_last_bits_stand_at_one_place) {
  const double above = std::nextafter(1.0, 2.0);
  const Scale scale(kLinear, {1, above}, 0, 1);
  EXPECT_LE(scale.ticks().size(), 10);
  EXPECT_NEAR(scale.place(1), scale.place(above), 1e-6);
  EXPECT_LE(Scale(kLogarithmic, {1, above}, 0, 1).ticks().size(), 10);
}

TEST(Scale, what_leaves_binary64_cannot_be_drawn) {
  for (const double value : {0.0, -1.0, 1e200, -1e-200}) EXPECT_TRUE(can_be_drawn(value)) << value;
  for (const double value : {5e-324, -1e-201, 1.1e200, -1e308, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_FALSE(can_be_drawn(value)) << value;
  EXPECT_LE(Scale(kLinear, {-1e200, 1e200}, 0, 1).ticks().size(), 10);
  EXPECT_LE(Scale(kLinear, {1e-200, 2e-200}, 0, 1).ticks().size(), 10);
  EXPECT_LE(Scale(kLogarithmic, {0, 1e-200, 1e200}, 0, 1).ticks().size(), 10);
}

TEST(Scale, tick_texts_are_short) {
  EXPECT_EQ(tick_text(0), "0");
  EXPECT_EQ(tick_text(1e-17), "0");
  EXPECT_EQ(tick_text(0.25), "0.25");
  EXPECT_EQ(tick_text(-5000), "-5000");
  EXPECT_EQ(tick_text(20000), "20k");
  EXPECT_EQ(tick_text(2500000), "2.5M");
  EXPECT_EQ(tick_text(3e9), "3G");
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(Plot, has_a_title_a_description_and_its_figures) {
  Figures figures;
  const Plot plot{"Times <1>", {"frame"}, {"time, ms"}, {{"refit", {{0, 1.5}, {1, 2.5}}}, {"rebuild", {{1, 7.25}}}}};
  const std::string html = draw(plot, figures).html();
  EXPECT_NE(html.find("<title id=\"figure1-title\">Times &lt;1&gt;</title>"), std::string::npos);
  EXPECT_NE(html.find("aria-labelledby=\"figure1-title\""), std::string::npos);
  EXPECT_NE(html.find("refit: 2 points, least 1.5 at 0, most 2.5 at 1."), std::string::npos);
  EXPECT_NE(html.find(">1.5</td><td class=\"number\">-</td>"), std::string::npos) << "no row of a frame without one";
  EXPECT_NE(html.find("time, ms"), std::string::npos);
  EXPECT_EQ(occurrences(html, " mark\""), 3 + 2);  // and the legend's
  EXPECT_NE(draw(plot, figures).html().find("figure2-title"), std::string::npos);
}

TEST(Plot, what_cannot_be_drawn_is_left_out) {
  Figures figures;
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(draw(Plot{"", {"x"}, {"y"}, {}}, figures).empty());
  EXPECT_TRUE(draw(Plot{"", {"x"}, {"y"}, {{"a", {{0, infinite}, {std::nan(""), 1}}}}}, figures).empty());
  const std::string html = draw(Plot{"", {"x"}, {"y"}, {{"a", {{0, infinite}, {1, 1}}}}}, figures).html();
  EXPECT_EQ(occurrences(html, " mark\""), 1);
  EXPECT_EQ(html.find("inf"), std::string::npos);
}

TEST(BarChart, parts_are_as_long_as_they_say) {
  Figures figures;
  const BarChart chart{"Traffic", "bytes", {"read", "written"}, {{"g", "a", {30, 10}}, {"g", "b", {100, 0}}}};
  const std::string html = draw(chart, figures).html();
  // 0..100 takes 436 units.
  EXPECT_NE(html.find("width=\"130.8\""), std::string::npos) << html;
  EXPECT_NE(html.find("width=\"43.6\""), std::string::npos);
  EXPECT_NE(html.find("g, a: 40."), std::string::npos);
  EXPECT_EQ(occurrences(html, "class=\"group\""), 1);
}

TEST(BarChart, bars_that_cannot_be_drawn_are_left_out) {
  Figures figures;
  EXPECT_TRUE(draw(BarChart{"", "", {"p"}, {}}, figures).empty());
  EXPECT_TRUE(
      draw(BarChart{"", "", {"p"}, {{"", "a", {-1}}, {"", "b", {std::nan("")}}, {"", "c", {}}}}, figures).empty());
}

TEST(Figure, coordinates_and_labels_are_short) {
  EXPECT_EQ(coordinate(12.3456), "12.35");
  EXPECT_EQ(coordinate(100), "100");
  EXPECT_EQ(coordinate(-0.001), "0");
  EXPECT_EQ(shorten("abcdef", 6), "abcdef");
  EXPECT_EQ(shorten("abcdefg", 6), "abcde\u2026");
  EXPECT_EQ(shorten("\u00e4\u00f6\u00fc\u00e4", 3), "\u00e4\u00f6\u2026");
}

}  // namespace
}  // namespace cbvh::testbench
