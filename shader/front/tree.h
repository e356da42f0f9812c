// What is done to the compiler's tree before it becomes SPIR-V: glslang 12 reads the top of an empty stack in
// two cases, which ends the process or not as it happens.
#pragma once

#include <optional>
#include <string>

namespace glslang {
class TIntermediate;
}

namespace brdf::shader {

// Global variables get their values at the beginning of the entry `name`, where a scope is open, in place of
// before any function. Their order stays.
void move_initialisers(glslang::TIntermediate& tree, const char* name);

// A call of a function that has a head and no body, which the compiler takes where nothing calls the caller;
// nothing: there is none.
struct EmptyCall {
  std::string function, file;  // as the compiler names the file
  int line = 0;
};
std::optional<EmptyCall> call_without_body(glslang::TIntermediate& tree);

// Braces open no scopes: without debug information of scopes there is none that they could lie in.
void remove_scopes(glslang::TIntermediate& tree);

}  // namespace brdf::shader
