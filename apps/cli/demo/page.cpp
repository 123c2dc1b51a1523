// SPDX-License-Identifier: MIT
#include "cli/demo/page.h"

#include <fmt/format.h>

#include "tools/report/escape.h"
#include "tools/report/html.h"

namespace dermis::cli::demo {
namespace {

std::string code(const std::string& command) { return "<code>" + report::escape(command) + "</code>"; }

std::string side_by_side(const Pair& pair, std::size_t number) {
  return "<div class=\"figures\">\n" +
         report::figure(
             "Light that enters the skin spreads and leaves it beside where it entered.<br>" +
                 code(pair.scattered.command),
             report::picture(fmt::format("scattered-{}", number), pair.scattered.pixels, "texture-space")) +
         report::figure("The same without scattering.<br>" + code(pair.lambert.command),
                        report::picture(fmt::format("lambert-{}", number), pair.lambert.pixels, "lambert")) +
         "</div>\n";
}

std::string heading(const std::string& title) { return "<h2>" + report::escape(title) + "</h2>\n"; }

/// The first view: a slider, whose pixels are those of the pictures below it.
std::string first_view(const Page& page) {
  std::string text = heading(page.pairs.front().title) +
                     report::slider("scattered-0", "lambert-0", "scattering", "none") + "\n";
  if (!page.credit.empty()) text += "<p>" + report::escape(page.credit) + "</p>\n";
  return text;
}

std::string skins(const std::vector<Shown>& all) {
  if (all.empty()) return {};
  std::string text = "<h2>Three skins of the built-in head</h2>\n<div class=\"figures\">\n";
  for (std::size_t i = 0; i < all.size(); ++i)
    text += report::figure(code(all[i].command),
                           report::picture(fmt::format("skin-{}", i), all[i].pixels, "a head"));
  return text + "</div>\n";
}

std::string cost(const Page& page) {
  const Statistics& with = page.pairs.front().scattered.cost;
  return fmt::format("<p>{}</p>\n",
                     report::escape(fmt::format(
                         "These pictures took {:.0f} seconds on {}, loading and preparing included. A "
                         "frame of the first, {} x {} pixels, took {:.0f} ms with scattering and {:.0f} ms "
                         "without.",
                         page.seconds, with.device, with.width, with.height, with.frame_ms_median,
                         page.pairs.front().lambert.cost.frame_ms_median)));
}

std::string next(const std::vector<Next>& all) {
  std::string text = "<h2>Next</h2>\n";
  for (const Next& one : all)
    text += "<p>" + report::escape(one.why) + "</p>\n<pre class=\"next\">" + report::escape(one.command) +
            "</pre>\n";
  return text;
}

}  // namespace

std::string html(const Page& page) {
  std::string body = first_view(page);
  for (std::size_t i = 1; i < page.pairs.size(); ++i)
    body += heading(page.pairs[i].title) + side_by_side(page.pairs[i], i);
  body += skins(page.skins) + cost(page) + next(page.next) + heading("The first view again, side by side") +
          side_by_side(page.pairs.front(), 0);
  return report::page("dermis: skin in real time", body);
}

}  // namespace dermis::cli::demo
