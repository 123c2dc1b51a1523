// SPDX-License-Identifier: MIT
#include "house/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace house {

namespace fs = std::filesystem;

namespace {

constexpr std::array shader_endings{".comp", ".vert", ".frag", ".glsl"};
constexpr std::array code_endings{".cpp", ".c", ".h", ".hpp"};
constexpr std::array script_endings{".sh", ".cmake", ".py", ".ci/run"};

bool ends_with_any(std::string_view path, const auto& endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view ending) { return path.ends_with(ending); });
}

/// "src/gpu/device.h", 1 -> "gpu"; nothing when there is no folder of that depth.
std::optional<std::string> folder_at(std::string_view path, int depth) {
  std::size_t begin = 0;
  for (int i = 0; i < depth; ++i) {
    begin = path.find('/', begin);
    if (begin == std::string_view::npos) return std::nullopt;
    ++begin;
  }
  const std::size_t end = path.find('/', begin);
  if (end == std::string_view::npos) return std::nullopt;
  return std::string(path.substr(begin, end - begin));
}

/// Folders of src/, such as "src/base/core", that are rooms: they have a CMakeLists.txt. A folder that has
/// none, with no room in it, is a room by its first name.
class Plan {
 public:
  explicit Plan(const std::vector<SourceFile>& tree) {
    for (const SourceFile& file : tree)
      if (file.path.starts_with("src/") && file.path.ends_with("/CMakeLists.txt"))
        folders_.insert(fs::path(file.path).parent_path().generic_string());
  }

  /// "src/render/gpu/device.h" -> "src/render/gpu"; nothing outside src/.
  std::optional<std::string> folder_of(std::string_view path) const {
    for (fs::path folder = fs::path(path).parent_path(); folder.has_parent_path();
         folder = folder.parent_path())
      if (folders_.contains(folder.generic_string())) return folder.generic_string();
    const auto first = path.starts_with("src/") ? folder_at(path, 1) : std::nullopt;
    return first ? std::optional("src/" + *first) : std::nullopt;
  }
  /// "src/render/gpu/device.h" -> "gpu".
  std::optional<std::string> room_of(std::string_view path) const {
    const auto folder = folder_of(path);
    return folder ? std::optional(fs::path(*folder).filename().string()) : std::nullopt;
  }
  /// Folders between the room and the file: "light_map/blur" of "src/render/passes/light_map/blur/blur.h".
  std::string inside(std::string_view path) const {
    const auto folder = folder_of(path);
    const std::string parent = fs::path(path).parent_path().generic_string();
    return !folder || parent.size() <= folder->size() ? "" : parent.substr(folder->size() + 1);
  }

 private:
  std::set<std::string> folders_;
};

/// Folders of passes, "blur" or "light_map/blur", hold a pass if no other lies in them; else files that
/// passes share.
bool is_a_pass(const std::string& inside) {
  static const std::set<std::string> stages{"asset",  "pose",   "light_map", "scatter",
                                            "pixels", "screen", "finish"};
  return !inside.empty() && !stages.contains(inside);
}

/// What stands between the quotes of an #include line.
std::optional<std::string> quoted_include(std::string_view line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string_view::npos || line[hash] != '#') return std::nullopt;
  const std::size_t word = line.find_first_not_of(" \t", hash + 1);
  if (word == std::string_view::npos || !line.substr(word).starts_with("include")) return std::nullopt;
  const std::size_t open = line.find('"', word);
  if (open == std::string_view::npos) return std::nullopt;
  const std::size_t close = line.find('"', open + 1);
  if (close == std::string_view::npos) return std::nullopt;
  return std::string(line.substr(open + 1, close - open - 1));
}

/// The file of the tree that an include means: beside the file, in src/ or in include/. Unknown ones
/// (libraries, generated files) are judged by their folder when that is a room.
std::string resolve(const SourceFile& from, const std::string& include, const std::set<std::string>& paths,
                    const Rules& rules, const Plan& plan) {
  const std::string beside =
      (fs::path(from.path).parent_path() / include).lexically_normal().generic_string();
  for (const std::string& candidate : {beside, "src/" + include, "include/" + include}) {
    if (paths.contains(candidate)) return candidate;
  }
  const auto room = plan.room_of("src/" + include);
  return room && rules.contains(*room) ? "src/" + include : include;
}

