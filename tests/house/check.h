// SPDX-License-Identifier: MIT
// The rules of the house as functions over a source tree, so that they can be run on the real tree and on
// made-up ones that break them.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace house {

/// One file of the tree, read once.
struct SourceFile {
  std::string path;  ///< relative to the root, '/' between its parts
  std::vector<std::string> lines;
};

/// What breaks a rule: "path:line: sentence", or "path: sentence" when it is about the whole file.
using Violations = std::vector<std::string>;

/// Room -> other rooms it may include, the indirect ones too (itself goes without saying).
using Rules = std::map<std::string, std::set<std::string>>;

/// Text files below root, sorted by path. Left out: build/, out/, folders whose name starts with a dot (but
/// .ci), binary files.
std::vector<SourceFile> read_tree(const std::filesystem::path& root);

/// One room and what its DEPENDS name.
struct Dependencies {
  std::string room;
  std::set<std::string> on;
};

/// Reads build/house.txt ("room: room room" a line, written by dermis_module), in its order. A target such as
/// passes_blur counts as its folder, passes. `rooms` are the folders of src/. Throws std::runtime_error on a
/// line it does not understand.
std::vector<Dependencies> read_dependencies(std::string_view text, const std::set<std::string>& rooms);

/// Closes them over indirect dependencies.
Rules close_over(const std::vector<Dependencies>& dependencies);

/// As ARCHITECTURE.md shows them.
std::string dependency_table(const std::vector<Dependencies>& dependencies);

/// The folders of src/ that hold a file.
std::set<std::string> rooms_of(const std::vector<SourceFile>& tree);

/// Every quoted #include of src/ and include/ goes along the rules; a pass is included by its own folder
/// alone; include/ never includes src/. Shaders count too: they share headers with C++.
Violations check_includes(const std::vector<SourceFile>& tree, const Rules& rules);

/// What is forbidden whatever the CMake files say: gpu and frame know nothing of skin's side of the chain,
/// the reference nothing of the GPU.
Violations check_rules(const Rules& rules);

/// gpu and frame hold no word about skin: skin, irradiance, gaussian, profile, head (as words of an
/// identifier or of a comment, plurals too).
Violations check_words(const std::vector<SourceFile>& tree);

/// A file of src/ROOM/ opens dermis::ROOM, or a namespace below it, and never that of another room.
/// Exceptions: api and core may open `dermis` itself and what is below it and no room's; headers for both
/// languages (shared/ and *_io.h) open dermis::io by a macro.
Violations check_namespaces(const std::vector<SourceFile>& tree);

/// The SPDX line is the first of every source file (the second where a "#!" line has to be first), and ends
/// with the licence.
Violations check_licence(const std::vector<SourceFile>& tree);

/// No path of the machine it was written on.
Violations check_machine_paths(const std::vector<SourceFile>& tree);

/// Every path that a document (.md) names between backquotes exists: from the root, or below src/ where it
/// begins with a room. What holds other characters than those of paths, or ends in CAPITALS, is a command or
/// a pattern, and not looked at.
Violations check_document_paths(const std::vector<SourceFile>& tree);

/// The library knows nothing of the command line: no string literal of src/ or include/ holds the name of an
/// option, "--size". Exception: style sheets of pages (src/report), whose variables begin so too.
Violations check_option_names(const std::vector<SourceFile>& tree);

/// The viewer shows and edits: apps/viewer has no Vulkan outside window/, no shader, pipeline or draw but
/// those of ImGui's lists, includes nothing that renders, and repeats no range, unit or help text of a
/// setting.
Violations check_viewer(const std::vector<SourceFile>& tree);

/// True for what the compilers read: C++, headers, shaders.
bool is_code(std::string_view path);
bool is_shader(std::string_view path);
/// Shell, Python and CMake.
bool is_script(std::string_view path);

}  // namespace house
