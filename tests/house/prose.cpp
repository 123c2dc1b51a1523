// SPDX-License-Identifier: MIT
#include "house/prose.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>

namespace house {

namespace {

bool has_any_prefix(const std::string& path, std::initializer_list<std::string_view> prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](std::string_view prefix) { return path.starts_with(prefix); });
}

/// Where the comment of a line begins, outside of string literals.
std::optional<std::size_t> comment_in(const std::string& line) {
  bool quoted = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (quoted && line[i] == '\\')
      ++i;
    else if (line[i] == '"' && (i == 0 || line[i - 1] != '\''))
      quoted = !quoted;
    else if (!quoted && line[i] == '/' && line[i + 1] == '/')
      return i;
  }
  return std::nullopt;
}

/// Text of comments, joined from line to line.
class Comments {
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

  void add(std::size_t line, const std::string& raw) {
    const auto at = comment_in(raw);
    if (!at || raw.find("SPDX-") != std::string::npos) return end();
    const bool own_line = trimmed(raw.substr(0, *at)).empty();
    // A comment behind code goes on in lines below it, where it began.
    const bool goes_on = own_line && (*at == column_ || of_lines_);
    if (!goes_on) end();
    column_ = *at;
    of_lines_ = own_line && (of_lines_ || open_.text.empty());

    std::size_t text = *at + 2;
    while (text < raw.size() && (raw[text] == '/' || raw[text] == '!' || raw[text] == '<')) ++text;
    const bool is_code = raw.compare(text, 3, "   ") == 0 && own_line && raw.compare(*at, 4, "///<") != 0;
    std::string words = trimmed(raw.substr(std::min(text, raw.size())));
    if (words.empty() || is_code) return end();
    if (words.starts_with("- ")) {
      end();
      words.erase(0, 2);
    }

    if (open_.text.empty())
      open_ = {line, words};
    else
      open_.text += " " + words;
  }

  Block open_;
  std::size_t column_ = 0;
  bool of_lines_ = false;  ///< each line of the comment stands by itself
};

/// String literals of C++, adjacent ones joined. Raw literals are left out: they hold style sheets and code.
class Literals {
 public:
  void read(const SourceFile& file) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) read_line(i + 1, file.lines[i]);
    end();
  }
  std::vector<Block> found;

 private:
  void end() {
    if (!open_.text.empty()) found.push_back(open_);
    open_ = {};
  }

  /// Returns where the raw literal ends that the line begins in, or its end.
  std::size_t skip_raw(const std::string& line, std::size_t at) {
    const std::size_t close = line.find(raw_end_, at);
    if (close == std::string::npos) return line.size();
    const std::size_t next = close + raw_end_.size();
    raw_end_.clear();
    return next;
  }

  std::size_t add(std::size_t number, const std::string& line, std::size_t open) {
    if (open_.text.empty()) open_.line = number;
    std::size_t i = open + 1;
    for (; i < line.size() && line[i] != '"'; ++i) {
      if (line[i] == '\\') {
        ++i;
        open_.text += i < line.size() && line[i] == 'n' ? '\n' : i < line.size() ? line[i] : ' ';
      } else {
        open_.text += line[i];
      }
    }
    return i + 1;
  }

  void read_line(std::size_t number, const std::string& line) {
    if (trimmed(line).starts_with("#include")) return;
    for (std::size_t i = 0; i < line.size();) {
      if (!raw_end_.empty()) {
        i = skip_raw(line, i);
      } else if (line.compare(i, 2, "//") == 0) {
        return;
      } else if (line.compare(i, 3, "'\"'") == 0 || line.compare(i, 4, "'\\\"'") == 0) {
        i += line[i + 1] == '"' ? 3 : 4;
      } else if (line.compare(i, 2, "R\"") == 0 && line.find('(', i) != std::string::npos) {
        const std::size_t open = line.find('(', i);
        raw_end_ = ")" + line.substr(i + 2, open - i - 2) + "\"";
        i = open + 1;
      } else if (line[i] == '"') {
        i = add(number, line, i);
      } else {
        if (std::isspace(static_cast<unsigned char>(line[i])) == 0) end();
        ++i;
      }
    }
  }

  Block open_;
  std::string raw_end_;
};

}  // namespace

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

