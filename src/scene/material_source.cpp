// SPDX-License-Identifier: MIT
#include "scene/material_source.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "core/known_names.h"
#include "core/one_line.h"
#include "core/warnings.h"

namespace dermis::scene {

namespace {

constexpr float skin_ior = 1.4f;  // F0 of skin 0.028

bool says_skin(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.find("skin") != std::string::npos;
}

std::vector<std::string> names_of(const std::vector<MaterialSource>& materials) {
  std::vector<std::string> names;
  for (const MaterialSource& m : materials) names.push_back(m.material.name);
  return names;
}

std::string quoted_names(const std::vector<MaterialSource>& materials) {
  std::vector<std::string> names;
  for (const std::string& name : names_of(materials))
    names.push_back(fmt::format("'{}'", one_line(name, 80)));
  if (names.size() > 20) names.resize(20);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Makes blended skin a surface, as lashes are: light cannot spread in what is blended over something else.
void make_blended_skin_surface(const std::string& file, std::vector<MaterialSource>& materials) {
  std::vector<MaterialSource> blended;
  for (MaterialSource& m : materials) {
    if (!m.material.skin || m.material.alpha_mode != AlphaMode::blend) continue;
    m.material.skin = false;
    blended.push_back(m);
  }
  if (!blended.empty())
    warn(
        "{}: skin with alphaMode BLEND is drawn as a blended surface, and no light spreads in it: {}; OPAQUE "
        "or MASK draws it as skin",
        file, quoted_names(blended));
}

}  // namespace

MaterialSource default_material() {
  MaterialSource source;
  source.material.name = "default";
  return source;
}

void choose_skin(const std::string& file, const std::string& skin_material,
                 std::vector<MaterialSource>& materials) {
  bool any = false;
  const auto choose = [&](const auto& is_skin) {
    for (MaterialSource& m : materials) {
      m.material.skin = is_skin(m);
      any |= m.material.skin;
    }
  };
  // A material with "skin": false is skin only by SceneOptions::skin_material.
  const auto may_be = [](const MaterialSource& m) { return m.says_skin.value_or(true); };

  if (!skin_material.empty()) {
    choose([&](const MaterialSource& m) { return m.material.name == skin_material; });
    if (!any)
      throw input_error(file, "no material is called '{}'; {}", skin_material,
                        listed_names(skin_material, names_of(materials)));
  }

  // In this order: what the file says, what the names say, the only material.
  if (!any) choose([](const MaterialSource& m) { return m.says_skin.value_or(false); });
  if (!any) choose([&](const MaterialSource& m) { return may_be(m) && says_skin(m.material.name); });
  if (!any && materials.size() == 1) choose(may_be);

  if (!any) {
    const std::string line = fmt::format("{}: no material is skin; name one with skin_material: {}", file,
                                         quoted_names(materials));
    warn_of(line, file, line);
  }

  make_blended_skin_surface(file, materials);
  for (MaterialSource& m : materials) {
    if (m.material.skin && !m.has_ior) m.material.ior = skin_ior;
    if (!m.material.skin) m.material.skin_settings = {};
  }
}

}  // namespace dermis::scene
