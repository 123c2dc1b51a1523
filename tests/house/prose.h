// SPDX-License-Identifier: MIT
// The rules of prose: sentences of Markdown, of comments, and of the texts that programs print.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "house/check.h"

namespace house {

struct Sentence {
  std::size_t line = 0;  ///< of the file, from 1, in which its text begins
  int words = 0;         ///< code between backquotes counts as one word, a link as its text
  std::string text;
};

/// Text that belongs together, of one line or several: a sentence ends with it.
struct Block {
  std::size_t line = 0;
  std::string text;
};

/// Without spaces at both ends.
std::string trimmed(const std::string& text);

/// Words with a letter or a digit.
int count_words(const std::string& text);

/// The text as it is read: code becomes one word, a link its text, and abbreviations end no sentence.
std::string as_read(std::string text);

/// Sentences of a text.
std::vector<Sentence> split(const Block& block);

/// Whether the subject of the sentence is a clause ("What a frame costs is ..."). Questions have none.
bool has_clause_subject(const std::string& sentence);

/// Sentences of the comments of C++ and of shaders. Lines of code, of formulas and of usage in a comment
/// (three spaces or more before them) are left out.
std::vector<Sentence> sentences_of_comments(const SourceFile& file);

/// Sentences of string literals, adjacent ones joined, that hold a space: helps and messages.
std::vector<Sentence> sentences_of_texts(const SourceFile& file);

/// A sentence and its file.
struct Found {
  std::string path;
  Sentence sentence;
};

/// Comments of the library, the programs and the Python module that are hard to read.
struct HardComments {
  std::vector<Found> clauses;  ///< whose subject is a clause
  std::vector<Found> longs;    ///< of more than `most_words` words, the longest first
};
HardComments hard_comments(const std::vector<SourceFile>& tree, int most_words);

/// Texts of the library and the programs with a clause as subject, or of more words than that per sentence.
Violations check_texts(const std::vector<SourceFile>& tree, int most_words);

}  // namespace house
