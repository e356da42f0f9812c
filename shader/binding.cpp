#include "shader/binding.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "shader/program/lower.h"
#include "shader/program/operations.h"

namespace brdf::shader {
namespace {

std::string last_word(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == name.npos ? name : name.substr(dot + 1);
}

// Creates the parameters and the bindings of a program's inputs.
class Binder {
 public:
  Binder(Function& function, const std::vector<Declared>& declared) : f_(function), declared_(declared) {}

  std::vector<Binding> bind(const Program& program) {
    read_ = read_slots(program);
    std::vector<Binding> out;
    // Arguments first, then globals in the order in which the file declares them.
    std::vector<Input> inputs = program.inputs;
    const auto place = [&](const Input& input) {
      const auto& globals = f_.source.globals;
      return input.argument >= 0 ? -1 : std::ranges::find(globals, input.name) - globals.begin();
    };
    std::ranges::stable_sort(inputs, [&](const Input& a, const Input& b) { return place(a) < place(b); });
    for (const Input& input : inputs) {
      const bool used = std::ranges::any_of(input.slots, [&](std::uint32_t slot) {
        return read_.contains({input.integer, slot});
      });
      add(input, input.integer, used, out);
    }
    return out;
  }

  // Throws InputError if the command line or the file declares a parameter that does not exist.
  void check_declared(const std::set<std::string>& elsewhere) const {
    for (const Declared& d : declared_) {
      if (used_.contains(d.name) || elsewhere.contains(d.name)) continue;
      std::vector<std::string> known;
      for (const Parameter& p : f_.parameters) known.push_back(p.name);
      if (std::ranges::find(f_.source.globals, d.name) == f_.source.globals.end())
        throw InputError(said_by(d) + ": is not an argument, uniform or global variable of " + f_.entry +
                         (known.empty() ? "" : " (its parameters: " + io::joined(known) + ")"));
    }
  }

 private:
  static constexpr double kMostWhole = 2147483647;

  std::string said_by(const Declared& d) const {
    return d.line > 0 ? f_.source.name + ":" + std::to_string(d.line) + ": param " + d.name
                      : "--param " + d.name;
  }

