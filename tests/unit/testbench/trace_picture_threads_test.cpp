// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "golden/input_error.h"
#include "testbench/trace/colours.h"
#include "testbench/trace/picture_report.h"

namespace cbvh::testbench {
namespace {

constexpr golden::Box kBox{{-1, -1, -1}, {1, 1, 1}};

/// Pixels as they are made up: those of a number through another triangle, nearer, otherwise lit or turned.
class MadeUp : public PixelSource {
 public:
  explicit MadeUp(int wrong) : wrong_(wrong) {}

  TracedPixel trace(unsigned x, unsigned y, unsigned width, unsigned) override {
    TracedPixel pixel;
    const unsigned number = y * width + x;
    pixel.hit = {0, number, number + 0.5};
    pixel.light = number % 7 / 6.0;
    pixel.normal = {0, 1, 0};
    pixel.primary = {1, {number, 2 * number + 1, number % 3}};
    pixel.secondary.rays = 2;
    if (wrong_ == 1 && number == 13) pixel.hit.primitive = 0;
    if (wrong_ == 2 && number == 13) pixel.hit.t = std::nextafter(pixel.hit.t, 99.0);
    if (wrong_ == 3 && number == 13) pixel.light = std::nextafter(pixel.light, 0.5);
    if (wrong_ == 4 && number == 13) pixel.normal.x = -0.0;
    if (wrong_ == 5 && number == 13) pixel.hit.instance = 1;
    return pixel;
  }

 private:
  int wrong_;
};

PictureTree made_up(int wrong) {
  return {wrong == 0 ? "right" : "wrong", [wrong](const Shot&) { return std::make_unique<MadeUp>(wrong); }};
}

PictureJob job(unsigned threads) { return {.width = 8, .height = 5, .threads = threads}; }

TracedPicture picture(const std::vector<PictureTree>& trees, unsigned threads, std::size_t shown = 0) {
  Progress progress("test", 1);
  return trace_trees(trees, kBox, job(threads), shown, progress);
}

TEST(TracedPicture, one_bit_of_one_pixel_of_one_tree_is_a_difference) {
  for (const unsigned threads : {1U, 3U}) {
    EXPECT_EQ(picture({made_up(0), made_up(0)}, threads).different_pixels, 0U);
    for (int wrong = 1; wrong <= 5; ++wrong) {
      const TracedPicture found = picture({made_up(0), made_up(0), made_up(wrong)}, threads);
      EXPECT_EQ(found.different_pixels, 1U) << wrong;
      EXPECT_EQ(found.trees[1].different_pixels, 0U);
      EXPECT_EQ(found.trees[2].different_pixels, 1U);
      EXPECT_EQ(found.first_difference.substr(0, 24), "pixel 5 1: wrong tree: t") << found.first_difference;
      const Image image = draw(found, ImageKind::difference);
      for (std::size_t i = 0; i < image.rgb.size(); ++i) ASSERT_EQ(image.rgb[i], i / 3 == 13 ? 255 : 0);
    }
  }
}

TEST(TracedPicture, counts_are_the_sums_of_all_pixels) {
  const TracedPicture found = picture({made_up(0)}, 2);
  EXPECT_EQ(found.hits, 40U);
  EXPECT_EQ(found.trees[0].primary, (golden::RayCounts{40, {780, 1600, 39}}));
  EXPECT_EQ(found.trees[0].secondary.rays, 80U);
}

TEST(TracedPicture, heat_is_black_without_tests_white_at_the_most_and_never_darker_for_more) {
  const TracedPicture found = picture({made_up(0)}, 1);
  EXPECT_EQ(most_tests(found, ImageKind::box_tests), 79U);
  EXPECT_EQ(most_tests(found, ImageKind::triangle_tests), 2U);
  const Image boxes = draw(found, ImageKind::box_tests);
  int before = -1;
  for (std::size_t i = 0; i < 40; ++i) {
    const int luminance = 2 * boxes.rgb[3 * i] + 5 * boxes.rgb[3 * i + 1] + boxes.rgb[3 * i + 2];
    EXPECT_GT(luminance, before) << i;
    before = luminance;
  }
  EXPECT_EQ(before, 8 * 255);
  const Image triangles = draw(found, ImageKind::triangle_tests);
  EXPECT_EQ(triangles.rgb[0] + triangles.rgb[1] + triangles.rgb[2], 0);
  const Image normals = draw(found, ImageKind::normals);
  EXPECT_EQ(normals.rgb[1], 255);
  EXPECT_EQ(normals.rgb[0], 128);
}

TEST(TracedPicture, sizes_without_pixels_or_beyond_memory_are_refused) {
  const auto refused = [](unsigned width, unsigned height, unsigned samples) {
    try {
      check_picture_job({.samples = samples, .width = width, .height = height});
    } catch (const golden::InputError&) {
      return true;
    }
    return false;
  };
  EXPECT_TRUE(refused(0, 9, 1));
  EXPECT_TRUE(refused(9, 0, 1));
  EXPECT_TRUE(refused(9, 9, 0));
  EXPECT_TRUE(refused(16385, 1, 1));
  EXPECT_TRUE(refused(8193, 4097, 1));
  EXPECT_FALSE(refused(8192, 4096, 1));
  EXPECT_FALSE(refused(16384, 1, 1));
}

TEST(TracedPicture, a_camera_in_words_is_the_camera) {
  PictureJob wanted = job(1);
  wanted.camera = "1,2,3:1,2,-4:0.25";
  const golden::Ray ray = camera_of(wanted, kBox).ray(1, 1, 3, 3);
  EXPECT_EQ(ray.origin, glm::vec3(1, 2, 3));
  EXPECT_EQ(ray.direction, glm::vec3(0, 0, -1));
  wanted.camera = "0,9,0:0,0,0";
  EXPECT_EQ(camera_of(wanted, kBox).ray(1, 1, 3, 3).direction, glm::vec3(0, -1, 0)) << "straight down";
  for (const char* text :
       {"", "over", "1,2,3", "1,2:3,4,5", "1,2,3:4,5", "1,2,3:4,5,6,7", "1,2,3:4,5,6:", "1,2,3:4,5,6:x", "1,2,3:1,2,3",
        "1,2,3:4,5,6:-1", "1,2,nan:4,5,6", "1e39,2,3:4,5,6", "1,2,3:4,5,6:1:1"}) {
    wanted.camera = text;
    EXPECT_THROW(camera_of(wanted, kBox), golden::InputError) << text;
  }
}

}  // namespace
}  // namespace cbvh::testbench
