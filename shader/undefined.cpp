#include "shader/undefined.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "shader/program/operations.h"

namespace brdf::shader {
namespace {

// Marks slots with a value that depends on an undefined value, with the first reason. Mark 0 is a defined
// value.
class Marks {
 public:
  explicit Marks(const Program& p) : numbers_(p.numbers, kUnwritten), integers_(p.integers, kUnwritten) {
    reasons_ = {{Undefined::variable, 0, {}}, {Undefined::no_return, 0, {}}};
    for (const Program::Constant& c : p.constants) numbers_[c.slot] = 0;
    for (const Program::IntegerConstant& c : p.integer_constants) integers_[c.slot] = 0;
    for (const Program::Undefined& u : p.undefined)
      of(u.integer)[u.slot] = u.why == Unset::variable ? kUnwritten : kNoReturn;
  }
  void define(bool integer, std::uint32_t slot) { of(integer)[slot] = 0; }
  std::uint32_t at(bool integer, std::uint32_t slot) const { return (integer ? integers_ : numbers_)[slot]; }

  // Assigns the line to a mark that has no line yet, as a new reason.
  std::uint32_t placed(std::uint32_t mark, std::uint32_t line) {
    if (mark == 0 || reasons_[mark - 1].line > 0 || line == 0) return mark;
    reasons_.push_back(reasons_[mark - 1]);
    reasons_.back().line = line;
    return std::uint32_t(reasons_.size());
  }
  std::uint32_t add(const UndefinedValue& reason) {
    reasons_.push_back(reason);
    return std::uint32_t(reasons_.size());
  }
  void set(bool integer, std::uint32_t slot, std::uint32_t mark) { of(integer)[slot] = mark; }
  const UndefinedValue& reason(std::uint32_t mark) const { return reasons_[mark - 1]; }

 private:
  static constexpr std::uint32_t kUnwritten = 1, kNoReturn = 2;
  std::vector<std::uint32_t>& of(bool integer) { return integer ? integers_ : numbers_; }

  std::vector<std::uint32_t> numbers_, integers_;
  std::vector<UndefinedValue> reasons_;
};

template <class T>
class MarkedRun {
 public:
  MarkedRun(const Function& f, std::span<const double> values, const Vec3<double>& wi, const Vec3<double>& wo)
      : program_(f.program<T>()), runner_(f), marks_(program_) {
    std::vector<T> rounded;
    for (const double v : values) rounded.push_back(Functions<T>::number(v));
    const auto lanes = [&](const Vec3<double>& w) {
      return runner_.lanes_of(Vec3<T>{T(w.x), T(w.y), T(w.z)});
    };
    runner_.set_values(f, rounded);
    runner_.set_directions(f, lanes(wi), lanes(wo));
    for (const Binding& b : f.bound<T>()) marks_.define(b.integer, b.slot);
  }

  std::optional<UndefinedValue> run() {
    std::uint32_t found = 0;
    run_watched<T>(
        program_, runner_.bank(), [&](const Step& s) { follow(s); }, kMostStepsRun,
        [&](const Stretch& s) {
          if (found == 0 && s.end == End::branch) found = marks_.placed(marks_.at(true, s.condition), s.line);
        });
    bool is_finite = true;
    for (const std::uint32_t slot : program_.results) {
      if (found == 0) found = marks_.at(false, slot);
      is_finite = is_finite && std::isfinite(number(slot));
    }
    if (found == 0) return std::nullopt;
    UndefinedValue reason = marks_.reason(found);
    if (!is_finite && shows_in_result(reason.why)) return std::nullopt;
    if (reason.line == 0) reason.line = program_.line;  // only the return has read the value
    return reason;
  }

 private:
  // Every driver gives NaN or infinity outside the domain of these functions. A result that is not finite
  // is the finding of another check; a finite result that depends on such a value is undefined.
  static bool shows_in_result(Undefined why) {
    return why == Undefined::root || why == Undefined::logarithm || why == Undefined::arc;
  }
  double number(std::uint32_t slot) { return Functions<T>::value(*runner_.bank().number(slot)); }
  std::uint32_t integer(std::uint32_t slot) { return *runner_.bank().integer(slot); }

  // The first mark among the operands that determine the result.
  std::uint32_t mark_of_operands(const Step& s, const Operation& o) {
    if (s.op == Op::select || s.op == Op::iselect) {
      const std::uint32_t condition = marks_.at(true, s.a);
      return condition > 0 ? condition : marks_.at(s.op == Op::iselect, integer(s.a) != 0 ? s.b : s.c);
    }
    if (o.loads()) {
      const std::uint32_t at = marks_.at(true, s.b);
      return at > 0 ? at : marks_.at(o.reads_integer(0), s.a + std::min(integer(s.b), s.c - 1));
    }
    const std::uint32_t slots[] = {s.a, s.b, s.c};
    for (int k = 0; k < o.count(); ++k)
      if (const std::uint32_t mark = marks_.at(o.reads_integer(k), slots[k]); mark > 0) return mark;
    return 0;
  }