/// The papers' technique stands alone: it shares no pass but `count`, and the list alone knows it.
std::string judge_published(const SourceFile& file, const std::string& target, const Plan& plan) {
  const auto of_published = [&](const std::string& path) {
    return plan.room_of(path) == "techniques" && plan.inside(path) == "published";
  };
  const bool of_a_pass = plan.room_of(target) == "passes" && is_a_pass(plan.inside(target)) &&
                         !plan.inside(target).ends_with("count"),
             of_another = plan.room_of(target) == "techniques" && !plan.inside(target).empty() &&
                          !of_published(target);
  if (of_published(file.path)) {
    if (of_a_pass) return "the papers' technique has passes of its own";
    return of_another ? "the papers' technique knows no other" : "";
  }
  return of_published(target) && !file.path.ends_with("techniques/all.cpp")
             ? "the list alone knows the papers' technique"
             : "";
}

std::string judge_include(const SourceFile& file, const std::string& target, const Rules& rules,
                          const Plan& plan) {
  const auto to = plan.room_of(target);
  if (!to) return {};
  const auto from = plan.room_of(file.path);
  if (!from) return "a public header includes a file of src/";
  if (std::string broken = judge_published(file, target, plan); !broken.empty()) return broken;
  if (*from == *to) {
    const std::string pass = plan.inside(target);
    return *to == "passes" && is_a_pass(pass) && plan.inside(file.path) != pass
               ? "a pass is included from outside its folder"
               : "";
  }
  const auto rule = rules.find(*from);
  if (rule == rules.end() || rule->second.contains(*to)) return {};
  return fmt::format("'{}' may not include '{}' (its DEPENDS do not reach it)", *from, *to);
}

/// Lower-case words of a line: a snake_case or CamelCase identifier is split into its parts.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  std::string word;
  const auto flush = [&] {
    if (!word.empty()) words.push_back(std::exchange(word, {}));
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto c = static_cast<unsigned char>(line[i]);
    if (std::isalpha(c) == 0) {
      flush();
      continue;
    }
    if (std::isupper(c) != 0 && i > 0 && std::islower(static_cast<unsigned char>(line[i - 1])) != 0) flush();
    word += static_cast<char>(std::tolower(c));
  }
  flush();
  return words;
}

/// "  namespace dermis::gpu {" -> "dermis::gpu"; nothing for other lines and for namespaces without a name.
std::optional<std::string> opened_namespace(std::string_view line) {
  if (line.starts_with("inline ")) line.remove_prefix(7);
  constexpr std::string_view word = "namespace ";
  if (!line.starts_with(word) || line.find('=') != std::string_view::npos) return std::nullopt;
  line = line.substr(word.size());
  const std::string name(line.substr(0, line.find_first_of(" {")));
  return name.empty() ? std::nullopt : std::optional(name);
}

std::string judge_namespace(const std::string& name, const std::string& room,
                            const std::set<std::string>& rooms) {
  // In `dermis` itself stand what the library offers to others, what it says of its settings, and core, whose
  // names all rooms use bare.
  const bool in_dermis = room == "api" || room == "core" || room == "settings";
  const bool qualified = name == "dermis" || name.starts_with("dermis::");
  if (name == "dermis") return in_dermis ? "" : fmt::format("'dermis' itself is for api, core and settings");

  std::string first = qualified ? name.substr(std::string_view("dermis::").size()) : name;
  first = first.substr(0, first.find("::"));
  if (first == room || (!rooms.contains(first) && (in_dermis || !qualified))) return {};
  return fmt::format("'{}' in the room '{}'", name, room);
}

bool has_spdx(const SourceFile& file) {
  const std::size_t line = !file.lines.empty() && file.lines[0].starts_with("#!") ? 1 : 0;
  const std::string text =
      "SPDX-License-Identifier: "
      "MIT";
  return file.lines.size() > line && file.lines[line].ends_with(text);
}

}  // namespace

bool is_shader(std::string_view path) { return ends_with_any(path, shader_endings); }
bool is_script(std::string_view path) {
  return path == "run" || path.ends_with("CMakeLists.txt") || ends_with_any(path, script_endings);
}
bool is_code(std::string_view path) { return is_shader(path) || ends_with_any(path, code_endings); }

