// SPDX-License-Identifier: MIT
// A profile of which some light leaves where it entered: what counts it, and who cannot draw it.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "alone.h"
#include "dermis/error.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "support/files.h"
#include "support/thrown.h"

namespace dermis::setup {
namespace {

class Unscattered : public testing::Test {
 protected:
  RenderSettings with(const std::string& profile) const {
    const std::filesystem::path file = folder_.path() / "profile.json";
    tests::write_text(file, profile);
    RenderSettings s;
    s.skin.profile = file.string();
    return s;
  }
  RenderSettings half() const {
    return with(R"({"variances_mm2": [0, 1], "weights": [[0.5, 0.5, 0.5], [0.5, 0.5, 0.5]]})");
  }

  tests::TempFolder folder_;
  std::shared_ptr<const scene::AssetData> ball_ = scene::measured(scene::sphere(0.1));
};

TEST_F(Unscattered, CountsAsAGaussian) {
  EXPECT_EQ(set_up_alone(ball_, half()).gaussians, 2);
  EXPECT_EQ(set_up_alone(ball_, with(R"({"variances_mm2": [0], "weights": [[1, 1, 1]]})")).gaussians, 1);
}

TEST_F(Unscattered, IsRefusedWhereAHostDrawsTheLight) {
  HostSetup host;
  EXPECT_NO_THROW(set_up_alone(ball_, half(), {}, &host));
  host.part = {.scattered = true};
  EXPECT_NO_THROW(set_up_alone(ball_, half(), {}, &host)) << "the host lights it";
  host.part = {.irradiance = true};
  const std::string said = tests::thrown<InputError>([&] { set_up_alone(ball_, half(), {}, &host); });
  EXPECT_NE(said.find("variance of 0 mm^2"), std::string::npos) << said;
  EXPECT_NO_THROW(set_up_alone(ball_, {}, {}, &host)) << "another profile";
}

}  // namespace
}  // namespace dermis::setup
