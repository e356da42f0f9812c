#include "render/viewer/messages.h"

#include <iostream>

#include "io/files/text.h"

namespace brdf::render {

void Messages::say(const std::string& message) {
  last_ = message;
  is_error_ = false;
  wake_();
}

void Messages::forget_error() {
  if (is_error_) say("");
}

void Messages::keep(const std::string& error) {
  say(error);
  is_error_ = true;
}

void Messages::complain(const std::exception& error) {
  keep(error.what());
  std::cerr << "brdf: " << io::printable(error.what()) << std::endl;
}

}  // namespace brdf::render
