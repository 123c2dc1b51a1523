// SPDX-License-Identifier: MIT
#include "cli/html.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>

#include "image/codec.h"
#include "image/compare_map.h"

namespace dermis::cli::html {
namespace {

// The policy lets the page use what is inside it and nothing else.
constexpr std::string_view head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
)";

constexpr std::string_view style = R"(<style>
body { margin: 2rem; background: #262626; color: #ddd; font: 15px/1.45 system-ui, sans-serif; }
h1 { font-size: 1.25rem; font-weight: 600; overflow-wrap: anywhere; }
h2 { font-size: 1rem; font-weight: 600; margin: 1.6rem 0 .5rem; }
h3 { font-size: .95rem; font-weight: 600; margin: 1.4rem 0 .4rem; color: #bbb; }
p { max-width: 60rem; }
.figures { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; max-width: 100%; }
figcaption { color: #aaa; margin-top: .3rem; overflow-wrap: anywhere; }
img { display: block; max-width: 100%; height: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
td { padding: .15rem 1.2rem .15rem 0; border-bottom: 1px solid #444; overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
td:first-child { white-space: nowrap; vertical-align: top; }
.grid th, .grid td { text-align: right; white-space: nowrap; }
.grid th, .grid td { padding: .2rem .9rem; border-bottom: 1px solid #444; }
.grid th { color: #aaa; font-weight: 500; }
.grid th:first-child, .grid td:first-child { text-align: left; padding-left: 0; }
.chart { max-width: 100%; height: auto; }
.chart text { fill: #bbb; font: 11px system-ui, sans-serif; }
.chart .title { fill: #ddd; font-weight: 600; font-size: 12px; }
.chart .grid { stroke: #484848; stroke-width: 1; }
.legend { display: flex; flex-wrap: wrap; gap: .3rem 1.3rem; margin: .5rem 0; }
.slider { position: relative; display: inline-block; max-width: 100%; overflow: hidden; }
.slider { --at: 50%; cursor: ew-resize; touch-action: pan-y; }
.slider .over { position: absolute; inset: 0; clip-path: inset(0 0 0 var(--at)); }
.slider .line { position: absolute; top: 0; bottom: 0; left: var(--at); width: 2px; margin-left: -1px; }
.slider .line { background: #fff; mix-blend-mode: difference; }
.slider .label { position: absolute; top: .4rem; padding: 0 .45rem; background: #000a; color: #fff; }
.slider input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; }
.slider input { opacity: 0; pointer-events: none; }
.slider:focus-within { outline: 2px solid #8ab4f8; }
.scale { height: .8rem; margin-top: .4rem; min-width: 12rem; }
.ticks { display: flex; justify-content: space-between; color: #aaa; font-size: .8rem; }
</style>
)";

constexpr std::string_view script = R"(<script>
for (const slider of document.querySelectorAll('.slider')) {
  for (const img of slider.querySelectorAll('img')) img.src = document.getElementById(img.dataset.from).src;
  const input = slider.querySelector('input');
  const set = (percent) => slider.style.setProperty('--at', percent + '%');
  input.addEventListener('input', () => set(input.value));
  slider.addEventListener('pointermove', (event) => {
    const box = slider.getBoundingClientRect();
    input.value = Math.min(100, Math.max(0, (event.clientX - box.left) / box.width * 100));
    set(input.value);
  });
}
</script>
)";

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

/// Length of the UTF-8 character that begins at `at`; 0 if none does.
std::size_t character(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0u;
  };
  const unsigned first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  return length;
}

}  // namespace

std::string escape(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character(text, at);
    const char c = text[at];

    if (length == 0) {
      out += "\xef\xbf\xbd";
    } else if (length > 1) {
      out += text.substr(at, length);
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '\'') {
      out += "&#39;";
    } else {
      out += static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
    }

    at += length == 0 ? 1 : length;
  }
  return out;
}

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
  for (int i = 0; i <= 4; ++i) ticks += fmt::format("<span>{:.3g}</span>", full_scale * i / 4);
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

std::string page(std::string_view title, std::string_view body) {
  return fmt::format("{}<title>{}</title>\n{}</head>\n<body>\n<h1>{}</h1>\n{}{}</body>\n</html>\n", head,
                     escape(title), style, escape(title), body, script);
}

}  // namespace dermis::cli::html
