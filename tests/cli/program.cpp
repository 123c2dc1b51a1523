// SPDX-License-Identifier: MIT
#include "cli/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

namespace dermis::tests {
namespace fs = std::filesystem;
namespace {

constexpr double limit_s = 300;  // for what hangs: no program that works comes near, however busy the machine

// Between fork and exec: only calls that are safe there.
[[noreturn]] void become(const fs::path& out, const fs::path& err, char* const* arguments,
                         char* const* variables, const Surroundings& surroundings) {
  const int out_file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600),
            err_file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, 0), ::dup2(out_file, 1), ::dup2(err_file, 2);
  if (const rlim_t bytes = surroundings.address_space_bytes; bytes != 0) {
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  if (const rlim_t bytes = surroundings.file_bytes; bytes != 0) {
    const rlimit limit{bytes, bytes};
    ::signal(SIGXFSZ, SIG_IGN);  // else the system ends the program instead of refusing to write
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ::execve(arguments[0], arguments, variables);
  ::_exit(127);
}

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
  all.push_back(nullptr);
  return all;
}

}  // namespace

std::string Program::file(const std::string& name, const std::string& content) const {
  std::ofstream(folder() / name, std::ios::binary) << content;
  return (folder() / name).string();
}

Result Program::run(const Arguments& arguments, const Surroundings& surroundings) const {
  std::vector<std::string> all{DERMIS_PROGRAM};
  all.insert(all.end(), arguments.begin(), arguments.end());

  std::vector<std::string> variables = surroundings.variables;
  for (char** v = environ; *v; ++v) {
    const std::string variable = *v, name = variable.substr(0, variable.find('=') + 1);
    if (std::none_of(variables.begin(), variables.end(),
                     [&](const std::string& own) { return own.starts_with(name); }))
      variables.push_back(variable);
  }
  const std::vector<char*> argv = pointers(all), envp = pointers(variables);

  // beside the folder: what is left in the folder is what the program left
  const fs::path log = folder().string() + ".log";
  const fs::path out = log.string() + ".out", err = log.string() + ".err";
  const pid_t child = ::fork();
  if (child == 0) become(out, err, argv.data(), envp.data(), surroundings);

  const double allowed_s = surroundings.kill_after_s > 0 ? surroundings.kill_after_s : limit_s;
  const auto start = std::chrono::steady_clock::now();
  const auto gone_s = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  int status = 0;
  pid_t done = 0;
  const auto should_interrupt = [&] {
    if (const std::string& text = surroundings.interrupt_after_text; !text.empty())
      return fs::exists(out) && read_text(out).find(text) != std::string::npos;
    return surroundings.interrupt_after_s > 0 && gone_s() > surroundings.interrupt_after_s;
  };
  bool interrupted = false;
  while ((done = ::waitpid(child, &status, WNOHANG)) == 0 && gone_s() < allowed_s) {
    if (!interrupted && should_interrupt()) {
      ::kill(child, SIGINT);
      interrupted = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (done == 0) {
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
  }

  Result result{.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                .out = read_text(out),
                .err = read_text(err)};
  fs::remove(out);
  fs::remove(err);
  return result;
}

Result Program::render(const Arguments& arguments, const Surroundings& surroundings) const {
  Arguments all{"render", "-o", picture().string()};
  for (const auto& [option, value] :
       {std::pair("--size", "48x48"), std::pair("--map-size", "64"), std::pair("--shadow-size", "64")})
    if (std::find(arguments.begin(), arguments.end(), option) == arguments.end())
      all.insert(all.end(), {option, value});
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run(all, surroundings);
}

void Program::expect_refused(const Result& result, const std::string& says) const {
  EXPECT_EQ(result.status, 1) << result.err;
  // Warnings may come before; the error is one line, the last.
  EXPECT_FALSE(result.err.empty());
  if (result.err.empty()) return;
  const std::size_t last = result.err.rfind('\n', result.err.size() - 2);
  const std::string line = last == std::string::npos ? result.err : result.err.substr(last + 1);
  EXPECT_TRUE(line.starts_with("dermis: ")) << result.err;
  EXPECT_TRUE(line.ends_with("\n"));
  EXPECT_NE(line.find(says), std::string::npos) << "expected '" << says << "' in: " << line;
  for (std::size_t at = 0; last != std::string::npos && at <= last; at = result.err.find('\n', at) + 1)
    EXPECT_TRUE(result.err.compare(at, 17, "dermis: warning: ") == 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_FALSE(fs::exists(picture()));
  for (const auto& entry : fs::directory_iterator(folder()))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

void Program::expect_not_understood(const Result& result, const std::string& says) const {
  EXPECT_EQ(result.status, 2) << result.err;
  EXPECT_NE(result.err.find(says), std::string::npos) << "expected '" << says << "' in: " << result.err;
  EXPECT_FALSE(fs::exists(picture()));
}

bool Program::expect_rendered(const Result& result) const {
  EXPECT_EQ(result.status, 0) << result.err;
  const std::string png = read_text(picture());
  EXPECT_TRUE(png.starts_with("\x89PNG"));
  return result.status == 0 && !png.empty();
}

}  // namespace dermis::tests
