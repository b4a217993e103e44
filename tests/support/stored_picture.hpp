// Pictures that are compared with stored ones, as an eye would: small differences at edges do not count.
#pragma once

#include <concino/render/png.hpp>

#include <support/png_reader.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace concino::testing {

/// The means of sRGB bytes over squares of 3 x 3 pixels, by which an edge that is half a pixel away differs little.
inline std::vector<double> blurred(const std::vector<std::uint8_t>& bytes, std::size_t width, std::size_t height) {
  std::vector<double> result(bytes.size());
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0, n = 0;
        for (std::size_t j = y > 0 ? y - 1 : 0; j <= y + 1 && j < height; ++j)
          for (std::size_t i = x > 0 ? x - 1 : 0; i <= x + 1 && i < width; ++i) sum += bytes[3 * (j * width + i) + c], ++n;
        result[3 * (y * width + x) + c] = sum / n;
      }
  return result;
}

/// Checks that a picture looks like the stored one: after blurring, at most 1 % of the components differ by more than 12 of 255, and the mean difference is
/// at most 1. If the environment variable CONCINO_STORE_PICTURES is set, the picture is stored instead.
inline void check_picture(const image& picture, const std::filesystem::path& stored) {
  if (std::getenv("CONCINO_STORE_PICTURES")) save_png(picture, stored.string());
  const std::string file = read_file(stored.string());
  const png_contents expected = read_png(std::vector<std::uint8_t>(file.begin(), file.end()));
  REQUIRE(expected.width == picture.width());
  REQUIRE(expected.height == picture.height());
  const auto a = blurred(expected.bytes, picture.width(), picture.height()), b = blurred(srgb_bytes(picture), picture.width(), picture.height());
  double sum = 0;
  std::size_t differ = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(a[i] - b[i]);
    sum += d;
    differ += d > 12;
  }
  CHECK(static_cast<double>(differ) <= 0.01 * static_cast<double>(a.size()));
  CHECK(sum <= static_cast<double>(a.size()));
}

}  // namespace concino::testing
