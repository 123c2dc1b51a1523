// SPDX-License-Identifier: MIT
#include "gaussians/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace dermis::gaussians {
namespace {

using std::numbers::pi;
constexpr double width = 900, left = 80, right = 20;
constexpr const char* colour[] = {
    "#c0392b", "#1e8449",
    // legible on white, and apart for the colour-blind by their order in the legend
    "#2455a4"};
constexpr const char* channel_name[] = {"red", "green", "blue"};

/// Bytes of the UTF-8 character at `at`, 0 if there is none (RFC 3629: no overlong forms, no surrogates,
/// nothing past U+10FFFF).
std::size_t utf8_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0u;
  };
  const unsigned first = byte(at), second = byte(at + 1);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F)) return 0;
  // U+FFFE and U+FFFF, which XML refuses
  if (first == 0xEF && second == 0xBF && byte(at + 2) > 0xBD) return 0;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  return length;
}

/// As XML takes it: names of files may hold any bytes, an SVG only UTF-8.
std::string escaped(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const char c = text[i];

    if (length == 0)
      out += "\xEF\xBF\xBD";  // U+FFFD
    else if (length > 1)
      out.append(text, i, length);
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (static_cast<unsigned char>(c) >= ' ')
      out += c;

    i += std::max<std::size_t>(length, 1);
  }

  return out;
}

std::string text_at(double x, double y, const std::string& text, const char* anchor = "start",
                    const char* fill = "#333") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n", x, y,
                     anchor, fill, escaped(text));
}

/// A panel with a logarithmic radius axis.
struct Panel {
  double top, height, r_low, r_high, y_low, y_high;

  double x(double r) const {
    return left + (width - left - right) * std::log(r / r_low) / std::log(r_high / r_low);
  }
  double y(double value) const {
    return top + height * (1 - (std::clamp(value, y_low, y_high) - y_low) / (y_high - y_low));
  }

  std::string frame(const std::string& label, bool radii) const {
    std::string svg = fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
        "stroke=\"#999\"/>\n",
        left, top, width - left - right, height);
    for (int decade = -6; decade <= 4; ++decade) {
      const double r = std::pow(10.0, decade);
      if (r < r_low || r > r_high) continue;
      svg +=
          fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n",
                      x(r), top, top + height);
      if (radii) svg += text_at(x(r), top + height + 16, fmt::format("{:g} mm", r), "middle");
    }
    for (const double value : {y_low, (y_low + y_high) / 2, y_high})
      svg += text_at(left - 6, y(value) + 4, fmt::format("{:.2g}", value), "end");
    return svg + text_at((left + width - right) / 2, top + 18, label, "middle");
  }

  std::string curve(const std::function<double(double)>& f, const char* stroke, const char* dash,
                    double thickness) const {
    std::string points;
    constexpr int samples = 240;
    for (int i = 0; i <= samples; ++i) {
      const double r = r_low * std::pow(r_high / r_low, static_cast<double>(i) / samples);
      points += fmt::format("{:.1f},{:.1f} ", x(r), y(f(r)));
    }
    return fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\"/>\n",
        points, stroke, thickness, dash);
  }
};

double scaled(const profile::RadialProfile& profile, double r) { return r * profile.at(r) / profile.total(); }
double scaled(const std::vector<Term>& terms, double r) { return r * evaluate(terms, r); }

std::string display(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double shown = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;  // IEC 61966-2-1
  return fmt::format("{}", static_cast<int>(std::lround(255 * shown)));
}

/// One strip of the colours across the edge.
std::string strip(const PlottedSum& sum, double top, double reach_mm) {
  std::string svg;
  constexpr int steps = 160;
  const double step = (width - left - right) / steps;
  for (int i = 0; i < steps; ++i) {
    const double x_mm = -reach_mm / 4 + (i + 0.5) / steps * reach_mm * 1.25;
    svg += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"34\" fill=\"rgb({},{},{})\"/>\n",
        left + i * step, top, step + 0.5, display(edge_response(sum.channels[0], x_mm)),
        display(edge_response(sum.channels[1], x_mm)), display(edge_response(sum.channels[2], x_mm)));
  }
  return svg + text_at(left + (width - left - right) - 8, top + 22, sum.label, "end", "#fff");
}

struct Scale {
  double r_low = 1e300, r_high = 0, peak = 0, residual = 0;
};

