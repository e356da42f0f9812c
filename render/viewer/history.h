// What was done to a state, step by step, to go back and forth.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/compare/state.h"

namespace brdf::render {

// Whether they are the same but for what no hand has done: the picture's size, which is the window's, and how
// far the turntable has turned.
bool same_edit(const ViewState& a, const ViewState& b);
// What differs, in a few words: "the material", "the camera and the lights".
std::string what_differs(const ViewState& a, const ViewState& b);

class History {
 public:
  explicit History(ViewState first) : states_{std::move(first)} {}

  // Makes the state a step of its own where it differs from the last one; what was undone is then forgotten.
  void record(const ViewState& state);
  // The state before, or after; none at the ends.
  const ViewState* back();
  const ViewState* forth();
  const ViewState& now() const { return states_[place_]; }
  std::size_t steps() const { return place_; }

 private:
  std::vector<ViewState> states_;
  std::size_t place_ = 0;
};

}  // namespace brdf::render
