// SPDX-License-Identifier: MIT
#include "api/prepare/asset_files.h"

#include <filesystem>
#include <set>

#include "api/asset_state.h"
#include "base/core/file.h"
#include "head/scene/gltf/document.h"
#include "head/scene/gltf/uri.h"

namespace dermis::api {
namespace {

namespace fs = std::filesystem;
namespace gltf = scene::gltf;

/// Sorted, each once; nothing of what is built in or made in memory.
std::set<fs::path> files_of(const Scene& scene) {
  std::set<fs::path> files;
  for (const InstanceId id : scene.instances())
    if (const auto& source = Asset::State::source_of(scene.instance(id).asset);
        source && !source->file.empty())
      files.insert(source->file);
  return files;
}

}  // namespace

void add_asset_files(Hash& hash, const Scene& scene) {
  for (const fs::path& file : files_of(scene)) {
    const gltf::Container container = gltf::open_container(file);
    hash.bytes(container.bytes.data(), container.bytes.size());

    const json::Document json = gltf::parse(container.json, file.string());
    for (const gltf::Buffer& buffer : gltf::read_document(json.root(), container, file).buffers) {
      if (!buffer.uri || buffer.uri->starts_with("data:")) continue;
      const std::vector<std::byte> bytes =
          read_file(gltf::uri_path(file.parent_path(), *buffer.uri, file.string()));
      hash.bytes(bytes.data(), bytes.size());
    }
  }
}

}  // namespace dermis::api
