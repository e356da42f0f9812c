// A SPIR-V module as compilers write it, read into tables. Nothing in it is trusted: every id, length and
// type is checked.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace brdf::shader::spirv {

using Id = std::uint32_t;

enum class Kind {
  none,
  nothing,
  boolean,
  integer,
  number,
  vector,
  matrix,
  array,
  structure,
  pointer,
  opaque
};

struct Type {
  Kind kind = Kind::none;
  bool is_signed = false;
  Id element = 0;           // of a vector, matrix, array or pointer
  std::uint32_t count = 0;  // elements of a vector, columns of a matrix, length of an array
  std::vector<Id> members = {};
  std::uint32_t storage = 0;  // of a pointer
};

struct Instruction {
  std::uint32_t code = 0;
  Id type = 0, result = 0;                // 0 where it has none
  std::vector<std::uint32_t> words = {};  // what follows those
  std::uint32_t line = 0;                 // of the source, from 1; 0: unknown
};

struct Block {
  Id label = 0;
  std::vector<Instruction> code = {};
};

struct Function {
  Id id = 0, type = 0;    // its return type
  std::string name = {};  // as the source has it
  std::vector<Id> parameters = {}, parameter_types = {};
  std::vector<Block> blocks = {};
  std::uint32_t line = 0;
};

// A constant's or a variable's declaration.
struct Global {
  Instruction instruction;
  bool variable = false;
};

struct Module {
  std::map<Id, Type> types;
  std::map<Id, Global> globals;
  std::map<Id, Function> functions;
  std::map<Id, std::string> names;
  std::map<Id, std::map<std::uint32_t, std::string>> member_names;
  Id entry = 0;     // of the function that a driver would call
  Id extended = 0;  // the set of GLSL's functions

  const Type& type(Id id) const;
  // How many scalars a value of that type has. Throws InputError on types that have none, and on huge ones.
  std::size_t scalars(Id type) const;
  std::string name(Id id) const;
  // A type in GLSL's words, for messages: "vec3", "uvec2", "float[4]", a struct's own name, "void".
  std::string spelled(Id type) const;
};

// Lines are those of the file `own`: what stands in another one has none, nor has it a line where `own` is
// not given and the module says nothing. Throws InputError where it is no module, or one of which something
// is left open.
Module parse(std::span<const std::uint32_t> words, const std::string& own = "");

}  // namespace brdf::shader::spirv
