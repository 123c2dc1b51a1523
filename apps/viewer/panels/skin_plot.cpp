// SPDX-License-Identifier: MIT
#include "viewer/panels/skin_plot.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "viewer/panels/places.h"

namespace dermis::viewer {
namespace {

constexpr ImU32 channel_colours[] = {IM_COL32(235, 90, 80, 255), IM_COL32(95, 200, 110, 255),
                                     IM_COL32(100, 150, 255, 255)};
constexpr ImU32 grid = IM_COL32(62, 64, 70, 255), text = IM_COL32(170, 170, 175, 255);

struct Axes {
  ImVec2 low, size;
  double first_mm, last_mm, most;

  float x(double r_mm) const {
    return low.x + size.x * static_cast<float>(std::log(r_mm / first_mm) / std::log(last_mm / first_mm));
  }
  double r_mm(float at) const {
    return first_mm * std::pow(last_mm / first_mm, static_cast<double>((at - low.x) / size.x));
  }
  float y(double value) const {
    return low.y + size.y * (1 - static_cast<float>(std::clamp(value / most, 0.0, 1.0)));
  }
};

// Light that leaves per step of ln r. On an axis of ln r the area below the curve is what skin reflects, so a
// wide Gaussian looks as large as it counts.
double per_ln_r(double r_mm, double reflectance_per_mm2) {
  return 2 * std::numbers::pi * r_mm * r_mm * reflectance_per_mm2;
}

double most_of(const SkinCurves& curves) {
  double most = 1e-9;
  for (std::size_t i = 0; i < curves.r_mm.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double r = curves.r_mm[i], fit = curves.fit[i][c];
      most = std::max(most, per_ln_r(r, fit));
      if (!curves.model.empty() && std::isfinite(curves.model[i][c]))
        most = std::max(most, per_ln_r(r, std::min(curves.model[i][c], 3 * fit)));
    }
  return most * 1.08;
}

void draw_grid(const Axes& axes, ImDrawList& list) {
  const ImVec2 high(axes.low.x + axes.size.x, axes.low.y + axes.size.y);
  list.AddRectFilled(axes.low, high, IM_COL32(28, 29, 32, 255));
  for (const double mark : {0.01, 0.1, 1.0, 10.0}) {
    const float x = axes.x(mark);
    list.AddLine({x, axes.low.y}, {x, high.y}, grid);
    const std::string label = fmt::format("{:g} mm", mark);
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    list.AddText({std::clamp(x - width / 2, axes.low.x, high.x - width), high.y + 1}, text, label.c_str());
  }
  list.AddText({axes.low.x + 4, axes.low.y + 2}, text, "2 pi r^2 R(r)");
}

void draw_channel(const Axes& axes, ImDrawList& list, const SkinCurves& curves, std::size_t c) {
  const ImU32 colour = channel_colours[c], faint = (colour & 0x00ffffffu) | 0x40000000u;
  ImVec2 last;
  for (std::size_t i = 0; i < curves.r_mm.size(); ++i) {
    const double r = curves.r_mm[i];
    const float x = axes.x(r);
    if (!curves.model.empty() && std::isfinite(curves.model[i][c])) {
      const double value = per_ln_r(r, curves.model[i][c]);
      const double error = per_ln_r(r, curves.standard_error[i][c]);
      if (error > 0) list.AddLine({x, axes.y(value - error)}, {x, axes.y(value + error)}, faint, 3);
      const ImVec2 at(x, axes.y(value));
      if (i > 0) list.AddLine(last, at, colour, 1.5f);
      last = at;
    }
    if (i % 2 == 0) list.AddCircleFilled({x, axes.y(per_ln_r(r, curves.fit[i][c]))}, 1.5f, colour, 6);
  }
}

// The mean of the channels carries the points.
double mean(const std::array<double, 3>& v) { return (v[0] + v[1] + v[2]) / 3; }

void keep_normal(ScatterProfile& profile) {
  std::array<double, 3> sums{};
  for (const Gaussian& term : profile.terms)
    for (std::size_t c = 0; c < 3; ++c) sums[c] += term.weight[c];
  for (Gaussian& term : profile.terms)
    for (std::size_t c = 0; c < 3; ++c)
      term.weight[c] =
          sums[c] > 0 ? term.weight[c] / sums[c] : 1.0 / static_cast<double>(profile.terms.size());
}

void drag_term(ScatterProfile& profile, std::size_t i, double sigma_mm, double factor) {
  // Terms stay in their order, a little apart.
  const double below = i > 0 ? profile.terms[i - 1].variance_mm2 * 1.02 : 1e-6;
  const double above = i + 1 < profile.terms.size() ? profile.terms[i + 1].variance_mm2 / 1.02 : 1e4;
  if (below < above) profile.terms[i].variance_mm2 = std::clamp(sigma_mm * sigma_mm, below, above);
  for (double& weight : profile.terms[i].weight) weight = std::clamp(weight * factor, 1e-6, 1.0);
  keep_normal(profile);
}

bool handles(const Axes& axes, ImDrawList& list, ScatterProfile& profile) {
  bool changed = false;
  for (std::size_t i = 0; i < profile.terms.size(); ++i) {
    const double sigma = std::sqrt(profile.terms[i].variance_mm2);
    const ImVec2 at(axes.x(sigma), axes.y(per_ln_r(sigma, mean(reflectance(profile, sigma)))));
    const float radius = ImGui::GetFontSize() * 0.4f;
    ImGui::SetCursorScreenPos({at.x - radius, at.y - radius});
    ImGui::PushID(static_cast<int>(i));
    ImGui::InvisibleButton("term", {2 * radius, 2 * radius});
    note_place(fmt::format("term {}", i));
    if (ImGui::IsItemHovered() || ImGui::IsItemActive())
      ImGui::SetTooltip("variance %.4g mm^2, weights %.3f %.3f %.3f", profile.terms[i].variance_mm2,
                        profile.terms[i].weight[0], profile.terms[i].weight[1], profile.terms[i].weight[2]);
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemActive() && (by.x != 0 || by.y != 0)) {
      drag_term(profile, i, axes.r_mm(at.x + by.x), std::exp(static_cast<double>(-4 * by.y / axes.size.y)));
      changed = true;
    }
    list.AddCircleFilled(at, radius, IM_COL32(230, 200, 160, 255), 16);
    list.AddCircle(at, radius, IM_COL32(30, 30, 30, 255), 16);
    ImGui::PopID();
    if (changed) break;
  }
  return changed;
}

}  // namespace

bool skin_plot(const SkinCurves& curves, ScatterProfile* terms) {
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFontSize() * 11;
  const float marks = ImGui::GetTextLineHeightWithSpacing();  // below the axis
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const Axes axes{low, {width, height - marks}, curves.r_mm.front(), curves.r_mm.back(), most_of(curves)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushClipRect(low, {low.x + width, low.y + height}, true);
  draw_grid(axes, list);
  for (std::size_t c = 0; c < 3; ++c) draw_channel(axes, list, curves, c);
  const bool changed = terms && handles(axes, list, *terms);
  ImGui::PopClipRect();
  ImGui::SetCursorScreenPos(low);
  ImGui::Dummy({width, height + 4});
  return changed;
}

}  // namespace dermis::viewer
