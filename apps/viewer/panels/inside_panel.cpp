// SPDX-License-Identifier: MIT
// Parts of a picture: its maps, the cost of each pass, values under the pointer.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/settings/fields.h"
#include "viewer/model/label_views.h"
#include "viewer/model/page.h"
#include "viewer/model/shown_maps.h"
#include "viewer/panels/desk.h"
#include "viewer/panels/places.h"
#include "viewer/panels/rows.h"

namespace dermis::viewer {
namespace {

void show_row(Desk& desk) {
  const Statistics* statistics = desk.shown ? &desk.shown->picture.statistics : nullptr;
  const bool open = ImGui::BeginCombo("show", desk.view.show.c_str(), ImGuiComboFlags_HeightLargest);
  note_place("show");
  if (!open) return;
  std::vector<std::string> names =
      shown_map_names(statistics ? statistics->gaussians : 1, statistics ? statistics->lights : 1);
  names.insert(names.end(), label_views.begin(), label_views.end());
  for (const std::string& name : names) {
    if (ImGui::Selectable(name.c_str(), name == desk.view.show)) desk.view.show = name;
    note_place("show " + name);
  }
  ImGui::EndCombo();
}

// Optimisations as switches, so that one sees what each saves.
void optimisations(Desk& desk) {
  QualitySettings quality = desk.now.settings.quality;
  bool changed = false;
  for_each_setting(quality, [&](const std::string& name, const About& about, auto& value, std::string_view) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, bool>)
      if (about.option == "optimise") {
        changed |= switch_row(name, about, value);
        ImGui::SameLine();
      }
  });
  ImGui::NewLine();
  if (changed) desk.edit("optimise", [&](Document& next) { next.settings.quality = quality; });
}

// The columns of a pass, after its name.
void pass_columns(const std::array<std::string, 3>& words) {
  const float right = ImGui::GetWindowContentRegionMax().x, em = ImGui::GetFontSize();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const float end = right - em * 4 * static_cast<float>(words.size() - 1 - i);
    ImGui::SameLine(end - ImGui::CalcTextSize(words[i].c_str()).x);
    ImGui::TextUnformatted(words[i].c_str());
  }
}

// Time as a bar behind the name; and the images that a pass writes.
void passes(const Statistics& s) {
  double most = 1e-9;
  for (const PassStatistics& pass : s.passes) most = std::max(most, pass.ms);
  ImGui::TextDisabled("pass, images that it writes");
  pass_columns({"ms", "Mtexel", "MB"});
  const float width = ImGui::GetContentRegionAvail().x;
  for (const PassStatistics& pass : s.passes) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float length = std::max(1.0f, width * static_cast<float>(pass.ms / most));
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + length, at.y + ImGui::GetTextLineHeight()},
                                              IM_COL32(190, 115, 92, 110));
    ImGui::TextUnformatted(pass.name.c_str());
    const bool draws = pass.texels > 0;
    pass_columns({fmt::format("{:.2f}", pass.ms),
                  draws ? fmt::format("{:.2f}", static_cast<double>(pass.texels) / 1e6) : "",
                  draws ? fmt::format("{:.1f}", static_cast<double>(pass.image_bytes) / 1e6) : ""});
  }
}

void cost(Desk& desk) {
  if (!desk.shown) return;
  const Statistics& s = desk.shown->picture.statistics;
  const auto number = [](int n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
  };
  ImGui::Text("%s, %s, %s", number(s.lights, "light").c_str(), number(s.gaussians, "Gaussian").c_str(),
              number(s.heads, "head").c_str());
  std::string sides;
  for (const int side : s.used_size) sides += (sides.empty() ? "" : ", ") + std::to_string(side);
  ImGui::TextWrapped("T %s texels; lit %.3f million, blurred %.3f million", sides.c_str(),
                     static_cast<double>(s.irradiance_texels) / 1e6,
                     static_cast<double>(s.convolved_texels) / 1e6);
  ImGui::Text("images %.0f MB, buffers %.0f MB, at most %.0f MB", static_cast<double>(s.image_bytes) / 1e6,
              static_cast<double>(s.buffer_bytes) / 1e6, static_cast<double>(s.peak_bytes) / 1e6);
  if (!desk.view.frame_ms.empty())
    ImGui::PlotLines(
        "##ms", desk.view.frame_ms.data(), static_cast<int>(desk.view.frame_ms.size()), 0,
        fmt::format("{:.0f} ms, last {} pictures", desk.view.frame_ms.back(), desk.view.frame_ms.size())
            .c_str(),
        0, *std::max_element(desk.view.frame_ms.begin(), desk.view.frame_ms.end()) * 1.1f,
        {ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 4});
  if (!s.passes.empty()) passes(s);
}

