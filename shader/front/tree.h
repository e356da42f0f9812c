// Changes to the compiler's tree before it becomes SPIR-V. They avoid two cases in which glslang 12 reads
// the top of an empty stack, which may or may not crash the process.
#pragma once

#include <optional>
#include <string>

namespace glslang {
class TIntermediate;
}

namespace brdf::shader {

// Moves the initialisers of global variables to the beginning of the entry function `name`, where a scope
// is open, instead of before any function. Their order does not change.
void move_initialisers(glslang::TIntermediate& tree, const char* name);

// A call of a function without a body.
struct EmptyCall {
  std::string function, file;  // with the name that the compiler uses
  int line = 0;
};
// Returns a call of a function that is declared but not defined; std::nullopt if all called functions are
// defined. The compiler accepts such a call if nothing calls the caller.
std::optional<EmptyCall> call_without_body(glslang::TIntermediate& tree);

// Makes braces open no scopes. Without debug information on scopes, no enclosing scope exists for them.
void remove_scopes(glslang::TIntermediate& tree);

}  // namespace brdf::shader
