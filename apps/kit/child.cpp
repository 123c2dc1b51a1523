// SPDX-License-Identifier: MIT
#include "kit/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "base/core/error.h"

namespace dermis::kit {
namespace {

constexpr std::size_t most_text = 1 << 20;  // bytes of each stream

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Pipe {
  int from = -1, into = -1;

  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      throw input_error("", "no pipe for a program: {}", std::strerror(errno));
    from = ends[0];
    into = ends[1];
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(from);
    if (into >= 0) ::close(into);
  }
  void close_into() {
    ::close(into);
    into = -1;
  }
};

[[noreturn]] void become(const Command& command, const Pipe& out, const Pipe& err) {
  // A group of its own: Ctrl-C reaches us alone, and all that it starts can be ended together.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::dup2(out.into, STDOUT_FILENO);
  ::dup2(err.into, STDERR_FILENO);

  for (const auto& [name, value] : command.variables) ::setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> words;
  for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);

  if (::chdir(command.folder.c_str()) == 0) ::execv(words[0], words.data());
  std::fprintf(stderr, "%s: %s\n", words[0], std::strerror(errno));
  ::_exit(127);
}

/// Takes what is there; false at the end of the stream.
bool take(int file, std::string& text) {
  std::array<char, 4096> part{};
  const ssize_t count = ::read(file, part.data(), part.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  const std::size_t room = most_text - std::min(most_text, text.size());
  text.append(part.data(), std::min(static_cast<std::size_t>(count), room));
  return count > 0;
}

/// Ends a group of processes in order, then at once.
class Ending {
 public:
  explicit Ending(pid_t group) : group_(group) {}

  void ask(double now) {
    if (asked_ <= now) return;
    asked_ = now;
    ::kill(-group_, SIGTERM);
  }
  void insist(double now) {
    if (now - asked_ > grace_seconds) ::kill(-group_, SIGKILL);
  }

 private:
  pid_t group_;
  double asked_ = std::numeric_limits<double>::infinity();  // when
};

void listen(pid_t child, const Command& command, const std::atomic<bool>& stop, const Pipe& out,
            const Pipe& err, Ended& ended) {
  const double start = seconds_now();
  Ending ending(child);
  std::array<pollfd, 2> streams{pollfd{out.from, POLLIN, 0}, pollfd{err.from, POLLIN, 0}};

  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    ::poll(streams.data(), streams.size(), 100);
    if (streams[0].revents != 0 && !take(out.from, ended.out)) streams[0].fd = -1;
    if (streams[1].revents != 0 && !take(err.from, ended.err)) streams[1].fd = -1;

    const double now = seconds_now();
    if (stop) ended.stopped = true;
    if (!ended.stopped && now - start > command.most_seconds) ended.timed_out = true;
    if (ended.stopped || ended.timed_out) ending.ask(now);
    ending.insist(now);
  }
}

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

std::string Ended::why() const {
  if (ok()) return "";
  if (stopped) return "stopped";
  if (timed_out) return fmt::format("ended after {:.0f} s, which is too long", seconds);
  if (signal != 0) return fmt::format("ended by signal {} ({})", signal, ::strsignal(signal));
  const std::string line = last_line(err);
  return line.empty() ? fmt::format("exit status {}", status) : line;
}

Ended run(const Command& command, const std::atomic<bool>& stop) {
  const double start = seconds_now();
  Ended ended;
  Pipe out, err;
  const pid_t child = ::fork();
  if (child < 0) throw input_error("", "no process for {}: {}", command.words[0], std::strerror(errno));
  if (child == 0) become(command, out, err);

  ::setpgid(child, child);
  out.close_into();
  err.close_into();
  listen(child, command, stop, out, err, ended);

  int status = 0;
  rusage used{};
  while (::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {}
  ended.seconds = seconds_now() - start;
  ended.peak_mb = 1024e-6 * static_cast<double>(used.ru_maxrss);
  if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  return ended;
}

std::string quoted(const std::vector<std::string>& words) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:=+@%";
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
      line += word;
    else {
      line += '\'';
      for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
      line += '\'';
    }
  }
  return line;
}

}  // namespace dermis::kit
