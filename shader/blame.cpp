#include "shader/blame.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/numbers.h"
#include "shader/program/operands.h"

namespace brdf::shader {
namespace {

// One step as it was run: its operands and which entry made each (-1: an input or a constant).
struct Entry {
  const Step* step;
  double result;
  double operand[3];
  int from[3];
};

struct Trace {
  std::vector<Entry> entries;
  int last = -1;  // that made the result
  double result = 0;
};

template <class T>
Trace traced(const Function& f, const Program& program, const std::vector<Binding>&,
             std::span<const double> values, const Vec3<double>& wi, const Vec3<double>& wo,
             std::size_t component) {
  std::vector<T> rounded;
  for (const double v : values) rounded.push_back(Functions<T>::number(v));
  const auto convert = [](const Vec3<double>& w) { return Vec3<T>{T(w.x), T(w.y), T(w.z)}; };
  Runner<T, 1> runner(f);
  runner.set_values(f, rounded);
  runner.set_directions(f, convert(wi), convert(wo));
  Bank<T, 1>& bank = runner.bank();
  std::vector<int> writer(program.numbers, -1);
  std::vector<double> before(
      program.numbers);  // values as the steps read them: a step may overwrite its operand
  for (std::uint32_t slot = 0; slot < program.numbers; ++slot)
    before[slot] = Functions<T>::value(*bank.number(slot));
  Trace trace;
  constexpr std::size_t kMostEntries = 1u << 20;
  run_watched<T>(program, bank, [&](const Step& step) {
    const Operands o = operands_of(step.op);
    const std::uint32_t slots[] = {step.a, step.b, step.c};
    Entry e{&step, 0, {NAN, NAN, NAN}, {-1, -1, -1}};
    for (int k = 0; k < o.count; ++k) {
      if (o.integer[k]) continue;
      std::uint32_t slot = slots[k];
      if (o.indexed_load) slot += std::min(*bank.integer(step.b), step.c - 1);
      e.operand[k] = before[slot];
      e.from[k] = writer[slot];
    }
    if (o.result_integer) return;
    std::uint32_t r = step.r;
    if (o.indexed_store) r += std::min(*bank.integer(step.b), step.c - 1);
    e.result = before[r] = Functions<T>::value(*bank.number(r));
    if (step.op == Op::select) {  // what was taken
      const bool yes = *bank.integer(step.a) != 0;
      e.operand[0] = e.operand[yes ? 1 : 2];
      e.from[0] = e.from[yes ? 1 : 2];
      e.operand[1] = e.operand[2] = NAN;
      e.from[1] = e.from[2] = -1;
    }
    if (trace.entries.size() >= kMostEntries) return;
    trace.entries.push_back(e);
    writer[r] = int(trace.entries.size()) - 1;
  });
  const std::uint32_t slot = program.results[std::min(component, program.results.size() - 1)];
  trace.last = writer[slot];
  trace.result = before[slot];
  return trace;
}

int operands_in(const Entry& e) {
  return e.step->op == Op::select ? 1 : operands_of(e.step->op).count;
}

bool only_passes_on(Op op) {
  return op == Op::copy || op == Op::select || op == Op::load_number || op == Op::store_number;
}

// The operand to follow; nothing: it begins here.
std::optional<int> not_finite_operand(const Entry& e) {
  const Operands o = operands_of(e.step->op);
  for (int k = 0; k < operands_in(e); ++k)
    if ((e.step->op == Op::select || !o.integer[k]) && !std::isfinite(e.operand[k])) return k;
  return std::nullopt;
}

std::optional<int> negative_operand(const Entry& e) {
  const double a = e.operand[0], b = e.operand[1];
  switch (e.step->op) {
    case Op::mul:
    case Op::div:
      return a < 0 ? 0 : 1;
    case Op::add:  // of two signs: here it goes below 0
      return a < 0 && b < 0 ? std::optional(a < b ? 0 : 1) : std::nullopt;
    case Op::sub:
      return a < 0 ? std::optional(0) : std::nullopt;
    case Op::min:
    case Op::max:
      return e.result == a ? 0 : 1;
    case Op::mix:
      return a < 0 ? std::optional(0) : b < 0 ? std::optional(1) : std::nullopt;
    default:
      return only_passes_on(e.step->op) ? std::optional(0) : std::nullopt;
  }
}

template <class Next>
const Entry* follow(const Trace& trace, Next&& next) {
  const Entry* e = trace.last < 0 ? nullptr : &trace.entries[std::size_t(trace.last)];
  while (e) {
    const std::optional<int> k = next(*e);
    if (!k || e->from[*k] < 0) return e;
    e = &trace.entries[std::size_t(e->from[*k])];
  }
  return nullptr;
}

const char* sign_of(Op op) {
  switch (op) {
    case Op::add:
      return " + ";
    case Op::sub:
      return " - ";
    case Op::mul:
      return " * ";
    case Op::div:
      return " / ";
    default:
      return nullptr;
  }
}

const char* name_of(Op op) {
  constexpr const char* kNames[] = {
      "",     "",      "",           "",      "",      "-",         "mod",   "rem",  "abs",
      "sign", "floor", "ceil",       "trunc", "round", "roundEven", "fract", "sqrt", "inversesqrt",
      "exp",  "exp2",  "log",        "log2",  "pow",   "sin",       "cos",   "tan",  "asin",
      "acos", "atan",  "atan",       "sinh",  "cosh",  "tanh",      "min",   "max",  "clamp",
      "mix",  "step",  "smoothstep", "fma",   "log1p", "erfcx",     "angle"};
  return std::size_t(op) < std::size(kNames) ? kNames[std::size_t(op)] : "";
}

std::string operation_text(const Entry& e) {
  const auto number = [](double x) { return std::isnan(x) ? "no number" : io::short_number(x, 6); };
  const std::string equals = " = " + number(e.result);
  if (const char* sign = sign_of(e.step->op))
    return number(e.operand[0]) + sign + number(e.operand[1]) + equals;
  if (only_passes_on(e.step->op)) return number(e.operand[0]);
  std::string text = std::string(name_of(e.step->op)) + "(";
  for (int k = 0; k < operands_in(e); ++k) text += (k > 0 ? ", " : "") + number(e.operand[k]);
  return text + ")" + equals;
}

Blame made(const Function& f, const Entry* e, std::string operation = {}) {
  Blame b;
  if (!e) return b;
  b.line = e->step->line;
  b.expression = line_of_text(f.source.text, b.line);
  b.operation = operation.empty() ? operation_text(*e) : std::move(operation);
  return b;
}

// Float and double of the same steps, side by side; where they part, what they part at.
Blame lost_digits(const Function& f, std::span<const double> values, const Vec3<double>& wi,
                  const Vec3<double>& wo, std::size_t component) {
  const auto rounded = [](double x) { return double(float(x)); };
  std::vector<double> at;
  for (const double v : values) at.push_back(rounded(v));
  const Vec3<double> i{rounded(wi.x), rounded(wi.y), rounded(wi.z)},
      o{rounded(wo.x), rounded(wo.y), rounded(wo.z)};
  const Trace single = traced<float>(f, f.as_written, f.bindings, at, i, o, component),
              wide = traced<double>(f, f.as_meant, f.bindings_as_meant, at, i, o, component);
  if (!std::isfinite(single.result)) return made(f, follow(single, not_finite_operand));
  const std::size_t common = std::min(single.entries.size(), wide.entries.size());
  const auto same_step = [](const Entry& a, const Entry& b) {
    return a.step->op == b.step->op && a.step->r == b.step->r && a.step->line == b.step->line;
  };
  for (std::size_t k = 0; k < common; ++k)
    if (!same_step(single.entries[k], wide.entries[k]))
      return made(f, k > 0 ? &single.entries[k] : nullptr, "float goes another way than double");
  const auto error = [&](int entry) {
    const double a = single.entries[std::size_t(entry)].result, b = wide.entries[std::size_t(entry)].result;
    return a == b ? 0 : std::abs(a - b) / std::max(std::abs(b), 1e-300);
  };
  int e = single.last;
  while (e >= 0) {
    const Entry& entry = single.entries[std::size_t(e)];
    int worst = -1;
    for (const int from : entry.from)
      if (from >= 0 && (worst < 0 || error(from) > error(worst))) worst = from;
    if (worst < 0 || !(error(worst) > 0.3 * error(e))) break;
    e = worst;
  }
  if (e < 0) return {};
  const Entry& entry = single.entries[std::size_t(e)];
  return made(
      f, &entry,
      operation_text(entry) + ", in double " + io::short_number(wide.entries[std::size_t(e)].result, 6));
}

}  // namespace

template <class T>
Blame blame(const Function& f, Fault fault, std::span<const double> values, const Vec3<double>& wi,
            const Vec3<double>& wo, std::size_t component) {
  if (fault == Fault::loses_digits) return lost_digits(f, values, wi, wo, component);
  const Trace trace = traced<T>(f, f.program<T>(), f.bound<T>(), values, wi, wo, component);
  if (fault == Fault::not_finite)
    return std::isfinite(trace.result) ? Blame{} : made(f, follow(trace, not_finite_operand));
  return trace.result < 0 ? made(f, follow(trace, negative_operand)) : Blame{};
}
template Blame blame<float>(const Function&, Fault, std::span<const double>, const Vec3<double>&,
                            const Vec3<double>&, std::size_t);
template Blame blame<double>(const Function&, Fault, std::span<const double>, const Vec3<double>&,
                             const Vec3<double>&, std::size_t);

std::string to_text(const Blame& b) {
  if (b.operation.empty()) return "";
  if (b.line == 0) return b.operation;
  return "line " + std::to_string(b.line) + ", `" + b.expression + "`: " + b.operation;
}

}  // namespace brdf::shader
