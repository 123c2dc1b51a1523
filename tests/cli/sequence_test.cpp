// SPDX-License-Identifier: MIT
// `dermis sequence`: its frames are pictures of `dermis render`, a stopped run leaves whole files and goes
// on, and what makes no sense is refused in one line.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <random>
#include <thread>

#include "cli/program.h"
#include "cli/tiny_gltf.h"
#include "image/codec.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string bytes_of(const std::vector<float>& values) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

/// A square that is turned by the clip "turn" for two seconds, and shifted by "shift" for one.
std::string moving_gltf() {
  return tiny_gltf({}, [](json& root) {
    const auto add = [&](const std::vector<float>& values, const char* type, std::size_t width, json more) {
      const std::string bytes = bytes_of(values);
      root["buffers"].push_back(
          {{"byteLength", bytes.size()}, {"uri", data_uri("application/octet-stream", bytes)}});
      root["bufferViews"].push_back({{"buffer", root["buffers"].size() - 1}, {"byteLength", bytes.size()}});
      more.update({{"bufferView", root["bufferViews"].size() - 1},
                   {"componentType", 5126},
                   {"type", type},
                   {"count", values.size() / width}});
      root["accessors"].push_back(more);
      return root["accessors"].size() - 1;
    };
    const auto clip = [&](const char* name, const char* path, float end_s, std::size_t values) {
      const std::size_t times = add({0, end_s}, "SCALAR", 1, {{"min", {0}}, {"max", {end_s}}});
      return json{{"name", name},
                  {"samplers", {{{"input", times}, {"output", values}}}},
                  {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}};
    };
    root["animations"] = {
        clip("turn", "rotation", 2, add({0, 0, 0, 1, 0, 0.6f, 0, 0.8f}, "VEC4", 4, json::object())),
        clip("shift", "translation", 1, add({0, 0, 0, 0.1f, 0, 0}, "VEC3", 3, json::object()))};
  });
}

class Sequence : public Program {
 protected:
  std::string head() const { return file("head.gltf", moving_gltf()); }
  std::string in_folder(const std::string& name) const { return (folder() / name).string(); }
  static Arguments small(Arguments arguments) {
    if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end())
      arguments.insert(arguments.end(), {"--size", "40x32"});
    arguments.insert(arguments.end(), {"--map-size", "64", "--shadow-size", "64"});
    return arguments;
  }
  Result sequence(const std::string& output, const Arguments& arguments,
                  const Surroundings& surroundings = {}) const {
    Arguments all{"sequence", head(), "-o", in_folder(output)};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(small(all), surroundings);
  }
  /// The bytes that `render` writes.
  std::string rendered(const std::string& ending, const Arguments& arguments) const {
    const std::string output = in_folder("one" + ending);
    Arguments all{"render", head(), "-o", output};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Result result = run(small(all));
    EXPECT_EQ(result.status, 0) << result.err;
    std::string bytes = read_text(output);
    fs::remove(output);
    return bytes;
  }
  /// Names of the files of the folder that begin so, sorted.
  std::vector<std::string> files(const std::string& prefix) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder()))
      if (const std::string name = entry.path().filename().string(); name.starts_with(prefix))
        names.push_back(name);
    std::sort(names.begin(), names.end());
    return names;
  }
};

