// SPDX-License-Identifier: MIT
// What programs report is not taken for more than it shows.
#include "kit/results.h"

#include <gtest/gtest.h>

#include "support/files.h"

namespace dermis::kit {
namespace {

using Json = nlohmann::ordered_json;

Json report(const char* cases) {
  return Json::parse(std::string(R"({"tests": 2, "testsuites": [{"name": "S", "testsuite": [)") + cases +
                     "]}]}");
}

Json read(const char* cases) {
  Json note;
  add_cases(note, report(cases));
  return note;
}

constexpr const char* passed = R"({"name": "a", "result": "COMPLETED"})";
constexpr const char* skipped =
    R"({"name": "b", "result": "SKIPPED", "skipped": [{"message": "x.cpp:1\nno scan"}]})";
constexpr const char* failed =
    R"({"name": "c", "result": "COMPLETED", "failures": [{"failure": "x.cpp:2\nis 1, not 2"}]})";

const Ended good{.status = 0}, bad{.status = 1, .err = "the device is lost\n"};

TEST(Results, OfCasesThatPass) {
  const Json note = read((std::string(passed) + "," + skipped).c_str());
  EXPECT_EQ(note["cases"], 2);
  EXPECT_EQ(note["passed"], 1);
  EXPECT_EQ(note["skipped"], 1);
  EXPECT_EQ(note["why_skipped"], Json({"x.cpp:1 no scan"}));
  EXPECT_EQ(result_of(note, good), "holds");
}

TEST(Results, WhereAllIsSkippedNothingHolds) { EXPECT_EQ(result_of(read(skipped), good), "skipped"); }

TEST(Results, AFailureIsOneLineAndNamesTheCase) {
  const Json note = read((std::string(passed) + "," + failed).c_str());
  EXPECT_EQ(result_of(note, bad), "failed");
  EXPECT_EQ(note["failures"], Json({"S.c: x.cpp:2 is 1, not 2"}));
  EXPECT_EQ(why_not(note, bad), "1 of 2 cases; S.c: x.cpp:2 is 1, not 2");
}

TEST(Results, AProgramThatCrashedOrRanNothingFailed) {
  const Json nothing = [] {
    Json note;
    add_cases(note, Json::object());
    return note;
  }();
  EXPECT_EQ(result_of(nothing, bad), "failed");
  EXPECT_EQ(why_not(nothing, bad), "the device is lost");
  EXPECT_EQ(result_of(nothing, good), "failed");
  EXPECT_EQ(why_not(nothing, good), "no case ran");
  EXPECT_EQ(result_of(read(passed), bad), "failed") << "it passed, and then the program crashed";
}

TEST(Results, FilesAreComparedByteByByte) {
  const tests::TempFolder folder;
  const auto file = [&](const char* name, const char* text) {
    tests::write_text(folder.path() / name, text);
    return folder.path() / name;
  };
  const auto one = file("one", "abc"), same = file("same", "abc"), other = file("other", "abd"),
             longer = file("longer", "abcd");
  EXPECT_TRUE(same_bytes(one, same));
  EXPECT_FALSE(same_bytes(one, other));
  EXPECT_FALSE(same_bytes(one, longer));
  EXPECT_FALSE(same_bytes(one, folder.path() / "none"));
}

TEST(Results, BrokenJsonIsEmpty) {
  const tests::TempFolder folder;
  tests::write_text(folder.path() / "broken.json", "{\"cells\": [");
  EXPECT_TRUE(read_json(folder.path() / "broken.json").empty());
  EXPECT_TRUE(read_json(folder.path() / "none.json").empty());
}

TEST(Results, UnlitReadsOfAllVariantsWithAMarginCount) {
  EXPECT_EQ(unshaded_reads(Json::parse(R"({"texels": {"all": {"unshaded_reads": 2},
                                                      "all_margin_0": {"unshaded_reads": 100},
                                                      "cull": {"unshaded_reads": 3}}})")),
            5u);
  EXPECT_EQ(unshaded_reads(Json::object()), 0u);
}

TEST(Results, DevicesNameFiles) {
  EXPECT_EQ(file_part("NVIDIA H100 PCIe"), "nvidia-h100-pcie");
  EXPECT_EQ(file_part("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe-llvm-15-0-6-256-bits");
  EXPECT_EQ(file_part("../../"), "unknown");
  EXPECT_LE(file_part(std::string(500, 'a')).size(), 60u);
}

}  // namespace
}  // namespace dermis::kit
