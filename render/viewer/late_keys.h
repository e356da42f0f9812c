// Keys that come while a text field closes: Dear ImGui wants text for some frames more, and they are not for
// it.
#pragma once

#include <utility>
#include <vector>

namespace brdf::render {

struct LateKey {
  int key, mods;  // GLFW's
};

class LateKeys {
 public:
  // A field closes: keys wait for so many frames.
  void wait(int frames) { frames_ = frames; }
  bool waiting() const { return frames_ > 0; }
  void add(const LateKey& key) { keys_.push_back(key); }
  // A frame was drawn; the keys that are the window's now.
  std::vector<LateKey> after_frame() {
    if (frames_ == 0 || --frames_ > 0) return {};
    return std::exchange(keys_, {});
  }

 private:
  int frames_ = 0;
  std::vector<LateKey> keys_;
};

}  // namespace brdf::render
