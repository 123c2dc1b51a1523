// SPDX-License-Identifier: MIT
#include "tools/report/html.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>

#include "image/codec.h"
#include "image/compare_map.h"
#include "tools/report/escape.h"
#include "tools/report/svg.h"

namespace dermis::report {
namespace {

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    for (std::size_t k = 0; k < 3; ++k)
      triple = triple << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[triple >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string png_uri(const image::Image8& picture) {
  return "data:image/png;base64," + base64(image::encode_png(picture));
}

std::string picture(std::string_view id, const image::Image8& pixels, std::string_view alt) {
  return fmt::format("<img id=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\">", escape(id),
                     pixels.width, pixels.height, escape(alt), png_uri(pixels));
}

std::string figure(std::string_view caption, std::string_view inner) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", inner, caption);
}

std::string slider(std::string_view left_id, std::string_view right_id, std::string_view left_label,
                   std::string_view right_label) {
  return fmt::format(
      "<div class=\"slider\"><img data-from=\"{}\" alt=\"\"><img class=\"over\" data-from=\"{}\" "
      "alt=\"\"><span class=\"line\"></span>"
      "<span class=\"label\" style=\"left:.4rem\">{}</span><span class=\"label\" "
      "style=\"right:.4rem\">{}</span>"
      "<input type=\"range\" min=\"0\" max=\"100\" step=\"0.1\" value=\"50\" aria-label=\"border between the "
      "two pictures\"></div>\n",
      escape(left_id), escape(right_id), escape(left_label), escape(right_label));
}

std::string magma_scale(double full_scale) {
  std::string stops, ticks;
  for (int i = 0; i <= 15; ++i) {
    const auto c = image::magma(static_cast<float>(i) / 15);
    stops += fmt::format(",#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
  }
  for (int i = 0; i <= 4; ++i) ticks += "<span>" + number(full_scale * i / 4) + "</span>";
  return fmt::format(
      "<div class=\"scale\" style=\"background:linear-gradient(to right{})\"></div><div "
      "class=\"ticks\">{}</div>",
      stops, ticks);
}

std::string table(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string text = "<table>\n";
  for (const auto& [name, value] : rows)
    text += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escape(name), escape(value));
  return text + "</table>\n";
}

std::string grid(const std::vector<std::string>& headings,
                 const std::vector<std::vector<std::string>>& rows) {
  const auto row = [](const std::vector<std::string>& cells, const char* kind) {
    std::string text = "<tr>";
    for (const std::string& cell : cells) text += fmt::format("<{}>{}</{}>", kind, escape(cell), kind);
    return text + "</tr>\n";
  };
  std::string text = "<div class=\"wide\"><table class=\"grid\">\n" + row(headings, "th");
  for (const std::vector<std::string>& cells : rows) text += row(cells, "td");
  return text + "</table></div>\n";
}

}  // namespace dermis::report
