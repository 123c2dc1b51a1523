// SPDX-License-Identifier: MIT
// What `dermis sequence` makes of frames: contact sheets, and videos by a program that takes the place of
// ffmpeg. It stands on the path, keeps what it is given, and ends as a test asks.
#include <fmt/format.h>

#include <algorithm>

#include "cli/program.h"
#include "cli/tiny_gltf.h"
#include "image/codec.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

class SequenceVideo : public Program {
 protected:
  std::string in_folder(const std::string& name) const { return (folder() / name).string(); }
  Result sequence(const Arguments& arguments, const Surroundings& surroundings = {}) const {
    Arguments all{"sequence",    file("head.gltf", tiny_gltf()),
                  "--orbit",     "-40,0..40,0",
                  "--fps",       "2",
                  "--map-size",  "64",
                  "--technique", "lambert"};
    if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end())
      all.insert(all.end(), {"--size", "40x32"});
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(all, surroundings);
  }
  /// A folder for the path whose ffmpeg writes its words to words.txt and runs `script`, in which $out is the
  /// file to write. No other program is on the path but those of the system.
  Surroundings with_ffmpeg(const std::string& script) const {
    const fs::path bin = folder() / "bin";
    fs::create_directories(bin);
    write_text(bin / "ffmpeg", "#!/bin/sh\nprintf '%s\\n' \"$@\" > '" + in_folder("words.txt") +
                                   "'\nfor out; do :; done\nout=${out#file:}\n" + script + "\n");
    fs::permissions(bin / "ffmpeg", fs::perms::owner_all);
    return {.variables = {"PATH=" + bin.string() + ":/usr/bin:/bin"}};
  }
  /// No video, and nothing of one.
  void expect_no_video() const {
    for (const auto& entry : fs::directory_iterator(folder()))
      EXPECT_FALSE(entry.path().filename().string().starts_with("clip.")) << entry.path();
  }
  /// Display values of the frames, as ffmpeg takes them.
  std::string raw_frames(std::size_t count) const {
    std::string raw;
    for (std::size_t i = 0; i < count; ++i) {
      const image::Image8 picture = image::load_image8(folder() / fmt::format("f-{}.png", i));
      for (std::size_t p = 0; p < picture.rgba.size(); p += 4)
        raw.append(reinterpret_cast<const char*>(&picture.rgba[p]), 3);
    }
    return raw;
  }
};

TEST_F(SequenceVideo, FramesArePipedInOrder) {
  ASSERT_EQ(sequence({"--to", "4", "-o", in_folder("f-%d.png")}).status, 0);
  for (const char* ending : {"mp4", "webm", "webp"}) {
    const std::string video = in_folder(std::string("clip.") + ending);
    const Result result = sequence({"--to", "4", "-o", video}, with_ffmpeg("cat > \"$out\""));
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(read_text(video), raw_frames(8));

    const std::string words = read_text(folder() / "words.txt");
    EXPECT_NE(words.find("rawvideo\n-pixel_format\nrgb24\n-video_size\n40x32\n-framerate\n2\n"),
              std::string::npos)
        << words;
    EXPECT_NE(words.find(std::string("-f\n") + ending + "\n"), std::string::npos) << words;
    // Until it is whole it has another name.
    EXPECT_EQ(words.find(video + "\n"), std::string::npos) << words;
    fs::remove(video);
    expect_no_video();
  }
}

TEST_F(SequenceVideo, WithoutFfmpegItSaysWhatToDo) {
  const Surroundings without{.variables = {"PATH=" + folder().string()}};
  for (const char* name : {"clip.mp4", "clip.webm", "clip.webp"}) {
    expect_refused(sequence({"-o", in_folder(name)}, without),
                   "ffmpeg, which is not on the path; install it");
    // What cannot be run is none.
    file("ffmpeg", "#!/bin/sh\n");
    expect_refused(sequence({"-o", in_folder(name)}, without),
                   "ffmpeg, which is not on the path; install it");
    fs::remove(folder() / "ffmpeg");
  }
  expect_no_video();
}

TEST_F(SequenceVideo, RefusesWhatAVideoCannotBe) {
  const Surroundings with = with_ffmpeg("cat > \"$out\"");
  const auto refuse = [&](const Arguments& arguments, const std::string& says) {
    expect_refused(sequence(arguments, with), says);
    expect_no_video();
  };
  refuse({"-o", in_folder("clip.mp4"), "--size", "41x32"}, "even number of rows and columns");
  refuse({"-o", in_folder("clip.webm"), "--resume"}, "--resume: goes on with numbered pictures");
  refuse({"-o", in_folder("none/clip.mp4")}, "does not exist");
  refuse({"-o", in_folder("clip.avi")}, ".mp4, .webm or .webp");
  refuse({"-o", in_folder("clip.mp4"), "--sheet", in_folder("sheet.jpg")}, "is written as .png");
  refuse({"-o", in_folder("clip.mp4"), "--sheet", in_folder("none/sheet.png")}, "does not exist");
  refuse({"-o", in_folder("f-%02d.png"), "--sheet", in_folder("f-03.png")}, "is also the name of a frame");
  refuse({"-o", in_folder("clip.mp4"), "--save-scene", in_folder("clip.mp4")}, "needs its own");
}

