// SPDX-License-Identifier: MIT
// Made-up trees that break one rule each: a check that notices nothing would pass on the real tree for ever.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "house/check.h"
#include "house/measure.h"

namespace {

namespace fs = std::filesystem;

/// A source tree in a temporary folder, gone at the end of the test.
class MadeUpTree {
 public:
  MadeUpTree() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(::testing::TempDir()) / (std::string("dermis_house_") + test->name());
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  ~MadeUpTree() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  MadeUpTree(const MadeUpTree&) = delete;
  MadeUpTree& operator=(const MadeUpTree&) = delete;

  MadeUpTree& add(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path, std::ios::binary) << text;
    return *this;
  }
  std::vector<house::SourceFile> read() const { return house::read_tree(root_); }

 private:
  fs::path root_;
};

constexpr const char* house_txt =
    "core: \ngpu: core\nframe: gpu\nscene: core\npasses: frame\npasses_blur: scene\n"
    "techniques: passes\n";

house::Rules rules_of(const std::string& text, const std::set<std::string>& rooms) {
  return house::close_over(house::read_dependencies(text, rooms));
}

house::Violations includes(const MadeUpTree& tree) {
  const auto files = tree.read();
  auto rooms = house::rooms_of(files);
  rooms.insert({"core", "gpu", "frame", "scene", "passes", "techniques"});
  return house::check_includes(files, rules_of(house_txt, rooms));
}

testing::AssertionResult one_about(const house::Violations& violations, const std::string& part) {
  if (violations.size() == 1 && violations[0].find(part) != std::string::npos)
    return testing::AssertionSuccess();
  auto result = testing::AssertionFailure() << violations.size() << " violations";
  for (const auto& violation : violations) result << "\n" << violation;
  return result;
}

TEST(HouseCheck, RulesReachThroughNeighbours) {
  const auto rules = rules_of(house_txt, {"core", "gpu", "frame", "scene", "passes"});
  EXPECT_EQ(rules.at("frame"), (std::set<std::string>{"core", "gpu"}));
  EXPECT_EQ(rules.at("passes"), (std::set<std::string>{"core", "frame", "gpu", "scene"}));
  EXPECT_THROW(rules_of("no colon here\n", {}), std::runtime_error);
}

TEST(HouseCheck, AllowedIncludesPass) {
  MadeUpTree tree;
  tree.add("src/core/a.h", "")
      .add("src/gpu/b.h", "#include \"core/a.h\"\n#include \"c.h\"\n#include \"dermis/error.h\"\n")
      .add("src/gpu/c.h", "");
  tree.add("include/dermis/error.h", "#include <string>\n")
      .add("src/passes/blur/blur.cpp", "#include \"blur.h\"\n#include \"frame/plan.h\"\n");
  tree.add("src/passes/blur/blur.h", "#include \"scene/scene.h\"\n")
      .add("tests/unit/t.cpp", "#include \"gpu/b.h\"\n");
  EXPECT_EQ(includes(tree), house::Violations{});
}

TEST(HouseCheck, FindsAnIncludeAgainstTheDirection) {
  MadeUpTree tree;
  tree.add("src/core/a.h", "// one\n  #  include \"gpu/b.h\"\n").add("src/gpu/b.h", "");
  EXPECT_TRUE(one_about(includes(tree), "src/core/a.h:2: \"gpu/b.h\": 'core' may not include 'gpu'"));
}

TEST(HouseCheck, FindsAnIncludeByRelativePath) {
  MadeUpTree tree;
  tree.add("src/core/a.h", "#include \"../gpu/b.h\"\n").add("src/gpu/b.h", "");
  EXPECT_TRUE(one_about(includes(tree), "'core' may not include 'gpu'"));
}

TEST(HouseCheck, FindsAnIncludeInAShader) {
  MadeUpTree tree;
  tree.add("src/gpu/clear.comp", "#include \"scene/light.h\"\n");
  EXPECT_TRUE(one_about(includes(tree), "'gpu' may not include 'scene'"));
}