Scale scale_of(const Plot& plot) {
  Scale scale;
  for (int c = 0; c < 3; ++c) {
    const profile::RadialProfile& profile = *plot.profiles[c];
    scale.r_low = std::min(scale.r_low, profile.has_pole() ? std::sqrt(core_variance_mm2(profile)) / 2
                                                           : std::max(profile.quantile(0.003), 1e-6));
    scale.r_high = std::max(scale.r_high, std::min(profile.quantile(0.998), 1e5));
  }
  if (!(scale.r_high > 2 * scale.r_low)) scale.r_high = 2 * scale.r_low;

  // Finds the highest curve and the largest residual, at 241 radii.
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i <= 240; ++i) {
      const double r = scale.r_low * std::pow(scale.r_high / scale.r_low, i / 240.0);
      const double exact = scaled(*plot.profiles[c], r), fitted = scaled(plot.fit.channels[c], r);
      scale.peak = std::max({scale.peak, exact, fitted});
      for (const PlottedSum& other : plot.others)
        scale.peak = std::max(scale.peak, scaled(other.channels[c], r));
      scale.residual = std::max(scale.residual, std::abs(exact - fitted));
    }

  return scale;
}

constexpr const char* dashed = "7 4";
constexpr const char* dots[] = {"2 3", "1 5", "6 3 1 3"};

/// Which line is which, beneath the names of the channels: at the right every curve has come down.
std::string legend(const Plot& plot, const Panel& panel) {
  constexpr double line_right = width - right - 10, line_left = line_right - 40;
  std::string svg;
  double y = panel.top + 76;
  const auto entry = [&](const std::string& label, const char* dash, double thickness) {
    svg += text_at(line_left - 8, y, label, "end");
    svg += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#333\" stroke-width=\"{}\" "
        "stroke-dasharray=\"{}\"/>\n",
        line_left, y - 4, line_right, y - 4, thickness, dash);
    y += 17;
  };
  entry("profile", "none", 1.6);
  entry(plot.fit.label, dashed, 2.4);
  for (std::size_t i = 0; i < plot.others.size() && i < std::size(dots); ++i)
    entry(plot.others[i].label, dots[i], 1.4);
  return svg;
}

double wide_reach_mm(const PlottedSum& sum) {
  double variance = 0;
  for (const auto& terms : sum.channels)
    for (const Term& term : terms)
      if (term.weight > 0.02) variance = std::max(variance, term.variance_mm2);
  return 2.5 * std::sqrt(variance);
}

}  // namespace

double edge_response(const std::vector<Term>& terms, double x_mm) {
  double sum = 0;
  for (const Term& term : terms) sum += term.weight * std::erfc(x_mm / std::sqrt(2 * term.variance_mm2)) / 2;
  return sum;
}

double difference_percent(const std::vector<Term>& sum, const std::vector<Term>& other) {
  const auto product = [](const std::vector<Term>& a, const std::vector<Term>& b) {
    double value = 0;
    for (const Term& s : a)
      for (const Term& t : b)
        value += s.weight * t.weight / (4 * pi * pi * (s.variance_mm2 + t.variance_mm2));
    return value;
  };
  const double own = product(sum, sum);
  return 100 * std::sqrt(std::max(0.0, own - 2 * product(sum, other) + product(other, other)) / own);
}

std::string svg_plot(const Plot& plot) {
  const Scale scale = scale_of(plot);
  const Panel main{50, 300, scale.r_low, scale.r_high, 0, 1.05 * scale.peak};
  const double limit = std::max(scale.residual, 1e-12) * 1.05;
  const Panel below{400, 120, scale.r_low, scale.r_high, -limit, limit};
  const double strips_top = 580, height = strips_top + 44 * static_cast<double>(1 + plot.others.size()) + 40;

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" "
      "font-size=\"13\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      width, height);
  svg += text_at(left, 30, plot.title);
  svg += main.frame("r R(r) / total   [1/mm]", false) + below.frame("residual of the fit   [1/mm]", true);

  for (int c = 0; c < 3; ++c) {
    const auto exact = [&](double r) { return scaled(*plot.profiles[c], r); };
    const auto fitted = [&](double r) { return scaled(plot.fit.channels[c], r); };
    svg += main.curve(exact, colour[c], "none", 1.6) + main.curve(fitted, colour[c], dashed, 2.4);
    for (std::size_t i = 0; i < plot.others.size() && i < std::size(dots); ++i)
      svg += main.curve([&](double r) { return scaled(plot.others[i].channels[c], r); }, colour[c], dots[i],
                        1.4);
    svg += below.curve([&](double r) { return exact(r) - fitted(r); }, colour[c], "none", 1.4);
    svg += text_at(width - right - 10, main.top + 18 + 17 * c, channel_name[c], "end", colour[c]);
  }
  svg += legend(plot, main);

  double reach_mm = wide_reach_mm(plot.fit);
  for (const PlottedSum& other : plot.others) reach_mm = std::max(reach_mm, wide_reach_mm(other));
  svg += text_at(
      left, strips_top - 10,
      fmt::format("light that bleeds from a white edge into the dark, {:.3g} mm wide, edge at a fifth",
                  1.25 * reach_mm));
  svg += strip(plot.fit, strips_top, reach_mm);
  for (std::size_t i = 0; i < plot.others.size(); ++i)
    svg += strip(plot.others[i], strips_top + 44 * static_cast<double>(i + 1), reach_mm);

  return svg + "</svg>\n";
}

}  // namespace dermis::gaussians
