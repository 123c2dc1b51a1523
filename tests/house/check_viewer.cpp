// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <regex>

#include "house/check.h"

namespace house {
namespace {

constexpr std::string_view viewer = "apps/viewer/", window = "apps/viewer/window/";

/// What a line of the viewer may not hold, and where it may.
struct Rule {
  std::regex pattern;
  std::string_view allowed;  ///< files that begin so
  std::string_view says;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{
      {std::regex(R"(\b(vk|Vk)[A-Z]|\bVK_)"), window, "Vulkan, outside of what shows ImGui's lists"},
      {std::regex(R"(\bvkCmd(Dispatch|Trace)|\bvkCreateComputePipelines)"), "-", "a step of rendering"},
      {std::regex(R"(\bvkCmdDraw)"), "apps/viewer/window/ui_renderer.cpp", "a draw of its own"},
      {std::regex(R"(\bvkCreateGraphicsPipelines)"), "apps/viewer/window/ui_pipeline.cpp",
       "a pipeline of its own"},
      // Live shaders are compiled for passes, and read how.
      {std::regex(R"(#include "(passes|techniques|frame|gpu)/)"), "apps/viewer/model/live_shaders",
       "an include of what renders"},
      {std::regex(R"(\.(least|most|unit) = |\.help = ")"), "-", "a range, unit or help text of a setting"}};
  return all;
}

/// Texts of the settings' rows that are long enough that nothing else says just that.
std::vector<std::string> texts_of_rows(const std::vector<SourceFile>& tree) {
  static const std::regex text(R"re("([^"\\]{32,})")re");
  std::vector<std::string> texts;
  for (const SourceFile& file : tree) {
    if (!file.path.starts_with("src/base/settings/") || !file.path.ends_with("fields.h")) continue;
    for (const std::string& line : file.lines)
      for (std::sregex_iterator at(line.begin(), line.end(), text), end; at != end; ++at)
        texts.push_back((*at)[1]);
  }
  return texts;
}

}  // namespace

Violations check_viewer(const std::vector<SourceFile>& tree) {
  const std::vector<std::string> texts = texts_of_rows(tree);
  Violations violations;

  for (const SourceFile& file : tree) {
    if (!file.path.starts_with(viewer)) continue;
    if (is_shader(file.path) && !file.path.starts_with("apps/viewer/window/ui."))
      violations.push_back(fmt::format("{}: a shader of the viewer's own", file.path));
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::string& line = file.lines[i];
      const auto found = [&](std::string_view what) {
        violations.push_back(fmt::format("{}:{}: {}", file.path, i + 1, what));
      };
      for (const Rule& rule : rules())
        if (!file.path.starts_with(rule.allowed) && std::regex_search(line, rule.pattern)) found(rule.says);
      for (const std::string& text : texts)
        if (line.find(text) != std::string::npos) found("a text of the settings, typed again");
    }
  }
  return violations;
}

}  // namespace house
