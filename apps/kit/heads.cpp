// SPDX-License-Identifier: MIT
#include "kit/heads.h"

#include <algorithm>
#include <system_error>

namespace dermis::kit {
namespace {

namespace fs = std::filesystem;

const std::string none_packed = Heads::built_in;

}  // namespace

const std::string& Heads::main() const { return scan.empty() ? light() : scan; }

const std::string& Heads::light() const {
  if (!people.empty()) return people.front();
  return scan.empty() ? none_packed : scan;
}

std::vector<std::string> Heads::all() const {
  std::vector<std::string> files = people;
  if (!scan.empty()) files.push_back(scan);
  files.emplace_back(built_in);
  return files;
}

Heads find_heads(const fs::path& kit) {
  Heads heads;
  std::error_code missing;
  const fs::path scan = fs::path("assets") / "heads" / "lee-perry-smith.gltf";
  if (fs::exists(kit / scan, missing)) heads.scan = scan.string();

  const fs::path people = fs::path("assets") / "makehuman";
  for (fs::directory_iterator entry(kit / people, missing), end; !missing && entry != end;
       entry.increment(missing))
    if (entry->path().extension() == ".glb")
      heads.people.push_back((people / entry->path().filename()).string());
  std::ranges::sort(heads.people);
  return heads;
}

}  // namespace dermis::kit