  // The name that determines the meaning of an input: the name on the entry line, if that line names the
  // argument.
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
    // Declarations of the command line come last and take precedence.
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
    if (f_.draws && !declared && add_random(input, name, integer, out)) return;
    const auto meaning = declared || integer ? std::nullopt : meaning_of(name, vector);
    if (meaning) return add_meaning(*meaning, input, out);
    if (!used && !declared) {
      for (const std::uint32_t slot : input.slots) out.push_back({Binding::From::zero, slot, integer});
      return;
    }
    if (input.type.ends_with("]") || input.type.starts_with("mat") || (integer && input.slots.size() > 1))
      return add_numbers(input, name, declared, out);
    if (input.type == "vec4") {  // a colour, and a number of its own if that is read
      Input colour = input;
      colour.slots.pop_back();
      add_parameter(colour, name, declared, false, out);
      if (!read_.contains({false, input.slots[3]}))
        return out.push_back({Binding::From::one, input.slots[3]});
      const Declared* const own = declaration(name + "_w");
      const std::size_t before = f_.parameters.size();
      add_parameter({input.name, "float", {input.slots[3]}, false, input.argument}, name + "_w", own, false,
                    out);
      if (!own && f_.parameters.size() > before) f_.parameters.back().initial.fill(1);
      return;
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

  Axis seen(Axis axis) const {
    if (!f_.exchanged) return axis;
    return axis == Axis::light ? Axis::view : axis == Axis::view ? Axis::light : axis;
  }

  // Binds an input of a sampler that is a random number, or the state of a generator, which has no effect
  // because the generator's calls are replaced. Returns false for other inputs.
  bool add_random(const Input& input, const std::string& name, bool integer, std::vector<Binding>& out) {
    if (integer && input.type != "bool") {
      for (const std::uint32_t slot : input.slots) out.push_back({Binding::From::zero, slot, true});
      return true;
    }
    if (integer || (input.name != kRandomInput && !is_random(last_word(name), input.slots.size())))
      return false;
    const auto [at, fresh] = random_of_.try_emplace(name, f_.randoms);
    for (std::size_t k = 0; k < input.slots.size(); ++k) {
      Binding b{Binding::From::random, input.slots[k]};
      b.value = at->second + k;
      out.push_back(b);
    }
    if (fresh) f_.randoms += input.slots.size();
    return true;
  }

  // Adds a parameter for each number of an array or a matrix that is read: NAME_0 and so on.
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
                         " numbers are used: write the values into the file");
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
        b.a = seen(m.a);
        b.component = int(k);
      } else if (m.kind == Meaning::Kind::product) {
        b.from = Binding::From::product;
        b.a = seen(m.a), b.b = seen(m.b);
      }
      out.push_back(b);
    }
  }

  void add_parameter(const Input& input, const std::string& name, const Declared* declared, bool integer,
                     std::vector<Binding>& out) {
    std::string word = last_word(name);
    std::ranges::replace(word, '.', '_');
    const bool boolean = input.type == "bool" || (input.type == "uint" && input.argument < 0 &&
                                                  is_declared_bool(last_word(input.name)));
    const auto known = known_.find(name);
    if (known == known_.end()) {
      Parameter p;
      p.name = word;
      for (int n = 2;
           std::ranges::any_of(f_.parameters, [&](const Parameter& q) { return q.name == p.name; }); ++n)
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
      if (p.whole && !p.boolean)
        throw InputError(f_.source.name + ": " + p.name + " of " + f_.entry +
                         " is a whole number without a range: give one with --param " + p.name +
                         "=MIN:MAX:DEFAULT or a line `//: param " + p.name + " MIN MAX DEFAULT`");
      if (!p.boolean) p.doc += "; the file gives no range";
      if (const auto value = initial_in_text(p.name))
        p.initial.fill(*value), p.min = std::min(0.0, *value), p.max = std::max(1.0, *value);
      return;
    }
    p.declared = true;
    p.min = declared->min.value_or(0);
    p.max = declared->max.value_or(1);
    p.log_scale = declared->log_scale;
    p.role = declared->role;
    p.whole = p.whole || declared->boolean;
    double middle = p.log_scale && p.min > 0 ? std::sqrt(p.min * p.max) : (p.min + p.max) / 2;
    if (p.whole) middle = std::floor(middle);
    for (std::size_t k = 0; k < 3; ++k)
      p.initial[k] =
          declared->initial.empty() ? middle : declared->initial[std::min(k, declared->initial.size() - 1)];
    p.min = std::min(p.min, *std::ranges::min_element(p.initial));
    p.max = std::max(p.max, *std::ranges::max_element(p.initial));
    if (p.whole) require_whole_numbers(p, *declared);
  }

  void require_whole_numbers(const Parameter& p, const Declared& declared) const {
    const bool truth = p.boolean || declared.boolean;
    for (const double value : {p.min, p.max, p.initial[0]})
      if (value != std::floor(value) || std::abs(value) > kMostWhole || (truth && value != 0 && value != 1))
        throw InputError(said_by(declared) + ": " + io::to_text(value) +
                         (truth ? " must be 0 or 1, because the parameter is a truth value"
                                : " must be a whole number below 2^31"));
  }

  // Returns whether the text declares the name as bool, and as no other integer, outside all functions: a
  // block of constants stores truth values as integers.
  bool is_declared_bool(const std::string& name) const {
    const std::vector<Token> tokens = tokens_of(f_.source.whole);
    std::vector<bool> open;  // of each bracket that is open: whether a function's arguments or body are in it
    bool boolean = false;
    for (std::size_t k = 1; k < tokens.size(); ++k) {
      if (tokens[k].is("(") || tokens[k].is("{")) open.push_back(tokens[k].is("(") || tokens[k - 1].is(")"));
      if ((tokens[k].is(")") || tokens[k].is("}")) && !open.empty()) open.pop_back();
      if (!tokens[k].is(name) || std::ranges::find(open, true) != open.end()) continue;
      if (tokens[k - 1].is("int") || tokens[k - 1].is("uint")) return false;
      boolean = boolean || tokens[k - 1].is("bool");
    }
    return boolean;
  }

  // The initial value in "uniform float NAME = 0.3;"; std::nullopt if the text has no such line.
  std::optional<double> initial_in_text(const std::string& name) const {
    const std::string& text = f_.source.whole;
    const std::vector<Token> tokens = tokens_of(text);
    for (std::size_t k = 2; k + 2 < tokens.size(); ++k) {
      const bool uniform = tokens[k - 2].is("uniform") || (k > 2 && tokens[k - 3].is("uniform"));
      if (!uniform || !tokens[k].is(name) || !tokens[k + 1].is("=")) continue;
      const std::size_t begin = std::size_t(tokens[k + 2].text.data() - text.data());
      std::string value = text.substr(begin, text.find_first_of(";,", begin) - begin);
      std::erase_if(value, [](char c) { return c == ' ' || c == '\n'; });
      if (value == "true") return 1;
      if (double number; io::parse_number(value, number)) return number;
    }
    return std::nullopt;
  }

  Function& f_;
  const std::vector<Declared>& declared_;
  std::map<std::string, std::size_t> known_;      // first value of the input with that name
  std::map<std::string, std::size_t> random_of_;  // first random number of the input with that name
  std::set<std::string> used_;
  std::set<std::pair<bool, std::uint32_t>> read_;  // slots of the program that is being bound
};

}  // namespace

std::set<std::pair<bool, std::uint32_t>> read_slots(const Program& p) {
  std::set<std::pair<bool, std::uint32_t>> out;
  for (const std::uint32_t slot : p.results) out.insert({false, slot});
  for (const Stretch& s : p.stretches) {
    if (s.end == End::branch) out.insert({true, s.condition});
    for (const Step& step : s.steps) {
      const Operation& o = operation(step.op);
      const std::uint32_t slots[] = {step.a, step.b, step.c};
      for (int k = 0; k < o.count(); ++k) {
        const std::uint32_t width = k == 0 && o.loads() ? step.c : 1;
        for (std::uint32_t j = 0; j < width; ++j) out.insert({o.reads_integer(k), slots[k] + j});
      }
    }
  }
  return out;
}

namespace {

Binder bound_binder(Function& f, Function* in_half) {
  Binder binder(f, f.source.parameters);
  f.bindings = binder.bind(f.as_written);
  f.bindings_as_meant = binder.bind(f.as_meant);
  if (in_half != nullptr) in_half->bindings = in_half->bindings_as_meant = binder.bind(in_half->as_written);
  return binder;
}

}  // namespace

void bind_inputs(Function& f, Function* in_half, const std::set<std::string>& elsewhere) {
  bound_binder(f, in_half).check_declared(elsewhere);
}

void bind_companion(Function& f) {
  bound_binder(f, nullptr);
}

}  // namespace brdf::shader
