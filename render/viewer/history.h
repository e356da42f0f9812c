// The changes of a state, step by step, for undo and redo.
#pragma once

#include <string>
#include <vector>

#include "render/compare/state.h"

namespace brdf::render {

// Returns whether the states are the same except for changes that no user made: the picture's size, which
// follows the window, and the angle of the turntable.
bool same_edit(const ViewState& a, const ViewState& b);
// Returns the difference in a few words: "the material", "the camera and the lights".
std::string what_differs(const ViewState& a, const ViewState& b);

class History {
 public:
  explicit History(ViewState first) : states_{std::move(first)} {}

  // Records the state as a step if it differs from the last step, and discards undone steps.
  void record(const ViewState& state);
  // Go to the previous or the next state; null at the ends.
  const ViewState* back();
  const ViewState* forth();
  const ViewState& now() const { return states_[place_]; }
  std::size_t steps() const { return place_; }

 private:
  std::vector<ViewState> states_;
  std::size_t place_ = 0;
};

}  // namespace brdf::render
