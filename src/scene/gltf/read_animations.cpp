// SPDX-License-Identifier: MIT
// Reads animations: which nodes they move, and where their key frames are.
#include "scene/gltf/document.h"

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

AnimationSource::Channel read_channel(const Document& document, const Value& value, std::size_t samplers) {
  AnimationSource::Channel channel{.sampler = value.index("sampler", samplers, "sampler")};
  const Value target = value.at("target");
  channel.node = target.index_or_none("node", document.nodes.size(), "node");
  channel.path = path_of(target.at("path").text());

  const bool has_targets = channel.node >= 0 && document.nodes[channel.node].mesh >= 0 &&
                           !document.meshes[document.nodes[channel.node].mesh].primitives[0].targets.empty();
  if (channel.path == AnimatedPath::weights && channel.node >= 0 && !has_targets)
    target.fail("animates the weights of node {}, which has no morph targets", channel.node);
  return channel;
}

}  // namespace

void read_animations(Document& document, const Value& root) {
  root.for_each("animations", [&](const Value& value) {
    AnimationSource animation{.name = value.text_or("name", "")};
    const std::size_t samplers = value.at("samplers").array_size();
    value.for_each("samplers", [&](const Value& sampler) {
      animation.samplers.push_back({sampler.index("input", document.accessors.size(), "accessor"),
                                    sampler.index("output", document.accessors.size(), "accessor"),
                                    read_interpolation(sampler)});
    });
    value.at("channels");
    value.for_each("channels", [&](const Value& channel) {
      animation.channels.push_back(read_channel(document, channel, samplers));
    });
    document.animations.push_back(std::move(animation));
  });
}

}  // namespace dermis::scene::gltf
