// SPDX-License-Identifier: MIT
// Every file of gltf-valid and gltf-malformed: what loads, what fails and why is a golden list
// (tests/golden/gltf-corpus.tsv). DERMIS_UPDATE_GOLDEN=1 writes it anew; look at the difference before
// committing it.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "head/scene/placement.h"
#include "support.h"

namespace dermis::scene::test {

namespace {

struct Entry {
  std::string file;  ///< folder of the corpus included
  std::string errors, first_error;
  bool loads = false;
  std::string reason;  ///< the error without its file, or what was loaded
  double seconds = 0;
};

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part))
    text.erase(at, part.size());
  return text;
}

void try_to_load(const fs::path& root, Entry& entry) {
  const auto start = std::chrono::steady_clock::now();
  const Warnings quiet;
  try {
    const AssetData scene = load_gltf(root / entry.file);
    std::size_t triangles = 0;
    for (const Primitive& p : scene.primitives) triangles += copies_of(p) * p.indices.size() / 3;
    entry.loads = true;
    entry.reason = std::to_string(triangles) + (triangles == 1 ? " triangle" : " triangles");
  } catch (const InputError& error) {
    entry.reason = without(without(error.what(), (root / entry.file).string() + ": "), root.string() + "/");
    // The parser's own words differ between its versions.
    const std::string json = "is not valid JSON";
    if (const std::size_t at = entry.reason.find(json); at != std::string::npos)
      entry.reason.resize(at + json.size());
  }
  entry.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Loaded once for all tests.
const std::vector<Entry>& corpus() {
  static const std::vector<Entry> entries = [] {
    std::vector<Entry> all;
    const fs::path root = *assets();

    for (const char* folder : {"gltf-valid", "gltf-malformed"}) {
      std::istringstream index(read_text(root / folder / "INDEX.tsv"));
      std::string line;
      // Step over the line of column names.
      std::getline(index, line);
      while (std::getline(index, line)) {
        std::istringstream fields(line);
        Entry entry;
        std::string warnings;
        std::getline(fields, entry.file, '\t');
        std::getline(fields, entry.errors, '\t');
        std::getline(fields, warnings, '\t');
        std::getline(fields, entry.first_error, '\t');

        entry.file = std::string(folder) + "/" + entry.file;
        try_to_load(root, entry);
        all.push_back(entry);
      }
    }
    return all;
  }();
  return entries;
}

}  // namespace

TEST(GltfCorpus, IsAsTheGoldenListSays) {
  DERMIS_NEED_ASSETS(root);
  std::string list =
      "# what the loader makes of gltf-valid and gltf-malformed; written by test_gltf with "
      "DERMIS_UPDATE_GOLDEN=1\nfile\tresult\treason\n";
  for (const Entry& e : corpus())
    list += e.file + "\t" + (e.loads ? "loads" : "fails") + "\t" + e.reason + "\n";
  const fs::path golden = fs::path(DERMIS_SOURCE_DIR) / "tests" / "golden" / "gltf-corpus.tsv";
  if (std::getenv("DERMIS_UPDATE_GOLDEN") != nullptr) write_text(golden, list);
  std::istringstream actual(list), expected(read_text(golden));
  std::string a, e;
  while (std::getline(expected, e)) {
    ASSERT_TRUE(std::getline(actual, a)) << "missing: " << e;
    EXPECT_EQ(a, e);
  }
  EXPECT_FALSE(std::getline(actual, a)) << "not in the list: " << a;
}

TEST(GltfCorpus, ValidFilesLoadUnlessTheyRequireMore) {
  DERMIS_NEED_ASSETS(root);
  for (const Entry& e : corpus()) {
    if (!e.file.starts_with("gltf-valid") || e.errors != "0" || e.loads) continue;
    // A newer glTF that a file itself says is needed is a requirement like an extension.
    const bool says_why = e.reason.starts_with("requires the extension ") ||
                          e.reason.starts_with("asset.minVersion: needs glTF 2.1");
    EXPECT_TRUE(says_why) << e.file << ": " << e.reason;
  }
}

TEST(GltfCorpus, FilesWithStructuralErrorsFail) {
  DERMIS_NEED_ASSETS(root);
  // What the validator calls an error but leaves the geometry whole: repaired or without effect on a scene at
  // rest (docs/assets.md has the table).
  const std::set<std::string> harmless{"ACCESSOR_VECTOR3_NON_UNIT",
                                       "MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY",
                                       "NODE_SKIN_NO_SCENE",
                                       "BUFFER_VIEW_TARGET_OVERRIDE",
                                       "BUFFER_VIEW_TOO_LONG",
                                       "INVALID_INDEX",
                                       "NODE_SKIN_WITH_NON_SKINNED_MESH",
                                       "NODE_WEIGHTS_INVALID",
                                       "TYPE_MISMATCH",
                                       "UNDEFINED_PROPERTY"};
  int failed = 0;
  for (const Entry& e : corpus()) {
    if (!e.file.starts_with("gltf-malformed") || e.errors == "0") continue;
    EXPECT_TRUE(!e.loads || harmless.contains(e.first_error)) << e.file << " loads: " << e.first_error;
    failed += e.loads ? 0 : 1;
  }
  EXPECT_GT(failed, 200);
}

TEST(GltfCorpus, NothingTakesLong) {
  DERMIS_NEED_ASSETS(root);
  for (const Entry& e : corpus()) EXPECT_LT(e.seconds, 5) << e.file;  // the promise is "no hang", not a speed
}

}  // namespace dermis::scene::test