TEST(HouseCheck, FindsAPassThatIncludesAnother) {
  MadeUpTree tree;
  tree.add("src/passes/blur/blur.cpp", "#include \"passes/shadow/shadow.h\"\n")
      .add("src/passes/shadow/shadow.h", "");
  EXPECT_TRUE(one_about(includes(tree), "a pass is included from outside its folder"));
}

TEST(HouseCheck, FindsWhatThePapersTechniqueShares) {
  const std::string folder = "src/techniques/published/";
  for (const auto& [from, to] : {std::pair{folder + "final.frag", std::string("passes/blur/blur.glsl")},
                                 {folder + "final.cpp", "techniques/lambert/lambert.h"},
                                 {"src/techniques/screen.h", "techniques/published/final.h"}}) {
    MadeUpTree tree;
    tree.add(from, "#include \"" + to + "\"\n").add("src/" + to, "");
    EXPECT_TRUE(one_about(includes(tree), "the papers' technique")) << from;
  }

  MadeUpTree tree;
  tree.add(folder + "final.cpp", "#include \"passes/count/count.h\"\n#include \"passes/bindings.h\"\n")
      .add("src/passes/count/count.h", "")
      .add("src/passes/bindings.h", "")
      .add("src/techniques/all.cpp", "#include \"techniques/published/final.h\"\n")
      .add(folder + "final.h", "");
  EXPECT_EQ(includes(tree), house::Violations{});
}

TEST(HouseCheck, FindsASharedPassHeaderThatIncludesAPass) {
  MadeUpTree tree;
  tree.add("src/passes/shared.h", "#include \"shadow/shadow.h\"\n")
      .add("src/passes/shadow/shadow.h", "#include \"passes/bindings.h\"\n");
  tree.add("src/passes/bindings.h", "");
  EXPECT_TRUE(
      one_about(includes(tree),
                "src/passes/shared.h:1: \"shadow/shadow.h\": a pass is included from outside its folder"));
}

TEST(HouseCheck, WritesTheDependencyTable) {
  const auto dependencies =
      house::read_dependencies(house_txt, {"core", "gpu", "frame", "scene", "passes", "techniques"});
  EXPECT_EQ(house::dependency_table(dependencies),
            "```\ncore\ngpu        -> core\nframe      -> gpu\nscene      -> core\npasses     -> frame, "
            "scene\ntechniques -> passes\n```\n");
}

TEST(HouseCheck, FindsAPublicHeaderThatIncludesTheInside) {
  MadeUpTree tree;
  tree.add("include/dermis/scene.h", "#include \"scene/scene.h\"\n").add("src/scene/scene.h", "");
  EXPECT_TRUE(one_about(includes(tree), "a public header includes a file of src/"));
}

TEST(HouseCheck, RoomsLieWithinFolders) {
  MadeUpTree tree;
  for (const char* room : {"base/core", "render/passes", "render/techniques"})
    tree.add(std::string("src/") + room + "/CMakeLists.txt", "");
  tree.add("src/base/core/a.h", "namespace dermis {\n")
      .add("src/render/passes/light_map/pool.h", "#include \"base/core/a.h\"\nnamespace dermis::passes {\n")
      .add("src/render/passes/light_map/tiles/tiles.h",
           "#include \"render/passes/light_map/pool.h\"\nnamespace dermis::passes {\n")
      .add("src/render/passes/scatter/blur/blur.h",
           "#include \"render/passes/light_map/pool.h\"\nnamespace dermis::passes {\n");
  EXPECT_EQ(includes(tree), house::Violations{});
  EXPECT_EQ(house::check_namespaces(tree.read()), house::Violations{});
  EXPECT_EQ(house::rooms_of(tree.read()), (std::set<std::string>{"core", "passes", "techniques"}));

  tree.add("src/render/passes/scatter/blur/blur.cpp",
           "#include \"render/passes/light_map/tiles/tiles.h\"\nnamespace dermis::passes {\n");
  EXPECT_TRUE(one_about(includes(tree), "a pass is included from outside its folder"));
  tree.add("src/render/passes/scatter/blur/blur.cpp", "namespace dermis::render {\n")
      .add("src/base/core/b.h", "#include \"render/passes/light_map/pool.h\"\nnamespace dermis {\n");
  EXPECT_TRUE(one_about(includes(tree), "'core' may not include 'passes'"));
  EXPECT_TRUE(one_about(house::check_namespaces(tree.read()), "'dermis::render' in the room 'passes'"));
}

