// SPDX-License-Identifier: MIT
#include "support.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace dermis::fuzz {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "dermis-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the input can be made");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

void check_message(std::string_view message) {
  constexpr std::size_t longest = 4000;
  DERMIS_ASSERT(!message.empty());
  DERMIS_ASSERT_LE(message.size(), longest);
  for (const char c : message) DERMIS_ASSERT(static_cast<unsigned char>(c) >= ' ' && c != '\x7f');
}

std::string_view as_text(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

const fs::path& scratch_folder() {
  static const Folder folder;
  return folder.path();
}

fs::path put_file(const fs::path& name, Bytes bytes) {
  fs::path path = scratch_folder() / name;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) throw std::runtime_error("the input's file cannot be written");
  const bool written = bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  if (std::fclose(file) != 0 || !written) throw std::runtime_error("the input's file cannot be written");
  return path;
}

}  // namespace dermis::fuzz
