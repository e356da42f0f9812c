#include "shader/function.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <set>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/binding.h"
#include "shader/entry.h"
#include "shader/front/compile.h"
#include "shader/front/languages.h"
#include "shader/front/module_file.h"
#include "shader/half_precision.h"
#include "shader/joint.h"
#include "shader/kernels.h"
#include "shader/program/lower.h"
#include "shader/reflection.h"
#include "shader/symmetry.h"
#include "shader/textures.h"

namespace brdf::shader {
namespace {

std::string undeclared(const Function& f) {
  std::vector<std::string> names;
  for (const Parameter& p : f.parameters)
    if (!p.declared && !p.boolean) names.push_back(p.name);
  if (names.empty()) return "";
  return "range 0 to 1 assumed for " + io::joined(names) +
         "; give other ranges with --param NAME=MIN:MAX or a line `//: param NAME MIN MAX DEFAULT`";
}

// A width across the tangent requires a width along the tangent.
void check_roles(const Function& f) {
  const auto with = [&](Role role) {
    return std::ranges::find_if(f.parameters, [&](const Parameter& p) { return p.role == role; });
  };
  for (const auto& [along, across] : kAxisRoles) {
    const auto alone = with(across);
    if (alone == f.parameters.end() || with(along) != f.parameters.end()) continue;
    const auto line = std::find_if(f.source.parameters.rbegin(), f.source.parameters.rend(),
                                   [&](const Declared& d) { return d.role == across; });
    const bool in_file = line != f.source.parameters.rend() && line->line > 0;
    throw InputError(f.source.name + (in_file ? ":" + std::to_string(line->line) : "") + ": param " +
                     alone->name + ": role " + std::string(name_of(across)) +
                     " needs another parameter of role " + std::string(name_of(along)) +
                     "; if there is only one width, use that role for it");
  }
}

std::string without_functions(const std::vector<LeftOut>& left_out) {
  std::vector<std::string> names;
  for (const LeftOut& f : left_out) names.push_back(f.name + "()");
  return "omitted " + io::joined(names) + ", which do" + (names.size() > 1 ? "" : "es") + " not compile (" +
         left_out.front().why + ")";
}

// Parameters that the file or the command line declares, but on which no result depends.
std::vector<std::string> unread_parameters(const Function& f) {
  std::set<std::size_t> values;  // values that some step reads
  const auto add = [&](const Program& program, const std::vector<Binding>& bindings) {
    const auto read = read_slots(program);
    for (const Binding& b : bindings)
      if (b.from == Binding::From::value && read.contains({b.integer, b.slot})) values.insert(b.value);
  };
  add(f.as_written, f.bindings);
  add(f.as_meant, f.bindings_as_meant);
  std::vector<std::string> out;
  for (const Parameter& p : f.parameters) {
    bool read = false;
    for (std::size_t k = 0; k < (p.colour ? 3u : 1u); ++k) read = read || values.contains(p.first + k);
    if (p.declared && !read) out.push_back(p.name);
  }
  return out;
}

// The value of a function that depends on no input; std::nullopt if it depends on an input.
std::optional<double> constant_value(const Function& f) {
  const auto read = read_slots(f.as_meant);
  for (const Binding& b : f.bindings_as_meant)
    if (read.contains({b.integer, b.slot})) return std::nullopt;
  if (f.as_meant.loops) return std::nullopt;
  Runner<double, 1> runner(f);
  const Vec3<double> up{0, 0, 1};
  const std::vector<double> values = f.defaults();
  const double first = evaluate<double>(f, runner, values, up, up, 0);
  for (const std::size_t component : {1, 2})
    if (evaluate<double>(f, runner, values, up, up, component) != first) return std::nullopt;
  return first;
}

// Macros of the command line that are mentioned neither in the file nor in its included files.
std::string unmentioned(const std::vector<std::string>& macros) {
  if (macros.empty()) return "";
  return "--define " + io::joined(macros) + ": no file uses " +
         (macros.size() > 1 ? "these macros" : "this macro");
}

Program lowered(const spirv::Module& module, const spirv::Function& entry, const LowerOptions& options,
                const std::string& name) {
  try {
    return lower(module, entry, options);
  } catch (const InputError& e) {
    const std::string what = e.what();
    if (!what.starts_with("line ")) throw InputError(name + ": " + what);
    throw InputError(name + ":" + what.substr(5));
  }
}

}  // namespace

std::vector<double> Function::defaults() const {
  std::vector<double> out(values);
  for (const Parameter& p : parameters)
    for (std::size_t k = 0; k < (p.colour ? 3u : 1u); ++k) out[p.first + k] = p.initial[k];
  return out;
}

bool Function::is_given(Axis axis) const {
  return std::ranges::any_of(bindings, [&](const Binding& b) {
    if (b.from != Binding::From::coordinate && b.from != Binding::From::product) return false;
    const auto is = [&](Axis a) { return a == axis || a == Axis::half; };
    return is(b.a) || (b.from == Binding::From::product && is(b.b));
  });
}

std::string entry_advice(const Function& f) {
  const std::string name =
      f.source.entry ? f.source.entry->name
                     : f.entry.substr(f.entry.find(' ') + 1, f.entry.find('(') - f.entry.find(' ') - 1);
  return "assign the arguments with --entry '" + name + "(L, V, N, ...)' or a line `//: entry " + name +
         "(L, V, N, ...)`";
}

std::string said_of_unread(const Function& f) {
  const bool zero = f.zero_where_asked || (f.constant && *f.constant == 0);
  if (!zero && f.unread.empty()) return "";
  std::string out;
  if (f.constant)
    out = "the value is always " + io::to_text(*f.constant);
  else if (zero)
    out = "the value is 0 at all directions that were tried";
  if (!f.unread.empty())
    out += std::string(out.empty() ? "" : "; ") + "the value does not depend on " + io::joined(f.unread);
  if (!f.asked_macros.empty())
    out += "; the text tests macros that are not defined (" + io::joined(f.asked_macros) +
           "): define a macro with --define NAME or NAME=VALUE";
  return out;
}

Function make_function(const ShaderChoice& choice) {
  return make_function(read_source(choice.file), choice);
}

namespace {

// The names of --entry take the places of names that a module has lost: by their order, or, as "0=L", by the
// location of an input. `words` becomes a list by order.
void name_arguments(spirv::Module& module, const spirv::Function& function, std::vector<std::string>& words) {
  std::vector<std::string> ordered;
  for (const spirv::Id parameter : function.parameters) ordered.push_back(module.name(parameter));
  if (words.size() > ordered.size()) return;  // of another function of this name
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::size_t equals = words[k].find('=');
    std::size_t place = k;
    if (equals != words[k].npos)
      for (place = 0; place < ordered.size(); ++place)
        if (const auto found = module.locations.find(function.parameters[place]);
            found != module.locations.end() && std::to_string(found->second) == words[k].substr(0, equals))
          break;
    if (place == ordered.size())
      throw InputError("--entry " + function.name + "(" + words[k] +
                       "): the entry point has no input at this location");
    ordered[place] = words[k].substr(equals == words[k].npos ? 0 : equals + 1);
    if (std::string& name = module.names[function.parameters[place]]; name.starts_with('%'))
      name = ordered[place];
  }
  words = ordered;
}

// Completes a SPIR-V file. Returns its entry point if this is, with inputs as arguments, a candidate for the
// reflectance: it is the only function, because an optimiser has merged the others into it, or --entry names
// it.
spirv::Id complete(spirv::Module& module, Source& source) {
  spirv::name_all(module);
  const auto main = module.functions.find(module.entry);
  const bool is_candidate =
      main != module.functions.end() &&
      (module.functions.size() == 1 || (source.entry && source.entry->name == main->second.name));
  const spirv::Id candidate = is_candidate ? module.entry : 0;
  if (is_candidate) spirv::give_arguments(module);
  // In a text that this program completes, main initialises globals. In a foreign module main is a program.
  module.entry = 0;
  if (!source.entry || !source.entry->arguments) return candidate;
  for (auto& [id, function] : module.functions)
    if (function.name == source.entry->name) name_arguments(module, function, *source.entry->arguments);
  return candidate;
}

constexpr const char* kMerged =
    "the reflectance is the entry point of the module: if an optimiser has written the module, the order of "
    "operations is the optimiser's";

Function function_of(Source source, const Compiled& compiled) {
  static std::atomic<std::uint64_t> count{0};
  source.whole = compiled.whole;
  Function f;
  const bool is_module = !source.module.empty();
  spirv::Module module = spirv::parse(compiled.spirv, is_module ? "" : source.name);
  const spirv::Id entry_point = is_module ? complete(module, source) : 0;
  const Chosen chosen = choose_entry(module, source, compiled);
  LowerOptions options;
  for (const Declared& d : source.parameters) options.parameters.insert(d.name);
  for (const std::string& name : free_directions(module, source)) options.parameters.insert(name);
  options.results = chosen.results.parts;
  options.written = chosen.results.written;
  options.accumulated = chosen.results.accumulated;
  options.zero_globals = source.language == Language::hlsl;
  options.textures = textures_of(module, source);
  const std::set<spirv::Id> kernels = library_kernels(module);
  std::shared_ptr<Function> in_half = set_programs(f, options, kernels, [&](const LowerOptions& o) {
    return lowered(module, *chosen.function, o, source.name);
  });
  f.source = std::move(source);
  f.entry = signature(module, *chosen.function);
  f.returns = f.source.returns.value_or(Returns::f);
  options.results.clear();
  if (in_half == nullptr && compiled.ignores_narrow && !compiled.narrow_word.empty())
    f.half_unknown = "the text compiles only if " + compiled.narrow_word + " is read as a type of 32 bits";
  const std::shared_ptr<Joint> joint = make_joint(module, *chosen.function, f.source, options, kernels);
  f.exchanged =
      exchanges(joint.get(), module, *chosen.function) && !(f.source.entry && f.source.entry->arguments);
  bind_inputs(f, in_half.get(), joint ? joint->parameters() : std::set<std::string>{});
  if (joint) bind_joint(*joint, f);
  f.joint = joint;
  check_roles(f);
  if (!f.is_given(Axis::light) && !f.is_given(Axis::view))
    throw InputError(f.source.name + ": no argument of " + f.entry +
                     " is recognised as the direction to the light or to the viewer: " + entry_advice(f));
  f.number = ++count;
  const auto read = read_slots(f.as_written);
  for (const Binding& b : f.bindings)
    for (const Axis axis : {b.a, b.b})
      if ((b.from == Binding::From::coordinate || b.from == Binding::From::product) &&
          (axis == Axis::tangent || axis == Axis::bitangent))
        f.oriented = f.oriented || read.contains({b.integer, b.slot});
  f.symmetry = symmetry_of(f.as_written, f.bindings);
  f.symmetry.reflects = reflects(f.as_written, f.bindings);
  f.symmetry_as_meant = f.symmetry;
  if (!kernels.empty()) {
    f.symmetry_as_meant = symmetry_of(f.as_meant, f.bindings_as_meant);
    f.symmetry_as_meant.reflects = reflects(f.as_meant, f.bindings_as_meant);
  }
  f.asked_macros = compiled.asked;
  f.unread = unread_parameters(f);
  f.constant = constant_value(f);
  f.notes = compiled.notes;
  if (!compiled.left_out.empty()) f.notes.push_back(without_functions(compiled.left_out));
  for (const std::string& note :
       {chosen.note, chosen.results.note, undeclared(f), unmentioned(compiled.unmentioned),
        said_of_half(f, in_half.get(), compiled.narrow_word), said_of_textures(f, options.textures),
        std::string(entry_point == chosen.function->id ? kMerged : "")})
    if (!note.empty()) f.notes.push_back(note);
  if (f.as_meant.takes_bits)
    f.notes.push_back(
        "float only: the shader operates on the bits of a float; other precisions use the bits of the float "
        "value");
  if (in_half != nullptr) {
    const Program program = in_half->as_written;
    const std::vector<Binding> bindings = in_half->bindings;
    *in_half = f;
    in_half->as_written = in_half->as_meant = program;
    in_half->bindings = in_half->bindings_as_meant = bindings;
    in_half->number = ++count;
    f.in_half = std::move(in_half);
  }
  return f;
}

// Adds the missing files to any error message, because they may be the cause.
Function with_missing_files(Source source, const Compiled& compiled) {
  const std::string files = compiled.missing.empty() ? "" : no_files(compiled.missing, source);
  try {
    return function_of(std::move(source), compiled);
  } catch (const InputError& e) {
    const std::string what = e.what();
    if (files.empty() || what.find(files) != what.npos) throw;
    throw InputError(what + " (" + files + ")");
  }
}

}  // namespace

Function make_function(Source source, const ShaderChoice& choice) {
  choose(source, choice);
  const Compiled compiled = source.module.empty() ? compile(source) : compile(source, checked_module);
  return with_missing_files(std::move(source), compiled);
}

Function make_function(Source source, const ShaderChoice& choice, Compiler& compiler) {
  choose(source, choice);
  const Compiled compiled =
      source.module.empty() ? compiler.compile(source) : compile(source, checked_module);
  return with_missing_files(std::move(source), compiled);
}

}  // namespace brdf::shader
