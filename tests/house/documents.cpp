// SPDX-License-Identifier: MIT
#include "house/documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <utility>

namespace house {

namespace fs = std::filesystem;

namespace {

bool is_markdown(const SourceFile& file) { return file.path.ends_with(".md"); }
bool is_note(const SourceFile& file) { return file.path.starts_with("docs/notes/"); }
bool is_fence(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" ");
  return first != std::string::npos && line.compare(first, 3, "```") == 0;
}

class Blocks {
 public:
  void read(const SourceFile& file) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) add(i + 1, file.lines[i]);
    end();
  }
  std::vector<Block> found;

 private:
  void end() {
    if (count_words(open_.text) > 0) found.push_back(open_);
    open_ = {};
  }
  void begin(std::size_t line, const std::string& text) {
    end();
    open_ = {line, text};
  }

  void add_row(std::size_t line, const std::string& row) {
    static const std::regex border(R"([^\\]\|)");
    std::string rest = row;
    for (std::smatch match; std::regex_search(rest, match, border); rest = match.suffix())
      begin(line, trimmed(match.prefix().str() + match.str()[0]));
    end();
  }

  void add(std::size_t line, const std::string& raw) {
    const std::string text = trimmed(raw);
    if (is_fence(raw)) fenced_ = !fenced_;
    if (text.starts_with("<!--")) written_ = text.find(": written by ") != std::string::npos;
    const bool is_code = raw.starts_with("    ") && open_.text.empty();
    if (fenced_ || written_ || is_fence(raw) || is_code || text.empty() || text.starts_with("<!--"))
      return end();

    static const std::regex item(R"(^([*-]|\d+\.|#+)\s+)");
    std::smatch marker;
    if (text.front() == '|') return add_row(line, text.substr(1) + " ");
    if (std::regex_search(text, marker, item)) return begin(line, marker.suffix());
    if (open_.text.empty()) return begin(line, text);
    open_.text += " " + text;
  }

  Block open_;
  bool fenced_ = false, written_ = false;
};

/// As GitHub makes it: lower case, spaces as '-', without punctuation.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : as_read(heading)) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') anchor += '-';
    if (std::isalnum(byte) != 0 || byte >= 0x80 || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

std::set<std::string> anchors_of(const SourceFile& file) {
  std::set<std::string> anchors;
  bool fenced = false;
  for (const std::string& line : file.lines) {
    if (is_fence(line)) fenced = !fenced;
    const std::size_t text = line.find_first_not_of('#');
    if (fenced || text == 0 || text == std::string::npos || line[text] != ' ') continue;

    const std::string anchor = anchor_of(trimmed(line.substr(text)));
    int number = 0;
    std::string own = anchor;
    while (!anchors.insert(own).second) own = fmt::format("{}-{}", anchor, ++number);
  }
  return anchors;
}

/// Targets of the links of a line that are no addresses of the network.
std::vector<std::string> targets_of(const std::string& line) {
  static const std::regex code("`[^`]*`"), link(R"(\]\(([^)\s]+)\))"), address("^[a-z]+:.*");
  const std::string text = std::regex_replace(line, code, "");
  std::vector<std::string> targets;
  for (std::sregex_iterator it(text.begin(), text.end(), link); it != std::sregex_iterator(); ++it)
    if (!std::regex_match((*it)[1].str(), address)) targets.push_back((*it)[1]);
  return targets;
}

/// What is wrong with a link; nothing where it leads somewhere.
std::optional<std::string> judge_link(const SourceFile& from, const std::string& target, const fs::path& root,
                                      const std::map<std::string, std::set<std::string>>& anchors) {
  const std::size_t hash = target.find('#');
  const std::string file = target.substr(0, hash);
  const fs::path beside = fs::path(from.path).parent_path() / file;
  std::string path = file.empty() ? from.path : beside.lexically_normal().generic_string();
  if (!fs::exists(root / path)) return fmt::format("the link leads nowhere: {}", target);

  const auto headings = anchors.find(path);
  if (hash == std::string::npos || headings == anchors.end()) return std::nullopt;
  if (headings->second.contains(target.substr(hash + 1))) return std::nullopt;
  return fmt::format("there is no such heading: {}", target);
}

}  // namespace

