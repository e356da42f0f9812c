// Implements lower(): one pass over the code from the entry function, with calls inlined.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>

#include "shader/program/lower.h"

namespace brdf::shader {

using Slot = std::uint32_t;
using Slots = std::vector<Slot>;
using spirv::Id;

// Returns "line 12: ", the prefix of error messages; empty if the line is unknown.
std::string at_line(std::uint32_t line);

class Lowering {
 public:
  Lowering(const spirv::Module& module, const LowerOptions& options) : module_(module), options_(options) {}
  Program run(const spirv::Function& entry);

 private:
  // Scalars in memory. Number k of the value is slot numbers + k or integers + k, depending on its kind.
  struct Variable {
    Slot numbers = 0, integers = 0;
    std::vector<bool> integer = {};          // for each scalar
    std::map<std::size_t, Slot> known = {};  // in this stretch: slots that hold the value of a scalar
    std::set<std::size_t> unwritten = {};    // subset of `known` that is not yet in the variable's own slots
  };
  struct Pointer {
    Variable* to = nullptr;
    Id type = 0;  // of the object that it points to
    std::size_t offset = 0;
    std::optional<Slot> index = {};  // an integer that is added to the offset
  };
  // An argument of a call: a pointer, the scalars of a value, or a texture.
  struct Argument {
    std::optional<Pointer> pointer = {};
    Slots slots = {};
    std::optional<const Texture*> texture = {};
  };
  // Two neighbouring texels along one axis, and the share of the second in a bilinear sample.
  struct Neighbours {
    Slot first, second, share;
  };
  // One inlined call.
  struct Frame {
    const spirv::Function* function = nullptr;
    std::map<Id, std::pair<Id, Slots>> values = {};  // type and slots
    std::map<Id, Pointer> pointers = {};
    std::map<Id, const Texture*> textures = {};   // null: a sampler
    std::map<Id, std::uint32_t> stretch_of = {};  // stretch of each label
    std::map<Id, const spirv::Block*> blocks = {};
    struct Jump {
      std::uint32_t stretch;
      int which;
      Id label;
    };
    std::vector<Jump> jumps = {};
    std::vector<std::pair<std::uint32_t, int>> returns = {};  // jumps to the code after the call
    // The slots to which the returns copy the value, if there are several returns.
    Slots result = {};
    bool returned = false;
  };

  // lower.cpp: control flow
  Slots call(const spirv::Function& function, const std::vector<Argument>& arguments);
  std::pair<Slots, Id> written_value(int argument, const spirv::Function& entry, const Slots& returned,
                                     const std::map<int, Pointer>& written);
  Slots result_of(const spirv::Function& entry, const Slots& returned, const std::map<int, Pointer>& written);
  void block(Frame& frame, const spirv::Block& block, bool last);
  void end(Frame& frame, const spirv::Block& block, const spirv::Instruction& i, bool last);
  void leave(Frame& frame, Slots value, bool last);
  void branch(Frame& frame, const spirv::Block& from, Slot condition, Id yes, Id no);
  void choose(Frame& frame, const spirv::Block& from, const spirv::Instruction& i);
  void jump(Frame& frame, int which, Id from, Id to);
  bool has_phis(const Frame& frame, Id label) const;
  void set_phis(Frame& frame, Id from, Id to);
  void begin_stretch();
  void end_stretch(End end);
  std::optional<Slots> kernel(const spirv::Function& function, const std::vector<Argument>& arguments);

  // lower_random.cpp: numbered random numbers, and several results
  void begin_random();
  Slot next_random();
  Slots random_value(const spirv::Function& function);
  Slots results_apart(const spirv::Function& entry, const Slots& returned,
                      const std::map<int, Pointer>& written);

