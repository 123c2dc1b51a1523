// SPDX-License-Identifier: MIT
#include "posed_by_hand.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "support/files.h"

namespace dermis::scene::test {
namespace {

std::string decoded_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t held = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) continue;
    held = (held << 6 | static_cast<std::uint32_t>(digit)) & 0xffffff;
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(held >> (bits -= 8) & 0xff);
  }
  return bytes;
}

template <class T>
double one(const char* bytes, bool normalised) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  if (!normalised) return static_cast<double>(value);
  return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

std::pair<std::size_t, double (*)(const char*, bool)> component(int type) {
  switch (type) {
    case 5120: return {1, one<std::int8_t>};
    case 5121: return {1, one<std::uint8_t>};
    case 5122: return {2, one<std::int16_t>};
    case 5123: return {2, one<std::uint16_t>};
    case 5125: return {4, one<std::uint32_t>};
    default: return {4, one<float>};
  }
}

std::size_t components(const std::string& type) {
  const std::map<std::string, std::size_t> known{
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  return known.at(type);
}

std::array<double, 16> product(const std::array<double, 16>& a, const std::array<double, 16>& b) {
  std::array<double, 16> c{};
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return c;
}

}  // namespace

PosedByHand::PosedByHand(const std::filesystem::path& file) {
  std::string text = tests::read_text(file), chunk;
  if (text.starts_with("glTF")) {
    std::uint32_t size = 0, rest = 0;
    std::memcpy(&size, text.data() + 12, 4);
    if (text.size() > 28 + size) {
      std::memcpy(&rest, text.data() + 20 + size, 4);
      chunk = text.substr(28 + size, rest);
    }
    text = text.substr(20, size);
  }
  json_ = Json::parse(text);
  for (const Json& name : json_.value("extensionsUsed", Json::array()))
    compressed_ |= name == "EXT_meshopt_compression" || name == "KHR_draco_mesh_compression";
  for (const Json& buffer : json_["buffers"]) {
    const std::string uri = buffer.value("uri", "");
    if (uri.empty())
      buffers_.push_back(chunk);
    else if (uri.starts_with("data:"))
      buffers_.push_back(decoded_base64(uri.substr(uri.find(',') + 1)));
    else
      buffers_.push_back(tests::read_text(file.parent_path() / uri));
  }
}

std::size_t PosedByHand::animations() const { return json_.value("animations", Json::array()).size(); }

double PosedByHand::end_s(std::size_t animation) const {
  double end = 0;
  for (const Json& sampler : json_["animations"][animation]["samplers"])
    end = std::max(end, numbers(sampler["input"]).back());
  return end;
}

std::vector<double> PosedByHand::read(const Json& accessor, const Json& at, std::size_t count) const {
  const Json& view = json_["bufferViews"][at["bufferView"].get<std::size_t>()];
  const auto [bytes, read_one] = component(at.value("componentType", accessor["componentType"].get<int>()));
  const std::size_t size = at.contains("componentType") ? 1 : components(accessor["type"]);
  const std::size_t stride = view.value("byteStride", size * bytes);
  const char* from = buffers_[view["buffer"].get<std::size_t>()].data() + view.value("byteOffset", 0u) +
                     at.value("byteOffset", 0u);
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < size; ++c)
      out.push_back(read_one(from + i * stride + c * bytes, accessor.value("normalized", false)));
  return out;
}

const std::vector<double>& PosedByHand::numbers(std::size_t index) const {
  const auto [entry, is_new] = read_.try_emplace(index);
  if (!is_new) return entry->second;
  Json accessor = json_["accessors"][index];
  const std::size_t count = accessor["count"], size = components(accessor["type"]);
  std::vector<double>& out = entry->second;
  out.assign(count * size, 0);
  if (accessor.contains("bufferView")) {
    Json plain = accessor;
    plain.erase("componentType");
    out = read(accessor, plain, count);
  }
  if (!accessor.contains("sparse")) return out;

  const Json& sparse = accessor["sparse"];
  const std::size_t changed = sparse["count"];
  Json scalar = accessor;
  scalar["normalized"] = false;
  const std::vector<double> where = read(scalar, sparse["indices"], changed),
                            values = read(accessor, sparse["values"], changed);
  for (std::size_t i = 0; i < changed; ++i)
    for (std::size_t c = 0; c < size; ++c)
      out[static_cast<std::size_t>(where[i]) * size + c] = values[i * size + c];
  return out;
}

