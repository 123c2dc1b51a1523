// SPDX-License-Identifier: MIT
// Files that come into the window, whole and broken.
#include "viewer/model/opening.h"

#include <gtest/gtest.h>

#include "base/settings/json.h"
#include "support/files.h"
#include "support/thrown.h"
#include "unit/viewer/documents.h"
#include "viewer/model/saving.h"

namespace dermis::viewer {
namespace {

Hooks quiet() {
  return {.log = [](LogLevel, const std::string&) {}};
}

TEST(Opening, ASavedProfileComesBack) {
  const tests::TempFolder folder;
  const std::filesystem::path file = folder.path() / "skin.json";
  const ScatterProfile skin = load_profile("skin");
  write_profile(skin, file.string());

  Document document = tests::square_document();
  document.settings.skin.profile = "skin";
  read_file_for(document, file, quiet()).into(document);
  EXPECT_TRUE(document.settings.skin.profile.empty());
  EXPECT_EQ(profile_of(document).terms, skin.terms);
  EXPECT_EQ(document.skin.kind, SkinKind::gaussians);
  clear_profile(document);
  EXPECT_FALSE(document.scene.instance(document.scene.instances().front()).profile);
}

TEST(Opening, SavedSettingsComeBack) {
  const tests::TempFolder folder;
  Document document = tests::square_document();
  document.settings.output.bloom = 0.3;
  document.settings.quality.map_size = 256;
  save_settings(document, folder.path() / "a.json");

  Document other = tests::square_document();
  read_file_for(other, folder.path() / "a.json", quiet()).into(other);
  EXPECT_EQ(to_json({.render = other.settings, .scene = {}, .reference = {}}),
            to_json({.render = document.settings, .scene = {}, .reference = {}}));
}

TEST(Opening, BrokenFilesChangeNothing) {
  const tests::TempFolder folder;
  const Document document = tests::square_document();
  for (const char* name : {"a.glb", "a.gltf", "a.hdr", "a.exr", "a.json", "a.txt", "a"})
    for (const char* content :
         {"", "{", "garbage \x01\xff", "{\"dermis_scene\": 1}", "{\"variances_mm2\": 3}",
          "{\"output\": {\"bloom\": 7}}", "#?RADIANCE\n\n-Y 3 +X 3\n"}) {
      tests::write_text(folder.path() / name, content);
      EXPECT_THROW(read_file_for(document, folder.path() / name, quiet()), InputError) << name << content;
    }
  EXPECT_THROW(read_file_for(document, folder.path() / "none.glb", quiet()), InputError);
  EXPECT_THROW(read_file_for(document, folder.path(), quiet()), InputError);
}

TEST(Saving, NamesLieBesideEachOther) {
  EXPECT_EQ(save_names("out/face.png").picture, "out/face.png");
  EXPECT_EQ(save_names("out/face.v2").scene, "out/face.v2.scene.json");
  EXPECT_THROW(save_names(""), InputError);
  EXPECT_THROW(save_names("out/"), InputError);
}

TEST(Saving, ASceneThatWasEditedIsNamedByItsFileAlone) {
  Document document = tests::square_document();
  EXPECT_EQ(scene_words(document, {}), (std::vector<std::string>{"square.glb"}));
  document.scene.add_light({});
  EXPECT_FALSE(scene_words(document, {}));
  const SavedScene saved{.scene = document.scene, .file = "out/a.scene.json"};
  EXPECT_EQ(scene_words(document, saved), (std::vector<std::string>{"out/a.scene.json"}));
  document.scene.add_light({});
  EXPECT_FALSE(scene_words(document, saved));
}

}  // namespace
}  // namespace dermis::viewer