TEST(HouseCheck, FindsARoomWithoutATarget) {
  MadeUpTree tree;
  tree.add("src/attic/a.cpp", "#include \"core/a.h\"\n").add("src/core/a.h", "");
  EXPECT_TRUE(one_about(includes(tree), "src/attic: no dermis_module"));
}

TEST(HouseCheck, FindsForbiddenDependenciesAndCircles) {
  const std::set<std::string> rooms{"core", "gpu", "frame", "scene", "passes", "reference"};
  EXPECT_EQ(house::check_rules(rules_of(house_txt, rooms)), house::Violations{});
  EXPECT_TRUE(
      one_about(house::check_rules(rules_of("gpu: scene\n", rooms)), "'gpu' must never depend on 'scene'"));
  EXPECT_TRUE(one_about(house::check_rules(rules_of("core:\nreference: core gpu\n", rooms)),
                        "'reference' must never depend on 'gpu'"));
  EXPECT_EQ(house::check_rules(rules_of("core: gpu\ngpu: core\n", rooms)).size(), 2u);
}

TEST(HouseCheck, FindsWordsAboutSkin) {
  MadeUpTree tree;
  tree.add("src/gpu/a.h", "// header, overhead, profiler, ahead\nint skin_count;\n")
      .add("src/frame/b.cpp", "drawHead();\n")
      .add("src/scene/c.h", "// skin\n");
  const auto violations = house::check_words(tree.read());
  ASSERT_EQ(violations.size(), 2u);
  EXPECT_EQ(violations[0], "src/frame/b.cpp:1: the word 'head' does not belong here");
  EXPECT_EQ(violations[1], "src/gpu/a.h:2: the word 'skin' does not belong here");
}

TEST(HouseCheck, FindsANamespaceOfAnotherRoom) {
  MadeUpTree tree;
  tree.add("src/frame/plan.h", "namespace dermis::frame {\nnamespace {\n")
      .add("src/frame/part/a.cpp", "namespace dermis::frame::part {\n")
      .add("src/passes/blur/blur_io.h", "DERMIS_IO_BEGIN\n")
      .add("src/core/cache.h", "namespace dermis {\nnamespace dermis::cache {\n")
      .add("src/api/a.cpp", "namespace fs = std::filesystem;\nnamespace dermis {\nnamespace api {\n")
      .add("apps/a.cpp", "namespace cli {\n");
  EXPECT_EQ(house::check_namespaces(tree.read()), house::Violations{});

  tree.add("src/passes/data.h", "\nnamespace dermis::frame {\n");
  EXPECT_TRUE(one_about(house::check_namespaces(tree.read()),
                        "src/passes/data.h:2: 'dermis::frame' in the room 'passes'"));
  tree.add("src/passes/data.h", "namespace dermis::frames {\n");
  EXPECT_TRUE(one_about(house::check_namespaces(tree.read()), "'dermis::frames' in the room 'passes'"));
  tree.add("src/passes/data.h", "namespace dermis {\nnamespace passes {\n");
  EXPECT_TRUE(
      one_about(house::check_namespaces(tree.read()), "'dermis' itself is for api, core and settings"));
  tree.add("src/passes/data.h", "int a;\n");
  EXPECT_TRUE(one_about(house::check_namespaces(tree.read()), "data.h: no namespace dermis::passes"));
  tree.add("src/passes/data.h", "inline namespace dermis::passes {\n")
      .add("src/api/a.cpp", "namespace dermis {\nnamespace core {\n");
  EXPECT_TRUE(one_about(house::check_namespaces(tree.read()), "src/api/a.cpp:2: 'core' in the room 'api'"));
}

