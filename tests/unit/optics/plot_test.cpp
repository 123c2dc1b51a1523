// SPDX-License-Identifier: MIT
// The picture of a profile, without the command that writes it.
#include <gtest/gtest.h>

#include "cli/profile_plot.h"
#include "tissue/gaussians/known.h"
#include "tissue/profile/burley.h"

namespace dermis::cli {
namespace {

TEST(Plot, IsSvgOfBoundedSizeAndEscapesNames) {
  ProfilePlot plot{.title = "<skin> & co", .profiles = {}, .fit = {}, .others = {}};
  plot.fit.label = "4 Gaussians";
  const auto six = gaussians::skin_six();
  for (int c = 0; c < 3; ++c) {
    plot.profiles[c] = std::make_shared<profile::Burley>(0.7 - 0.2 * c, 0.8 / (c + 1), "test");
    plot.fit.channels[c] = gaussians::channel(six, c);
  }
  plot.others.push_back(plot.fit);

  const std::string svg = profile_svg(plot);
  EXPECT_EQ(svg.rfind("<svg", 0), 0u);
  EXPECT_NE(svg.find("&lt;skin&gt; &amp; co"), std::string::npos);
  EXPECT_LT(svg.size(), 200'000u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace dermis::cli
