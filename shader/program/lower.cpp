#include "shader/program/lower.h"

#include <algorithm>

#include <glslang/SPIRV/spirv.hpp>
#include <stdexcept>

#include "io/files/error.h"
#include "shader/program/lowering.h"

namespace brdf::shader {
namespace {

constexpr int kDeepestCalls = 64;
constexpr std::uint32_t kMostSlots = 1u << 17;

bool is_end(std::uint32_t code) {
  return code == spv::OpBranch || code == spv::OpBranchConditional || code == spv::OpSwitch ||
         code == spv::OpReturn || code == spv::OpReturnValue || code == spv::OpKill ||
         code == spv::OpUnreachable;
}

// The kernels that exported shaders contain (brdf/trace.h), with the operations that replace them in
// scalars other than float.
struct Kernel {
  const char* name;
  Op op;
  std::size_t operands;
};
constexpr Kernel kKernels[] = {{"brdf_exp", Op::exp, 1},
                               {"brdf_log", Op::log, 1},
                               {"brdf_log1p", Op::log1p, 2},
                               {"brdf_erfcx", Op::erfcx, 1},
                               {"brdf_angle", Op::angle, 2}};

const Kernel* kernel_of(const spirv::Module& module, const spirv::Function& function) {
  const auto found = std::find_if(std::begin(kKernels), std::end(kKernels),
                                  [&](const Kernel& k) { return function.name == k.name; });
  if (found == std::end(kKernels) || function.parameters.size() != found->operands) return nullptr;
  if (module.type(function.type).kind != spirv::Kind::number) return nullptr;
  return &*found;
}

}  // namespace

std::string at_line(std::uint32_t line) {
  return line > 0 ? "line " + std::to_string(line) + ": " : "";
}

void Lowering::refuse(const std::string& what) const {
  throw InputError(at_line(line_) + what);
}

Slot Lowering::emit(Op op, Slot a, Slot b, Slot c) {
  const bool pure = op != Op::copy && op != Op::icopy && op < Op::load_number;
  const auto key = std::tuple(op, a, b, c, narrow_);
  if (pure)
    if (const auto found = computed_.find(key); found != computed_.end()) return found->second;
  const bool integer = (op >= Op::equal && op <= Op::bits_of) || (op >= Op::icopy && op <= Op::logical_not) ||
                       op == Op::load_integer;
  const Slot r = integer ? program_.integers++ : program_.numbers++;
  emit_to(op, r, a, b, c);
  const Slot result = narrow_ && needs_rounding(op) ? to_half(r) : r;
  if (pure) computed_[key] = result;
  return result;
}

void Lowering::emit_to(Op op, Slot r, Slot a, Slot b, Slot c) {
  if (++steps_ > options_.most_steps || program_.numbers > kMostSlots || program_.integers > kMostSlots)
    refuse("the function, with all functions that it calls, has more than " +
           std::to_string(options_.most_steps) + " operations");
  program_.takes_bits = program_.takes_bits || op == Op::bits_of || op == Op::from_bits;
  program_.stretches.back().steps.push_back({op, r, a, b, c, line_});
}

void Lowering::begin_stretch() {
  if (program_.stretches.size() > options_.most_steps) refuse("the function has too many branches");
  program_.stretches.emplace_back();
  computed_.clear();
  for (Variable* variable : touched_) {
    variable->known.clear();
    variable->unwritten.clear();
  }
  touched_.clear();
}

void Lowering::end_stretch(End end) {
  for (Variable* variable : touched_) write_back(*variable);
  program_.stretches.back().end = end;
  program_.stretches.back().line = line_;
}

bool Lowering::has_phis(const Frame& frame, Id label) const {
  const auto found = frame.blocks.find(label);
  if (found == frame.blocks.end()) refuse("a branch leads nowhere");
  const auto& code = found->second->code;
  return !code.empty() && code.front().code == spv::OpPhi;
}

// Sets the phis of `to` for the edge from `from`. All sources are read before any phi is written.
void Lowering::set_phis(Frame& frame, Id from, Id to) {
  std::vector<std::pair<Slot, std::pair<bool, Slot>>> copies;
  for (const spirv::Instruction& i : frame.blocks.at(to)->code) {
    if (i.code != spv::OpPhi) break;
    const std::vector<bool> integer = kinds(i.type);
    Slots& slots = frame.values.try_emplace(i.result, i.type, Slots{}).first->second.second;
    if (slots.empty())
      for (const bool is : integer) slots.push_back(is ? program_.integers++ : program_.numbers++);
    for (std::size_t k = 0; k + 1 < i.words.size(); k += 2) {
      if (i.words[k + 1] != from) continue;
      const Slots target = slots, source = value(frame, i.words[k]);
      if (source.size() != target.size()) refuse("a value has two types");
      for (std::size_t s = 0; s < source.size(); ++s)
        copies.push_back({target[s], {integer[s], emit(integer[s] ? Op::icopy : Op::copy, source[s])}});
    }
  }
  for (const auto& [target, source] : copies)
    emit_to(source.first ? Op::icopy : Op::copy, target, source.second);
}

void Lowering::jump(Frame& frame, int which, Id, Id to) {
  frame.jumps.push_back({std::uint32_t(program_.stretches.size() - 1), which, to});
}

void Lowering::branch(Frame& frame, const spirv::Block& from, Slot condition, Id yes, Id no) {
  const bool edges[2] = {has_phis(frame, yes), has_phis(frame, no)};
  const Id to[2] = {yes, no};
  end_stretch(End::branch);
  const std::size_t here = program_.stretches.size() - 1;
  program_.stretches[here].condition = condition;
  for (int k = 0; k < 2; ++k) {
    if (!edges[k]) {
      frame.jumps.push_back({std::uint32_t(here), k, to[k]});
      continue;
    }
    begin_stretch();
    program_.stretches[here].next[k] = std::uint32_t(program_.stretches.size() - 1);
    set_phis(frame, from.label, to[k]);
    end_stretch(End::jump);
    jump(frame, 0, from.label, to[k]);
  }
}

// Lowers a switch to a chain of comparisons.
void Lowering::choose(Frame& frame, const spirv::Block& from, const spirv::Instruction& i) {
  if (i.words.size() < 2) refuse("a switch is incomplete");
  const Slot selector = scalar(frame, i.words[0]);
  const Id otherwise = i.words[1];
  for (std::size_t k = 2; k + 1 < i.words.size(); k += 2) {
    const Slot is = emit(Op::ieq, selector, integer_constant(i.words[k]));
    end_stretch(End::branch);
    const std::size_t here = program_.stretches.size() - 1;
    program_.stretches[here].condition = is;
    begin_stretch();
    program_.stretches[here].next[0] = std::uint32_t(program_.stretches.size() - 1);
    set_phis(frame, from.label, i.words[k + 1]);
    end_stretch(End::jump);
    jump(frame, 0, from.label, i.words[k + 1]);
    begin_stretch();
    program_.stretches[here].next[1] = std::uint32_t(program_.stretches.size() - 1);
  }
  has_phis(frame, otherwise);
  set_phis(frame, from.label, otherwise);
  end_stretch(End::jump);
  jump(frame, 0, from.label, otherwise);
}

void Lowering::leave(Frame& frame, Slots value, bool last) {
  if (last && frame.returns.empty()) {  // the only exit: the code after the call follows here
    frame.result = std::move(value);
    frame.returned = true;
    return;
  }
  const std::vector<bool>* integer = value.empty() ? nullptr : &kinds(frame.function->type);
  if (frame.result.empty())
    for (std::size_t k = 0; k < value.size(); ++k)
      frame.result.push_back((*integer)[k] ? program_.integers++ : program_.numbers++);
  for (std::size_t k = 0; k < value.size(); ++k)
    emit_to((*integer)[k] ? Op::icopy : Op::copy, frame.result[k], value[k]);
  end_stretch(End::jump);
  frame.returns.emplace_back(std::uint32_t(program_.stretches.size() - 1), 0);
}

void Lowering::end(Frame& frame, const spirv::Block& block, const spirv::Instruction& i, bool last) {
  const auto word = [&](std::size_t k) {
    if (k >= i.words.size()) refuse("a branch is incomplete");
    return i.words[k];
  };
  switch (i.code) {
    case spv::OpBranch:
      if (has_phis(frame, word(0))) set_phis(frame, block.label, word(0));
      end_stretch(End::jump);
      return jump(frame, 0, block.label, word(0));
    case spv::OpBranchConditional:
      return branch(frame, block, scalar(frame, word(0)), word(1), word(2));
    case spv::OpSwitch:
      return choose(frame, block, i);
    case spv::OpReturn:
      return leave(frame, {}, last);
    case spv::OpReturnValue:
      return leave(frame, value(frame, word(0)), last);
    case spv::OpKill:
      refuse("discards the pixel; return 0 instead");
    default:  // OpUnreachable: a function that should return a value ends without one
      if (module_.type(frame.function->type).kind == spirv::Kind::nothing) return leave(frame, {}, last);
      return leave(frame, undefined_value(frame.function->type, Unset::no_return), last);
  }
}

void Lowering::block(Frame& frame, const spirv::Block& block, bool last) {
  for (const spirv::Instruction& i : block.code) {
    line_ = i.line > 0 ? i.line : line_;
    if (is_end(i.code)) return end(frame, block, i, last);
    instruction(frame, i);
  }
  refuse("a block has no end");
}

std::optional<Slots> Lowering::kernel(const spirv::Function& function,
                                      const std::vector<Argument>& arguments) {
  const Kernel* known = options_.by_meaning.contains(function.id) ? kernel_of(module_, function) : nullptr;
  if (!known) return std::nullopt;
  Slots operands;
  for (const Argument& a : arguments) operands.push_back((a.pointer ? load(*a.pointer) : a.slots).at(0));
  return Slots{operands.size() > 1 ? emit(known->op, operands[0], operands[1])
                                   : emit(known->op, operands[0])};
}

Slots Lowering::call(const spirv::Function& function, const std::vector<Argument>& arguments) {
  if (++depth_ > kDeepestCalls)
    refuse("calls are nested more than " + std::to_string(kDeepestCalls) + " deep");
  if (arguments.size() != function.parameters.size() || function.blocks.empty())
    refuse("calls a function without a body");
  if (auto known = kernel(function, arguments)) {
    --depth_;
    return *known;
  }
  if (options_.random.contains(function.id)) {
    --depth_;
    return random_value(function);
  }
  const std::uint32_t line = line_;
  Frame frame;
  frame.function = &function;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const Argument& argument = arguments[k];
    if (argument.texture)
      frame.textures[function.parameters[k]] = *argument.texture;
    else if (argument.pointer)
      frame.pointers[function.parameters[k]] = *argument.pointer;
    else
      frame.values[function.parameters[k]] = {function.parameter_types[k], argument.slots};
  }
  for (const spirv::Block& b : function.blocks) frame.blocks[b.label] = &b;
  for (std::size_t k = 0; k < function.blocks.size(); ++k) {
    if (k > 0) begin_stretch();
    frame.stretch_of[function.blocks[k].label] = std::uint32_t(program_.stretches.size() - 1);
    block(frame, function.blocks[k], k + 1 == function.blocks.size());
  }
  for (const Frame::Jump& j : frame.jumps) {
    const auto found = frame.stretch_of.find(j.label);
    if (found == frame.stretch_of.end() || j.label == function.blocks.front().label)
      refuse("a branch leads nowhere");
    program_.stretches[j.stretch].next[j.which] = found->second;
    program_.loops = program_.loops || found->second <= j.stretch;
  }
  if (!frame.returned) {
    begin_stretch();
    for (const auto& [stretch, which] : frame.returns)
      program_.stretches[stretch].next[which] = std::uint32_t(program_.stretches.size() - 1);
    if (frame.result.empty() && module_.type(function.type).kind != spirv::Kind::nothing) {
      frame.result = undefined_value(function.type, Unset::no_return);  // the function never returns
    }
  }
  line_ = line;
  --depth_;
  return frame.result;
}