TEST_F(Sequence, FramesAreThoseOfRenderToTheBit) {
  struct Case {
    const char* ending;
    Arguments sequence;                                ///< of 4 frames
    std::vector<std::pair<int, Arguments>> of_render;  ///< by frame
  };
  const Case cases[] = {
      {".png", {"--orbit", "-20,0..20,8"}, {{0, {"--orbit", "-20,0"}}, {3, {"--orbit", "10,6"}}}},
      // 0,0 would be the camera of the file.
      {".png", {"--orbit", "-40,0..40,0"}, {{2, {"--orbit", "360,0"}}}},
      {".exr", {"--dolly", "3..7"}, {{0, {"--distance", "3"}}, {3, {"--distance", "6"}}}},
      {".exr",
       {"--light-orbit", "-80,10..80,10", "--light", "0,60,1", "--orbit", "15,0"},
       {{1, {"--light", "0,60,1", "--light", "-40,10", "--orbit", "15,0"}}}},
      {".png", {"--clip", "turn"}, {{0, {"--time", "0"}}, {3, {"--time", "1.5"}}}},
      {".exr",
       {"--clip", "shift", "--eye", "0,0,1", "--target", "0,0,0"},
       {{3, {"--clip", "shift", "--time", "0.75", "--eye", "0,0,1", "--target", "0,0,0"}}}},
      {".png", {"--clip", "turn", "--orbit", "0,0..80,0"}, {{2, {"--time", "1", "--orbit", "40,0"}}}},
      {".png",
       {"--clip", "turn", "--time", "2", "--orbit", "0,0..80,0"},
       {{1, {"--time", "2", "--orbit", "20,0"}}}},
      // What a session does not draw.
      {".png",
       {"--orbit", "-20,0..20,8", "--exposure", "auto", "--ambient", "0.3"},
       {{3, {"--orbit", "10,6", "--exposure", "auto", "--ambient", "0.3"}}}},
      {".png",
       {"--clip", "turn", "--show", "irradiance", "--optimise", "none"},
       {{1, {"--time", "0.5", "--show", "irradiance", "--optimise", "none"}}}},
      {".exr",
       {"--clip", "turn", "--technique", "lambert", "--set", "quality.light_samples=1"},
       {{2, {"--time", "1", "--technique", "lambert", "--set", "quality.light_samples=1"}}}},
  };

  for (const Case& c : cases) {
    SCOPED_TRACE(fmt::format("{}", fmt::join(c.sequence, " ")));
    Arguments arguments = c.sequence;
    const bool shifts = std::find(arguments.begin(), arguments.end(), "shift") != arguments.end();
    const bool plays = arguments[0] == "--clip";
    // A clip ends by itself.
    arguments.insert(arguments.end(), {"--fps", shifts ? "4" : "2"});
    if (!plays || std::find(arguments.begin(), arguments.end(), "--time") != arguments.end())
      arguments.insert(arguments.end(), {"--to", "2"});

    const std::string pattern = std::string("f-%02d") + c.ending;
    const Result result = sequence(pattern, arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const std::vector<std::string> names = files("f-");
    EXPECT_EQ(names.size(), 4u) << fmt::format("{}", fmt::join(names, " "));
    for (const auto& [frame, options] : c.of_render) {
      const std::string bytes = read_text(folder() / fmt::format("f-{:02}{}", frame, c.ending));
      EXPECT_FALSE(bytes.empty());
      EXPECT_EQ(bytes, rendered(c.ending, options)) << "frame " << frame;
    }
    // What moves is seen to move.
    EXPECT_NE(read_text(folder() / ("f-00" + std::string(c.ending))),
              read_text(folder() / ("f-03" + std::string(c.ending))));
    for (const std::string& name : names) fs::remove(folder() / name);
  }
}

// A sequence costs what it draws: the file is not read again for each frame. Here it is gone after the first.
TEST_F(Sequence, ReadsItsFileOnce) {
  std::atomic<bool> ended = false;
  std::thread remover([&] {
    while (!ended && !fs::exists(folder() / "f-000.png"))
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    fs::remove(folder() / "head.gltf");
  });
  const Result result = sequence("f-%03d.png", {"--clip", "turn", "--fps", "50", "--technique", "lambert"});
  ended = true;
  remover.join();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(files("f-").size(), 100u);
}

TEST_F(Sequence, RefusesWhatMakesNoSense) {
  const auto refuse_output = [&](const std::string& output, const std::string& says) {
    SCOPED_TRACE(output);
    expect_refused(sequence(output, {"--clip", "turn"}), says);
  };
  refuse_output("frame.png", "does not say where the number of the frame stands");
  refuse_output("frame-%d-%d.png", "twice");
  refuse_output("frame-%s.png", "after % there must be");
  refuse_output("frame-%4d.png", "after % there must be");
  refuse_output("frame-%0000d.png", "after % there must be");
  refuse_output("frame-%d.bmp", ".png or .exr");
  refuse_output("frame-%", ".png or .exr");
  refuse_output("frame-%.png", "after % there must be");
  refuse_output("%d/frame.png", "name of a folder");
  refuse_output("none/frame-%d.png", "does not exist");
  const fs::path closed = folder() / "closed";
  fs::create_directory(closed);
  fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
  // Whoever may do anything can write there, too.
  if (::access(closed.c_str(), W_OK) != 0) refuse_output("closed/frame-%d.png", "cannot be written");

  const auto refuse = [&](const Arguments& arguments, const std::string& says) {
    SCOPED_TRACE(fmt::format("{}", fmt::join(arguments, " ")));
    expect_refused(sequence("f-%d.png", arguments), says);
    EXPECT_EQ(files("f-"), std::vector<std::string>{});
  };
  refuse({"--orbit", "0,0..90,0", "--dolly", "2..4"}, "give one range of them");
  refuse({"--light-orbit", "0,0..90,0", "--dolly", "2..4"}, "give one range of them");
  refuse({"--clip", "turn", "--fps", "0"}, "--fps: must be above 0");
  refuse({"--clip", "turn", "--fps", "-30"}, "--fps: must be above 0");
  refuse({"--clip", "turn", "--fps", "nan"}, "--fps: must be above 0");
  refuse({"--clip", "turn", "--fps", "1e9"}, "at most 1000");
  refuse({"--clip", "turn", "--from", "1", "--to", "0.5"}, "--to: must be after the begin");
  refuse({"--clip", "turn", "--from", "1", "--to", "1"}, "--to: must be after the begin");
  refuse({"--clip", "turn", "--from", "-1"}, "--from: must be 0 to");
  refuse({"--clip", "turn", "--to", "inf"}, "--to: must be 0 to");
  refuse({"--clip", "turn", "--to", "1e6"}, "more than 1000000 frames");
  refuse({"--clip", "turn", "--from", "2"}, "the clip ends at 2 s");
  refuse({"--clip", "walk"}, "there are: turn, shift");
  refuse({"--time", "1"}, "nothing else moves");
  refuse({"--orbit", "20,0", "--time", "1"}, "nothing else moves");
  refuse({"--orbit", "0,0..nan,0"}, "camera.orbit_deg");
  refuse({"--orbit", "0,0..90,1e9"}, "camera.orbit_deg");
  refuse({"--dolly", "3..-1"}, "camera.distance");
  refuse({"--light-orbit", "0,0..0,91"}, "elevation_deg");
  refuse({"--light-orbit", "0,0..90,0", "--lights", "2"}, "both");
  refuse({"--orbit", "0,0..90,0", "--distance", "5"}, "--distance replaces");
  refuse({"--orbit", "0,0..90,0", "--camera", "main"}, "--camera replaces");
  refuse({"--orbit", "0,0..90,0", "--eye", "0,0,1", "--target", "0,0,0"}, "camera.orbit_deg");
  expect_refused(run({"sequence", "--clip", "walk", "-o", in_folder("f-%d.png")}), "there are: life");

  for (const char* range : {"0..90", "0,0..", "..90,0", "0,0.90,0", "0,0..90,0..20,0", "0,0..90,0,3", ""})
    expect_not_understood(sequence("f-%d.png", {"--orbit", range}), "--orbit");
  for (const char* range : {"3", "3..", "3,4..5,6", "near..far"})
    expect_not_understood(sequence("f-%d.png", {"--dolly", range}), "--dolly");
  for (const char* range : {"90,0", "0..90", "0,0,3..90,0,3"})
    expect_not_understood(sequence("f-%d.png", {"--light-orbit", range}), "--light-orbit");
  expect_not_understood(sequence("f-%d.png", {"--frames", "3"}), "--frames");
}

TEST_F(Sequence, CtrlCLeavesWholeFilesAndResumeGoesOn) {
  const Arguments long_one{"--orbit", "0,0..360,0", "--to", "1000"};
  const auto interrupted_from = [&](int frame) {
    return Surroundings{.variables = {},
                        .interrupt_after_s = 0.01,
                        .from_file = folder() / fmt::format("f-{:04}.png", frame)};
  };
  const Result stopped = sequence("f-%04d.png", long_one, interrupted_from(3));
  EXPECT_EQ(stopped.status, 1);
  EXPECT_EQ(std::count(stopped.err.begin(), stopped.err.end(), '\n'), 1) << stopped.err;
  const std::string says = "dermis: stopped after ";
  ASSERT_TRUE(stopped.err.starts_with(says)) << stopped.err;
  EXPECT_NE(stopped.err.find(" of 30000 frames; --resume goes on"), std::string::npos) << stopped.err;
  const auto written = static_cast<std::size_t>(std::stoi(stopped.err.substr(says.size())));
  ASSERT_GE(written, 4u);

  // The frames and the record; nothing unfinished.
  std::vector<std::string> expected{"f-%04d.png.resume"};
  for (std::size_t i = 0; i < written; ++i) expected.push_back(fmt::format("f-{:04}.png", i));
  EXPECT_EQ(files("f-"), expected);
  for (std::size_t i = 1; i < expected.size(); ++i)
    EXPECT_NO_THROW(image::load_image8(folder() / expected[i])) << expected[i];

  // Another sequence is refused, and all stays.
  const std::string record = read_text(folder() / expected[0]);
  for (const Arguments& other :
       {Arguments{"--orbit", "0,0..350,0", "--to", "1000"}, Arguments{"--orbit", "0,0..360,0", "--to", "999"},
        Arguments{"--orbit", "0,0..360,0", "--to", "1000", "--fps", "29"},
        Arguments{"--orbit", "0,0..360,0", "--to", "1000", "--ambient", "0.1"},
        Arguments{"--orbit", "0,0..360,0", "--to", "1000", "--set", "quality.light_samples=1"},
        Arguments{"--orbit", "0,0..360,0", "--to", "1000", "--clip", "turn", "--time", "1"}}) {
    SCOPED_TRACE(fmt::format("{}", fmt::join(other, " ")));
    Arguments arguments = other;
    arguments.push_back("--resume");
    expect_refused(sequence("f-%04d.png", arguments), "belongs to another sequence");
    EXPECT_EQ(read_text(folder() / expected[0]), record);
  }

  // Frames that are not as they were written, and one that is gone, are drawn again.
  const std::string first = read_text(folder() / "f-0000.png"), second = read_text(folder() / "f-0001.png");
  file("f-0000.png", first.substr(0, first.size() / 2));
  fs::remove(folder() / "f-0001.png");
  const std::string third = read_text(folder() / "f-0002.png");
  std::string touched = third;
  touched[touched.size() / 2] ^= 1;
  file("f-0002.png", touched);
  Arguments again = long_one;
  again.push_back("--resume");
  const Result resumed = sequence("f-%04d.png", again, interrupted_from(static_cast<int>(written)));
  EXPECT_EQ(resumed.status, 1);
  EXPECT_EQ(read_text(folder() / "f-0000.png"), first);
  EXPECT_EQ(read_text(folder() / "f-0001.png"), second);
  EXPECT_EQ(read_text(folder() / "f-0002.png"), third);
  ASSERT_TRUE(resumed.err.starts_with(says)) << resumed.err;
  EXPECT_GT(std::stoul(resumed.err.substr(says.size())), written);
}

TEST_F(Sequence, OfTwoRunsThatWriteTheSamePicturesTheSecondEnds) {
  const Arguments long_one{"--orbit", "0,0..360,0", "--to", "1000"};
  const std::string scene = head();
  std::thread first([&] {
    sequence("f-%d.png", long_one,
             {.variables = {}, .interrupt_after_s = 0.01, .from_file = folder() / "end"});
  });
  for (int i = 0; i < 3000 && !fs::exists(folder() / "f-1.png"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  Arguments again{"sequence", scene, "-o", in_folder("f-%d.png")}, other = again;
  other.back() = in_folder("g-%d.png");
  const Result second = run(small(again)), beside = run(small([&] {
                                             other.insert(other.end(), {"--to", "0.1"});
                                             return other;
                                           }()));
  file("end", "");
  first.join();

  EXPECT_EQ(second.status, 1);
  EXPECT_NE(second.err.find("another `dermis sequence` is writing these pictures"), std::string::npos)
      << second.err;
  EXPECT_EQ(beside.status, 0) << beside.err;
  EXPECT_TRUE(fs::exists(folder() / "f-%d.png.resume"));
  EXPECT_FALSE(fs::exists(folder() / "f-%d.png.lock"));
}

// Also what is not a setting: the files of the scene, and those that settings name.
TEST_F(Sequence, ResumeTakesOnlyTheSameFiles) {
  const Arguments arguments{"--clip", "turn", "--to", "1000", "--fps", "1000"};
  const auto interrupted_from = [&](int frame) {
    return Surroundings{
        .variables = {}, .interrupt_after_s = 0.01, .from_file = folder() / fmt::format("f-{}.png", frame)};
  };
  ASSERT_EQ(sequence("f-%d.png", arguments, interrupted_from(0)).status, 1);
  ASSERT_TRUE(fs::exists(folder() / "f-%d.png.resume"));
  const auto resume = [&](const std::string& gltf, const Surroundings& surroundings = {}) {
    const std::string scene = file("head.gltf", gltf);
    return run(small({"sequence", scene, "-o", in_folder("f-%d.png"), "--clip", "turn", "--to", "1000",
                      "--fps", "1000", "--resume"}),
               surroundings);
  };

  const std::string same = moving_gltf();
  const Result resumed = resume(same, interrupted_from(static_cast<int>(files("f-").size()) + 1));
  EXPECT_NE(resumed.err.find("stopped after"), std::string::npos) << resumed.err;
  // A clip that differs between its ends alone, and a material.
  json other = json::parse(same);
  other["animations"][0]["samplers"][0]["interpolation"] = "STEP";
  expect_refused(resume(other.dump()), "belongs to another sequence");
  other = json::parse(same);
  other["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0.9;
  expect_refused(resume(other.dump()), "belongs to another sequence");

  // What is no record at all.
  file("f-%d.png.resume", "these are words\n");
  expect_refused(resume(same), "is not what a stopped `dermis sequence` leaves");
  file("f-%d.png.resume", "dermis sequence 1\n");
  expect_refused(resume(same), "belongs to another sequence");
}

TEST_F(Sequence, KilledAtTenMomentsItLeavesNoBrokenFileAndGoesOn) {
  constexpr int frames = 40;
  const Arguments arguments{"--clip", "turn", "--orbit",     "0,0..360,0",
                            "--fps",  "20",   "--technique", "lambert"};
  const auto path = [&](const char* prefix, int frame) {
    return folder() / fmt::format("{}-{:02}.exr", prefix, frame);
  };
  ASSERT_EQ(sequence("whole-%02d.exr", arguments).status, 0);
  const std::vector<std::string> whole = files("whole-");
  ASSERT_EQ(whole.size(), static_cast<std::size_t>(frames));

  const unsigned seed = std::random_device()();
  SCOPED_TRACE(fmt::format("seed {}", seed));
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  Arguments resume = arguments;
  resume.push_back("--resume");
  int killed_runs = 0;
  for (int i = 0; i < 10; ++i) {
    // Two while all is prepared, the others around a frame further on each time.
    Surroundings killed{.variables = {}, .kill_after_s = between(0.01, 1)};
    if (i >= 2) {
      killed.kill_after_s = between(0.0005, 0.05);
      killed.from_file = path("f", 4 * (i - 2) + static_cast<int>(between(0, 4)));
    }
    const Result result = sequence("f-%02d.exr", i == 0 ? arguments : resume, killed);
    killed_runs += result.status == 128 + 9;

    for (int frame = 0; frame < frames; ++frame) {
      if (!fs::exists(path("f", frame))) continue;
      EXPECT_EQ(read_text(path("f", frame)), read_text(path("whole", frame))) << "kill " << i;
    }
  }

  EXPECT_GT(killed_runs, 0) << "all ended before they were killed";
  const Result resumed = sequence("f-%02d.exr", resume);
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  // No record is left, and nothing that a killed run had begun.
  EXPECT_EQ(files("f-").size(), static_cast<std::size_t>(frames));
  for (int frame = 0; frame < frames; ++frame)
    EXPECT_EQ(read_text(path("f", frame)), read_text(path("whole", frame))) << frame;
}

}  // namespace
}  // namespace dermis::tests
