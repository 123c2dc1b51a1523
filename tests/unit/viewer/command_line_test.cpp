// SPDX-License-Identifier: MIT
// A command line gives back the settings that it was made of: for every row there is, and whatever is added.
#include "viewer/model/command_line.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "base/settings/fields.h"
#include "base/settings/names.h"
#include "cli/command.h"
#include "cli/command_line.h"

namespace dermis::viewer {
namespace {

// Another value than the default one, within the range, with many digits.
struct Other {
  const About& about;

  void operator()(double& value) const {
    const double least = std::max(about.least, -1e3), most = std::min(about.most, 1e3);
    const double before = value;
    value = least + (most - least) * 0.41421356237309503;
    if (value == before) value = least + (most - least) / 7;
  }
  void operator()(int& value) const {
    value = static_cast<int>(about.least) + (value == about.least + 1 ? 0 : 1);
  }
  void operator()(std::uint64_t& value) const { value += 3; }
  void operator()(bool& value) const { value = !value; }
  void operator()(std::string& value) const { value = "it's a name; $HOME"; }
  void operator()(std::vector<std::string>& values) const { values = {"it's a name; $HOME", "*[a-z]"}; }
  template <std::size_t Count>
  void operator()(std::array<double, Count>& values) const {
    for (double& value : values) value = -1.0 / 3 + 0.1 * static_cast<double>(&value - values.data());
  }
  void operator()(std::vector<PlacedLight>& lights) const {
    lights = {{-60.5, 1.0 / 3, 0.7}, {10, -20, 1e-3}};
  }
  template <class Value>
  void operator()(std::optional<Value>& value) const {
    if (value) {
      value.reset();
      return;
    }
    (*this)(value.emplace());
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(Enum& value) const { value = static_cast<Enum>(names_of<Enum>.size() - 1); }
};

cli::SceneArguments parsed(const std::vector<std::string>& words) {
  CLI::App app;
  CLI::App* command = app.add_subcommand("render");
  cli::SceneArguments arguments;
  cli::add_scene_arguments(*command, arguments, cli::SceneUse::render);
  std::vector<std::string> all{"dermis", "render"};
  all.insert(all.end(), words.begin(), words.end());
  const std::vector<std::string> joined = cli::join_lists(all);
  std::vector<const char*> pointers;
  for (const std::string& word : joined) pointers.push_back(word.c_str());
  app.parse(static_cast<int>(pointers.size()), pointers.data());
  return arguments;
}

std::string text(const RenderSettings& settings) {
  return to_json({.render = settings, .scene = {}, .reference = {}});
}
std::string text(const SceneOptions& options) {
  return to_json({.render = {}, .scene = options, .reference = {}});
}

TEST(CommandLine, DefaultsNeedNoWords) {
  EXPECT_TRUE(option_words(RenderSettings{}).empty());
  EXPECT_TRUE(option_words(SceneOptions{}).empty());
  EXPECT_EQ(render_command({}, {}, "best", "out.png"), "dermis render -o out.png");
}

TEST(CommandLine, EachSettingByItselfComesBack) {
  int rows = 0;
  RenderSettings names;
  for_each_setting(names, [&](const std::string& wanted, const About& about, auto&, std::string_view) {
    if (about.option == "frames") return;
    ++rows;
    RenderSettings settings;
    for_each_setting(settings, [&](const std::string& path, const About& of, auto& value, std::string_view) {
      if (path == wanted) Other{of}(value);
    });
    ASSERT_NE(text(settings), text(RenderSettings{})) << wanted;
    EXPECT_EQ(text(parsed(option_words(settings)).settings), text(settings)) << wanted;
  });
  EXPECT_GT(rows, 40);
}

TEST(CommandLine, AllSettingsTogetherComeBack) {
  RenderSettings settings;
  for_each_setting(settings, [&](const std::string&, const About& about, auto& value, std::string_view) {
    if (about.option != "frames") Other{about}(value);
  });
  settings.lighting.rig_lights.reset();  // in the place of placed_lights
  EXPECT_EQ(text(parsed(option_words(settings)).settings), text(settings));
}

TEST(CommandLine, HowFilesAreReadComesBack) {
  SceneOptions options;
  for_each_setting(options, [&](const std::string&, const About& about, auto& value, std::string_view) {
    Other{about}(value);
  });
  EXPECT_EQ(text(parsed(option_words(options)).options), text(options));
}

TEST(CommandLine, WordsAreQuotedForAShell) {
  EXPECT_EQ(render_command({"my head.glb"}, {}, "llvmpipe", "a b.png"),
            "dermis render 'my head.glb' --device llvmpipe -o 'a b.png'");
  // A file whose name begins like an option.
  EXPECT_EQ(render_command({"-o.glb"}, {}, "best", "x.png"), "dermis render ./-o.glb -o x.png");
}

}  // namespace
}  // namespace dermis::viewer
