// SPDX-License-Identifier: MIT
// The rules of the documents: sentences, links, size.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "house/check.h"
#include "house/prose.h"

namespace house {

/// README.md, and Markdown below docs/.
bool is_document(const SourceFile& file);

/// Sentences of paragraphs, items of lists, cells of tables and headings. Code, and tables that are written
/// from the code ("<!-- ...: written by ... -->"), are left out.
std::vector<Sentence> sentences_of(const SourceFile& file);

/// Sentences of documents with more words than that, or with a clause as subject.
Violations check_sentences(const std::vector<SourceFile>& tree, int most_words);

/// Number of sentences with more words than that in all other Markdown.
int count_long_sentences_elsewhere(const std::vector<SourceFile>& tree, int most_words);

/// Documents name no commit: records of docs/results do.
Violations check_commits(const std::vector<SourceFile>& tree);

/// Relative links of all Markdown lead to files, and to headings of these. `root` is that of the tree,
/// because pictures are not in it.
Violations check_links(const std::vector<SourceFile>& tree, const std::filesystem::path& root);

/// Bytes of the documents outside of docs/notes, and of those in it.
struct DocumentBytes {
  std::size_t documents = 0, notes = 0;
};
DocumentBytes bytes_of_documents(const std::vector<SourceFile>& tree);

}  // namespace house