// The colours of the view of thickness.
void legend(const Desk& desk) {
  if (!desk.shown) return;
  const float side = ImGui::GetFontSize();
  for (const LegendMark& mark : thickness_legend(*desk.shown)) {
    if (ImGui::GetContentRegionAvail().x < 4 * side) ImGui::NewLine();
    const auto [r, g, b] = mark.colour;
    ImGui::ColorButton("##mark", {r, g, b, 1}, ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoBorder,
                       {side, side});
    ImGui::SameLine();
    ImGui::Text("%.3g", mark.mm);
    ImGui::SameLine();
  }
  ImGui::TextUnformatted("mm");
}

void loupe(const Desk& desk) {
  if (!desk.view.pointer || !desk.shown) return;
  const std::optional<PixelValues> pixel =
      pixel_at(*desk.shown, desk.view.pointer->at(0), desk.view.pointer->at(1));
  if (!pixel) return;
  ImGui::Text("pixel %d, %d: linear %.4f %.4f %.4f", pixel->x, pixel->y, pixel->linear[0], pixel->linear[1],
              pixel->linear[2]);
  ImGui::Text("display %d %d %d, skin %.0f %%", pixel->display[0], pixel->display[1], pixel->display[2],
              100 * pixel->linear[3]);
  if (!pixel->is_labelled) return;
  if (pixel->instance == 0) {
    ImGui::TextDisabled("nothing is there");
    return;
  }
  ImGui::Text("instance %u, material %u, %s", pixel->instance, pixel->material, pixel->region.c_str());
  ImGui::Text("%.1f mm from the eye; normal %.2f %.2f %.2f", 1000 * pixel->depth_m, pixel->normal[0],
              pixel->normal[1], pixel->normal[2]);
  if (pixel->position_m)
    ImGui::Text("position %.4f %.4f %.4f m", pixel->position_m->at(0), pixel->position_m->at(1),
                pixel->position_m->at(2));
  ImGui::Text("uv %.4f %.4f", pixel->uv[0], pixel->uv[1]);
  if (pixel->skin_mesh == 0) return;
  ImGui::Text("thickness %.1f mm; texel %.1f %.1f of T %d", pixel->thickness_mm, pixel->texel[0],
              pixel->texel[1], pixel->map_side);
  if (pixel->irradiance)
    ImGui::Text("irradiance that enters %.4f %.4f %.4f", pixel->irradiance->at(0), pixel->irradiance->at(1),
                pixel->irradiance->at(2));
  else
    ImGui::TextDisabled("its irradiance is in no map");
  if (pixel->mapped_terms >= 0)
    ImGui::Text("Gaussians from maps: the widest %d of %d", pixel->mapped_terms,
                desk.shown->picture.statistics.gaussians);
}

}  // namespace

void inside_panel(Desk& desk) {
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
  show_row(desk);
  ImGui::PopItemWidth();
  optimisations(desk);

  ImGui::Checkbox("times of the passes", &desk.view.timed);
  note_place("times of the passes");
  ImGui::SameLine();
  ImGui::Checkbox("loupe", &desk.view.loupe);
  note_place("loupe");
  ImGui::Separator();
  const bool labelled = is_label_view(desk.view.show);
  if ((desk.view.loupe && desk.view.show != first_shown && !labelled) ||
      ((desk.view.loupe || labelled) && desk.view.timed))
    ImGui::TextDisabled("labels need the picture itself, untimed");
  if (desk.view.show == "thickness") legend(desk);
  if (desk.view.loupe) {
    loupe(desk);
    ImGui::Separator();
  }
  cost(desk);

  if (noted_header("Pages")) {
    ImGui::TextDisabled("computed beside the window, opened in the browser");
    const std::vector<Page> pages = pages_of({}, {}, "");
    for (std::size_t i = 0; i < pages.size(); ++i)
      if (noted_button(pages[i].title)) desk.requests.page = i;
  }
  if (!desk.view.notes.empty() && noted_header("Notes of the library"))
    for (const std::string& note : desk.view.notes) ImGui::TextWrapped("%s", note.c_str());
}

}  // namespace dermis::viewer
