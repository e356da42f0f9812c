#include "shader/blame.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/files/numbers.h"
#include "shader/program/half.h"
#include "shader/program/lower.h"
#include "shader/trace.h"

namespace brdf::shader {
namespace {

int operands_in(const Entry& e) {
  return e.step->op == Op::select ? 1 : operation(e.step->op).count();
}

bool only_passes_on(Op op) {
  return op == Op::copy || op == Op::select || op == Op::load_number || op == Op::store_number;
}

// The operand to follow; std::nullopt: the fault begins at this entry.
std::optional<int> not_finite_operand(const Entry& e) {
  const Operation& o = operation(e.step->op);
  for (int k = 0; k < operands_in(e); ++k)
    if ((e.step->op == Op::select || !o.reads_integer(k)) && !std::isfinite(e.operand[k])) return k;
  return std::nullopt;
}

std::optional<int> negative_operand(const Entry& e) {
  const double a = e.operand[0], b = e.operand[1];
  switch (e.step->op) {
    case Op::mul:
    case Op::div:
      return a < 0 ? 0 : 1;
    case Op::add:  // with operands of both signs the sum becomes negative here
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
      "mix",  "step",  "smoothstep", "fma",   "log1p", "erfcx",     "angle", "half"};
  return std::size_t(op) < std::size(kNames) ? kNames[std::size_t(op)] : "";
}

std::string operation_text(const Entry& e) {
  const auto number = [](double x) { return std::isnan(x) ? "not a number" : io::short_number(x, 6); };
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

// The last step before two runs take different paths; null if they take the same path.
const Entry* first_other_way(const Trace& a, const Trace& b) {
  const std::size_t common = std::min(a.entries.size(), b.entries.size());
  for (std::size_t k = 1; k < common; ++k) {
    const Step &x = *a.entries[k].step, &y = *b.entries[k].step;
    if (x.op != y.op || x.r != y.r || x.line != y.line) return &a.entries[k - 1];
  }
  return nullptr;
}

// Follows two runs of the same steps back from entry `e`. Returns the entry at which the runs differ while
// its operands differ far less; -1 if there is no entry.
int where_they_part(const Trace& a, const Trace& b, int e) {
  const auto error = [&](int entry) {
    const double x = a.entries[std::size_t(entry)].result, y = b.entries[std::size_t(entry)].result;
    return x == y ? 0 : std::abs(x - y) / std::max(std::abs(y), 1e-300);
  };
  while (e >= 0) {
    const Entry& entry = a.entries[std::size_t(e)];
    int worst = -1;
    for (const int from : entry.from)
      if (from >= 0 && (worst < 0 || error(from) > error(worst))) worst = from;
    if (worst < 0 || !(error(worst) > 0.3 * error(e))) break;
    e = worst;
  }
  return e;
}

// The text of a step that rounds to half precision, with the operation that made its operand.
std::string rounding_text(const Trace& trace, const Entry& e) {
  std::string text = e.from[0] < 0 ? io::short_number(e.operand[0], 6)
                                   : operation_text(trace.entries[std::size_t(e.from[0])]);
  text += ", in half precision " + io::short_number(e.result, 6);
  if (std::isinf(e.result)) return text + " (an overflow: the largest number is 65504)";
  const bool small = std::abs(e.operand[0]) < double(kLeastNormalHalf);
  return text + (small ? " (an underflow: the least normal number is 6.1e-05)" : "");
}

Blame made_in_half(const Function& f, const Trace& trace, const Entry* e, const std::string& rest = "") {
  if (!e || e->step->op != Op::to_half) return made(f, e);
  return made(f, e, rounding_text(trace, *e) + rest);
}

// Returns the operand that differs most between the two runs of a step; -1 if no operand differs visibly.
int different_operand(const Trace& a, const Trace& b, const Entry& e) {
  int worst = -1;
  double most = 0.01;
  for (const int from : e.from) {
    if (from < 0 || std::size_t(from) >= b.entries.size()) continue;
    const double x = a.entries[std::size_t(from)].result, y = b.entries[std::size_t(from)].result;
    const double error = std::abs(x - y) / std::max(std::abs(y), 1e-300);
    if (error > most) most = error, worst = from;
  }
  return worst;
}

// Compares float, or half precision, with double for the same steps. Returns the operation at which they
// take different paths or at which their values separate.
Blame lost_digits(const Function& f, std::span<const double> values, const Vec3<double>& wi,
                  const Vec3<double>& wo, std::size_t component) {
  const auto rounded = [](double x) { return double(float(x)); };
  std::vector<double> at;
  for (const double v : values) at.push_back(rounded(v));
  const Vec3<double> i{rounded(wi.x), rounded(wi.y), rounded(wi.z)},
      o{rounded(wo.x), rounded(wo.y), rounded(wo.z)};
  const Trace single = traced<float>(f, at, i, o, component), wide = traced<double>(f, at, i, o, component);
  const Entry* const other = first_other_way(single, wide);
  const bool is_half = first_half(f.as_written).has_value();
  int e = single.last;
  std::string rest;
  if (!std::isfinite(single.result)) {
    const Entry* const first = follow(single, not_finite_operand);
    // A quotient by a number that half precision has made 0, for example.
    e = first && !other && is_half ? different_operand(single, wide, *first) : -1;
    if (e < 0) return made_in_half(f, single, first);
    rest = "; then " + (first->step->line > 0 ? "line " + std::to_string(first->step->line) + ": " : "") +
           operation_text(*first);
  } else if (other) {
    return made(f, other,
                std::string(is_half ? "half precision" : "float") + " takes a different branch than double");
  }
  e = where_they_part(single, wide, e);
  if (e < 0) return {};
  const Entry& entry = single.entries[std::size_t(e)];
  rest = ", in double " + io::short_number(wide.entries[std::size_t(e)].result, 6) + rest;
  if (entry.step->op == Op::to_half) return made_in_half(f, single, &entry, rest);
  return made(f, &entry, operation_text(entry) + (is_half ? " with operands in half precision" : "") + rest);
}

}  // namespace

template <class T>
Blame blame(const Function& f, Fault fault, std::span<const double> values, const Vec3<double>& wi,
            const Vec3<double>& wo, std::size_t component) {
  if (fault == Fault::loses_digits) return lost_digits(f, values, wi, wo, component);
  const Trace trace = traced<T>(f, values, wi, wo, component);
  if (fault == Fault::not_finite)
    return std::isfinite(trace.result) ? Blame{} : made(f, follow(trace, not_finite_operand));
  return trace.result < 0 ? made(f, follow(trace, negative_operand)) : Blame{};
}
template Blame blame<float>(const Function&, Fault, std::span<const double>, const Vec3<double>&,
                            const Vec3<double>&, std::size_t);
template Blame blame<double>(const Function&, Fault, std::span<const double>, const Vec3<double>&,
                             const Vec3<double>&, std::size_t);

Blame blame_jump(const Function& f, std::span<const double> values, const DirectionPair& here,
                 const DirectionPair& there, std::size_t component) {
  const Trace a = traced<double>(f, values, here.wi, here.wo, component),
              b = traced<double>(f, values, there.wi, there.wo, component);
  const std::size_t common = std::min(a.decisions.size(), b.decisions.size());
  for (std::size_t k = 0; k < common; ++k) {
    const Decision &x = a.decisions[k], &y = b.decisions[k];
    if (x.step != y.step) break;
    if (x.result == y.result) continue;
    Blame blame;
    blame.line = x.step->line;
    blame.expression = line_of_text(f.source.text, blame.line);
    const bool two = operation(x.step->op).count() > 1;
    blame.operation = two ? io::short_number(x.operand[0], 6) + " passes " + io::short_number(x.operand[1], 6)
                          : io::short_number(x.operand[0], 6) + " becomes a different integer";
    return blame;
  }
  if (first_other_way(a, b)) return {};
  const int e = where_they_part(a, b, a.last);
  if (e < 0) return {};
  return made(f, &a.entries[std::size_t(e)],
              operation_text(a.entries[std::size_t(e)]) + ", and at a neighbouring direction " +
                  io::short_number(b.entries[std::size_t(e)].result, 6));
}

std::string to_text(const Blame& b) {
  if (b.operation.empty()) return "";
  if (b.line == 0) return b.operation;
  return "line " + std::to_string(b.line) + ", `" + b.expression + "`: " + b.operation;
}

}  // namespace brdf::shader
