// SPDX-License-Identifier: MIT
// Reads animations: which nodes they move, and where their key frames are.
#include <set>

#include "base/core/one_line.h"
#include "head/scene/gltf/document.h"
#include "head/scene/gltf/lenient.h"

namespace dermis::scene::gltf {

namespace {

Interpolation read_interpolation(const Value& sampler) {
  const std::string name = sampler.text_or("interpolation", "LINEAR");
  if (name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  sampler.at("interpolation").fail("must be LINEAR, STEP or CUBICSPLINE, is \"{}\"", name.substr(0, 40));
}

std::optional<AnimatedPath> path_of(const std::string& name) {
  if (name == "translation") return AnimatedPath::translation;
  if (name == "rotation") return AnimatedPath::rotation;
  if (name == "scale") return AnimatedPath::scale;
  if (name == "weights") return AnimatedPath::weights;
  return std::nullopt;  // extensions have others
}

void read_channel(const Document& document, const Value& value, AnimationSource& animation) {
  AnimationSource::Channel channel{.sampler = value.index("sampler", animation.samplers.size(), "sampler")};
  const Value target = value.at("target");
  channel.node = target.index_or_none("node", document.nodes.size(), "node");
  channel.path = path_of(target.at("path").text());

  if (channel.path == AnimatedPath::weights && channel.node >= 0) {
    const int mesh = document.nodes[static_cast<std::size_t>(channel.node)].mesh;
    if (mesh < 0 || document.meshes[static_cast<std::size_t>(mesh)].targets == 0) {
      warn_at(target, "animates weights of a node without morph targets, and is left out");
      return;
    }
  }
  animation.channels.push_back(channel);
}

void read_animation(const Document& document, const Value& value, AnimationSource& animation) {
  value.for_each("samplers", [&](const Value& sampler) {
    animation.samplers.push_back({sampler.index("input", document.accessors.size(), "accessor"),
                                  sampler.index("output", document.accessors.size(), "accessor"),
                                  read_interpolation(sampler)});
  });
  value.for_each("channels", [&](const Value& channel) { read_channel(document, channel, animation); });
}

}  // namespace

void read_animations(Document& document, const Value& root) {
  std::size_t number = 0;
  root.for_each("animations", [&](const Value& value) {
    const std::string otherwise = std::to_string(number++);
    AnimationSource animation{.name = text_near(value, "name", "")};
    if (animation.name.empty()) animation.name = otherwise;
    animation.fault = fault_of([&] { read_animation(document, value, animation); });
    // Exporters write one for each character, whether it moves or not.
    if (animation.fault.empty() && animation.channels.empty())
      warn_at(value, "moves nothing, and is left out");
    else
      document.animations.push_back(std::move(animation));
  });

  std::set<std::string> names;
  for (const AnimationSource& animation : document.animations)
    if (!names.insert(animation.name).second)
      warn_in(document.file, "animations share the name '{}'; a number, 0 to {}, takes any of them",
              one_line(animation.name, 80), document.animations.size() - 1);
}

}  // namespace dermis::scene::gltf
