// SPDX-License-Identifier: MIT
// What the tests of unwraps share.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/log.h"
#include "scene/scene.h"
#include "scene/unwrap.h"

namespace dermis::scene {

inline SkinMesh only_mesh(const Scene& scene) {
  std::vector<SkinMesh> meshes = skin_meshes(scene);
  EXPECT_EQ(meshes.size(), 1u);
  return std::move(meshes.at(0));
}

/// Collects warnings while it lives.
struct Warnings {
  std::vector<std::string> lines;
  LogSink former = set_log_sink([this](LogLevel level, const std::string& line) {
    if (level == LogLevel::warning) lines.push_back(line);
  });
  ~Warnings() { set_log_sink(former); }
};

}  // namespace dermis::scene