// The scalars of the returned value, or of an argument that the function writes, and their type.
std::pair<Slots, Id> Lowering::written_value(int argument, const spirv::Function& entry,
                                             const Slots& returned, const std::map<int, Pointer>& written) {
  const auto to = written.find(argument);
  if (argument >= 0 && to == written.end()) refuse("an output argument is missing");
  const Id id = argument < 0 ? entry.id : entry.parameters[std::size_t(argument)];
  const Id type = argument < 0 ? entry.type : to->second.type;
  Slots all = argument < 0 ? returned : load(to->second);
  return {is_narrow_result(id, type) ? to_half(std::move(all), type) : std::move(all), type};
}

// The sum of the parts of the reflectance.
Slots Lowering::result_of(const spirv::Function& entry, const Slots& returned,
                          const std::map<int, Pointer>& written) {
  std::vector<ResultPart> parts = options_.results;
  if (parts.empty() && module_.type(entry.type).kind != spirv::Kind::nothing)
    parts = {{-1, 0, returned.size() == 4 ? 3 : returned.size()}};
  if (parts.empty()) refuse("the function returns nothing; a reflectance is a float or a vec3");
  Slots sum;
  for (const ResultPart& part : parts) {
    const auto [all, type] = written_value(part.argument, entry, returned, written);
    const std::vector<bool> integer = kinds(type);
    if ((part.count != 1 && part.count != 3) || part.first + part.count > all.size() || integer[part.first])
      refuse("the function returns " + module_.spelled(type) + "; a reflectance is a float or a vec3");
    Slots one(all.begin() + long(part.first), all.begin() + long(part.first + part.count));
    if (sum.empty()) {
      sum = std::move(one);
      continue;
    }
    if (one.size() == 1) one.assign(sum.size(), one[0]);
    if (sum.size() == 1) sum.assign(one.size(), sum[0]);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = emit(Op::add, sum[k], one[k]);
  }
  return sum;
}

