// SPDX-License-Identifier: MIT
#include "render/setup/background.h"

#include <charconv>

#include "base/core/error.h"
#include "base/core/known_names.h"

namespace dermis::setup {

passes::Behind background_of(const std::string& name) {
  using Kind = passes::Behind::Kind;
  if (name == "black") return {.kind = Kind::black};
  if (name == "studio") return {.kind = Kind::studio};
  if (name == "environment") return {.kind = Kind::environment};

  unsigned value = 0;
  const char* const end = name.data() + name.size();
  const bool is_colour = name.size() == 7 && name[0] == '#';
  const auto parsed = is_colour ? std::from_chars(name.data() + 1, end, value, 16) : std::from_chars_result{};
  if (!is_colour || parsed.ec != std::errc() || parsed.ptr != end)
    throw input_error("", "output.background must be black, studio, environment or #RRGGBB, got '{}'{}", name,
                      did_you_mean(name, {"black", "studio", "environment"}));

  const auto part = [&](unsigned shift) { return static_cast<float>(value >> shift & 255u) / 255.0f; };
  return {.kind = Kind::colour, .srgb = {part(16), part(8), part(0)}};
}

}  // namespace dermis::setup
