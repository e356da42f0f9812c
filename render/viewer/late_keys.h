// Holds back keys that arrive while a text field closes. Dear ImGui requests text for some more frames,
// although these keys are not meant for the text field.
#pragma once

#include <utility>
#include <vector>

namespace brdf::render {

struct LateKey {
  int key, mods;  // values of GLFW
};

class LateKeys {
 public:
  // Call when a field closes; keys wait for `frames` frames.
  void wait(int frames) { frames_ = frames; }
  bool waiting() const { return frames_ > 0; }
  void add(const LateKey& key) { keys_.push_back(key); }
  // Call after a frame was drawn. Returns the keys that the window may process now.
  std::vector<LateKey> after_frame() {
    if (frames_ == 0 || --frames_ > 0) return {};
    return std::exchange(keys_, {});
  }

 private:
  int frames_ = 0;
  std::vector<LateKey> keys_;
};

}  // namespace brdf::render
