#include "shader/spirv/module.h"

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>

#include "io/files/error.h"

namespace brdf::shader::spirv {
namespace {

constexpr std::size_t kMostWords = 1u << 22, kMostScalars = 1u << 14;

class Parser {
 public:
  Parser(std::span<const std::uint32_t> words, const std::string& own) : words_(words), own_(own) {}

  Module run() {
    if (words_.size() < 5 || words_.size() > kMostWords || words_[0] != spv::MagicNumber)
      fail("is not a SPIR-V module");
    for (std::size_t at = 5; at < words_.size();) {
      const std::uint32_t length = words_[at] >> 16, code = words_[at] & 0xffff;
      if (length == 0 || length > words_.size() - at) fail("ends within an instruction");
      read(code, words_.subspan(at + 1, length - 1));
      at += length;
    }
    if (function_) fail("ends within a function");
    return std::move(module_);
  }

 private:
  using Words = std::span<const std::uint32_t>;
  [[noreturn]] static void fail(const std::string& what) { throw InputError("SPIR-V: " + what); }

  static std::uint32_t word(Words w, std::size_t k) {
    if (k >= w.size()) fail("an instruction is too short");
    return w[k];
  }
  // The string that begins at word k.
  static std::string text(Words w, std::size_t k) {
    if (k > w.size()) fail("an instruction is too short");
    std::string out;
    for (const std::uint32_t four : w.subspan(k))
      for (int byte = 0; byte < 4; ++byte) {
        const char c = char(four >> (8 * byte) & 0xff);
        if (c == 0) return out;
        out += c;
      }
    return out;
  }

  void read(std::uint32_t code, Words w) {
    switch (code) {
      case spv::OpName:
        module_.names[word(w, 0)] = text(w, 1);
        return;
      case spv::OpMemberName:
        word(w, 1);
        module_.member_names[w[0]][w[1]] = text(w, 2);
        return;
      case spv::OpDecorate:
        if (word(w, 1) == spv::DecorationRelaxedPrecision) module_.relaxed.insert(w[0]);
        if (w[1] == spv::DecorationLinkageAttributes) module_.exported[w[0]] = text(w, 2);
        if (w[1] == spv::DecorationLocation) module_.locations[w[0]] = word(w, 2);
        return;
      case spv::OpString:
        files_[word(w, 0)] = text(w, 1);
        return;
      case spv::OpLine:
        line_ = is_own(word(w, 0)) ? word(w, 1) : 0;
        return;
      case spv::OpNoLine:
        line_ = 0;
        return;
      case spv::OpEntryPoint:
        module_.entry = word(w, 1);
        module_.exported[module_.entry] = text(w, 2);
        return;
      case spv::OpExtInstImport:
        if (text(w, 1) == "GLSL.std.450") module_.extended = word(w, 0);
        if (text(w, 1).starts_with("NonSemantic.")) debug_ = word(w, 0);
        return;
      default:
        break;
    }
    if (code == spv::OpExtInst && debug_ != 0 && word(w, 2) == debug_) return debug(w);
    if (is_type(code))
      add_type(code, w);
    else if (function_ || code == spv::OpFunction)
      in_function(code, w);
    else
      global(code, w);
  }

  // Returns whether this string is the file with the recorded lines.
  bool is_own(Id file) const {
    const auto found = files_.find(file);
    return own_.empty() || found == files_.end() || found->second.empty() || found->second == own_;
  }

  // DebugLine gives the line of the next instructions, as the id of a constant, and the file, as the id of
  // a DebugSource.
  void debug(Words w) {
    constexpr std::uint32_t kDebugSource = 35, kDebugLine = 103;
    if (word(w, 3) == kDebugSource) sources_[w[1]] = word(w, 4);
    if (word(w, 3) != kDebugLine) return;
    const auto line = module_.globals.find(word(w, 5));
    if (line == module_.globals.end() || line->second.instruction.words.empty()) return;
    const auto source = sources_.find(w[4]);
    line_ = source == sources_.end() || is_own(source->second) ? line->second.instruction.words[0] : 0;
  }

  static bool is_type(std::uint32_t code) { return code >= spv::OpTypeVoid && code <= spv::OpTypeFunction; }

