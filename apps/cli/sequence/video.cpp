// SPDX-License-Identifier: MIT
#include "cli/sequence/video.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "base/core/error.h"
#include "base/core/file.h"

extern "C" char** environ;  // NOLINT: what POSIX calls it

namespace dermis::cli::sequence {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Arguments of ffmpeg for a format. Colours are those of Rec.709, as the pictures are; without dates and
// names of encoders, equal frames give equal bytes.
Words encoding(const std::string& ending) {
  const Words rec709{"-vf",
                     "scale=out_color_matrix=bt709:out_range=limited",
                     "-pix_fmt",
                     "yuv420p",
                     "-colorspace",
                     "bt709",
                     "-color_trc",
                     "bt709",
                     "-color_range",
                     "tv",
                     "-color_primaries",
                     "bt709"};
  Words words;
  if (ending == ".mp4") words = {"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"};
  if (ending == ".webm") words = {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-f", "webm"};
  if (ending == ".webp") return {"-c:v", "libwebp_anim", "-quality", "85", "-loop", "0", "-f", "webp"};
  words.insert(words.begin(), rec709.begin(), rec709.end());
  return words;
}

std::optional<fs::path> on_the_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::string_view folders = path ? path : "";
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const fs::path file = fs::path(folders.substr(0, end)) / program;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return file;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return std::nullopt;
}

fs::path find_ffmpeg(const fs::path& video) {
  if (const std::optional<fs::path> found = on_the_path("ffmpeg")) return *found;
  throw input_error(video.string(),
                    "a video is made by the program ffmpeg, which is not on the path; install it, or write "
                    "pictures: -o frame-%04d.png");
}

// Standard input from `in`, standard error to `messages`, and out of the reach of Ctrl-C, which this program
// answers. Returns an error number, or 0.
int spawn(const Words& words, int in, int messages, pid_t& process) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawnattr_t how;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawnattr_init(&how);
  ::posix_spawn_file_actions_adddup2(&files, in, STDIN_FILENO);
  ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_adddup2(&files, messages, STDERR_FILENO);
  sigset_t usual;
  ::sigemptyset(&usual);
  ::sigaddset(&usual, SIGPIPE);
  ::posix_spawnattr_setsigdefault(&how, &usual);
  ::posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);

  const int error = ::posix_spawn(&process, arguments[0], &files, &how, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&files);
  ::posix_spawnattr_destroy(&how);
  return error;
}

// A file without a name.
int open_nameless() {
  std::FILE* const file = std::tmpfile();
  if (!file) return -1;
  const int copy = ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 0);
  std::fclose(file);
  return copy;
}

std::string last_line(int file) {
  std::string text(4096, '\0');
  const off_t end = ::lseek(file, 0, SEEK_END);
  const ssize_t size =
      ::pread(file, text.data(), text.size(), std::max<off_t>(end - static_cast<off_t>(text.size()), 0));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

bool is_video(const fs::path& path) {
  const std::string ending = ending_of(path);
  return ending == ".mp4" || ending == ".webm" || ending == ".webp";
}

void check_video(const fs::path& path, int width, int height) {
  find_ffmpeg(path);
  if (ending_of(path) == ".mp4" && (width % 2 != 0 || height % 2 != 0))
    throw input_error(path.string(), "an .mp4 has an even number of rows and columns, and the frames {}x{}",
                      width, height);
}

Video::Video(fs::path path, int width, int height, double fps) : path_(followed_links(path)) {
  check_video(path_, width, height);
  unfinished_ = unfinished_path(path_, 0);

  Words words{find_ffmpeg(path_).string(), "-hide_banner", "-loglevel", "error", "-nostdin", "-y"};
  for (const std::string& word :
       Words{"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", fmt::format("{}x{}", width, height),
             "-framerate", fmt::format("{}", fps), "-i", "pipe:0", "-fflags", "+bitexact", "-flags:v",
             "+bitexact"})
    words.push_back(word);
  for (const std::string& word : encoding(ending_of(path_))) words.push_back(word);
  words.push_back("file:" + unfinished_.string());

  // A pipe without a reader is an error to report, not the end of this program.
  ::signal(SIGPIPE, SIG_IGN);
  int ends[2] = {-1, -1};
  messages_ = open_nameless();
  int error = messages_ < 0 || ::pipe2(ends, O_CLOEXEC) != 0 ? errno : 0;
  if (error == 0) error = spawn(words, ends[0], messages_, process_);
  if (ends[0] >= 0) ::close(ends[0]);
  pipe_ = ends[1];
  if (error == 0) return;

  close_pipe();
  if (messages_ >= 0) ::close(messages_);
  throw input_error(path_.string(), "ffmpeg cannot be started: {}", std::strerror(error));
}

Video::~Video() {
  close_pipe();
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    wait();
  }
  ::close(messages_);
  std::error_code ignored;  // it has its own name by now, or was never begun
  fs::remove(unfinished_, ignored);
}

void Video::add(const Picture& picture) {
  const std::size_t pixels = picture.display_rgba.size() / 4;
  rgb_.resize(pixels * 3);
  for (std::size_t i = 0; i < pixels; ++i)
    std::copy_n(&picture.display_rgba[4 * i], 3, rgb_.begin() + static_cast<std::ptrdiff_t>(3 * i));

  for (std::size_t done = 0; done < rgb_.size();) {
    const ssize_t written = ::write(pipe_, rgb_.data() + done, rgb_.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    done += static_cast<std::size_t>(written);
  }
}

void Video::finish() {
  close_pipe();
  const int status = wait();
  std::error_code error;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !fs::exists(unfinished_, error)) fail();

  fs::rename(unfinished_, path_, error);
  if (error) throw input_error(path_.string(), "cannot be written: {}", error.message());
}

void Video::fail() {
  close_pipe();
  wait();
  const std::string says = last_line(messages_);
  throw input_error(path_.string(), "ffmpeg has failed{}{}", says.empty() ? "" : ": ", says);
}

int Video::wait() {
  int status = 0;
  if (process_ > 0)
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
  process_ = -1;
  return status;
}

void Video::close_pipe() {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
}

}  // namespace dermis::cli::sequence
