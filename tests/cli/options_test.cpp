// SPDX-License-Identifier: MIT
// Options: 2 for a command line that cannot be parsed, 1 with the range or the known names for a value that
// makes no sense.
#include "base/settings/fields.h"
#include "cli/program.h"
#include "cli/tiny_gltf.h"

namespace dermis::tests {
namespace {

class Options : public Program {
 protected:
  std::string head() const { return file("head.gltf", tiny_gltf()); }
  void refuse(const Arguments& options, const std::string& says) const {
    SCOPED_TRACE(options.front() + " " + options.back());
    Arguments arguments{head()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_refused(render(arguments), says);
  }
};

TEST_F(Options, WhatCannotBeParsedEndsWithTwo) {
  const std::string out = picture().string(), scene = head();
  expect_not_understood(run({}), "subcommand");
  expect_not_understood(run({"paint"}), "there is no command 'paint'; there are: render, sequence");
  expect_not_understood(run({"render"}), "--output");

  expect_not_understood(run({"render", scene, "-o"}), "-o");
  expect_not_understood(run({"render", scene, "-o", out, "--brush"}), "--brush");
  expect_not_understood(run({"render", scene, "-o", out, "--map-size", "big"}), "--map-size");
  expect_not_understood(run({"render", scene, "-o", out, "--map-size"}), "--map-size");
  expect_not_understood(run({"render", scene, "-o", out, "--map-size", "64.5"}), "--map-size");
  expect_not_understood(run({"render", scene, "-o", out, "--frames", "99999999999"}), "--frames");
  expect_not_understood(run({"render", scene, "-o", out, "--fov", "wide"}), "--fov");
  expect_not_understood(run({"render", scene, "-o", out, "--translucency", "maybe"}), "--translucency");

  for (const char* size :
       {"12", "12x", "x12", "12x12x12", "12 x 12", "12x12 ", "axb", "99999999999x10", "1.5x2", "0x10x10"})
    expect_not_understood(run({"render", scene, "-o", out, "--size", size}), "--size");
  for (const char* names : {"everything", "cull,none", "cull;depth", ""})
    expect_not_understood(run({"render", scene, "-o", out, "--optimise", names}), "--optimise");
  expect_not_understood(run({"render", scene, "-o", out, "--orbit", "1"}), "--orbit");
  expect_not_understood(run({"render", scene, "-o", out, "--orbit", "1,2,3"}), "--orbit");
  expect_not_understood(run({"render", scene, "-o", out, "--orbit", "left,up"}), "--orbit");
  expect_not_understood(run({"render", scene, "-o", out, "--eye", "0,1", "--target", "0,0,0"}), "--eye");
  expect_not_understood(run({"render", scene, "-o", out, "--eye", "0,0,1", "--target", "nose"}), "--target");
  for (const char* light :
       {"90", "90,", ",10", "90,10,", "90,10,3,4", "90;10", "left,up", " 90,10", "90,10x", ""})
    expect_not_understood(run({"render", scene, "-o", out, "--light", light}), "--light");

  expect_not_understood(run({"bench", scene, "another.glb"}), "another.glb");
  expect_not_understood(run({"info", "--brush"}), "--brush");
  for (const char* exposure : {"bright", "1,5", "", "auto1"})
    expect_not_understood(run({"render", scene, "-o", out, "--exposure", exposure}),
                          "--exposure: expected EV or auto");

  expect_not_understood(run({"render", scene, "-o", out, "--view", "filmic"}), "--view: is now --tone-map");
  expect_not_understood(run({"bench", "--view", "filmic"}), "--view: is now --tone-map");
  expect_not_understood(run({"compare", scene, scene, "--view", "filmic"}), "--view: is now --tone-map");
  expect_not_understood(run({"render", scene, "-o", out, "--maps", "full"}),
                        "--maps: is gone: texture-space blurs");
  expect_not_understood(run({"render", scene, "-o", out, "--blur", "chain"}),
                        "--blur: is gone: texture-space blurs");
  expect_not_understood(run({"render", scene, "-o", out, "--shading", "raster"}),
                        "--shading: is gone: skin is always shaded in compute");
  expect_not_understood(run({"plan", "--brush"}), "--brush");
}

// What few people set has no option of its own, and an option of before says so.
TEST_F(Options, AnySettingCanBeSet) {
  for (const auto& [set, says] : std::initializer_list<std::pair<std::string, const char*>>{
           {"quality.mask", "expected NAME=VALUE, got 'quality.mask'"},
           {"quality.brush=1", "quality: unknown key 'brush'"},
           {"=1", "unknown key ''"},
           {"camera.=1", "camera: unknown key ''"},
           {"quality.taps=", "quality.taps: must be an integer"},
           {"camera.fov_deg.x=1", "camera.fov_deg: "},
           {"camera.eye_m=" + std::string(50'000, '[') + std::string(50'000, ']'), ""},
           {"quality.d_ref=nan", "quality.d_ref: must be a number"},
           {"scene.texture_budget_mb=0", "scene.texture_budget_mb: "}})
    refuse({"--set", set}, std::string("--set: ") + says);
  const std::string out = picture().string(), scene = head();
  for (const auto& [option, says] : {std::pair("--mask", "is now --set quality.mask=VALUE"),
                                     {"--clip-margin", "is now --set quality.clip_margin_mm=VALUE"},
                                     {"--normalise", "is gone: the weights of a profile must sum to 1"}})
    expect_not_understood(run({"render", scene, "-o", out, option}), std::string(option) + ": " + says);
}

TEST_F(Options, UnknownNamesListTheKnownOnes) {
  refuse({"--technique", "oil"}, "texture-space, lambert");
  refuse({"--tone-map", "sepia"}, "natural, neutral, agx, filmic, srgb, linear");
  refuse({"--set", "quality.mask=tape"}, "alpha, depth");
  refuse({"--camera", "main"}, "it has no cameras");
  refuse({"--show", "nothing"}, "picture, blur:");
  refuse({"--show", "shadow:-1"}, "shadow:0");
  refuse({"--show", "shadow:99999999999999999999"}, "shadow:0");
  refuse({"--device", "abacus"}, "there are: 0: ");
  refuse({"--device", "99"}, "there are: 0: ");
  refuse({"--device", "-1"}, "there are: 0: ");
  refuse({"--skin", "leather"}, "there are: skin");
  refuse({"--profile", "leather"}, "there are: skin");
}

TEST_F(Options, NamesNearAKnownOneAreAskedFor) {
  refuse({"--technique", "lamber"}, "did you mean 'lambert'?");
  refuse({"--tone-map", "Filmic"}, "did you mean 'filmic'?");
  refuse({"--set", "quality.mask=dpeth"}, "did you mean 'depth'?");
  refuse({"--show", "irradience"}, "did you mean 'irradiance'?");
  refuse({"--device", "bset"}, "did you mean 'best'?");
  refuse({"--skin", "skni"}, "did you mean 'skin'?");
  refuse({"--profile", "skinn"}, "did you mean 'skin'?");
  refuse({"--environment", "stduio"}, "did you mean 'studio'?");
  refuse({"--background", "blakc"}, "did you mean 'black'?");
  expect_refused(
      run({"render", "built-in:lihgt", "-o", picture().string()}),
      "no skin 'lihgt'; there are: light, medium, dark, ita-very-light, ita-light, ita-intermediate, "
      "ita-tan, ita-brown, ita-dark; did you mean 'light'?");
  expect_refused(run({"render", "bulit-in", "-o", picture().string()}), "did you mean 'built-in'?");
  expect_refused(run({"render", "test:nsoe", "-o", picture().string()}), "did you mean 'nose'?");
  expect_refused(run({"profile", "--preset", "skin3"}), "did you mean 'skin1'?");
  expect_refused(run({"profile", "--preset", "skin1", "--export", "unty"}), "did you mean 'unity'?");
  expect_refused(run({"render", head(), "built-in", "--layout", "gird", "-o", picture().string()}),
                 "did you mean 'grid'?");
}

TEST_F(Options, SlipsOfTheCommandLineAreAskedFor) {
  const std::string out = picture().string(), scene = head();
  for (const auto& [words, says] : std::initializer_list<std::pair<Arguments, const char*>>{
           {{"rendr", scene, "-o", out}, "there is no command 'rendr'"},
           {{"rendr", scene, "-o", out}, "; did you mean 'render'?"},
           {{"help"}, "; did you mean '--help'?"},
           {{"--versoin"}, "there is no option '--versoin'; did you mean '--version'?"},
           {{"render", scene, "--environmnt", "studio"},
            "render: there is no option '--environmnt'; did you"},
           {{"render", scene, "-o", out, "--tonemap=agx"}, "option '--tonemap'; did you mean '--tone-map'?"},
           {{"render", scene, "-o", out, "--Map_Size", "64"}, "did you mean '--map-size'?"},
           {{"render", scene, "-o", out, "--expo", "1"}, "did you mean '--exposure'?"},
           {{"render", scene, "-o", out, "--translucency", "of"},
            "--translucency: 'of' is not known; there are: on, "},
           {{"render", scene, "-o", out, "--optimise", "cul"}, "did you mean 'cull'?"},
           {{"bench", scene, "quick"}, "bench: nothing takes the word 'quick'; did you mean '--quick'?"},
           {{"view", "--orbti", "1,2"}, "view: there is no option '--orbti'; did you mean '--orbit'?"}}) {
    const Result result = run(words);
    expect_not_understood(result, says);
    EXPECT_TRUE(result.err.starts_with("dermis: ") || result.err.starts_with("--")) << result.err;
  }

  const Result nonsense = run({"render", scene, "-o", out, "--xyzzy"});
  expect_not_understood(nonsense, "render: there is no option '--xyzzy'; --help-all shows all\n");
}

TEST_F(Options, SurroundingsThatAreNone) {
  refuse({"--environment", "moon"}, "studio");
  refuse({"--environment", "no/such/file.hdr"}, "no/such/file.hdr");
  refuse({"--environment", folder().string()}, "");
  refuse({"--environment", file("empty.hdr", "")}, "empty.hdr");
  refuse({"--environment", file("words.exr", "these are words")}, "words.exr");
  refuse({"--environment", file("wide.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 15000 +X 30000\n")},
         "wide.hdr");
  refuse({"--environment", file("cut.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 512 +X 1024\n\2\2")},
         "cut.hdr");
  refuse({"--environment", head()}, "head.gltf");
}

TEST_F(Options, ValuesOutOfRange) {
  refuse({"--size", "0x0"}, "--size");
  refuse({"--size", "100000x100000"}, "--size");
  refuse({"--size", "-5x10"}, "--size");
  refuse({"--size", "65536x1"}, "--size");
  refuse({"--map-size", "0"}, "--map-size");
  refuse({"--map-size", "-64"}, "--map-size");
  refuse({"--map-size", "65536"}, "--map-size");
  refuse({"--shadow-size", "65536"}, "--shadow-size");
  refuse({"--samples", "3"}, "1 or 4");
  refuse({"--frames", "0"}, "--frames");
  refuse({"--heads", "0"}, "--heads");
  refuse({"--heads", "2000000000"}, "--heads");
  refuse({"--lights", "-1"}, "--lights");
  refuse({"--lights", "2000000000"}, "--lights");
  refuse({"--map-budget", "0.001"}, "--map-budget");

  for (const char* light : {"nan,0", "4000,0", "0,91", "0,inf", "0,0,-1", "0,0,nan", "0,0,1e30"})
    refuse({"--light", light}, "--light");
  refuse({"--lights", "2", "--light", "90,10"},
         "lighting.rig_lights (--lights) and lighting.placed_lights (--light) both");
  for (const char* radius : {"-0.1", "nan", "inf", "1e9"})
    refuse({"--light-radius", radius}, "--light-radius");
  for (const char* value : {"nan", "inf", "-inf", "-1e300"})
    for (const char* option : {"--map-budget", "--environment-rotation", "--fov", "--distance", "--ambient",
                               "--bloom", "--exposure", "--unit-scale"})
      refuse({option, value}, option);

  refuse({"--orbit", "nan,0"}, "--orbit");
  refuse({"--eye", "0,0,1"}, "camera.target_m (--target) is missing");
  refuse({"--eye", "0,0,nan", "--target", "0,0,0"}, "camera.eye_m (--eye) must be");
  refuse({"--eye", "0,0,1", "--target", "0,0,1"}, "nowhere to look");
  refuse({"--eye", "0,0,1", "--target", "0,0,0", "--orbit", "30,0"}, "give one of these");
  refuse({"--fov", "180"}, "--fov");
  refuse({"--unit-scale", "0"}, "--unit-scale");
  refuse({"--unit-scale", "1e30"}, "--unit-scale");
}

TEST_F(Options, ExtremesThatAreAllowedGiveAPicture) {
  for (const Arguments& options : std::vector<Arguments>{
           {"--size", "1x1"},
           {"--size", "1x300"},
           {"--map-size", "32", "--shadow-size", "32"},
           {"--exposure", "64", "--ambient", "1000000"},
           {"--exposure", "-64"},
           {"--distance", "0.001"},
           {"--distance", "1000000"},
           {"--fov", "170"},
           {"--fov", "0.1"},
           {"--orbit", "-90,90"},
           {"--eye", "0,3,0", "--target", "0,0,0"},
           {"--samples", "1", "--bloom", "1"},
           {"--unit-scale", "1e-6"},
           {"--heads", "2", "--lights", "0"},
           {"--environment", "studio", "--environment-rotation", "-77.5"},
           {"--optimise", "none", "--set", "quality.light_samples=1"},
           {"--optimise", "cull", "--set", "quality.mask=alpha", "--set", "quality.clip_margin_mm=0"},
           {"--optimise", "clip", "--set", "quality.mask=depth", "--distance", "0.5"},
           {"--set", "quality.d_ref=0.000001", "--heads", "3", "--map-budget", "1"}}) {
    SCOPED_TRACE(options[0] + " " + options[1]);

    Arguments arguments{head()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expect_rendered(render(arguments));
  }
}

TEST_F(Options, LightsThatArePlacedReplaceThoseOfTheScene) {
  const auto rendered = [&](const Arguments& options) {
    Arguments arguments{head()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_TRUE(expect_rendered(render(arguments)));
    return read_text(picture());
  };
  const std::string side = rendered({"--light", "-30,10"}), bright = rendered({"--light", "-30,10,9.5"});
  EXPECT_NE(side, bright);
  EXPECT_EQ(side, rendered({"--light", "-30,10,3"}));
  EXPECT_EQ(side, rendered({"--light", "-30,10", "--light-radius", "0"}));
  EXPECT_NE(side, rendered({"--light", "-30,10", "--light-radius", "0.2"}));
  EXPECT_EQ(side, rendered({"--light", "330,10", "--light", "0,0,0"}))
      << "a lamp without light changes nothing";
  EXPECT_NE(side, rendered({"--light", "-30,10", "--light", "60,10"}));
  EXPECT_TRUE(expect_rendered(render({"--light", "-30,10", "--optimise", "none", head()})))
      << "the scene may come last";
}

TEST_F(Options, HelpNamesUnitsAndDefaults) {
  for (const char* command : {"render", "reference", "plan", "info"}) {
    const Result help = run({command, "--help"});
    EXPECT_EQ(help.status, 0) << command;
    EXPECT_NE(help.out.find("Usage"), std::string::npos) << command;
    EXPECT_EQ(help.err, "") << command;
  }
  const std::string help = run({"render", "--help-all"}).out;
  for (const char* text : {"pixels", "texels", "degrees", "metres", "radii", "=1280x720", "=2048",
                           "=texture-space", "=natural", "2^EV", "default: "})
    EXPECT_NE(help.find(text), std::string::npos) << text;
  EXPECT_EQ(run({"--help"}).status, 0);
}

// Of the rows: those that are common, and all. The rest of a command's options says so where it is added.
TEST_F(Options, HelpShowsTwentyAndHelpAllTheRest) {
  const Result few = run({"render", "--help"}), all = run({"render", "--help-all"});
  const auto options_in = [](const std::string& help) {
    std::size_t count = 0;
    for (std::size_t at = help.find("\n  -"); at != std::string::npos; at = help.find("\n  -", at + 1))
      ++count;
    return count - 2;  // --help and --help-all
  };
  EXPECT_EQ(options_in(few.out), 20u) << few.out;
  EXPECT_TRUE(few.out.ends_with(" render --help-all shows all " + std::to_string(options_in(all.out) + 2) +
                                " options\n"))
      << few.out;
  EXPECT_LE(options_in(all.out) + 2, 48u) << "a setting that few people set needs none: --set";
  for (const char* title : {"\nScene:\n", "\nCamera:\n", "\nLight:\n", "\nSkin:\n", "\nPicture:\n"})
    EXPECT_NE(few.out.find(title), std::string::npos) << title;

  const auto one = [&](const std::string&, const About& about, const auto&, std::string_view) {
    if (about.option.empty()) return;
    const std::string option = "\n  --" + std::string(about.option) + " ";
    EXPECT_EQ(few.out.find(option) != std::string::npos, about.common) << option;
    EXPECT_NE(all.out.find(option), std::string::npos) << option;
  };
  const RenderSettings render;
  const SceneOptions scene;
  for_each_setting(render, one);
  for_each_setting(scene, one);

  for (const char* command : {"sequence", "view", "plan", "reference", "compare", "bench", "profile"}) {
    const Result help = run({command, "--help"});
    EXPECT_LE(options_in(help.out), 30u) << command;
    EXPECT_NE(help.out.find("--help-all shows all "), std::string::npos) << command;
  }
  EXPECT_NE(run({"--help-all"}).out.find("--noise"), std::string::npos) << "of every command";
}

TEST_F(Options, VersionSaysWhatItWasBuiltWith) {
  const Result version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(version.out.starts_with("dermis " DERMIS_VERSION " (")) << version.out;
  for (const char* text : {"\nbuilt by ", "Vulkan headers 1.", "embree ", "OpenEXR 3."})
    EXPECT_NE(version.out.find(text), std::string::npos) << text << " in " << version.out;
}

const Surroundings no_driver{.variables = {"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"}};

TEST_F(Options, WithoutADriverTheErrorSaysWhatToInstall) {
  expect_refused(render({head()}, no_driver), "mesa-vulkan-drivers");
  const Result info = run({"info"}, no_driver);
  EXPECT_EQ(info.status, 1);
  EXPECT_NE(info.err.find("mesa-vulkan-drivers"), std::string::npos);
}

TEST_F(Options, ThePlanNeedsNoDriver) {
  const Result plan = run({"plan", head()}, no_driver);
  EXPECT_EQ(plan.status, 0) << plan.err;
  EXPECT_NE(plan.out.find("irradiance"), std::string::npos);
  const Result dot = run({"plan", head(), "--dot", "-o", (folder() / "plan.dot").string()}, no_driver);
  EXPECT_EQ(dot.status, 0) << dot.err;
  EXPECT_EQ(dot.out, "");
  EXPECT_NE(read_text(folder() / "plan.dot").find("digraph"), std::string::npos);
}

}  // namespace
}  // namespace dermis::tests
