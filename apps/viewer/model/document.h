// SPDX-License-Identifier: MIT
/// The edited document: a scene and the settings that it is drawn with. And every state that it was in, for
/// undo.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/renderer.h"
#include "viewer/model/skin_source.h"

namespace dermis::viewer {

/// An opened scene: the words that name it on a command line, and their result.
struct Opened {
  std::vector<std::string> words;  ///< files and options that choose between them; empty: the built-in head
  SceneOptions options{};
  Scene scene{};
};

struct Document {
  std::shared_ptr<const Opened> opened;
  Scene scene;
  RenderSettings settings{};
  SkinSource skin{};  ///< the source of the profile of the scene's skin, if it was made here
};

/// Returns whether both show the same instances, lights and surroundings.
bool same_contents(const Scene& a, const Scene& b);

/// The document, and how it was before each change.
class History {
 public:
  explicit History(Document first);

  const Document& now() const { return states_[at_].document; }
  /// Grows with every change of what is seen, undo and redo too. The source of a skin shows when its profile
  /// is there, by amend().
  std::uint64_t revision() const { return revision_; }

  /// Takes an edited document. `what` names the change. Changes of one `gesture` (a drag of a slider, say)
  /// are undone together; 0 is none.
  void take(Document next, std::string what, std::uint64_t gesture = 0);

  /// Changes the document as it is, in the same step: for what follows from a change and comes later.
  void amend(Document document);

  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ + 1 < states_.size(); }
  const std::string& undo_name() const { return states_.at(at_).what; }      ///< if can_undo()
  const std::string& redo_name() const { return states_.at(at_ + 1).what; }  ///< if can_redo()
  void undo();
  void redo();

 private:
  struct State {
    Document document;
    std::string what;  ///< the change that led here
    std::uint64_t gesture = 0;
  };
  std::vector<State> states_;
  std::size_t at_ = 0;
  std::uint64_t revision_ = 1;
};

/// Changes that can be undone, at most; the oldest are forgotten.
inline constexpr std::size_t most_undo = 200;

}  // namespace dermis::viewer