  // lower_values.cpp
  const std::vector<bool>& kinds(Id type);
  Variable& new_variable(Id type);
  Variable& global_variable(Id id);
  void make_input(Variable& variable, Id type, const std::string& name, int argument, std::size_t offset = 0);
  Slots value(Frame& frame, Id id);
  Slot scalar(Frame& frame, Id id) { return value(frame, id).at(0); }
  Id type_of(Frame& frame, Id id);
  Slots constant(Id id);
  Slot number_constant(double value);
  Slot integer_constant(std::uint32_t value);
  Pointer pointer(Frame& frame, Id id);
  Pointer chain(Frame& frame, const spirv::Instruction& i);
  Slots load(const Pointer& from);
  void store(const Pointer& to, const Slots& value);
  void clear(Variable& variable, Unset why = Unset::variable);
  void set_zero(Variable& variable);
  Slot undefined(bool integer, Unset why);
  Slots undefined_value(Id type, Unset why);
  void write_back(Variable& variable);
  void remember(Variable& variable, std::size_t k, Slot slot, bool written);
  // Returns the index of the first scalar of a part of a composite, and the part's type.
  std::pair<std::size_t, Id> part(Id type, std::span<const std::uint32_t> path);
  std::optional<Slots> composite(Frame& frame, const spirv::Instruction& i);

  // lower_operations.cpp
  void instruction(Frame& frame, const spirv::Instruction& i);
  Slots operation(Frame& frame, const spirv::Instruction& i);
  Slots matrix(Frame& frame, const spirv::Instruction& i);
  Slots convert(Frame& frame, const spirv::Instruction& i);
  Slots select(Frame& frame, const spirv::Instruction& i);
  // lower_functions.cpp: GLSL's built-in functions
  Slots function(Frame& frame, const spirv::Instruction& i);
  Slots geometric(Frame& frame, const spirv::Instruction& i, std::uint32_t which);
  std::uint32_t whole_exponent(Slot slot) const;
  Slot dot(const Slots& a, const Slots& b);
  Slots scaled(const Slots& a, Slot by);

  Slot emit(Op op, Slot a = 0, Slot b = 0, Slot c = 0);
  void emit_to(Op op, Slot r, Slot a, Slot b = 0, Slot c = 0);
  // lower_textures.cpp
  bool is_opaque(Id type) const;
  const Texture* texture_named(const std::string& name, Id type) const;
  const Texture* texture_of(const Frame& frame, Id id) const;
  bool passes_texture(Frame& frame, const spirv::Instruction& i);
  std::optional<Slots> read_texture(Frame& frame, const spirv::Instruction& i);
  Slot texel(const Texture& texture, std::size_t channel, Slot place);
  Slot texel_place(const Texture& texture, Slot x, Slot y);
  Slots fetched(const Texture& texture, const Slots& at);
  Slot wrapped(TextureWrap wrap, Slot u);
  Neighbours neighbours(const Texture& texture, std::uint32_t size, Slot u);
  Slots sampled(const Texture& texture, const Slots& at);
  // lower_half.cpp: half precision
  bool is_narrow(const spirv::Instruction& i) const;
  bool is_narrow_result(Id value, Id type) const;
  static bool needs_rounding(Op op);
  Slot to_half(Slot slot);
  Slot half_input(Slot slot);
  Slot half_constant(std::uint32_t bits);
  Slots to_half(Slots slots, Id type);
  [[noreturn]] void refuse(const std::string& what) const;

  const spirv::Module& module_;
  const LowerOptions& options_;
  Program program_;
  std::map<Id, std::vector<bool>> kinds_;
  std::vector<std::unique_ptr<Variable>> variables_;
  std::map<Id, Variable*> globals_;
  std::vector<Variable*> touched_;  // variables with known values in this stretch
  std::map<std::uint64_t, Slot> number_constants_;
  std::map<std::uint32_t, Slot> integer_constants_;
  // Results of the operations in this stretch.
  std::map<std::tuple<Op, Slot, Slot, Slot, bool>, Slot> computed_;
  // The instruction that is lowered computes in half precision.
  bool narrow_ = false;
  std::set<Slot> halves_;      // slots that hold numbers of half precision
  std::vector<Step> prelude_;  // precedes the first stretch
  Slot random_ = 0;            // the first number of kRandomInput
  Slot random_count_ = 0;      // integer slot: the numbers used so far
  std::uint32_t line_ = 0;
  std::size_t steps_ = 0;
  int depth_ = 0;
};

}  // namespace brdf::shader
