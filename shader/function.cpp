#include "shader/function.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include "io/error.h"
#include "io/numbers.h"
#include "io/text.h"
#include "shader/entry.h"
#include "shader/front/compile.h"
#include "shader/program/lower.h"
#include "shader/program/operands.h"
#include "shader/symmetry.h"

namespace brdf::shader {
namespace {

std::string last_word(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == name.npos ? name : name.substr(dot + 1);
}

// Slots of a program that are read before the end.
std::set<std::pair<bool, std::uint32_t>> read_slots(const Program& p) {
  std::set<std::pair<bool, std::uint32_t>> out;
  for (const std::uint32_t slot : p.results) out.insert({false, slot});
  for (const Stretch& s : p.stretches) {
    if (s.end == End::branch) out.insert({true, s.condition});
    for (const Step& step : s.steps) {
      const Operands o = operands_of(step.op);
      const std::uint32_t slots[] = {step.a, step.b, step.c};
      for (int k = 0; k < o.count; ++k) {
        const std::uint32_t width = k == 0 && o.indexed_load ? step.c : 1;
        for (std::uint32_t j = 0; j < width; ++j) out.insert({o.integer[k], slots[k] + j});
      }
    }
  }
  return out;
}

// Makes parameters and bindings of a program's inputs.
class Binder {
 public:
  Binder(Function& function, const std::vector<Declared>& declared) : f_(function), declared_(declared) {}

  std::vector<Binding> bind(const Program& program) {
    read_ = read_slots(program);
    std::vector<Binding> out;
    // Arguments first; globals in the order of the file where that declares them.
    std::vector<Input> inputs = program.inputs;
    const auto place = [&](const Input& input) {
      const auto& globals = f_.source.globals;
      return input.argument >= 0 ? -1
                                 : std::find(globals.begin(), globals.end(), input.name) - globals.begin();
    };
    std::stable_sort(inputs.begin(), inputs.end(),
                     [&](const Input& a, const Input& b) { return place(a) < place(b); });
    for (const Input& input : inputs) {
      const bool used = std::any_of(input.slots.begin(), input.slots.end(), [&](std::uint32_t slot) {
        return read_.contains({input.integer, slot});
      });
      add(input, input.integer, used, out);
    }
    return out;
  }

  // What the command line or the file says of parameters that are not there.
  void check_declared() const {
    for (const Declared& d : declared_) {
      if (used_.contains(d.name)) continue;
      std::vector<std::string> known;
      for (const Parameter& p : f_.parameters) known.push_back(p.name);
      const std::string what = d.line > 0
                                   ? f_.source.name + ":" + std::to_string(d.line) + ": param " + d.name
                                   : "--param " + d.name;
      if (std::find(f_.source.globals.begin(), f_.source.globals.end(), d.name) == f_.source.globals.end())
        throw InputError(what + ": is no argument, uniform or global variable of " + f_.entry +
                         (known.empty() ? "" : " (its parameters: " + io::joined(known) + ")"));
    }
  }

 private:
  // The name that its meaning is read from: the entry line's, where that names it.
  std::string spoken_name(const Input& input) const {
    const auto& line = f_.source.entry;
    if (input.argument < 0 || !line || !line->arguments ||
        std::size_t(input.argument) >= line->arguments->size())
      return input.name;
    const std::string& given = (*line->arguments)[std::size_t(input.argument)];
    const std::size_t dot = input.name.find('.');
    return dot == input.name.npos ? given : given + input.name.substr(dot);
  }

  const Declared* declaration(const std::string& name) {
    // The command line's come last, and win.
    for (std::size_t k = declared_.size(); k-- > 0;)
      if (declared_[k].name == name || declared_[k].name == last_word(name)) {
        used_.insert(declared_[k].name);
        return &declared_[k];
      }
    return nullptr;
  }

  void add(const Input& input, bool integer, bool used, std::vector<Binding>& out) {
    const std::string name = spoken_name(input);
    const bool vector = input.type == "vec3" || input.type == "vec4";
    const Declared* declared = declaration(name);
    const auto meaning = declared || integer ? std::nullopt : meaning_of(name, vector);
    if (meaning) return add_meaning(*meaning, input, out);
    if (!used && !declared) {
      for (const std::uint32_t slot : input.slots) out.push_back({Binding::From::zero, slot, integer});
      return;
    }
    if (input.type.ends_with("]") || input.type.starts_with("mat") || (integer && input.slots.size() > 1))
      return add_numbers(input, name, declared, out);
    if (input.type == "vec4") {  // a colour and what covers it
      Input colour = input;
      out.push_back({Binding::From::one, colour.slots[3]});
      colour.slots.pop_back();
      return add_parameter(colour, name, declared, false, out);
    }
    if (input.type == "vec2") {
      for (int k = 0; k < 2; ++k) {
        const std::string element = name + (k ? "_y" : "_x");
        const Declared* const own = declaration(element);
        add_parameter({input.name, "float", {input.slots[std::size_t(k)]}, false, input.argument}, element,
                      own ? own : declared, false, out);
      }
      return;
    }
    add_parameter(input, name, declared, integer, out);
  }

