// SPDX-License-Identifier: MIT
#include "scene/gltf/value.h"

namespace dermis::scene::gltf {

// A key that is given twice is bad style in glTF, not an error; the last one counts. A value takes 16 to 100
// bytes.
constexpr json::Limits limits{.depth = 128, .values = 5'000'000, .repeated_keys = true};

json::Document parse(std::string_view text, const std::string& file) {
  if (text.starts_with("\xEF\xBB\xBF"))
    throw input_error(file, "the JSON starts with a byte-order mark, which glTF forbids");
  json::Document document(text, file, limits);
  document.root().object();
  return document;
}

std::optional<Value> extension(const Value& value, const char* name) {
  const std::optional<Value> all = value.find("extensions");
  if (!all) return std::nullopt;
  const std::optional<Value> one = all->find(name);
  if (one) one->object();
  return one;
}

}  // namespace dermis::scene::gltf
