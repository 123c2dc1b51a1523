// SPDX-License-Identifier: MIT
// compare LINEAR.pfm FRAME: holds a frame that embedding has written against the picture of the same heads
// that dermis::Renderer draws by itself, on the same device. Prints two figures, over the pixels that one
// head alone covers, and ends with status 1 if they are worse than dermis promises.
//   way (i):   the largest difference, as a share of the value: half of a step of the 16-bit floats of the
//   target way (iii): the peak signal-to-noise ratio for a peak of 1, white; its shading is the host's own
#include <dermis/renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <glm/gtc/packing.hpp>
#include <string>

#include "device.h"
#include "picture.h"
#include "stage.h"

namespace {

constexpr int most_steps = 1;  // of 16-bit floats
constexpr double least_psnr_db = 40;
constexpr std::size_t least_pixels = 2000;
constexpr double least_brightest = 0.2;

struct Difference {
  std::size_t pixels = 0, unequal = 0;  // unequal: values, three per pixel
  int steps = 0;                        // of 16-bit floats, at most
  double largest = 0, squares = 0, brightest = 0;
  double psnr_db() const { return 10 * std::log10(3 * double(pixels) / std::max(squares, 1e-12)); }
};

// Returns how many 16-bit floats lie between two values. Those of one sign are ordered as their bits are.
int steps_between(float a, float b) {
  return std::abs(int{glm::packHalf1x16(a)} - int{glm::packHalf1x16(b)});
}

// Over pixels in which `wanted` is `head` alone, which has to be all that is skin there.
Difference difference(const host::Picture& found, const dermis::Picture& wanted, const dermis::Picture& head,
                      const dermis::Picture& other) {
  Difference d;
  for (std::size_t i = 0; i < wanted.linear_rgba.size() / 4; ++i) {
    if (head.linear_rgba[4 * i + 3] != 1 || other.linear_rgba[4 * i + 3] != 0) continue;
    ++d.pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      const double a = wanted.linear_rgba[4 * i + c], b = found.rgb[3 * i + c];
      const int steps = steps_between(wanted.linear_rgba[4 * i + c], found.rgb[3 * i + c]);
      d.unequal += steps == 0 ? 0 : 1;
      d.steps = std::max(d.steps, steps);
      d.largest = std::max(d.largest, std::abs(a - b));
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
  std::printf("way (i): at most %d half-float steps, %zu of %zu values unequal, brightest %.2f\n",
              by_dermis.steps, by_dermis.unequal, 3 * by_dermis.pixels, by_dermis.brightest);
  std::printf("way (iii): PSNR %.1f dB over %zu pixels, largest difference %.2g\n", by_host.psnr_db(),
              by_host.pixels, by_host.largest);
  const bool enough = std::min(by_dermis.pixels, by_host.pixels) >= least_pixels &&
                      std::min(by_dermis.brightest, by_host.brightest) >= least_brightest;
  if (!enough) std::printf("too little skin, or too little light on it, to compare\n");
  return enough && by_dermis.steps <= most_steps && by_host.psnr_db() >= least_psnr_db;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: compare LINEAR.pfm FRAME\n");
    return 2;
  }
  try {
    return compare(argv[1], std::stoull(argv[2])) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare: %s\n", error.what());
    return 1;
  }
}