std::vector<SourceFile> read_tree(const fs::path& root) {
  std::vector<SourceFile> tree;
  for (auto it = fs::recursive_directory_iterator(root); it != fs::recursive_directory_iterator(); ++it) {
    const std::string name = it->path().filename().string();
    if (it->is_directory()) {
      const bool hidden = name.starts_with('.') && name != ".ci";
      if (hidden || (it.depth() == 0 && (name.starts_with("build") || name == "out")))
        it.disable_recursion_pending();
      continue;
    }

    if (!it->is_regular_file() || name == ".git") continue;
    std::ifstream in(it->path(), std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (text.find('\0') != std::string::npos) continue;

    SourceFile file{fs::relative(it->path(), root).generic_string(), {}};
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) file.lines.push_back(line);
    tree.push_back(std::move(file));
  }

  std::sort(tree.begin(), tree.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return tree;
}

std::set<std::string> rooms_of(const std::vector<SourceFile>& tree) {
  const Plan plan(tree);
  std::set<std::string> rooms;
  for (const SourceFile& file : tree) {
    if (const auto room = plan.room_of(file.path)) rooms.insert(*room);
  }
  return rooms;
}

std::vector<Dependencies> read_dependencies(std::string_view text, const std::set<std::string>& rooms) {
  const auto room_of_target = [&](const std::string& target) {
    const std::string folder = target.substr(0, target.find('_'));
    return rooms.contains(target) || !rooms.contains(folder) ? target : folder;
  };

  std::vector<Dependencies> all;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos || colon == 0)
      throw std::runtime_error("house.txt: expected 'room: rooms', got '" + line + "'");

    const std::string room = room_of_target(line.substr(0, colon));
    auto entry = std::find_if(all.begin(), all.end(), [&](const Dependencies& d) { return d.room == room; });
    if (entry == all.end()) entry = all.insert(entry, {room, {}});

    std::istringstream names(line.substr(colon + 1));
    for (std::string name; names >> name;) {
      if (const std::string other = room_of_target(name); other != room || name == room)
        entry->on.insert(other);
    }
  }
  return all;
}

Rules close_over(const std::vector<Dependencies>& dependencies) {
  Rules rules;
  for (const Dependencies& d : dependencies) rules[d.room] = d.on;
  for (bool grew = true; grew;) {  // what my neighbours may include, I may include
    grew = false;
    for (auto& [room, allowed] : rules) {
      const std::size_t before = allowed.size();
      for (const std::string& neighbour : std::set<std::string>(allowed)) {
        if (const auto rule = rules.find(neighbour); rule != rules.end())
          allowed.insert(rule->second.begin(), rule->second.end());
      }
      grew = grew || allowed.size() > before;
    }
  }
  return rules;
}

std::string dependency_table(const std::vector<Dependencies>& dependencies) {
  std::string table = "```\n";
  for (const Dependencies& d : dependencies) {
    table += d.on.empty() ? d.room + "\n" : fmt::format("{:<10} -> {}\n", d.room, fmt::join(d.on, ", "));
  }
  return table + "```\n";
}

Violations check_includes(const std::vector<SourceFile>& tree, const Rules& rules) {
  const Plan plan(tree);
  std::set<std::string> paths;
  for (const SourceFile& file : tree) paths.insert(file.path);

  Violations violations;
  for (const std::string& room : rooms_of(tree)) {
    if (!rules.contains(room))
      violations.push_back(
          fmt::format("src/{}: no dermis_module of this name, so its includes cannot be judged", room));
  }

  for (const SourceFile& file : tree) {
    if (!is_code(file.path) || !(file.path.starts_with("src/") || file.path.starts_with("include/")))
      continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const auto include = quoted_include(file.lines[i]);
      if (!include) continue;
      const std::string broken =
          judge_include(file, resolve(file, *include, paths, rules, plan), rules, plan);
      if (!broken.empty())
        violations.push_back(fmt::format("{}:{}: \"{}\": {}", file.path, i + 1, *include, broken));
    }
  }
  return violations;
}

Violations check_rules(const Rules& rules) {
  const std::set<std::string> skin_side{"optics",       "profile", "gaussians",  "scene",
                                        "builtin_head", "passes",  "techniques", "reference",
                                        "regions",      "setup",   "api"};
  const Rules never{{"gpu", skin_side},
                    {"frame", skin_side},
                    {"scene", {"gpu", "frame"}},
                    {"reference", {"gpu", "frame", "passes", "techniques"}},
                    {"regions", {"gpu", "frame", "passes", "techniques"}}};

  Violations violations;
  for (const auto& [room, allowed] : rules) {
    if (allowed.contains(room))
      violations.push_back(fmt::format("house.txt: '{}' depends on itself, in a circle", room));

    const auto rule = never.find(room);
    if (rule == never.end()) continue;
    for (const std::string& other : rule->second) {
      if (allowed.contains(other))
        violations.push_back(fmt::format("house.txt: '{}' must never depend on '{}'", room, other));
    }
  }
  return violations;
}