  // Of an array or a matrix each number that is read, NAME_0 and so on.
  void add_numbers(const Input& input, const std::string& name, const Declared* declared,
                   std::vector<Binding>& out) {
    constexpr std::size_t kMost = 16;
    std::size_t count = 0;
    for (std::size_t k = 0; k < input.slots.size(); ++k) {
      if (!read_.contains({input.integer, input.slots[k]})) {
        out.push_back({Binding::From::zero, input.slots[k], input.integer});
        continue;
      }
      if (++count > kMost)
        throw InputError(f_.source.name + ": " + name + " of " + f_.entry + " is a " + input.type +
                         ", of which more than " + std::to_string(kMost) +
                         " numbers are used: write its values into the file");
      const std::string element = name + "_" + std::to_string(k);
      const Declared* const own = declaration(element);
      add_parameter(
          {input.name, input.integer ? "int" : "float", {input.slots[k]}, input.integer, input.argument},
          element, own ? own : declared, input.integer, out);
    }
  }

  void add_meaning(const Meaning& m, const Input& input, std::vector<Binding>& out) {
    for (std::size_t k = 0; k < input.slots.size(); ++k) {
      Binding b{Binding::From::one, input.slots[k]};
      if (m.kind == Meaning::Kind::vector) {
        b.from = k < 3 ? Binding::From::coordinate : Binding::From::zero;
        b.a = m.a;
        b.component = int(k);
      } else if (m.kind == Meaning::Kind::product) {
        b.from = Binding::From::product;
        b.a = m.a, b.b = m.b;
      }
      out.push_back(b);
    }
  }

  void add_parameter(const Input& input, const std::string& name, const Declared* declared, bool integer,
                     std::vector<Binding>& out) {
    std::string word = last_word(name);
    std::replace(word.begin(), word.end(), '.', '_');
    const bool boolean = input.type == "bool";
    const auto known = known_.find(name);
    if (known == known_.end()) {
      Parameter p;
      p.name = word;
      for (int n = 2; std::any_of(f_.parameters.begin(), f_.parameters.end(),
                                  [&](const Parameter& q) { return q.name == p.name; });
           ++n)
        p.name = word + "_" + std::to_string(n);
      p.doc = (input.argument >= 0 ? "argument " : "variable ") + input.name + " (" + input.type + ")";
      p.colour = input.slots.size() == 3;
      p.boolean = boolean;
      p.whole = integer;
      p.first = f_.values;
      if (boolean) p.initial = {0, 0, 0};
      describe(p, declared);
      known_[name] = p.first;
      f_.values += p.colour ? 3 : 1;
      f_.parameters.push_back(std::move(p));
    }
    for (std::size_t k = 0; k < input.slots.size(); ++k) {
      Binding b{Binding::From::value, input.slots[k], integer, boolean};
      b.value = known_.at(name) + k;
      out.push_back(b);
    }
  }

  void describe(Parameter& p, const Declared* declared) const {
    if (!declared) {
      p.doc += "; its range is not given";
      if (const auto value = initial_in_text(p.name))
        p.initial.fill(*value), p.min = std::min(0.0, *value), p.max = std::max(1.0, *value);
      return;
    }
    p.declared = true;
    p.min = declared->min.value_or(0);
    p.max = declared->max.value_or(1);
    p.log_scale = declared->log_scale;
    p.role = declared->role;
    const double middle = p.log_scale && p.min > 0 ? std::sqrt(p.min * p.max) : (p.min + p.max) / 2;
    for (std::size_t k = 0; k < 3; ++k)
      p.initial[k] =
          declared->initial.empty() ? middle : declared->initial[std::min(k, declared->initial.size() - 1)];
    p.min = std::min(p.min, *std::min_element(p.initial.begin(), p.initial.end()));
    p.max = std::max(p.max, *std::max_element(p.initial.begin(), p.initial.end()));
  }

