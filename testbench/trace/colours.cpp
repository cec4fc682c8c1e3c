// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/colours.h"

#include <algorithm>

namespace cbvh::testbench {

namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour kBlack = {0, 0, 0};
constexpr Colour kWhite = {255, 255, 255};
constexpr Colour kSky = {150, 180, 220};

/// Equally far apart, and each lighter than the one before.
constexpr std::array<Colour, 6> kHeat = {
    {kBlack, {50, 20, 120}, {170, 40, 110}, {240, 100, 40}, {255, 200, 60}, kWhite}};

Colour heat(std::uint64_t tests, std::uint64_t most) {
  const std::uint64_t steps = kHeat.size() - 1;
  const std::uint64_t place = most == 0 ? 0 : tests * steps * 256 / most;
  const auto below = std::min<std::size_t>(place / 256, steps - 1);
  const std::uint64_t above = place - below * 256;
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint8_t>((kHeat[below][i] * (256 - above) + kHeat[below + 1][i] * above) / 256);
  return colour;
}

std::uint32_t tests(const PixelFigures& pixel, ImageKind kind) {
  return kind == ImageKind::triangle_tests ? pixel.triangle_tests : pixel.box_tests;
}

Colour colour(const PixelFigures& pixel, ImageKind kind, std::uint32_t most) {
  switch (kind) {
    case ImageKind::shaded:
      return pixel.hit ? Colour{pixel.light, pixel.light, pixel.light} : kSky;
    case ImageKind::normals:
      return pixel.hit ? pixel.normal : kBlack;
    case ImageKind::box_tests:
    case ImageKind::triangle_tests:
      return heat(tests(pixel, kind), most);
    case ImageKind::difference:
      break;
  }
  return pixel.different ? kWhite : kBlack;
}

}  // namespace

std::uint32_t most_tests(const TracedPicture& picture, ImageKind kind) {
  std::uint32_t most = 0;
  for (const PixelFigures& pixel : picture.pixels) most = std::max(most, tests(pixel, kind));
  return most;
}

Image draw(const TracedPicture& picture, ImageKind kind) {
  Image image{picture.width, picture.height, {}};
  image.rgb.reserve(picture.pixels.size() * 3);
  const std::uint32_t most = most_tests(picture, kind);
  for (const PixelFigures& pixel : picture.pixels) {
    for (const std::uint8_t channel : colour(pixel, kind, most)) image.rgb.push_back(channel);
  }
  return image;
}

}  // namespace cbvh::testbench