TEST(HouseCheck, FindsAMissingLicence) {
  const std::string spdx = std::string("SPDX-License-Identifier: ") + "MIT\n";
  MadeUpTree tree;
  tree.add("src/gpu/a.h", "// " + spdx)
      .add("tools/b.sh", "#!/bin/sh\n# " + spdx)
      .add("c.md", "words\n")
      .add("src/gpu/d.comp", "\n// " + spdx);
  EXPECT_TRUE(one_about(house::check_licence(tree.read()), "src/gpu/d.comp"));

  MadeUpTree joined;
  joined.add("src/gpu/e.h", "// " + spdx.substr(0, spdx.size() - 1) + " and more words\n");
  EXPECT_TRUE(one_about(house::check_licence(joined.read()), "src/gpu/e.h"));
}

TEST(HouseCheck, FindsAMachinePath) {
  MadeUpTree tree;
  tree.add("docs/a.md", std::string("see https://example.org/") + "home/x and src/" + "work/y\n")
      .add("docs/b.md", std::string("see /") + "home/me/x\n");
  EXPECT_TRUE(one_about(house::check_machine_paths(tree.read()), "docs/b.md:1"));
}

TEST(HouseCheck, LeavesOutWhatIsNotSource) {
  MadeUpTree tree;
  tree.add("build/release/a.h", "")
      .add("out/b.h", "")
      .add(".git/c.h", "")
      .add("src/core/d.h", "")
      .add("assets/e.bin", std::string(3, '\0'));
  const auto files = tree.read();
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].path, "src/core/d.h");
}

TEST(HouseCheck, MeasuresFilesAndFunctions) {
  MadeUpTree tree;
  tree.add("src/core/a.cpp",
           "namespace n {\n\nint f() {\n  if (x) {\n  }\n  return 1;\n}\n\nvoid g(int a,\n       int b) "
           "{\n}\nstruct S {\n};\n}\n");
  const auto files = house::file_lengths(tree.read());
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].lines, 14);
  const auto functions = house::function_lengths(tree.read());
  ASSERT_EQ(functions.size(), 2u);
  EXPECT_EQ(functions[0].lines, 5);
  EXPECT_EQ(functions[0].where, "src/core/a.cpp:3 int f() {");
  EXPECT_EQ(functions[1].lines, 3);
  EXPECT_EQ(functions[1].where, "src/core/a.cpp:9 void g(int a,");
}

TEST(HouseCheck, SeesFunctionsWithoutParagraphs) {
  MadeUpTree tree;
  tree.add("src/core/a.cpp", "int f() {\n  a();\n\n  b();\n}\nint g() {\n  a();\n  b();\n}\n");
  const auto functions = house::function_lengths(tree.read());
  EXPECT_EQ(house::share_without_blank_line(functions, 4), 0.5);
  EXPECT_EQ(house::share_without_blank_line(functions, 5), 0);
  EXPECT_EQ(house::share_without_blank_line(functions, 50), 0);
  EXPECT_EQ(house::median(functions), 4);
}

TEST(HouseCheck, DoesNotTakeATableForAFunction) {
  MadeUpTree tree;
  tree.add("src/core/a.h",
           "inline constexpr auto rows = std::tuple{\n  Row{(1)},\n  Row{2}};\n\nint f(int a = 1) {\n}\n");
  const auto functions = house::function_lengths(tree.read());
  ASSERT_EQ(functions.size(), 1u);
  EXPECT_EQ(functions.front().lines, 2);
}

TEST(HouseCheck, SeesLinesThatAreTooWide) {
  MadeUpTree tree;
  const std::string narrow(8, 'x'), wide(9, 'x');
  tree.add("src/core/a.cpp", narrow + "\n" + wide + "\n");
  tree.add("src/core/a.comp", "// \u00e4\u00e4\u00e4\u00e4\u00e4\n");  // 8 columns, 13 bytes
  tree.add("run", wide + "\n");
  tree.add("README.md", wide + "\n");
  EXPECT_EQ(house::check_columns(tree.read(), 8),
            (house::Violations{"run:1: 9 columns", "src/core/a.cpp:2: 9 columns"}));
}