Program Lowering::run(const spirv::Function& entry) {
  program_.stretches.emplace_back();
  program_.line = entry.line;
  if (!options_.random.empty()) begin_random();
  for (const auto& [id, global] : module_.globals) {
    if (!global.variable || global.instruction.words.size() > 1) continue;
    const spirv::Type& pointer = module_.type(global.instruction.type);
    if (pointer.kind == spirv::Kind::pointer && pointer.storage == spv::StorageClassPrivate &&
        !is_opaque(pointer.element))
      global_variable(id);
  }
  // Globals get their initial values at the beginning of the driver's entry.
  const auto main = module_.functions.find(module_.entry);
  if (main != module_.functions.end()) call(main->second, {});
  for (const auto& [id, global] : module_.globals)
    if (global.variable && options_.parameters.contains(module_.name(id)))
      make_input(global_variable(id), module_.type(global.instruction.type).element, module_.name(id), -1);
  std::vector<Argument> arguments;
  std::map<int, Pointer> written;
  for (std::size_t k = 0; k < entry.parameters.size(); ++k) {
    const Id given = entry.parameter_types[k];
    const spirv::Type& type = module_.type(given);
    const std::string name = module_.name(entry.parameters[k]);
    line_ = entry.line;
    if (is_opaque(given)) {
      arguments.push_back(
          {.texture = texture_named(name, type.kind == spirv::Kind::pointer ? type.element : given)});
      continue;
    }
    if (type.kind == spirv::Kind::pointer) {
      Variable& variable = new_variable(type.element);
      arguments.push_back({Pointer{&variable, type.element}, {}});
      if (options_.written.contains(int(k))) {
        written[int(k)] = *arguments.back().pointer;
        options_.accumulated.contains(int(k)) ? set_zero(variable) : clear(variable);
      } else {
        make_input(variable, type.element, name, int(k));
      }
    } else {
      Variable& variable = new_variable(given);
      make_input(variable, given, name, int(k));
      arguments.push_back({std::nullopt, load({&variable, given})});
    }
  }
  const Slots returned = call(entry, arguments);
  line_ = entry.line;
  program_.results =
      options_.apart ? results_apart(entry, returned, written) : result_of(entry, returned, written);
  // The results get slots of their own, so that they are set on every path.
  for (Slot& slot : program_.results) slot = emit(Op::copy, slot);
  end_stretch(End::stop);
  std::vector<Step>& first = program_.stretches.front().steps;
  first.insert(first.begin(), prelude_.begin(), prelude_.end());
  return std::move(program_);
}

Program lower(const spirv::Module& module, const spirv::Function& entry, const LowerOptions& options) {
  try {
    Program program = Lowering(module, options).run(entry);
    remove_unused(program);
    return program;
  } catch (const std::out_of_range&) {  // an operand is missing, which no compiler produces
    throw InputError("SPIR-V: an instruction is incomplete");
  }
}

std::vector<NamedKernel> kernels_of(const spirv::Module& module) {
  std::vector<NamedKernel> out;
  for (const auto& [number, function] : module.functions)
    if (const Kernel* kernel = kernel_of(module, function)) out.push_back({&function, kernel->op});
  return out;
}

}  // namespace brdf::shader
