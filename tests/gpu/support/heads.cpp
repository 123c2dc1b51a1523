// SPDX-License-Identifier: MIT
#include "gpu/support/heads.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "gpu/support/scenes.h"
#include "support/assets.h"
#include "support/built_in.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

/// Opens when first asked for, and returns the same scene from then on: a renderer keeps what it has uploaded
/// of the last one.
std::function<Scene()> once(std::function<Scene()> open) {
  return [open = std::move(open), kept = std::make_shared<std::optional<Scene>>()] {
    if (!*kept) *kept = open();
    return **kept;
  };
}

Subject from_file(const std::string& name, const fs::path& path, const std::string& missing) {
  return {.name = name, .open = once([path] { return Scene::load(path); }), .missing = missing};
}

Subject from_cache(const std::string& name, const fs::path& path) {
  return from_file(name, asset_cache() / path, missing_asset({asset_cache() / path}));
}

}  // namespace

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all{
      {"sphere", once([] { return sphere(0.1); }), {}},
      {"sheared plane", once(sheared_plane), {}},
      {"built-in head", once([] { return wrap(kept_built_in_head(512)); }), {}},
      from_file("scan", scan_manifest(), missing_scan()),
      from_cache("MakeHuman", "makehuman/mh-african-man-young.glb"),
      from_cache("ICT", "ict-facekit/ict-mean-animated.glb"),
  };
  return all;
}

const Subject& subject(const std::string& name) {
  for (const Subject& s : subjects())
    if (s.name == name) return s;
  throw std::invalid_argument("no subject " + name);
}

std::vector<std::string> subject_names() {
  std::vector<std::string> names;
  for (const Subject& s : subjects()) names.push_back(s.name);
  return names;
}

void WithScan::SetUp() {
  if (!subject("scan").missing.empty()) GTEST_SKIP() << subject("scan").missing;
}

const Scene& WithScan::scan() const {
  static const Scene opened = subject("scan").open();
  return opened;
}

std::string test_name_of(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

}  // namespace dermis::tests