std::vector<double> PosedByHand::sampled(const Json& sampler, std::size_t size, bool turns,
                                         double seconds) const {
  const std::vector<double>&times = numbers(sampler["input"]), &values = numbers(sampler["output"]);
  const std::string way = sampler.value("interpolation", "LINEAR");
  const bool spline = way == "CUBICSPLINE";
  const auto value = [&](std::size_t key, std::size_t part = 1) {
    const std::size_t first = (spline ? 3 * key + part : key) * size;
    return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(first),
                               values.begin() + static_cast<std::ptrdiff_t>(first + size));
  };
  if (seconds <= times.front()) return value(0);
  if (seconds >= times.back()) return value(times.size() - 1);

  std::size_t k = 0;
  while (times[k + 1] <= seconds) ++k;
  const double duration = times[k + 1] - times[k], t = (seconds - times[k]) / duration;
  std::vector<double> a = value(k), b = value(k + 1);
  if (way == "STEP") return a;

  double share_a = 1 - t, share_b = t;
  if (turns && !spline) {  // spherical, along the shorter arc
    for (std::vector<double>* q : {&a, &b}) {
      const double length = std::hypot(std::hypot((*q)[0], (*q)[1]), std::hypot((*q)[2], (*q)[3]));
      for (double& number : *q) number /= length;
    }
    double cosine = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += a[i] * b[i];
    const double sign = cosine < 0 ? -1 : 1, angle = std::acos(std::min(std::abs(cosine), 1.0));
    if (angle > 1e-6) {
      share_a = std::sin((1 - t) * angle) / std::sin(angle);
      share_b = std::sin(t * angle) / std::sin(angle);
    }
    share_b *= sign;
  }
  std::vector<double> out(size);
  for (std::size_t i = 0; i < size; ++i) out[i] = share_a * a[i] + share_b * b[i];
  if (!spline) return out;

  const std::vector<double> leaving = value(k, 2), arriving = value(k + 1, 0);
  for (std::size_t i = 0; i < size; ++i)
    out[i] = (2 * t * t * t - 3 * t * t + 1) * a[i] + duration * (t * t * t - 2 * t * t + t) * leaving[i] +
             (3 * t * t - 2 * t * t * t) * b[i] + duration * (t * t * t - t * t) * arriving[i];
  return out;
}

std::vector<PosedByHand::Node> PosedByHand::nodes_at(std::size_t animation, double seconds) const {
  std::vector<Node> nodes;
  for (const Json& node : json_["nodes"]) {
    Node& made = nodes.emplace_back();
    made.translation = node.value("translation", std::vector<double>{0, 0, 0});
    made.rotation = node.value("rotation", std::vector<double>{0, 0, 0, 1});
    made.scale = node.value("scale", std::vector<double>{1, 1, 1});
    made.matrix = node.value("matrix", std::vector<double>{});
    if (!node.contains("mesh")) continue;
    const Json& mesh = json_["meshes"][node["mesh"].get<std::size_t>()];
    const std::size_t targets = mesh["primitives"][0].value("targets", Json::array()).size();
    made.weights = node.value("weights", mesh.value("weights", std::vector<double>(targets)));
  }

  const Json& moved = json_["animations"][animation];
  for (const Json& channel : moved["channels"]) {
    if (!channel["target"].contains("node")) continue;
    Node& node = nodes[channel["target"]["node"].get<std::size_t>()];
    const Json& sampler = moved["samplers"][channel["sampler"].get<std::size_t>()];
    const std::string path = channel["target"]["path"];
    if (path == "translation") node.translation = sampled(sampler, 3, false, seconds);
    if (path == "rotation") node.rotation = sampled(sampler, 4, true, seconds);
    if (path == "scale") node.scale = sampled(sampler, 3, false, seconds);
    if (path == "weights") node.weights = sampled(sampler, node.weights.size(), false, seconds);
  }
  return nodes;
}

std::vector<PosedByHand::Matrix> PosedByHand::worlds(const std::vector<Node>& nodes) const {
  std::vector<int> parents(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const Json& child : json_["nodes"][i].value("children", Json::array()))
      parents[child.get<std::size_t>()] = static_cast<int>(i);

  std::vector<Matrix> local(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& n = nodes[i];
    if (!n.matrix.empty()) {
      std::copy(n.matrix.begin(), n.matrix.end(), local[i].begin());
      continue;
    }
    double length = 0;
    for (const double q : n.rotation) length += q * q;
    length = std::sqrt(length);
    const double x = n.rotation[0] / length, y = n.rotation[1] / length, z = n.rotation[2] / length,
                 w = n.rotation[3] / length;
    const std::array<double, 9> turn{
        1 - 2 * (y * y + z * z), 2 * (x * y + z * w),     2 * (x * z - y * w),
        2 * (x * y - z * w),     1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
        2 * (x * z + y * w),     2 * (y * z - x * w),     1 - 2 * (x * x + y * y)};
    local[i] = Matrix{};
    for (std::size_t column = 0; column < 3; ++column)
      for (std::size_t row = 0; row < 3; ++row)
        local[i][4 * column + row] = turn[3 * column + row] * n.scale[column];
    for (std::size_t row = 0; row < 3; ++row) local[i][12 + row] = n.translation[row];
    local[i][15] = 1;
  }

  std::vector<Matrix> world = local;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int up = parents[i]; up >= 0; up = parents[static_cast<std::size_t>(up)])
      world[i] = product(local[static_cast<std::size_t>(up)], world[i]);
  return world;
}

