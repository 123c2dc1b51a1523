// SPDX-License-Identifier: MIT
#include "gpu/dataset/small_set.h"

#include <algorithm>

#include "cli/tiny_gltf.h"
#include "tools/dataset/manifest.h"
#include "tools/dataset/tar.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

// Its one morph target scales it.
std::string square(const std::string& copyright) {
  return tests::tiny_gltf({}, [&](Tree& file) {
    Tree& mesh = file["meshes"][0];
    mesh["primitives"][0]["targets"] = Tree::array({{{"POSITION", 0}}});
    mesh["extras"]["targetNames"] = {"grow"};
    if (!copyright.empty()) file["asset"]["copyright"] = copyright;
  });
}

}  // namespace

SmallSet::SmallSet() {
  tests::write_text(folder() / "plain.gltf", square(""));
  tests::write_text(folder() / "free.gltf", square("A. Author, CC BY 4.0"));
  quiet.hooks.log = [](LogLevel, const std::string&) {};
  quiet.threads = 2;
  recipe = Tree::parse(R"({
    "schema": 1, "name": "squares", "seed": 3, "samples": 18, "samples_per_shard": 4, "views_per_identity": 2,
    "test_share": 0.25, "size": [24, 20], "labels": ["depth", "uv", "instance", "region"],
    "identities": [
      {"asset": "plain.gltf", "licence": {"spdx": "MIT", "author": "A", "source": "made here"}},
      {"asset": "free.gltf", "count": 3, "morphs": {"grow": {"uniform": [0, 0.3]}}}],
    "settings": {
      "technique": "lambert", "quality": {"map_size": 64, "shadow_size": 64},
      "camera": {"orbit_deg": [{"uniform": [-40, 40]}, {"uniform": [-20, 20]}]},
      "lighting": {"ambient": {"uniform": [0.1, 0.5]}, "rig_lights": {"whole": [0, 2]}},
      "output": {"exposure_ev": 0}},
    "head": {"turn_deg": [0, 0, {"uniform": [-20, 20]}]}})");
}

fs::path SmallSet::write_recipe() const {
  tests::write_text(folder() / "recipe.json", recipe.dump());
  return folder() / "recipe.json";
}

fs::path SmallSet::prepared(const std::string& name, bool one_device) {
  prepare(write_recipe(), folder() / name, one_device, quiet);
  return folder() / name;
}

void SmallSet::replace_member(const fs::path& shard, const std::string& name, const std::string& content) {
  std::string bytes;
  TarReader tar(shard);
  for (const TarReader::File& file : tar.files()) {
    const std::vector<std::byte> old = tar.read(file);
    const std::string text =
        file.name == name ? content : std::string(reinterpret_cast<const char*>(old.data()), old.size());
    const auto header = tar_header(file.name, text.size());
    bytes.append(reinterpret_cast<const char*>(header.data()), header.size());
    bytes += text + std::string(tar_padding(text.size()), '\0');
  }
  bytes += std::string(tar_end, '\0');
  tests::write_text(shard, bytes);

  Manifest manifest = load_manifest(manifest_path(shard));
  manifest.bytes = bytes.size();
  manifest.sha256 = sha256(bytes);
  for (SampleHashes& sample : manifest.samples)
    if (name.starts_with(fmt::format("{:06}.json", sample.sample))) sample.json_sha256 = sha256(content);
  tests::write_text(manifest_path(shard), text_of(manifest, *load_lock(shard.parent_path()).recipe));
}

void SmallSet::flip_bit(const fs::path& file, std::size_t at) {
  std::string bytes = tests::read_text(file);
  bytes.at(at) = static_cast<char>(bytes.at(at) ^ 4);
  tests::write_text(file, bytes);
}

std::map<std::string, std::string> hashes_of(const fs::path& folder) {
  std::map<std::string, std::string> hashes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".tar")
      hashes[entry.path().filename().string()] = hash_of_file(entry.path()).sha256;
  return hashes;
}

std::vector<std::string> files_of(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace dermis::dataset
