// SPDX-License-Identifier: MIT
#include "head/scene/import/material_source.h"

#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "base/core/one_line.h"
#include "base/core/warnings.h"

namespace dermis::scene {

namespace {

constexpr float skin_ior = 1.4f;  // F0 of skin 0.028

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// Returns the words of a name in small letters, as programs join them: "Std_SkinHead.001" has std, skin,
/// head.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i])) continue;
    const bool after_letter = i > 0 && is_letter(name[i - 1]);
    const bool begins =
        is_upper(name[i]) && (!after_letter || !is_upper(name[i - 1]) ||
                              (i + 1 < name.size() && is_letter(name[i + 1]) && !is_upper(name[i + 1])));
    if (!after_letter || begins) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return words;
}

/// Returns whether a word is "skin", alone or joined to a part of the body or to a word for material: jeans
/// are skinny, boots of snakeskin.
bool is_skin_word(std::string_view word) {
  constexpr std::array joined{
      "arm",  "arms",  "base", "body", "col",    "color", "colour",   "ear",  "ears",  "face",  "female",
      "hand", "hands", "head", "leg",  "legs",   "limbs", "lips",     "male", "man",   "map",   "mat",
      "mtl",  "neck",  "nose", "s",    "shader", "tex",   "material", "tone", "torso", "human", "woman"};
  const std::size_t at = word.find("skin");
  if (at == std::string_view::npos) return false;
  const auto is_known = [&](std::string_view rest) {
    return rest.empty() || std::find(joined.begin(), joined.end(), rest) != joined.end();
  };
  return is_known(word.substr(0, at)) && is_known(word.substr(at + 4));
}

bool is_skin_name(const std::string& name) {
  const std::vector<std::string> words = words_of(name);
  return std::any_of(words.begin(), words.end(), is_skin_word);
}

// A material with "skin": false is skin only by SceneOptions::skin_material.
bool may_be(const MaterialSource& m) { return m.says_skin.value_or(true); }
bool is_named(const MaterialSource& m) { return may_be(m) && is_skin_name(m.material.name); }

/// A name matches itself, whatever a shell would make of its characters. Patterns take letters of either
/// case, as the names of skin that is not asked for do.
bool matches(const std::string& pattern, const std::string& name) {
  return pattern == name || fnmatch(pattern.c_str(), name.c_str(), FNM_CASEFOLD) == 0;
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
    if (!m.material.skin || m.material.alpha_mode != AssetAlpha::blend) continue;
    m.material.skin = false;
    blended.push_back(m);
  }
  if (!blended.empty())
    warn(
        "{}: skin with alphaMode BLEND is drawn as a blended surface, and no light spreads in it: {}; OPAQUE "
        "or MASK draws it as skin",
        file, quoted_names(blended));
}

/// Blends surfaces that light passes through over what lies behind them. Through skin light scatters, and
/// what is cut out is drawn before what it could show.
void make_transmissive_blended(const std::string& file, std::vector<MaterialSource>& materials) {
  std::vector<MaterialSource> kept_opaque;
  for (MaterialSource& m : materials) {
    if (m.material.transmission == 0) continue;
    if (!m.material.skin && m.material.alpha_mode != AssetAlpha::mask) {
      m.material.alpha_mode = AssetAlpha::blend;
      continue;
    }
    m.material.transmission = 0;
    kept_opaque.push_back(m);
  }
  if (!kept_opaque.empty())
    warn("{}: KHR_materials_transmission of skin and of cut-out materials is left out: {}", file,
         quoted_names(kept_opaque));
}

}  // namespace

void UnusedMaterials::add(const MaterialSource& material) {
  ++count;
  if (!skin && (material.says_skin.value_or(false) || is_named(material))) skin = material.material.name;
}

MaterialSource default_material() {
  MaterialSource source;
  source.material.name = "default";
  return source;
}

void choose_skin(const std::string& file, const std::vector<std::string>& patterns,
                 const UnusedMaterials& unused, std::vector<MaterialSource>& materials) {
  bool any = false;
  const auto choose = [&](const auto& is_skin) {
    for (MaterialSource& m : materials) {
      m.material.skin = is_skin(m);
      any |= m.material.skin;
    }
  };
  for (const std::string& pattern : patterns) {
    const auto is_meant = [&](const MaterialSource& m) { return matches(pattern, m.material.name); };
    if (std::none_of(materials.begin(), materials.end(), is_meant))
      throw input_error(file, "no material is called '{}'; {}", pattern,
                        listed_names(pattern, names_of(materials)));
  }
  choose([&](const MaterialSource& m) {
    return std::any_of(patterns.begin(), patterns.end(),
                       [&](const std::string& pattern) { return matches(pattern, m.material.name); });
  });

  // In this order: what the file says, what the names say, the only material in use.
  if (!any) choose([](const MaterialSource& m) { return m.says_skin.value_or(false); });
  if (!any) choose(is_named);
  if (!any && materials.size() == 1 && !unused.skin) {
    choose(may_be);
    if (any && unused.count > 0)
      warn("{}: of {} materials only '{}' is in use; it is drawn as skin", file, unused.count + 1,
           one_line(materials[0].material.name, 80));
  }

  if (!any) {
    const std::string is_unused =
        unused.skin ? fmt::format(" ('{}' is, and nothing uses it)", one_line(*unused.skin, 80)) : "";
    const std::string line = fmt::format("{}: no material is skin{}; name one with skin_material: {}", file,
                                         is_unused, quoted_names(materials));
    warn_of(line, file, line);
  }

  make_blended_skin_surface(file, materials);
  make_transmissive_blended(file, materials);
  for (MaterialSource& m : materials) {
    if (m.material.skin && !m.has_ior) m.material.ior = skin_ior;
    if (!m.material.skin) m.material.skin_settings = {};
  }
}

}  // namespace dermis::scene