int count_words(const std::string& text) {
  std::istringstream words(text);
  int count = 0;
  for (std::string word; words >> word;)
    count += std::any_of(word.begin(), word.end(),
                         [](unsigned char c) { return std::isalnum(c) != 0 || c >= 0x80; })
                 ? 1
                 : 0;
  return count;
}

std::string as_read(std::string text) {
  static const std::regex code("`[^`]*`"), link(R"(!?\[([^\]]*)\]\([^)]*\))"),
      short_form(R"(\b(e\.g|i\.e|et al|ch|sec|eq)\. )");
  text = std::regex_replace(text, code, "code");
  text = std::regex_replace(text, link, "$1");
  return std::regex_replace(text, short_form, "$1 ");
}

std::vector<Sentence> split(const Block& block) {
  static const std::regex end(R"x([.!?][*_)"']*\s+)x");
  std::vector<Sentence> sentences;
  std::string rest = as_read(block.text) + " ";
  for (std::smatch match; std::regex_search(rest, match, end); rest = match.suffix()) {
    const std::string text = match.prefix().str() + match.str()[0];
    sentences.push_back({block.line, count_words(text), text});
  }
  if (!trimmed(rest).empty()) sentences.push_back({block.line, count_words(rest), rest});
  return sentences;
}

bool has_clause_subject(const std::string& sentence) {
  static const std::regex clause(
      R"(^[("'\s]*([Ww]hat|[Hh]ow|[Ww]hich|[Ww]ho|[Ww]hatever|[Ww]hoever)\b[^(].*)");
  const std::string text = trimmed(sentence);
  return !text.ends_with('?') && std::regex_match(text, clause);
}

std::vector<Sentence> sentences_of_comments(const SourceFile& file) {
  Comments comments;
  comments.read(file);
  std::vector<Sentence> sentences;
  for (const Block& block : comments.found)
    for (Sentence& sentence : split(block)) sentences.push_back(std::move(sentence));
  return sentences;
}

std::vector<Sentence> sentences_of_texts(const SourceFile& file) {
  Literals literals;
  literals.read(file);
  std::vector<Sentence> sentences;
  for (const Block& literal : literals.found) {
    if (literal.text.find(' ') == std::string::npos) continue;
    std::istringstream lines(literal.text);
    for (std::string line; std::getline(lines, line);)
      for (Sentence& sentence : split({literal.line, line})) sentences.push_back(std::move(sentence));
  }
  return sentences;
}

HardComments hard_comments(const std::vector<SourceFile>& tree, int most_words) {
  HardComments hard;
  for (const SourceFile& file : tree) {
    if (!is_code(file.path) || !has_any_prefix(file.path, {"src/", "include/", "apps/", "python/src/"}))
      continue;
    for (Sentence& sentence : sentences_of_comments(file)) {
      if (has_clause_subject(sentence.text)) hard.clauses.push_back({file.path, sentence});
      if (sentence.words > most_words) hard.longs.push_back({file.path, std::move(sentence)});
    }
  }
  std::stable_sort(hard.longs.begin(), hard.longs.end(),
                   [](const Found& a, const Found& b) { return a.sentence.words > b.sentence.words; });
  return hard;
}

Violations check_texts(const std::vector<SourceFile>& tree, int most_words) {
  Violations violations;
  for (const SourceFile& file : tree) {
    if (!is_code(file.path) || is_shader(file.path) || !has_any_prefix(file.path, {"src/", "apps/"}))
      continue;
    for (const Sentence& sentence : sentences_of_texts(file)) {
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

}  // namespace house
