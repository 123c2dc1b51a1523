// SPDX-License-Identifier: MIT
// Skin: what it is made of, how far light spreads in it, and the same for other engines.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cstdio>

#include "base/settings/names.h"
#include "base/settings/profile_fields.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/gaussians/known.h"
#include "tissue/optics/presets.h"
#include "viewer/model/opening.h"
#include "viewer/model/saving.h"
#include "viewer/panels/desk.h"
#include "viewer/panels/places.h"
#include "viewer/panels/rows.h"
#include "viewer/panels/settings_rows.h"
#include "viewer/panels/skin_plot.h"

namespace dermis::viewer {
namespace {

bool kind_row(SkinSource& skin) {
  bool changed = false;
  const bool open = ImGui::BeginCombo("made of", skin_kind_titles[static_cast<std::size_t>(skin.kind)]);
  if (!open) note_place("made of");
  if (!open) return false;
  for (std::size_t i = 0; i < std::size(skin_kind_titles); ++i) {
    const bool chosen = ImGui::Selectable(skin_kind_titles[i], i == static_cast<std::size_t>(skin.kind));
    note_place(skin_kind_titles[i]);
    if (!chosen) continue;
    skin.kind = static_cast<SkinKind>(i);
    changed = true;
  }
  ImGui::EndCombo();
  return changed;
}

template <class Settings>
bool rows(Settings& settings) {
  bool changed = false;
  const Row row;
  for_each_setting(settings, [&](const std::string& path, const About& about, auto& value, std::string_view) {
    changed |= row(path, about, value);
  });
  return changed;
}

bool preset_row(SkinSource& skin) {
  bool changed = false;
  const bool open = ImGui::BeginCombo("material", skin.preset.c_str());
  if (!open) note_place("material");
  if (!open) return false;
  for (const std::string_view name : optics::preset_names())
    if (ImGui::Selectable(std::string(name).c_str(), name == skin.preset) && name != skin.preset) {
      skin.preset = name;
      changed = true;
    }
  ImGui::EndCombo();
  return changed;
}

// A colour finds the skin that is nearest to it; how far that is, is said.
bool colour_row(SkinSource& skin) {
  unsigned code = 0xc58c85;
  if (skin.colour.size() == 7) std::sscanf(skin.colour.c_str() + 1, "%6x", &code);
  float colour[3];
  for (unsigned c = 0; c < 3; ++c) colour[c] = static_cast<float>((code >> (16 - 8 * c)) & 255u) / 255;
  bool changed = false;
  ImGui::ColorEdit3("nearest to", colour);
  note_place("nearest to");
  // While a colour is dragged it is only shown: the nearest skin takes a tenth of a second.
  static bool edits = false;
  if (ImGui::IsItemActive() || ImGui::IsItemEdited()) {
    skin.colour = fmt::format("#{:02x}{:02x}{:02x}", std::lround(colour[0] * 255),
                              std::lround(colour[1] * 255), std::lround(colour[2] * 255));
    edits = true;
    changed = true;
  }
  if (!ImGui::IsItemActive() && edits) {
    edits = false;
    skin.spectral = skin_of_colour(skin.colour, &skin.colour_error);
    changed = true;
  }
  if (!skin.colour.empty())
    ImGui::TextDisabled("%s: %.1f dE (CIE76) from it", skin.colour.c_str(), skin.colour_error);
  return changed;
}

bool spectral_rows(SkinSource& skin) {
  bool changed = colour_row(skin);
  if (rows(skin.spectral)) {
    skin.colour.clear();
    changed = true;
  }
  return changed;
}

bool foreign_row(SkinSource& skin) {
  return text_row("parameters", About{.help = cli::import_help}, skin.foreign);
}

bool source_rows(SkinSource& skin) {
  switch (skin.kind) {
    case SkinKind::scene: return false;
    case SkinKind::preset: return preset_row(skin);
    case SkinKind::spectral: return spectral_rows(skin);
    case SkinKind::coefficients: return rows(skin.coefficients);
    case SkinKind::foreign: return foreign_row(skin);
    case SkinKind::gaussians: ImGui::TextDisabled("drag the points on the curve"); return false;
  }
  return false;
}

// A kind that was never used begins with the skin as it is.
void begin(SkinSource& skin, const Document& now) {
  if (skin.kind == SkinKind::gaussians && skin.gaussians.terms.empty()) skin.gaussians = profile_of(now);
  if (skin.kind == SkinKind::coefficients &&
      skin.coefficients.sigma_s_per_mm == std::array<double, 3>{0, 0, 0}) {
    const optics::RgbMedium medium = optics::find_material("skin1")->medium();
    for (std::size_t c = 0; c < 3; ++c) {
      skin.coefficients.sigma_a_per_mm[c] = medium[c].sigma_a_per_mm;
      skin.coefficients.sigma_s_per_mm[c] = medium[c].sigma_s_per_mm;
    }
    skin.coefficients.eta = medium[0].eta;
  }
}

void figures(const Desk& desk) {
  const ScatterProfile& profile = desk.skin->profile;
  ImGui::TextWrapped("%s%s", desk.skin->model.c_str(), desk.skin->is_quick ? " (a better one follows)" : "");
  if (!desk.skin_doing.empty()) ImGui::TextDisabled("%s", desk.skin_doing.c_str());
  // Numbers that a profile does not know are zero.
  const auto line = [](const char* what, const std::array<double, 3>& v, const char* unit) {
    if (v == std::array<double, 3>{}) return;
    ImGui::Text("%s", what);
    ImGui::SameLine(ImGui::GetFontSize() * 9);
    ImGui::Text("%.3g  %.3g  %.3g %s", v[0], v[1], v[2], unit);
  };
  line("error of the fit", profile.error_percent, "%");
  line("noise", profile.noise_percent, "%");
  line("reflects", profile.total_reflectance, "");
  line("mean free path", profile.mean_free_path_mm, "mm");
  if (!desk.skin->note.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", desk.skin->note.c_str());
}

void exports(Desk& desk) {
  if (!desk.skin || !noted_header("For other engines, and as a page")) return;
  if (!desk.skin->source) {
    ImGui::TextWrapped("Gaussians alone have no medium that could be told; they are saved as a profile.");
    return;
  }
  if (noted_button("R(r) and its fit in the browser")) desk.requests.profile_page = true;
  int number = 0;
  for (const std::string_view system : gaussians::exchange_names()) {
    if (number++ % 3 != 0) ImGui::SameLine();
    if (!noted_button(std::string(system))) continue;
    try {
      desk.view.exported = exported_skin(*desk.skin, std::string(system));
      ImGui::SetClipboardText(desk.view.exported.c_str());
      desk.view.message = "copied the parameters of " + std::string(system);
      desk.view.is_error = false;
    } catch (const InputError& error) {
      desk.view.message = error.what();
      desk.view.is_error = true;
    }
  }
  if (!desk.view.exported.empty())
    ImGui::InputTextMultiline("##exported", &desk.view.exported,
                              {ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 12},
                              ImGuiInputTextFlags_ReadOnly);
}

}  // namespace

void skin_panel(Desk& desk) {
  SkinSource skin = desk.now.skin;
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.5f);
  bool changed = kind_row(skin);
  if (changed) begin(skin, desk.now);
  changed |= source_rows(skin);
  if (skin.kind != SkinKind::scene && skin.kind != SkinKind::gaussians && ImGui::TreeNode("computation")) {
    changed |= rows(skin.options);
    ImGui::TreePop();
  }
  ImGui::PopItemWidth();

  const bool by_hand = skin.kind == SkinKind::gaussians;
  changed |= skin_plot(by_hand     ? curves_of(skin.gaussians)
                       : desk.skin ? desk.skin->curves
                                   : curves_of(profile_of(desk.now)),
                       by_hand ? &skin.gaussians : nullptr);
  if (desk.skin) figures(desk);

  if (changed)
    desk.edit("skin", [&](Document& next) {
      ++skin.serial;
      next.skin = skin;
      if (skin.kind == SkinKind::scene) clear_profile(next);
    });

  exports(desk);
  if (noted_header("In this scene", ImGuiTreeNodeFlags_DefaultOpen)) settings_rows(desk, "skin");
  ImGui::Checkbox("a scale of millimetres in the picture", &desk.view.scale);
}

}  // namespace dermis::viewer
