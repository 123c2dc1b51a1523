// SPDX-License-Identifier: MIT
// compare LINEAR.pfm FRAME: holds a frame that embedding has written against the picture of the same heads
// that dermis::Renderer draws by itself, on the same device. Prints two figures, over the pixels that one
// head alone covers whole, and ends with status 1 if they are worse than this:
// - way (i): equal, but for the rounding to the 16-bit floats of the target, by at most half a step of these;
// - way (iii): 40 dB of peak signal to noise, for a peak of 1, which is white. Its shading is the host's own.
#include <dermis/renderer.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "device.h"
#include "picture.h"
#include "stage.h"

namespace {

constexpr double step = 1.0 / 1024;   // of 16-bit floats, as a share of their value, at most
constexpr double least_value = 1e-3;  // darker values may differ as much as this one
constexpr double least_psnr_db = 40;
constexpr std::size_t least_pixels = 2000;
constexpr double least_brightest = 0.2;

struct Difference {
  std::size_t pixels = 0, unequal = 0;  // unequal: values, three per pixel
  double largest = 0, relative = 0, squares = 0, brightest = 0;
  double psnr_db() const { return 10 * std::log10(3 * double(pixels) / std::max(squares, 1e-12)); }
};

// Over pixels in which `wanted` is `head` alone, which has to be all that is skin there.
Difference difference(const host::Picture& found, const dermis::Picture& wanted, const dermis::Picture& head,
                      const dermis::Picture& other) {
  Difference d;
  for (std::size_t i = 0; i < wanted.linear_rgba.size() / 4; ++i) {
    if (head.linear_rgba[4 * i + 3] != 1 || other.linear_rgba[4 * i + 3] != 0) continue;
    ++d.pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      const double a = wanted.linear_rgba[4 * i + c], b = found.rgb[3 * i + c];
      d.unequal += a == b ? 0 : 1;
      d.largest = std::max(d.largest, std::abs(a - b));
      d.relative = std::max(d.relative, std::abs(a - b) / std::max({a, b, least_value}));
      d.squares += (a - b) * (a - b);
      d.brightest = std::max(d.brightest, a);
    }
  }
  return d;
}

bool compare(const std::string& path, std::uint64_t frame) {
  const host::Picture found = host::read_pfm(path);
  const host::Device device(false);
  dermis::Renderer renderer(device.host());
  stage::Stage stage;
  stage.turn(frame);
  dermis::RenderSettings settings = stage::settings();
  settings.camera.matrices = stage::camera(frame, found.width, found.height);
  settings.output.width = static_cast<int>(found.width);
  settings.output.height = static_cast<int>(found.height);

  const dermis::Picture both = renderer.render(stage.scene, settings);
  const auto only = [&](dermis::InstanceId shown, dermis::InstanceId hidden) {
    stage.scene.set_visible(shown, true);
    stage.scene.set_visible(hidden, false);
    return renderer.render(stage.scene, settings);
  };
  const dermis::Picture left = only(stage.left, stage.right), right = only(stage.right, stage.left);

  const Difference by_dermis = difference(found, both, left, right),
                   by_host = difference(found, both, right, left);
  std::printf("way (i): largest difference %.2f half-float steps, %zu of %zu values unequal\n",
              by_dermis.relative / step, by_dermis.unequal, 3 * by_dermis.pixels);
  std::printf("way (iii): PSNR %.1f dB over %zu pixels, largest difference %.2g\n", by_host.psnr_db(),
              by_host.pixels, by_host.largest);
  const bool enough = std::min(by_dermis.pixels, by_host.pixels) >= least_pixels &&
                      std::min(by_dermis.brightest, by_host.brightest) >= least_brightest;
  if (!enough) std::printf("too little skin, or too little light on it, to compare\n");
  return enough && by_dermis.relative <= step / 2 && by_host.psnr_db() >= least_psnr_db;
}

bool read_number(std::string_view word, std::uint64_t& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t frame = 0;
  if (argc != 3 || !read_number(argv[2], frame)) {
    std::fprintf(stderr, "usage: compare LINEAR.pfm FRAME\n");
    return 2;
  }
  try {
    return compare(argv[1], frame) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare: %s\n", error.what());
    return 1;
  }
}
