// SPDX-License-Identifier: MIT
#include "two_clips.h"

#include <cstring>

namespace dermis::scene::test {
namespace {

std::size_t node_of_mesh(const Json& json) {
  for (std::size_t n = 0; n < json["nodes"].size(); ++n)
    if (json["nodes"][n].contains("mesh")) return n;
  return 0;
}

}  // namespace

fs::path with_second_clip(const fs::path& file, const fs::path& to) {
  std::string text = read_text(file);
  std::uint32_t size = 0;
  std::memcpy(&size, text.data() + 12, 4);
  Json json = Json::parse(text.substr(20, size));
  std::string chunk = text.substr(28 + size);
  const auto accessor = [&](const std::vector<float>& values, const std::string& type, std::size_t count) {
    chunk.resize((chunk.size() + 3) / 4 * 4);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", chunk.size()}, {"byteLength", 4 * values.size()}});
    chunk.append(reinterpret_cast<const char*>(values.data()), 4 * values.size());
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", 5126},
                                 {"count", count},
                                 {"type", type}});
    return json["accessors"].size() - 1;
  };

  const std::size_t targets = json["meshes"][0]["primitives"][0]["targets"].size();
  std::vector<float> weights(targets, 0.0f);
  for (std::size_t i = 0; i < targets; ++i) weights.push_back(0.05f + 0.03f * static_cast<float>(i));
  const std::size_t times = accessor({0, 2}, "SCALAR", 2);
  const std::size_t turns = accessor({0, 0, 0, 1, 0, -0.6f, 0, -0.8f}, "VEC4", 2);
  const std::size_t rising = accessor(weights, "SCALAR", 2 * targets);
  const std::size_t joint = json["skins"][0]["joints"][1];
  const std::size_t node = node_of_mesh(json);
  json["animations"].push_back(
      {{"name", "second"},
       {"samplers", {{{"input", times}, {"output", turns}}, {{"input", times}, {"output", rising}}}},
       {"channels",
        {{{"sampler", 0}, {"target", {{"node", joint}, {"path", "rotation"}}}},
         {{"sampler", 1}, {"target", {{"node", node}, {"path", "weights"}}}}}}});
  json["buffers"][0]["byteLength"] = chunk.size();

  std::string head = json.dump();
  head.resize((head.size() + 3) / 4 * 4, ' ');
  chunk.resize((chunk.size() + 3) / 4 * 4);
  std::string glb("glTF");
  const auto word = [&](std::uint32_t value) { glb.append(reinterpret_cast<const char*>(&value), 4); };
  word(2);
  word(static_cast<std::uint32_t>(28 + head.size() + chunk.size()));
  word(static_cast<std::uint32_t>(head.size()));
  glb += "JSON" + head;
  word(static_cast<std::uint32_t>(chunk.size()));
  glb += std::string("BIN\0", 4) + chunk;
  write_text(to, glb);
  return to;
}

}  // namespace dermis::scene::test
