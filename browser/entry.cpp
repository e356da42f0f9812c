// The functions that the page's worker calls. Texts are UTF-8 with a final 0; an answer is valid until the
// next call.
#include <emscripten.h>

#include <cstddef>
#include <string>

#include "browser/session.h"

namespace {

EM_JS(void, show_progress, (const char* text, double share), {
  if (Module.onProgress) Module.onProgress(UTF8ToString(text), share);
});

EM_JS(void, show_first_result, (const char* text), {
  if (Module.onFitted) Module.onFitted(UTF8ToString(text));
});

brdf::browser::Session& session() {
  static brdf::browser::Session made(
      {[](const std::string& text, double share) { show_progress(text.c_str(), share); },
       [](const std::string& text) { show_first_result(text.c_str()); }});
  return made;
}

std::string answer;

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE char* brdf_put(const char* name, std::size_t size) {
  return session().put(name, size);
}

EMSCRIPTEN_KEEPALIVE void brdf_clear() {
  session().clear();
}

EMSCRIPTEN_KEEPALIVE const char* brdf_call(const char* request) {
  answer = session().answer(request).dump();
  return answer.c_str();
}

EMSCRIPTEN_KEEPALIVE const char* brdf_file(std::size_t k) {
  return session().files().at(k).bytes.data();
}

EMSCRIPTEN_KEEPALIVE std::size_t brdf_size(std::size_t k) {
  return session().files().at(k).bytes.size();
}

}  // extern "C"
