// SPDX-License-Identifier: MIT
// What files say of their own licence.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/files.h"
#include "tools/dataset/inputs.h"

namespace dermis::dataset {
namespace {

std::string spdx_of(const std::string& copyright) {
  const tests::TempFolder folder;
  const nlohmann::json file{{"asset", {{"version", "2.0"}, {"copyright", copyright}}}};
  tests::write_text(folder.path() / "a.gltf", file.dump());
  const auto licence = licence_in(folder.path() / "a.gltf");
  if (!licence) return "none";
  EXPECT_EQ(licence->author, copyright);
  EXPECT_EQ(licence->source, "a.gltf");
  return licence->spdx;
}

TEST(Licence, IsFoundInWhatPeopleWrite) {
  EXPECT_EQ(spdx_of("\"A Head\" by A. Author, CC BY 3.0; changed"), "CC-BY-3.0");
  EXPECT_EQ(spdx_of("CC BY-SA 4.0 someone"), "CC-BY-SA-4.0");
  EXPECT_EQ(spdx_of("CC0 1.0 (several people)"), "CC0-1.0");
  EXPECT_EQ(spdx_of("MIT, (c) 2020 an institute"), "MIT");
  EXPECT_EQ(spdx_of(""), "none");
}

TEST(Licence, IsNotFoundWhereItIsNot) {
  for (const char* text : {"(c) 2024 J. SMITH", "CC BY-NC 4.0", "MIT-like", "all rights reserved"})
    EXPECT_EQ(spdx_of(text), "LicenseRef-asset.copyright") << text;
}

}  // namespace
}  // namespace dermis::dataset
