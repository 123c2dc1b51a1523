// SPDX-License-Identifier: MIT
/// State that panels see, and their requests. A panel reads the document as it is, edits a copy, and says
/// what the change is called; the app does the rest.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dermis/error.h"
#include "viewer/model/camera_moves.h"
#include "viewer/model/comparison.h"
#include "viewer/model/document.h"
#include "viewer/model/painter.h"
#include "viewer/model/recording.h"
#include "viewer/model/shown_maps.h"
#include "viewer/model/skin_maker.h"

namespace dermis::viewer {

/// The comparison of A with B.
struct CompareState {
  CompareMode mode = CompareMode::off;
  bool truth = false;              ///< B is ground truth
  std::optional<Document> kept{};  ///< else this, seen by the camera of A
  std::uint64_t kept_serial = 0;   ///< another one after each that was kept
  float at = 0.5f;                 ///< of the slider, 0 to 1
  bool slides = false;             ///< it is being dragged
  bool is_on() const { return mode != CompareMode::off && (truth || kept); }
};

inline constexpr double blink_s = 0.6;  ///< of A, and of B

/// State of the window: nothing of it reaches a file.
struct ViewState {
  bool panels = true;              ///< shown
  bool fixed_size = false;         ///< pictures have the size of the settings, not that of the window
  std::optional<LightId> light{};  ///< that is selected
  bool playing = false;            ///< a clip
  bool loops = true;
  std::string save_name = "skin";
  Recording recording{};
  bool records = false;   ///< a sequence is being drawn
  std::string message{};  ///< of the last action or error
  bool is_error = false;
  std::vector<std::string> notes{};  ///< of the library, newest last
  std::string command_line{};        ///< copied last
  CompareState compare{};
  std::string show = first_shown;  ///< output.show of the window
  bool timed = false, loupe = false;
  std::optional<std::array<float, 2>> pointer{};  ///< in the picture, 0 to 1
  std::vector<float> frame_ms{};                  ///< of the last pictures
  std::string shader_errors{};                    ///< of shaders that are edited
  bool scale = true;                              ///< a bar of millimetres in the picture
  std::string exported{};                         ///< skin in another system's parameters, shown last
};

/// Requests to the app after a frame of the panels.
struct Requests {
  std::vector<std::string> open{};
  bool undo = false, redo = false, frame = false;
  bool save_png = false, save_exr = false, save_settings = false, save_scene = false, save_profile = false,
       copy_command = false, record = false, stop_recording = false;
  std::optional<std::size_t> page{};  ///< number of the page to be written
  bool profile_page = false;
};

struct Desk {
  const Document& now;
  const HeadSphere& sphere;
  const Painted* shown;  ///< the picture in the window, or null
  const MadeSkin* skin;  ///< the last result for the skin of the document, or null
  const std::string& skin_doing;
  const Painted* shown_b;         ///< B in the same view, or null: it has not come yet
  const Comparison* comparison;   ///< of the two, or null
  const std::string& truth_text;  ///< progress of the truth
  int truth_divisor;
  ViewState& view;
  Requests& requests;

  /// Takes an edited document: changed("exposure", document).
  void changed(std::string what, Document document) {
    change = std::move(what);
    next = std::move(document);
  }
  /// Edits a copy of the document. An InputError of the edit is shown, and nothing changes.
  template <class Edit>
  void edit(std::string what, const Edit& edit) {
    try {
      Document document = next.value_or(now);
      edit(document);
      changed(std::move(what), std::move(document));
    } catch (const InputError& error) {
      view.message = error.what();
      view.is_error = true;
    }
  }

  std::optional<Document> next{};
  std::string change{};
};

// The panels, each the contents of a tab.
void picture_panel(Desk& desk);  ///< technique, quality, camera, output
void light_panel(Desk& desk);
void skin_panel(Desk& desk);
void compare_panel(Desk& desk);
void animation_panel(Desk& desk);
void inside_panel(Desk& desk);
void save_panel(Desk& desk);

/// The picture itself, and the mouse in it. `moving`: the picture is smaller than it will be.
void picture_view(Desk& desk, const Painted* shown);

}  // namespace dermis::viewer
