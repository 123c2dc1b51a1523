// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "tools/report/escape.h"
#include "tools/report/html.h"

namespace dermis::report {
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
figcaption { width: 0; min-width: max(100%, 12rem); }
pre { white-space: pre-wrap; overflow-wrap: anywhere; background: #1c1c1c; padding: .5rem .8rem; }
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
  const follow = (event) => {
    const box = slider.getBoundingClientRect();
    input.value = Math.min(100, Math.max(0, (event.clientX - box.left) / box.width * 100));
    set(input.value);
  };
  slider.addEventListener('pointermove', follow);
  slider.addEventListener('pointerdown', follow);
  // A browser would drag the picture itself, and end the moves.
  slider.addEventListener('dragstart', (event) => event.preventDefault());
}
</script>
)";

}  // namespace

std::string page(std::string_view title, std::string_view body) {
  return fmt::format("{}<title>{}</title>\n{}</head>\n<body>\n<h1>{}</h1>\n{}{}</body>\n</html>\n", head,
                     escape(title), style, escape(title), body, script);
}

}  // namespace dermis::report
