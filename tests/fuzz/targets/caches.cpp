// SPDX-License-Identifier: MIT
// Files that dermis writes for itself. They carry checksums, which random bytes never pass: the targets make
// them right, so that what lies behind is read too.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/core/cache.h"
#include "environment/occlusion.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/unwrap.h"
#include "image/colour.h"
#include "support.h"
#include "tissue/profile/monte_carlo_cache.h"
#include "truth/reference/checkpoint.h"

namespace dermis::fuzz {
namespace {

bool is_payload(Bytes choice_and_bytes) {
  return !choice_and_bytes.empty() && (static_cast<unsigned>(choice_and_bytes.front()) & 1) != 0;
}
Bytes bytes_of(const std::string& text) { return std::as_bytes(std::span(text.data(), text.size())); }
Bytes after_choice(Bytes bytes) { return bytes.empty() ? bytes : bytes.subspan(1); }

std::vector<std::byte> file_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// Overwrites what follows the header of a kept occlusion, as far as `payload` goes.
void replace_payload(std::vector<std::byte>& file, Bytes payload) {
  constexpr std::size_t header_bytes = 32;
  const std::size_t count = std::min(payload.size(), file.size() - header_bytes);
  std::copy_n(payload.begin(), count, file.begin() + header_bytes);
}

}  // namespace

bool checkpoint(Bytes choice_and_bytes) {
  constexpr std::uint64_t fingerprint = 0x0123456789abcdefu;
  reference::Film film(3, 2);
  const Bytes bytes = after_choice(choice_and_bytes);

  bool restored = false;
  const bool accepted = accepts([&] {
    restored = is_payload(choice_and_bytes)
                   ? film.restore(bytes)
                   : reference::load_checkpoint(put_file("checkpoint", bytes), film, fingerprint);
  });
  if (!accepted || !restored) return false;

  // Whatever was restored can be gone on with, and be written again.
  film.add(std::vector<reference::Tracer::Sample>(6));
  film.picture();
  film.variance();
  film.noise_percent();
  const std::vector<std::byte> state = film.state();
  reference::save_checkpoint(scratch_folder() / "again", film, fingerprint);
  reference::Film again(3, 2);
  DERMIS_ASSERT(reference::load_checkpoint(scratch_folder() / "again", again, fingerprint));
  DERMIS_ASSERT(again.state() == state);
  return true;
}

bool occlusion_cache(Bytes choice_and_bytes) {
  // The smallest skin, and the file that is right for it.
  struct Right {
    scene::AssetData scene = scene::plane(0.2);
    std::vector<scene::SkinMesh> skin = scene::skin_meshes(scene);
    environment::OcclusionSettings settings{.side = 16, .rays = 1};
    std::filesystem::path folder = scratch_folder() / "occlusion", file;
    std::vector<std::byte> bytes, payload;
    Right() {
      environment::cached_occlusion(scene, skin.front(), folder, settings);
      file = std::filesystem::directory_iterator(folder)->path();
      bytes = file_bytes(file);
      payload = cache::read(file, bytes.size()).value();
    }
    void put(const std::vector<std::byte>& content, bool sealed) const {
      if (sealed)
        cache::write(file, content);
      else
        put_file(file, content);
    }
  };
  static const Right right;

  std::vector<std::byte> bytes = right.payload;
  const Bytes given = after_choice(choice_and_bytes);
  if (is_payload(choice_and_bytes))
    replace_payload(bytes, given);
  else
    bytes.assign(given.begin(), given.end());
  right.put(bytes, is_payload(choice_and_bytes));

  const environment::Occlusion read =
      environment::cached_occlusion(right.scene, right.skin.front(), right.folder, right.settings);
  DERMIS_ASSERT_EQ(read.side, right.settings.side);
  for (const float value : read.values) DERMIS_ASSERT(value >= -2 && value <= 2);
  for (const auto* halves : {&read.transfer, &read.bounced})
    for (const std::uint16_t half : *halves) DERMIS_ASSERT(std::isfinite(image::half_to_float(half)));

  // A file that is not used is made again, which makes it the right one.
  return file_bytes(right.file) != right.bytes;
}

bool monte_carlo_cache(Bytes lines) {
  // Results stay in memory by their key, so each input has a key of its own.
  static std::atomic<std::uint64_t> inputs = 0;
  const std::string key = fmt::format("fuzz {}", inputs++), text = key + "\n" + std::string(as_text(lines));
  const std::filesystem::path path =
      scratch_folder() / fmt::format("monte-carlo-{:016x}.txt", cache::checksum(bytes_of(key)));
  const Bytes bytes = bytes_of(text);
  cache::write(path, {bytes.begin(), bytes.end()});

  const auto result = profile::cached(key, scratch_folder());
  std::filesystem::remove(path);
  if (!result) return false;

  DERMIS_ASSERT_EQ(result->reflected_error.size(), result->reflected.energies().size());
  for (const double part : {0.1, 0.5, 0.99}) DERMIS_ASSERT(!std::isnan(result->reflected.quantile(part)));
  result->noise_percent();
  result->reflected.hankel(1.0);
  return true;
}

}  // namespace dermis::fuzz