  void add_type(std::uint32_t code, Words w) {
    Type type;
    const Id id = word(w, 0);
    const auto known = [&](std::size_t k) {
      module_.type(word(w, k));
      return w[k];
    };
    switch (code) {
      case spv::OpTypeVoid:
        type.kind = Kind::nothing;
        break;
      case spv::OpTypeBool:
        type.kind = Kind::boolean;
        break;
      case spv::OpTypeInt:
        type.kind = word(w, 1) == 32 ? Kind::integer : Kind::opaque;
        type.is_signed = word(w, 2) != 0;
        break;
      case spv::OpTypeFloat:
        type.is_half = word(w, 1) == 16;
        type.kind = w[1] == 32 || type.is_half ? Kind::number : Kind::opaque;
        break;
      case spv::OpTypeVector:
      case spv::OpTypeMatrix:
        type.kind = code == spv::OpTypeVector ? Kind::vector : Kind::matrix;
        type.element = known(1);
        type.count = word(w, 2);
        if (type.count < 1 || type.count > 4) fail("a vector's length is wrong");
        break;
      case spv::OpTypeArray:
        type.kind = Kind::array;
        type.element = known(1);
        type.count = length_of(word(w, 2));
        break;
      case spv::OpTypeStruct:
        type.kind = Kind::structure;
        for (std::size_t k = 1; k < w.size(); ++k) type.members.push_back(known(k));
        if (type.members.empty()) fail("a struct has no members");
        break;
      case spv::OpTypePointer:
        type.kind = Kind::pointer;
        type.storage = word(w, 1);
        type.element = known(2);
        break;
      case spv::OpTypeImage: {
        const Type& of = module_.type(word(w, 1));
        const bool plain = word(w, 3) != 1 && word(w, 4) == 0 && word(w, 5) == 0 && word(w, 6) != 2;
        type.kind = Kind::opaque;
        type.is_texture = plain && w[2] == spv::Dim2D && of.kind == Kind::number;
        break;
      }
      case spv::OpTypeSampledImage:
        type.kind = Kind::opaque;
        type.is_texture = module_.type(word(w, 1)).is_texture;
        break;
      case spv::OpTypeSampler:
        type.kind = Kind::opaque;
        type.is_sampler = true;
        break;
      case spv::OpTypeFunction:
        type.kind = Kind::opaque;
        type.element = known(1);
        for (std::size_t k = 2; k < w.size(); ++k) type.members.push_back(known(k));
        break;
      default:
        type.kind = Kind::opaque;
    }
    if (!module_.types.emplace(id, std::move(type)).second) fail("a type is declared twice");
  }

  std::uint32_t length_of(Id constant) {
    const auto found = module_.globals.find(constant);
    if (found == module_.globals.end() || found->second.instruction.words.empty())
      fail("an array's length is unknown");
    const std::uint32_t length = found->second.instruction.words[0];
    if (length < 1 || length > kMostScalars) fail("an array is too long");
    return length;
  }

  Instruction instruction(std::uint32_t code, Words w) const {
    Instruction i;
    i.code = code;
    i.line = line_;
    bool has_result = false, has_type = false;
    spv::HasResultAndType(spv::Op(code), &has_result, &has_type);
    std::size_t at = 0;
    if (has_type) i.type = word(w, at++);
    if (has_result) i.result = word(w, at++);
    i.words.assign(w.begin() + long(at), w.end());
    return i;
  }

  void global(std::uint32_t code, Words w) {
    const bool constant = (code >= spv::OpConstantTrue && code <= spv::OpConstantNull) ||
                          (code >= spv::OpSpecConstantTrue && code <= spv::OpSpecConstantOp) ||
                          code == spv::OpUndef;
    if (!constant && code != spv::OpVariable) return;
    Instruction i = instruction(code, w);
    module_.type(i.type);
    const Id id = i.result;
    module_.globals[id] = {std::move(i), code == spv::OpVariable};
  }

  void in_function(std::uint32_t code, Words w) {
    if (code == spv::OpFunction) {
      if (function_) fail("functions are nested");
      const Instruction i = instruction(code, w);
      function_ = &module_.functions[i.result];
      *function_ = {i.result, i.type, name_of(i.result)};
      function_->line = line_;
      module_.type(i.type);
    } else if (code == spv::OpFunctionParameter) {
      const Instruction i = instruction(code, w);
      module_.type(i.type);
      function_->parameters.push_back(i.result);
      function_->parameter_types.push_back(i.type);
    } else if (code == spv::OpLabel) {
      function_->blocks.push_back({word(w, 0)});
    } else if (code == spv::OpFunctionEnd) {
      function_ = nullptr;
      line_ = 0;
    } else {
      if (function_->blocks.empty()) fail("an instruction outside a block");
      Instruction i = instruction(code, w);
      if (function_->line == 0) function_->line = i.line;
      function_->blocks.back().code.push_back(std::move(i));
    }
  }

