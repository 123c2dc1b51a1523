// SPDX-License-Identifier: MIT
// Shaders are compiled while they are edited: what is right is drawn, what is wrong is told.
#include "viewer/model/live_shaders.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "support/files.h"
#include "unit/viewer/documents.h"
#include "viewer/model/painter.h"

namespace dermis::viewer {
namespace {

namespace fs = std::filesystem;

const std::atomic<bool> go_on = false;

// A copy of all shaders of the build, which can be edited.
class EditedShaders : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path from = fs::path(DERMIS_SOURCE_DIR) / "src";
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(from)) {
      const fs::path ending = entry.path().extension();
      if (ending != ".comp" && ending != ".vert" && ending != ".frag" && ending != ".glsl" && ending != ".h")
        continue;
      const fs::path to = folder_ / fs::relative(entry.path(), from);
      fs::create_directories(to.parent_path());
      fs::copy_file(entry.path(), to);
      fs::last_write_time(to, time_);
    }
    shaders_.emplace(folder_, DERMIS_GLSLC, time_);
  }

  // A second later than the edit before, whatever the clock of the file system.
  void edit(const char* name, const std::string& from, const std::string& to) {
    const fs::path file = folder_ / name;
    std::ifstream in(file);
    std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << name << ": " << from;
    std::ofstream(file) << text.replace(at, from.size(), to);
    fs::last_write_time(file, time_ += std::chrono::seconds(1));
  }

  tests::TempFolder temp_;
  fs::path folder_ = fs::canonical(temp_.path()) / "src";
  fs::file_time_type time_ = fs::file_time_type::clock::now();
  std::optional<ShaderFolder> shaders_;
};

constexpr const char* tone_map = "render/passes/finish/tone_map/tone_map.comp";

TEST_F(EditedShaders, AreCompiledWithWhatIncludesThem) {
  EXPECT_FALSE(shaders_->refresh(go_on));
  EXPECT_EQ(shaders_->errors(), "");

  edit(tone_map, "#version 460", "#version 460\n// a word more");
  EXPECT_TRUE(shaders_->refresh(go_on));
  EXPECT_TRUE(shaders_->shaders()->empty()) << "a comment makes another shader";
  EXPECT_FALSE(shaders_->refresh(go_on));

  edit("render/passes/pixels/open_share/open_share.comp", "void main() {",
       "void main() {\n  if (false) return;");
  EXPECT_TRUE(shaders_->refresh(go_on));
  EXPECT_EQ(shaders_->errors(), "");
  for (const char* name : {"open_share.comp", "open_share_single.comp"})
    EXPECT_TRUE(shaders_->shaders()->contains(name)) << name;
  EXPECT_EQ(shaders_->shaders()->size(), 2u);
}

TEST_F(EditedShaders, ForgetAVariantWhoseLineIsGone) {
  EXPECT_FALSE(shaders_->refresh(go_on));
  constexpr const char* light = "render/techniques/published/irradiance.frag";
  edit(light, "// Variant irradiance_through_3.frag: GROUPS=3",
       "// Variant irradiance_through_3.frag: GROUPS=x");
  EXPECT_TRUE(shaders_->refresh(go_on));
  EXPECT_NE(shaders_->errors().find("published/irradiance.frag:"), std::string::npos) << shaders_->errors();

  edit(light, "// Variant irradiance_through_3.frag: GROUPS=x\n", "");
  EXPECT_TRUE(shaders_->refresh(go_on));
  EXPECT_EQ(shaders_->errors(), "");
  EXPECT_TRUE(shaders_->shaders()->empty());
}

TEST_F(EditedShaders, KeepTheLastThatWereRight) {
  EXPECT_FALSE(shaders_->refresh(go_on));
  edit(tone_map, "void main() {", "void main() {\n  if (false) return;");
  EXPECT_TRUE(shaders_->refresh(go_on));
  const auto right = shaders_->shaders();

  edit(tone_map, "#version 460", "#version 460\nneither a type nor a name;");
  EXPECT_TRUE(shaders_->refresh(go_on));
  EXPECT_EQ(shaders_->errors().find("render/passes/finish/tone_map/tone_map.comp:10: error:"), 0u)
      << shaders_->errors();
  EXPECT_EQ(shaders_->shaders(), right);

  edit(tone_map, "neither a type nor a name;", "");
  EXPECT_TRUE(shaders_->refresh(go_on));
  EXPECT_EQ(shaders_->errors(), "");
}

TEST_F(EditedShaders, MustFitTheProgram) {
  EXPECT_FALSE(shaders_->refresh(go_on));
  edit(tone_map, "void main() {",
       "layout(binding = 29) buffer More { uint more; };\nvoid main() {\n  more = 1;");
  EXPECT_TRUE(shaders_->refresh(go_on));
  EXPECT_NE(shaders_->errors().find("has a binding 29"), std::string::npos) << shaders_->errors();
}

// Waits for what the painter has to say about a wish.
PainterNews news_of(Painter& painter) {
  while (painter.is_busy()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return painter.take_news();
}

TEST_F(EditedShaders, AreSeen) {
  EXPECT_FALSE(shaders_->refresh(go_on));
  Wish wish{.scene = tests::square_document().scene};
  wish.settings.output.width = wish.settings.output.height = 32;
  wish.settings.quality.map_size = wish.settings.quality.shadow_size = 64;
  Painter painter({});
  const auto drawn = [&] {
    painter.wish(wish);
    const PainterNews news = news_of(painter);
    EXPECT_TRUE(news.errors.empty());
    return news.painted ? news.painted->picture.display_rgba : std::vector<std::uint8_t>();
  };
  const std::vector<std::uint8_t> before = drawn();
  ASSERT_FALSE(before.empty());

  edit(tone_map, "vec4(shown, 1.0)", "vec4(0.5 * shown, 1.0)");
  EXPECT_TRUE(shaders_->refresh(go_on));
  ASSERT_EQ(shaders_->errors(), "");
  painter.use_shaders(shaders_->shaders());
  EXPECT_NE(drawn(), before);

  edit(tone_map, "vec4(0.5 * shown, 1.0)", "vec4(shown, 1.0)");
  EXPECT_TRUE(shaders_->refresh(go_on));
  painter.use_shaders(shaders_->shaders());
  EXPECT_EQ(drawn(), before);
}

}  // namespace
}  // namespace dermis::viewer
