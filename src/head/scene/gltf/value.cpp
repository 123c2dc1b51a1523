// SPDX-License-Identifier: MIT
#include "head/scene/gltf/value.h"

#include <fmt/ranges.h>

#include "head/scene/gltf/lenient.h"

namespace dermis::scene::gltf {

// A key that is given twice is bad style in glTF, not an error; the last one counts. A value takes 16 to 100
// bytes.
constexpr json::Limits limits{
    .depth = 128, .values = 5'000'000, .repeated_keys = true, .empty_is_absent = true};
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

json::Document parse(std::string_view text, const std::string& file) {
  if (text.starts_with(byte_order_mark)) {
    text.remove_prefix(byte_order_mark.size());
    warn_in(file, "the JSON starts with a byte-order mark, which glTF forbids");
  }
  json::Document document(text, file, limits);
  document.root().object();
  if (const json::LeftOut& empty = document.left_out(); empty.count > 0)
    warn_in(file, "{} null, empty or of another type than the others, read as if not there: {}{}",
            empty.count == 1 ? "a member is" : fmt::format("{} members are", empty.count),
            fmt::join(empty.first, ", "), empty.count > empty.first.size() ? ", ..." : "");
  return document;
}

std::optional<Value> extension(const Value& value, const char* name) {
  const std::optional<Value> all = value.find("extensions");
  if (!all || !all->is_object()) return std::nullopt;
  std::optional<Value> one = all->find(name);
  if (!one || one->is_object()) return one;
  warn_at(*one, "is no object, and is left out");
  return std::nullopt;
}

}  // namespace dermis::scene::gltf