  // The compiler turns the source's brdf into "brdf(vf3;vf3;".
  std::string name_of(Id id) const {
    const auto found = module_.names.find(id);
    if (found == module_.names.end()) return "";
    return found->second.substr(0, found->second.find('('));
  }

  Words words_;
  const std::string& own_;
  std::map<Id, std::string> files_;
  std::map<Id, Id> sources_;  // the file of each source
  Module module_;
  Function* function_ = nullptr;
  std::uint32_t line_ = 0;
  Id debug_ = 0;  // id of the set of debug instructions
};

}  // namespace

const Type& Module::type(Id id) const {
  const auto found = types.find(id);
  if (found == types.end()) throw InputError("SPIR-V: a type is not declared");
  return found->second;
}

bool Module::is_half(Id id) const {
  const Type& t = type(id);
  const bool has_elements = t.kind == Kind::vector || t.kind == Kind::matrix || t.kind == Kind::array;
  return has_elements ? is_half(t.element) : t.is_half;
}

std::size_t Module::scalars(Id id) const {
  const Type& t = type(id);
  std::size_t sum = 0;
  switch (t.kind) {
    case Kind::boolean:
    case Kind::integer:
    case Kind::number:
      return 1;
    case Kind::vector:
    case Kind::matrix:
    case Kind::array:
      sum = t.count * scalars(t.element);
      break;
    case Kind::structure:
      for (const Id member : t.members) sum += scalars(member);
      break;
    default:
      throw InputError(
          "has a value that is not a number, vector, matrix, array or struct of numbers with 32 bits, nor of "
          "floating-point numbers with 16 bits");
  }
  if (sum > kMostScalars)
    throw InputError("has a value of more than " + std::to_string(kMostScalars) + " numbers");
  return sum;
}

std::string Module::name(Id id) const {
  const auto found = names.find(id);
  return found == names.end() ? "" : found->second;
}

std::string Module::spelled(Id id) const {
  const Type& t = type(id);
  switch (t.kind) {
    case Kind::nothing:
      return "void";
    case Kind::boolean:
      return "bool";
    case Kind::integer:
      return t.is_signed ? "int" : "uint";
    case Kind::number:
      return "float";
    case Kind::vector: {
      const std::string element = spelled(t.element);
      return (element == "float" ? "" : element.substr(0, 1)) + "vec" + std::to_string(t.count);
    }
    case Kind::matrix:
      return "mat" + std::to_string(t.count);
    case Kind::array:
      return spelled(t.element) + "[" + std::to_string(t.count) + "]";
    case Kind::structure:
      return name(id);
    default:
      return "a type that is not a number";
  }
}

void name_all(Module& module) {
  const auto named = [&](Id id) {
    std::string& name = module.names[id];
    if (name.empty())
      if (const auto found = module.exported.find(id); found != module.exported.end()) name = found->second;
    if (name.empty()) name = "%" + std::to_string(id);
    return name;
  };
  for (auto& [id, function] : module.functions) {
    if (function.name.empty()) function.name = named(id);
    for (const Id parameter : function.parameters) named(parameter);
  }
  for (const auto& [id, global] : module.globals) {
    if (!global.variable) continue;
    named(id);
    const Type& pointer = module.type(global.instruction.type);
    if (pointer.kind != Kind::pointer || module.type(pointer.element).kind != Kind::structure) continue;
    const std::size_t members = module.type(pointer.element).members.size();
    for (std::uint32_t k = 0; k < members; ++k)
      if (std::string& name = module.member_names[pointer.element][k]; name.empty())
        name = "m" + std::to_string(k);
  }
}

void give_arguments(Module& module) {
  const auto found = module.functions.find(module.entry);
  if (found == module.functions.end() || !found->second.parameters.empty()) return;
  std::vector<std::pair<std::uint32_t, Id>> inputs, outputs;
  for (const auto& [id, location] : module.locations) {
    const auto global = module.globals.find(id);
    if (global == module.globals.end() || !global->second.variable) continue;
    const std::uint32_t storage = module.type(global->second.instruction.type).storage;
    if (storage == spv::StorageClassInput) inputs.emplace_back(location, id);
    if (storage == spv::StorageClassOutput) outputs.emplace_back(location, id);
  }
  if (inputs.empty() || outputs.empty()) return;
  std::ranges::sort(inputs);
  inputs.push_back(*std::ranges::min_element(outputs));
  for (const auto& [location, id] : inputs) {
    found->second.parameters.push_back(id);
    found->second.parameter_types.push_back(module.globals.at(id).instruction.type);
  }
}

Module parse(std::span<const std::uint32_t> words, const std::string& own) {
  return Parser(words, own).run();
}

}  // namespace brdf::shader::spirv