std::vector<std::vector<PosedByHand::Point>> PosedByHand::positions_m(std::size_t animation,
                                                                      double seconds) const {
  return positions_of(nodes_at(animation, seconds));
}

std::vector<std::vector<PosedByHand::Point>> PosedByHand::blended_m(std::size_t first, double first_s,
                                                                    std::size_t second, double second_s,
                                                                    double share) const {
  std::vector<Node> nodes = nodes_at(first, first_s);
  const std::vector<Node> others = nodes_at(second, second_s);
  const auto mix = [&](std::vector<double>& a, const std::vector<double>& b, double of_a, double of_b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = of_a * a[i] + of_b * b[i];
  };
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    mix(nodes[n].translation, others[n].translation, 1 - share, share);
    mix(nodes[n].scale, others[n].scale, 1 - share, share);
    mix(nodes[n].weights, others[n].weights, 1 - share, share);

    // Spherical, along the shorter arc.
    std::vector<double> a = nodes[n].rotation, b = others[n].rotation;
    double cosine = 0, length_a = 0, length_b = 0;
    for (std::size_t i = 0; i < 4; ++i) length_a += a[i] * a[i], length_b += b[i] * b[i];
    for (std::size_t i = 0; i < 4; ++i) a[i] /= std::sqrt(length_a), b[i] /= std::sqrt(length_b);
    for (std::size_t i = 0; i < 4; ++i) cosine += a[i] * b[i];
    const double angle = std::acos(std::min(std::abs(cosine), 1.0)), sign = cosine < 0 ? -1 : 1;
    if (angle > 1e-6)
      mix(a, b, std::sin((1 - share) * angle) / std::sin(angle),
          sign * std::sin(share * angle) / std::sin(angle));
    nodes[n].rotation = a;
  }
  return positions_of(nodes);
}

std::vector<std::vector<PosedByHand::Point>> PosedByHand::positions_of(const std::vector<Node>& nodes) const {
  const std::vector<Matrix> world = worlds(nodes);
  std::vector<std::vector<Point>> all;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const Json& node = json_["nodes"][n];
    if (!node.contains("mesh")) continue;

    std::vector<Matrix> joints;
    if (node.contains("skin")) {
      const Json& skin = json_["skins"][node["skin"].get<std::size_t>()];
      for (std::size_t j = 0; j < skin["joints"].size(); ++j) {
        Matrix bind{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        if (skin.contains("inverseBindMatrices"))
          std::copy_n(numbers(skin["inverseBindMatrices"]).begin() + static_cast<std::ptrdiff_t>(16 * j), 16,
                      bind.begin());
        joints.push_back(product(world[skin["joints"][j].get<std::size_t>()], bind));
      }
    }

    for (const Json& primitive : json_["meshes"][node["mesh"].get<std::size_t>()]["primitives"]) {
      const Json& attributes = primitive["attributes"];
      std::vector<double> p = numbers(attributes["POSITION"]);
      for (std::size_t t = 0; t < nodes[n].weights.size(); ++t) {
        const Json& target = primitive["targets"][t];
        if (!target.contains("POSITION")) continue;
        const std::vector<double>& moved = numbers(target["POSITION"]);
        for (std::size_t i = 0; i < p.size(); ++i) p[i] += nodes[n].weights[t] * moved[i];
      }

      std::vector<Point>& placed = all.emplace_back();
      for (std::size_t i = 0; i < p.size() / 3; ++i) {
        Matrix m{};
        double sum = 0;
        for (const char* set : {"0", "1"}) {
          if (joints.empty() || !attributes.contains(std::string("JOINTS_") + set)) continue;
          const std::vector<double>&hung = numbers(attributes[std::string("JOINTS_") + set]),
                &weights = numbers(attributes[std::string("WEIGHTS_") + set]);
          for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
            if (weights[k] == 0) continue;
            sum += weights[k];
            for (std::size_t e = 0; e < 16; ++e)
              m[e] += weights[k] * joints[static_cast<std::size_t>(hung[k])][e];
          }
        }
        if (sum == 0) m = world[n], sum = 1;

        Point& out = placed.emplace_back();
        for (std::size_t row = 0; row < 3; ++row)
          out[row] =
              (m[row] * p[3 * i] + m[4 + row] * p[3 * i + 1] + m[8 + row] * p[3 * i + 2] + m[12 + row]) / sum;
      }
    }
  }
  return all;
}

}  // namespace dermis::scene::test
