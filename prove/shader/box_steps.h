// Executes one step of a shader's program on ranges of its operands, and records undefined results.
#pragma once

#include <optional>
#include <vector>

#include "prove/shader/way.h"
#include "shader/undefined.h"

namespace brdf::prove {

template <class B>
class BoxSteps {
 public:
  using I = Interval<B>;

  explicit BoxSteps(const shader::Program& program) : tables_(program.tables) {}
  // Discards the reasons of another run.
  void start_over() { reasons_.resize(2, {shader::Undefined::variable, 0, {}}); }
  // Executes a step on the state of a way.
  void apply(Way<B>& w, const shader::Step& s);

  // Returns the reason for the mark of a slot; the mark is not 0.
  const shader::UndefinedValue& reason(std::uint32_t mark) const { return reasons_[mark - 1]; }

  // Returns whether the step divides a coordinate by the length of its vector.
  static bool of_length(const Way<B>& w, const shader::Step& s);

 private:
  // Returns the reason of an operand, placed at this step if it names no line yet; otherwise the reason of
  // the step.
  std::uint32_t reason_of(const Way<B>& w, const shader::Step& s, std::optional<shader::Undefined> own);
  std::uint32_t placed(std::uint32_t reason, const shader::Step& s);
  std::uint32_t reason_of_choice(const Way<B>& w, const shader::Step& s, const Whole& truth);
  void select(Way<B>& w, const shader::Step& s);
  void to_integer(Way<B>& w, const shader::Step& s);
  void read_texel(Way<B>& w, const shader::Step& s);
  void from_integer(Way<B>& w, const shader::Step& s);
  void apply_comparison(Way<B>& w, const shader::Step& s);
  void apply_numbers(Way<B>& w, const shader::Step& s);
  void apply_integers(Way<B>& w, const shader::Step& s);
  void load(Way<B>& w, const shader::Step& s);
  void store(Way<B>& w, const shader::Step& s);

  std::vector<std::shared_ptr<const shader::TexelTable>> tables_;
  std::vector<shader::UndefinedValue> reasons_{{shader::Undefined::variable, 0, {}},
                                               {shader::Undefined::no_return, 0, {}}};
};

}  // namespace brdf::prove