  void follow(const Step& s) {
    const Operation& o = operation(s.op);
    const auto place = [&](std::uint32_t mark) {
      return s.op == Op::copy || s.op == Op::icopy ? mark : marks_.placed(mark, s.line);
    };
    if (o.stores()) {
      const std::uint32_t at = place(marks_.at(true, s.b)), value = place(marks_.at(o.reads_integer(0), s.a));
      // With an undefined index, any element may be the one that is written.
      for (std::uint32_t k = 0; k < s.c; ++k)
        if (at > 0 || k == std::min(integer(s.b), s.c - 1))
          marks_.set(o.writes_integer(), s.r + k, at > 0 ? at : value);
      return;
    }
    std::uint32_t mark = place(mark_of_operands(s, o));
    // A later step may hide a value that would show in the result.
    if (mark == 0 || shows_in_result(marks_.reason(mark).why))
      if (const auto why = undefined_step(
              s, [&](std::uint32_t slot) { return number(slot); },
              [&](std::uint32_t slot) { return integer(slot); }))
        mark = marks_.add({*why, s.line, operands(s, o)});
    marks_.set(o.writes_integer(), s.r, mark);
  }

  std::array<double, 2> operands(const Step& s, const Operation& o) {
    if (o.reads_integer(0)) return {double(std::int32_t(integer(s.a))), double(std::int32_t(integer(s.b)))};
    return {number(s.a), o.count() > 1 ? number(s.b) : 0};
  }

  const Program& program_;
  Runner<T, 1> runner_;
  Marks marks_;
};

struct Sentence {
  Undefined why;
  int operands;  // number of operands that the text shows
  std::string_view text;
};
constexpr Sentence kSentences[] = {
    {Undefined::variable, 0, "a variable is read before it is written"},
    {Undefined::no_return, 0, "a path ends without a return"},
    {Undefined::index, 2, "an index is outside its array"},
    {Undefined::division, 2, "integers are divided by 0 or beyond their range"},
    {Undefined::remainder, 2, "the remainder of an integer below 0"},
    {Undefined::shift, 2, "a shift by 32 bits or more"},
    {Undefined::conversion, 1, "a number is outside the range of the integer type"},
    {Undefined::pow, 2, "pow of a base below 0, or of 0 to an exponent that is not above 0"},
    {Undefined::atan, 2, "atan of two zeros"},
    {Undefined::root, 1, "sqrt of a number below 0, or inversesqrt of one that is not above 0"},
    {Undefined::logarithm, 1, "a logarithm of a number that is not above 0"},
    {Undefined::arc, 1, "asin or acos of a number outside -1 to 1"},
    {Undefined::smoothstep, 2, "smoothstep with a lower edge that is not below the upper edge"},
    {Undefined::clamp, 0, "clamp with a lower limit above the upper limit"},
    {Undefined::min_max, 2, "min or max of NaN"},
};

const Sentence& row_of(Undefined why) {
  return *std::find_if(std::begin(kSentences), std::end(kSentences),
                       [&](const Sentence& s) { return s.why == why; });
}

}  // namespace

template <class T>
std::optional<UndefinedValue> undefined_value(const Function& function, std::span<const double> values,
                                              const Vec3<double>& wi, const Vec3<double>& wo) {
  return MarkedRun<T>(function, values, wi, wo).run();
}
template std::optional<UndefinedValue> undefined_value<float>(const Function&, std::span<const double>,
                                                              const Vec3<double>&, const Vec3<double>&);
template std::optional<UndefinedValue> undefined_value<double>(const Function&, std::span<const double>,
                                                               const Vec3<double>&, const Vec3<double>&);

std::string_view sentence_of(Undefined why) {
  return row_of(why).text;
}

std::string to_text(const Function& function, const UndefinedValue& value) {
  const Sentence& row = row_of(value.why);
  std::string text;
  if (value.line > 0)
    text =
        "line " + std::to_string(value.line) + ", `" + line_of_text(function.source.text, value.line) + "`: ";
  text += sentence_of(value.why);
  if (row.operands == 0) return text;
  text += " (" + io::short_number(value.operands[0], 4);
  return text + (row.operands > 1 ? ", " + io::short_number(value.operands[1], 4) : "") + ")";
}

}  // namespace brdf::shader
