// SPDX-License-Identifier: MIT
// The heads that tests look at, some of which are files that may not be there.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "dermis/scene.h"

namespace dermis::tests {

/// A head by name; open() reads it once. Its files may not be there: then `missing` says what to do.
struct Subject {
  std::string name;
  std::function<Scene()> open;
  std::string missing;
};

/// "sphere", "sheared plane", "built-in head", "scan", "MakeHuman", "ICT".
const std::vector<Subject>& subjects();
const Subject& subject(const std::string& name);  ///< one of them
std::vector<std::string> subject_names();

/// A fixture: skips where the scan is not there.
class WithScan : public testing::Test {
 protected:
  void SetUp() override;
  /// Read once.
  const Scene& scan() const;
};

/// What GoogleTest takes for a name, of a technique or a head.
std::string test_name_of(std::string name);

}  // namespace dermis::tests
