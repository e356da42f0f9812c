// The numbers and integers of a run of W lanes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "brdf/dual.h"
#include "shader/program/operations.h"
#include "shader/program/program.h"
#include "shader/run/functions.h"

namespace brdf::shader {

template <class T, int W>
class Bank {
 public:
  explicit Bank(const Program& p)
      : numbers_(std::size_t(std::max(p.numbers, 1u)) * W, Functions<T>::number(0)),
        integers_(std::size_t(std::max(p.integers, 1u)) * W),
        tables_(p.tables) {
    for (const Program::Constant& c : p.constants) set(c.slot, Functions<T>::number(c.value));
    for (const Program::IntegerConstant& c : p.integer_constants) std::fill_n(integer(c.slot), W, c.value);
  }
  T* number(std::uint32_t slot) { return numbers_.data() + std::size_t(slot) * W; }
  std::uint32_t* integer(std::uint32_t slot) { return integers_.data() + std::size_t(slot) * W; }
  const std::vector<float>& table(std::uint32_t which) const { return tables_[which]->values; }
  const T* number(std::uint32_t slot) const { return numbers_.data() + std::size_t(slot) * W; }
  // Sets the same value in all lanes.
  void set(std::uint32_t slot, const T& value) { std::fill_n(number(slot), W, value); }
  void set_integer(std::uint32_t slot, std::uint32_t value) { std::fill_n(integer(slot), W, value); }

 private:
  std::vector<T> numbers_;
  std::vector<std::uint32_t> integers_;
  std::vector<std::shared_ptr<const TexelTable>> tables_;
};

// The lanes of dual numbers: first the values of all lanes, then their partials one after the other, because
// only contiguous numbers are computed as vectors. Slots that depend on no variable have no partials, and
// steps that write them compute values alone.
template <class B, int N, int W>
class Bank<Dual<B, N>, W> {
 public:
  using T = Dual<B, N>;

  // One number, in place of a reference to it.
  class Number {
   public:
    Number(B* value, B* partials) : value_(value), partials_(partials) {}
    operator T() const {
      return {*value_, Partials<B, N>::make([&](std::size_t k) { return partials_[k * W]; })};
    }
    // An assignment changes the number, not the reference.
    const Number& operator=(const T& x) const {
      *value_ = x.a;
      [&]<std::size_t... k>(std::index_sequence<k...>) {
        ((partials_[k * W] = x.v[k]), ...);
      }(std::make_index_sequence<N>{});
      return *this;
    }
    Number& operator=(const Number& x) {
      std::as_const(*this) = T(x);
      return *this;
    }
    const Number& operator=(const Number& x) const { return *this = T(x); }
    Number(const Number&) = default;

   private:
    B *value_, *partials_;
  };
  // The lanes of a slot, in place of a pointer to the first.
  struct Numbers {
    B *values, *partials;
    Number operator[](std::size_t lane) const { return {values + lane, partials + lane}; }
    Number operator[](int lane) const { return (*this)[std::size_t(lane)]; }
  };

  explicit Bank(const Program& p)
      : values_(p), partials_(std::size_t(std::max(p.numbers, 1u)) * N * W), has_partials_(p.numbers, true) {}
  Numbers number(std::uint32_t slot) {
    return {values_.number(slot), partials_.data() + std::size_t(slot) * N * W};
  }
  std::uint32_t* integer(std::uint32_t slot) { return values_.integer(slot); }
  const std::vector<float>& table(std::uint32_t which) const { return values_.table(which); }
  void set(std::uint32_t slot, const T& value) {
    for (int l = 0; l < W; ++l) number(slot)[l] = value;
  }
  void set_integer(std::uint32_t slot, std::uint32_t value) { values_.set_integer(slot, value); }

  // States which slots may have partials other than 0, and sets the others to 0.
  void set_variables(std::vector<bool> slots) {
    has_partials_ = std::move(slots);
    std::ranges::fill(partials_, B(0));
  }
  bool has_partials(const Step& step) const {
    return !operation(step.op).writes_integer() && has_partials_[step.r];
  }
  Bank<B, W>& values() { return values_; }

 private:
  Bank<B, W> values_;
  std::vector<B> partials_;
  std::vector<bool> has_partials_;
};

}  // namespace brdf::shader
