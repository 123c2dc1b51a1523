// SPDX-License-Identifier: MIT
// The openings of the face: between the lids and between the lips. The net runs
// through each of them as a pouch: over the edge, along the inner side, and behind the eyeball or into the
// throat. So the skin stays one closed sheet with one chart. Nodes of the pouches are set, not relaxed.
#pragma once

#include <vector>

#include "head/builtin_head/sculpture.h"
#include "head/builtin_head/wrap.h"

namespace dermis::builtin_head {

/// A block of nodes of the net on the left half (the eye) or across the middle (the mouth).
struct Opening {
  int from = 0, to = 0;  ///< columns of the corners
  int middle = 0;        ///< row; the edges of the opening run `Openings::half` rows above and below
};

class Openings {
 public:
  static constexpr int columns = 144, rows = 120;  ///< of the net that the blocks are counted in
  static constexpr int half = 4;                   ///< rows from the middle of a pouch to its edge
  static constexpr Opening eye{80, 100, 80};
  static constexpr Opening mouth{52, 92, 40};

  explicit Openings(const Sculpture& bust);
  /// Puts the nodes of the openings in their places; the net may be coarser by 2 or 4.
  void place(Net& net) const;

 private:
  struct Node {
    int i = 0, j = 0;
    vec3 at_mm{0};
  };
  void add_eye(const Sculpture& bust, float side);
  void add_mouth(const Sculpture& bust);
  std::vector<Node> nodes_;
};

/// Returns whether node (i, j) of a net of the full size belongs to an opening, edge included.
bool in_opening(int i, int j);
/// Returns whether cell (i, j) lies inside: its skin is lid margin, conjunctiva or the lining of the mouth.
bool cell_in_opening(int i, int j);

/// The eyeball, in the symmetric face. Millimetres.
inline const vec3 eye_centre(31.4f, 0.0f, 67.4f);
inline constexpr float eyeball_mm = 12.0f;

}  // namespace dermis::builtin_head
