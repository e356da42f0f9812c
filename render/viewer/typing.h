// Numbers that are typed into a slider's field. Each keystroke changes the number in the field, but the
// material takes the number only on Enter, or after a pause.
#pragma once

#include <optional>

namespace brdf::render {

class Typing {
 public:
  static constexpr double kPause = 0.8;  // seconds without a keystroke

  // Call once per frame for each field. `open`: the field is open for typing; `typed`: the number in the
  // field, if it changed in this frame; `now` in seconds. Returns the number to apply, if there is one.
  std::optional<double> follow(unsigned field, bool open, std::optional<double> typed, double now) {
    if (open && typed) {
      field_ = field;
      number_ = typed;
      since_ = now;
    }
    if (!number_ || field != field_ || (open && now - since_ < kPause)) return std::nullopt;
    const std::optional<double> applied = number_;
    number_.reset();
    return applied;
  }

 private:
  unsigned field_ = 0;
  std::optional<double> number_;
  double since_ = 0;
};

}  // namespace brdf::render