TEST_F(SequenceVideo, AFailureOfFfmpegIsToldAndLeavesNothing) {
  const auto fail = [&](const std::string& script, const std::string& says) {
    expect_refused(sequence({"--to", "20", "-o", in_folder("clip.mp4")}, with_ffmpeg(script)), says);
    expect_no_video();
  };
  fail("echo begin > \"$out\"; echo first >&2; echo 'Unknown encoder' >&2; exit 1",
       "clip.mp4: ffmpeg has failed: Unknown encoder");
  fail("cat > \"$out\"; exit 3", "clip.mp4: ffmpeg has failed");
  fail("cat > \"$out\"; kill -9 $$", "clip.mp4: ffmpeg has failed");
  fail("cat > /dev/null", "clip.mp4: ffmpeg has failed");  // and has written nothing

  // An old video survives.
  file("clip.mp4", "the old one");
  const Result result = sequence({"-o", in_folder("clip.mp4")}, with_ffmpeg("exit 1"));
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(read_text(folder() / "clip.mp4"), "the old one");
}

TEST_F(SequenceVideo, CtrlCLeavesNoVideo) {
  Surroundings interrupted =
      with_ffmpeg("head -c 8000 > \"$out\"; echo x > '" + in_folder("begun") + "'; cat >> \"$out\"");
  interrupted.interrupt_after_s = 0.01;
  interrupted.from_file = folder() / "begun";
  const Result result = sequence({"--to", "10000", "-o", in_folder("clip.webm")}, interrupted);
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find(" of 20000 frames; a video is written in one piece, and there is none"),
            std::string::npos)
      << result.err;
  expect_no_video();
}

// 7 frames of 40 x 32 in rows of 4 with gaps of 6 pixels: not made smaller, so that the pixels are theirs.
TEST_F(SequenceVideo, TheSheetHoldsTheFrames) {
  const std::string of_pictures = in_folder("sheet.png"), of_video = in_folder("sheet-of-video.png");
  ASSERT_EQ(sequence({"--to", "3.5", "-o", in_folder("f-%d.png"), "--sheet", of_pictures}).status, 0);
  const image::Image8 sheet = image::load_image8(of_pictures);
  const int columns = 4, rows = 2;
  ASSERT_EQ(sheet.width, columns * 40 + (columns + 1) * 6);
  ASSERT_EQ(sheet.height, rows * 32 + (rows + 1) * 6);
  const auto cell = [&](int place, int x, int y) {
    return sheet.at(6 + place % columns * 46 + x, 6 + place / columns * 38 + y);
  };
  for (int i = 0; i < 7; ++i) {
    const image::Image8 frame = image::load_image8(folder() / fmt::format("f-{}.png", i));
    int differing = 0;
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x)
        for (int c = 0; c < 3; ++c) differing += frame.at(x, y)[c] != cell(i, x, y)[c];
    EXPECT_EQ(differing, 0) << "frame " << i;
  }
  EXPECT_EQ(sheet.at(0, 0)[0], 24);
  EXPECT_EQ(cell(7, 0, 0)[0], 24);  // an empty place

  // The same of a video, and, within the roundings of the tone map, of linear light.
  ASSERT_EQ(sequence({"--to", "3.5", "-o", in_folder("clip.mp4"), "--sheet", of_video},
                     with_ffmpeg("cat > \"$out\""))
                .status,
            0);
  EXPECT_EQ(read_text(of_video), read_text(of_pictures));
  ASSERT_EQ(sequence({"--to", "3.5", "-o", in_folder("e-%d.exr"), "--sheet", of_pictures}).status, 0);
  const image::Image8 of_light = image::load_image8(of_pictures);
  ASSERT_EQ(of_light.rgba.size(), sheet.rgba.size());
  for (std::size_t i = 0; i < sheet.rgba.size(); ++i)
    ASSERT_NEAR(of_light.rgba[i], sheet.rgba[i], 1) << "value " << i;
}

// 30 frames: 24 of them.
TEST_F(SequenceVideo, ALongSequenceShowsTwentyFourFrames) {
  const std::string sheet = in_folder("sheet.png");
  ASSERT_EQ(sequence({"--to", "15", "-o", in_folder("f-%d.png"), "--sheet", sheet}).status, 0);
  const image::Image8 picture = image::load_image8(sheet);
  const int columns = (picture.width - 6) / 46, rows = (picture.height - 6) / 38;
  EXPECT_EQ(columns * rows, 24);

  // The last one is frame 23 * 30 / 24.
  const image::Image8 last = image::load_image8(folder() / "f-28.png");
  EXPECT_EQ(picture.at(picture.width - 6 - 20, picture.height - 6 - 16)[0], last.at(20, 16)[0]);
  EXPECT_GT(last.at(20, 16)[0], 24);
}

}  // namespace
}  // namespace dermis::tests
