// Reads a SPIR-V module, as compilers write it, into tables. The input is not trusted: every id, length and
// type is checked.
#pragma once

#include <cstdint>
#include <map>
#include <set>
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
  // Of an opaque type: a texture of two dimensions with numbers, alone or with its sampler; or a sampler.
  bool is_texture = false, is_sampler = false;
  bool is_half = false;     // of a number: of 16 bits, not of 32
  Id element = 0;           // of a vector, matrix, array or pointer
  std::uint32_t count = 0;  // number of elements of a vector, columns of a matrix, length of an array
  std::vector<Id> members = {};
  std::uint32_t storage = 0;  // of a pointer
};

struct Instruction {
  std::uint32_t code = 0;
  Id type = 0, result = 0;                // 0 if there is no type or no result
  std::vector<std::uint32_t> words = {};  // the words after type and result
  std::uint32_t line = 0;                 // of the source, starting at 1; 0: unknown
};

struct Block {
  Id label = 0;
  std::vector<Instruction> code = {};
};

struct Function {
  Id id = 0, type = 0;    // type: the return type
  std::string name = {};  // the name in the source
  std::vector<Id> parameters = {}, parameter_types = {};
  std::vector<Block> blocks = {};
  std::uint32_t line = 0;
};

// The declaration of a constant or a variable.
struct Global {
  Instruction instruction;
  bool variable = false;
};

struct Module {
  std::map<Id, Type> types;
  std::map<Id, Global> globals;
  std::map<Id, Function> functions;
  std::map<Id, std::string> names;
  std::map<Id, std::string> exported;     // names by which a driver or a linker knows functions
  std::map<Id, std::uint32_t> locations;  // of the inputs and outputs of an entry point
  std::map<Id, std::map<std::uint32_t, std::string>> member_names;
  Id entry = 0;          // id of the function that a driver would call
  std::set<Id> relaxed;  // values that a device may compute with less precision
  Id extended = 0;       // id of the set of GLSL's built-in functions

  // Returns the type with this id. Throws InputError if the type is not declared.
  const Type& type(Id id) const;
  // Returns whether a value of this type is a number of 16 bits, or a vector, a matrix or an array of such
  // numbers.
  bool is_half(Id type) const;
  // Returns the number of scalars in a value of this type. Throws InputError for types without scalars and
  // for very large types.
  std::size_t scalars(Id type) const;
  // Returns the name in the module; empty if the module gives no name.
  std::string name(Id id) const;
  // Returns the GLSL name of a type, for messages: "vec3", "uvec2", "float[4]", a struct's own name,
  // "void".
  std::string spelled(Id type) const;
};

// Gives names to functions, arguments and variables of a module that has lost them: the exported name,
// otherwise "%16", the number by which disassemblers show them.
void name_all(Module& module);
// Makes the inputs of the module's entry point its arguments, in the order of their locations, and then its
// first output. Does nothing if the entry point has no inputs, or no output.
void give_arguments(Module& module);

// Reads a module. Line numbers refer to the source file `own`: instructions from other files get line 0. If
// `own` is empty, lines of all files are kept. An instruction for which the module gives no line gets line
// 0, too. Throws InputError if the words are not a module, or if the module is incomplete.
Module parse(std::span<const std::uint32_t> words, const std::string& own = "");

}  // namespace brdf::shader::spirv