  // "uniform float NAME = 0.3;"
  std::optional<double> initial_in_text(const std::string& name) const {
    std::smatch match;
    const std::string text = without_comments(f_.source.text);
    double value;
    if (text.find("uniform") != text.npos &&
        std::regex_search(text, match,
                          std::regex("\\buniform\\s+\\w+\\s+" + name + "\\s*=\\s*([-+0-9.eE]+)")) &&
        io::parse_number(match[1].str(), value))
      return value;
    return std::nullopt;
  }

  Function& f_;
  const std::vector<Declared>& declared_;
  std::map<std::string, std::size_t> known_;  // first value of an input of that name
  std::set<std::string> used_;
  std::set<std::pair<bool, std::uint32_t>> read_;  // slots of the program that is bound
};

std::string undeclared(const Function& f) {
  std::vector<std::string> names;
  for (const Parameter& p : f.parameters)
    if (!p.declared && !p.boolean) names.push_back(p.name);
  if (names.empty()) return "";
  return "range 0 to 1 taken for " + io::joined(names) +
         "; give others with --param NAME=MIN:MAX or a line `//: param NAME MIN MAX DEFAULT`";
}

// A width across the tangent is one of two.
void check_roles(const Function& f) {
  const auto with = [&](Role role) {
    return std::find_if(f.parameters.begin(), f.parameters.end(),
                        [&](const Parameter& p) { return p.role == role; });
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
                     "; if there is one width only, give it that role");
  }
}

std::string without_functions(const std::vector<LeftOut>& left_out) {
  std::vector<std::string> names;
  for (const LeftOut& f : left_out) names.push_back(f.name + "()");
  return "without " + io::joined(names) + ", which do" + (names.size() > 1 ? "" : "es") +
         " not compile here (" + left_out.front().why + ")";
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

Function make_function(const ShaderChoice& choice) {
  return make_function(read_source(choice.file), choice);
}

namespace {

Function function_of(Source source, const ShaderChoice& choice, const Compiled& compiled) {
  static std::atomic<std::uint64_t> count{0};
  if (!choice.entry.empty()) source.entry = parse_entry(choice.entry);
  if (!choice.returns.empty()) source.returns = parse_returns(choice.returns);
  for (const std::string& text : choice.parameters) source.parameters.push_back(parse_parameter(text));
  Function f;
  const spirv::Module module = spirv::parse(compiled.spirv);
  const Chosen chosen = choose_entry(module, source, compiled.left_out);
  LowerOptions options;
  for (const Declared& d : source.parameters) options.parameters.insert(d.name);
  for (const std::string& name : free_directions(module, source)) options.parameters.insert(name);
  options.results = chosen.results.parts;
  options.written = chosen.results.written;
  options.accumulated = chosen.results.accumulated;
  options.zero_globals = source.language == Language::hlsl;
  f.as_written = lowered(module, *chosen.function, options, source.name);
  f.as_meant = f.as_written;
  if (holds_kernels(module)) {
    options.kernels_by_meaning = true;
    f.as_meant = lowered(module, *chosen.function, options, source.name);
  }
  f.source = std::move(source);
  f.entry = signature(module, *chosen.function);
  f.returns = f.source.returns.value_or(Returns::f);
  Binder binder(f, f.source.parameters);
  f.bindings = binder.bind(f.as_written);
  f.bindings_as_meant = binder.bind(f.as_meant);
  binder.check_declared();
  check_roles(f);
  f.number = ++count;
  const auto read = read_slots(f.as_written);
  for (const Binding& b : f.bindings)
    for (const Axis axis : {b.a, b.b})
      if ((b.from == Binding::From::coordinate || b.from == Binding::From::product) &&
          (axis == Axis::tangent || axis == Axis::bitangent))
        f.oriented = f.oriented || read.contains({b.integer, b.slot});
  f.symmetry = symmetry_of(f.as_written, f.bindings);
  f.symmetry_as_meant = holds_kernels(module) ? symmetry_of(f.as_meant, f.bindings_as_meant) : f.symmetry;
  f.notes = compiled.notes;
  if (!compiled.left_out.empty()) f.notes.push_back(without_functions(compiled.left_out));
  for (const std::string& note : {chosen.note, chosen.results.note, undeclared(f)})
    if (!note.empty()) f.notes.push_back(note);
  if (f.as_meant.takes_bits)
    f.notes.push_back(
        "float only: it operates on the bits of a float, which in other precisions are those of its float "
        "value");
  return f;
}

}  // namespace

Function make_function(Source source, const ShaderChoice& choice) {
  const Compiled compiled = compile(source);
  return function_of(std::move(source), choice, compiled);
}

Function make_function(Source source, const ShaderChoice& choice, Compiler& compiler) {
  const Compiled compiled = compiler.compile(source);
  return function_of(std::move(source), choice, compiled);
}

}  // namespace brdf::shader