TEST(HouseCheck, FindsADocumentThatNamesWhatIsNotThere) {
  MadeUpTree tree;
  tree.add("src/core/error.h", "\n")
      .add("tools/make.sh", "\n")
      .add("docs/a.md", "`core/gone.h` `core/error.h`\n");
  tree.add(
      "README.md",
      "`src/core/` `tools/make.sh` `tools/gone.sh`\n"
      "`tools/make.sh --fast` `tools/*.sh` `out/picture.png` `and/or` `tools/NAME` tools/none `src/gone`\n");
  EXPECT_EQ(
      house::check_document_paths(tree.read()),
      (house::Violations{"README.md:1: there is no 'tools/gone.sh'", "README.md:2: there is no 'src/gone'",
                         "docs/a.md:1: there is no 'core/gone.h'"}));
}

TEST(HouseCheck, FindsOptionsInTextsOfTheLibrary) {
  MadeUpTree tree;
  tree.add("src/api/a.cpp",
           "int i = n--; // \"--size\" in a comment\n"
           "const char quote = '\"'; f(\"a -- b, ---, x--y, --7\", n); --n;\n"
           "throw input_error(\"a \\\"smaller\\\" --map-size holds it\");\n");
  tree.add("src/api/b.cpp", "const char* text = R\"css(\n  see --tone-map \"\n)css\"; --n; // --size\n");
  tree.add("include/dermis/a.h", "/// dermis render --profile\ninline const char* help = \"--help\";\n");
  tree.add("src/tools/report/page.cpp", "const char* style = \"{ --at: 50% }\";\n");
  tree.add("apps/cli/a.cpp", "add(\"--size\");\n");
  const std::string says = " in a text of the library: name the setting";
  EXPECT_EQ(house::check_option_names(tree.read()),
            (house::Violations{"include/dermis/a.h:2: the option '--help'" + says,
                               "src/api/a.cpp:3: the option '--map-size'" + says,
                               "src/api/b.cpp:2: the option '--tone-map'" + says}));
}

TEST(HouseCheck, FindsWhatTheViewerLeavesToOthers) {
  MadeUpTree tree;
  tree.add("src/base/settings/fields.h",
           "{.help = \"how far the lamps stand from the head\",\n .unit = \"m\"}\n");
  tree.add("apps/viewer/window/ui_renderer.cpp", "VkBuffer buffer;\nvkCmdDrawIndexed(commands);\n");
  tree.add("apps/viewer/window/ui.frag", "void main() {}\n");
  tree.add("apps/viewer/panels/a.cpp", "std::string vkontakte;  // a Vkontakte\n");
  EXPECT_EQ(house::check_viewer(tree.read()), house::Violations{});

  tree.add("apps/viewer/window/b.cpp", "vkCmdDraw(c);\nvkCmdDispatch(c);\n");
  tree.add("apps/viewer/window/other.frag", "void main() {}\n");
  tree.add("apps/viewer/panels/a.cpp",
           "#include \"passes/compute_pass.h\"\nVkImage image;\nAbout{.least = 0};\n"
           "text(\"how far the lamps stand from the head\");\n");
  EXPECT_EQ(house::check_viewer(tree.read()),
            (house::Violations{"apps/viewer/panels/a.cpp:1: an include of what renders",
                               "apps/viewer/panels/a.cpp:2: Vulkan, outside of what shows ImGui's lists",
                               "apps/viewer/panels/a.cpp:3: a range, unit or help text of a setting",
                               "apps/viewer/panels/a.cpp:4: a text of the settings, typed again",
                               "apps/viewer/window/b.cpp:1: a draw of its own",
                               "apps/viewer/window/b.cpp:2: a step of rendering",
                               "apps/viewer/window/other.frag: a shader of the viewer's own"}));
}

}  // namespace