Violations check_words(const std::vector<SourceFile>& tree) {
  const std::set<std::string> forbidden{"skin",  "irradiance",  "gaussian",  "profile",  "head",
                                        "skins", "irradiances", "gaussians", "profiles", "heads"};
  Violations violations;
  for (const SourceFile& file : tree) {
    if (!is_code(file.path) || (!file.path.starts_with("src/gpu/") && !file.path.starts_with("src/frame/")))
      continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      for (const std::string& word : words_of(file.lines[i])) {
        if (forbidden.contains(word))
          violations.push_back(
              fmt::format("{}:{}: the word '{}' does not belong here", file.path, i + 1, word));
      }
    }
  }
  return violations;
}

Violations check_namespaces(const std::vector<SourceFile>& tree) {
  const Plan plan(tree);
  const std::set<std::string> rooms = rooms_of(tree);
  Violations violations;
  for (const SourceFile& file : tree) {
    const auto room = plan.room_of(file.path);
    // What C++ and GLSL both read opens its namespace, dermis::io, by a macro.
    const bool both_read = room == "shared" || file.path.ends_with("_io.h");
    if (!room || !is_code(file.path) || is_shader(file.path) || both_read) continue;

    bool opens_own = false;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const auto name = opened_namespace(file.lines[i]);
      if (!name) continue;
      opens_own = opens_own || name->starts_with("dermis");
      if (const std::string broken = judge_namespace(*name, *room, rooms); !broken.empty())
        violations.push_back(fmt::format("{}:{}: {}", file.path, i + 1, broken));
    }
    if (!opens_own) violations.push_back(fmt::format("{}: no namespace dermis::{}", file.path, *room));
  }
  return violations;
}

Violations check_licence(const std::vector<SourceFile>& tree) {
  Violations violations;
  for (const SourceFile& file : tree) {
    const bool needs = is_code(file.path) || ends_with_any(file.path, script_endings) || file.path == "run";
    if (needs && !has_spdx(file))
      violations.push_back(file.path + ": the first line has no SPDX licence identifier");
  }
  return violations;
}

Violations check_machine_paths(const std::vector<SourceFile>& tree) {
  // In two parts, so that this file does not break its own rule.
  const std::vector<std::string> roots{std::string("/") + "work/", std::string("/") + "tmp/",
                                       std::string("/") + "root/", std::string("/") + "home/"};

  const auto continues_a_path = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("._-/$}>*").find(c) != std::string_view::npos;
  };

  Violations violations;
  for (const SourceFile& file : tree) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      for (const std::string& root : roots) {
        const std::size_t at = file.lines[i].find(root);
        if (at == std::string::npos || (at > 0 && continues_a_path(file.lines[i][at - 1]))) continue;
        violations.push_back(fmt::format("{}:{}: a path of some machine: {}", file.path, i + 1, root));
      }
    }
  }
  return violations;
}

namespace {

/// What stands between pairs of backquotes.
std::vector<std::string> quoted(const std::string& line) {
  std::vector<std::string> found;
  for (std::size_t from = line.find('`'); from != std::string::npos; from = line.find('`', from)) {
    const std::size_t to = line.find('`', from + 1);
    if (to == std::string::npos) break;
    found.push_back(line.substr(from + 1, to - from - 1));
    from = to + 1;
  }
  return found;
}

bool looks_like_a_path(const std::string& text) {
  return text.find('/') != std::string::npos && std::all_of(text.begin(), text.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '/' || c == '_' || c == '-' || c == '.';
         });
}

}  // namespace

Violations check_document_paths(const std::vector<SourceFile>& tree) {
  std::set<std::string> there;  // files, and the folders that hold them
  for (const SourceFile& file : tree)
    for (fs::path path = file.path; !path.empty(); path = path.parent_path())
      there.insert(path.generic_string());

  Violations found;
  for (const SourceFile& file : tree) {
    if (!file.path.ends_with(".md")) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i)
      for (std::string path : quoted(file.lines[i])) {
        if (!looks_like_a_path(path)) continue;
        if (path.ends_with('/')) path.pop_back();

        const std::string first = path.substr(0, path.find('/'));
        const std::string last = path.substr(path.rfind('/') + 1);
        if (std::all_of(last.begin(), last.end(), [](unsigned char c) { return std::isupper(c) != 0; }))
          continue;

        const bool of_room = there.contains("src/" + first);
        if (!of_room && !there.contains(first)) continue;
        if (!there.contains(path) && !(of_room && there.contains("src/" + path)))
          found.push_back(fmt::format("{}:{}: there is no '{}'", file.path, i + 1, path));
      }
  }
  return found;
}

}  // namespace house
