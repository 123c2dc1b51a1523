// SPDX-License-Identifier: MIT
// --settings and --save-settings: what is saved gives the same picture again, what is given by itself wins,
// and a file that is wrong is refused in one line.
#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "cli/program.h"
#include "cli/tiny_gltf.h"

namespace dermis::tests {
namespace {

class SettingsFiles : public Program {
 protected:
  std::string head() const { return file("head.gltf", tiny_gltf()); }
  std::string saved() const { return (folder() / "saved.json").string(); }
  std::string rendered(Arguments arguments) const {
    arguments.insert(arguments.begin(), head());
    EXPECT_TRUE(expect_rendered(render(arguments)));
    return read_text(picture());
  }
  void refuse(const std::string& text, const std::string& says) const {
    SCOPED_TRACE(text);
    expect_refused(render({head(), "--settings", file("wrong.json", text)}), says);
  }
};

TEST_F(SettingsFiles, GiveTheSamePictureAgain) {
  const std::string first =
      rendered({"--orbit", "30,5", "--light", "-30,10,2.5", "--light", "60,0", "--set", "quality.mask=depth",
                "--exposure", "auto", "--tone-map", "agx", "--set", "lighting.specular=false", "--unit-scale",
                "0.3", "--save-settings", saved()});
  const std::string text = read_text(saved());
  EXPECT_EQ(rendered({"--settings", saved()}), first);

  rendered({"--settings", saved(), "--save-settings", saved()});
  EXPECT_EQ(read_text(saved()), text);
}

// Of versions that had a choice where there is none now.
TEST_F(SettingsFiles, WhatIsGoneIsLeftOutWithAWarning) {
  const Result run = render({head(), "--settings", file("old.json", R"({"quality": {"mask": "tiles"}})")});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("'tiles' is left out: texture-space always blurs tiles"), std::string::npos)
      << run.err;

  for (const auto& [name, value] : {std::pair("maps", "full"), {"blur", "cascade"}}) {
    const std::string old = fmt::format(R"({{"quality": {{"{}": "{}"}}}})", name, value);
    const Result gone = render({head(), "--settings", file("gone.json", old)});
    EXPECT_EQ(gone.status, 0);
    EXPECT_NE(gone.err.find(fmt::format("quality.{}: is left out: texture-space blurs narrow to wide", name)),
              std::string::npos)
        << gone.err;
  }
}

TEST_F(SettingsFiles, WhatIsGivenByItselfWins) {
  const std::string lights =
      file("lights.json", R"({"lighting": {"rig_lights": 3}, "camera": {"orbit_deg": [40, 0]}})");
  EXPECT_EQ(rendered({"--orbit", "0,0", "--settings", lights}), rendered({"--lights", "3"}));
  EXPECT_EQ(rendered({"--settings", lights, "--light", "-30,10"}),
            rendered({"--orbit", "40,0", "--light", "-30,10"}));
  const std::string placed =
      file("placed.json", R"({"lighting": {"placed_lights": [{"azimuth_deg": -30}]}})");
  EXPECT_EQ(rendered({"--settings", placed, "--lights", "3"}), rendered({"--lights", "3"}));
  EXPECT_EQ(
      rendered({"--set", "lighting.rig_lights=1", "--set", "lighting.rig_lights=3", "--settings", lights}),
      rendered({"--settings", lights}))
      << "the last one, over the file";
  EXPECT_EQ(rendered({"--lights", "2", "--set", "lighting.rig_lights=3"}), rendered({"--lights", "2"}));
}

TEST_F(SettingsFiles, ThatAreWrongAreRefused) {
  refuse("", "wrong.json");
  refuse("these are words", "wrong.json");
  refuse("[]", "wrong.json");
  refuse(R"({"camera": 3})", "camera");
  refuse(R"({"camera": {"fov": 30}})", "fov_deg");
  refuse(R"({"brush": 1})", "technique");
  refuse(R"({"camera": {"fov_deg": "wide"}})", "camera.fov_deg");
  refuse(R"({"camera": {"fov_deg": 300}})", "camera.fov_deg");
  refuse(R"({"camera": {"fov_deg": NaN}})", "wrong.json");
  refuse(R"({"camera": {"fov_deg": 1e999}})", "wrong.json");
  refuse(R"({"camera": {"orbit_deg": [1]}})", "camera.orbit_deg");
  refuse(R"({"camera": {"heads": 1.5}})", "camera.heads");
  refuse(R"({"camera": {"heads": -1}})", "camera.heads");
  refuse(R"({"quality": {"map_size": 1e30}})", "quality.map_size");
  refuse(R"({"quality": {"mask": "tape"}})", "alpha, depth");
  refuse(R"({"quality": {"cull": 1}})", "quality.cull");
  refuse(R"({"lighting": {"placed_lights": [{"elevation_deg": 91}]}})", "placed_lights[0].elevation_deg");
  refuse(R"({"scene": {"unit_scale": 0}})", "scene.unit_scale");
  refuse("{\"technique\": \"" + std::string(2 << 20, 'x') + "\"}", "wrong.json");
  expect_refused(render({head(), "--settings", (folder() / "none.json").string()}), "none.json");
}

}  // namespace
}  // namespace dermis::tests