bool is_document(const SourceFile& file) {
  return is_markdown(file) && (file.path == "README.md" || file.path.starts_with("docs/"));
}

std::vector<Sentence> sentences_of(const SourceFile& file) {
  Blocks blocks;
  blocks.read(file);

  std::vector<Sentence> sentences;
  for (const Block& block : blocks.found)
    for (Sentence& sentence : split(block)) sentences.push_back(std::move(sentence));
  return sentences;
}

Violations check_sentences(const std::vector<SourceFile>& tree, int most_words) {
  Violations violations;
  for (const SourceFile& file : tree) {
    if (!is_document(file)) continue;
    for (const Sentence& sentence : sentences_of(file)) {
      if (sentence.words > most_words)
        violations.push_back(fmt::format("{}:{}: a sentence of {} words: {}", file.path, sentence.line,
                                         sentence.words, trimmed(sentence.text)));
      if (has_clause_subject(sentence.text))
        violations.push_back(fmt::format("{}:{}: the subject is a clause: {}", file.path, sentence.line,
                                         trimmed(sentence.text)));
    }
  }
  return violations;
}

int count_long_sentences_elsewhere(const std::vector<SourceFile>& tree, int most_words) {
  int count = 0;
  for (const SourceFile& file : tree) {
    if (!is_markdown(file) || is_document(file)) continue;
    const std::vector<Sentence> sentences = sentences_of(file);
    count += static_cast<int>(std::count_if(sentences.begin(), sentences.end(),
                                            [&](const Sentence& s) { return s.words > most_words; }));
  }
  return count;
}

Violations check_commits(const std::vector<SourceFile>& tree) {
  static const std::regex hash(R"((^|[^0-9A-Za-z#_/.-])([0-9a-f]{7,40})($|[^0-9A-Za-z_/-]))");
  const auto holds = [](const std::string& text, int (*kind)(int)) {
    return std::any_of(text.begin(), text.end(), [&](unsigned char c) { return kind(c) != 0; });
  };

  Violations violations;
  for (const SourceFile& file : tree) {
    if (!is_document(file)) continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      std::string rest = file.lines[i];
      for (std::smatch match; std::regex_search(rest, match, hash); rest = match.suffix()) {
        const std::string found = match[2];
        if (holds(found, std::isdigit) && holds(found, std::isalpha))
          violations.push_back(fmt::format("{}:{}: names the commit {}", file.path, i + 1, found));
      }
    }
  }
  return violations;
}

Violations check_links(const std::vector<SourceFile>& tree, const fs::path& root) {
  std::map<std::string, std::set<std::string>> anchors;
  for (const SourceFile& file : tree)
    if (is_markdown(file)) anchors.emplace(file.path, anchors_of(file));

  Violations violations;
  for (const SourceFile& file : tree) {
    if (!is_markdown(file)) continue;
    bool fenced = false;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      if (is_fence(file.lines[i])) fenced = !fenced;
      if (fenced) continue;
      for (const std::string& target : targets_of(file.lines[i])) {
        if (const auto broken = judge_link(file, target, root, anchors))
          violations.push_back(fmt::format("{}:{}: {}", file.path, i + 1, *broken));
      }
    }
  }
  return violations;
}

DocumentBytes bytes_of_documents(const std::vector<SourceFile>& tree) {
  DocumentBytes bytes;
  for (const SourceFile& file : tree) {
    if (!is_document(file)) continue;
    std::size_t& sum = is_note(file) ? bytes.notes : bytes.documents;
    for (const std::string& line : file.lines) sum += line.size() + 1;
  }
  return bytes;
}

}  // namespace house
