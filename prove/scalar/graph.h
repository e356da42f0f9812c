// The formula of a form as a graph in which quantities that are certainly equal share one node: same node,
// same bits.
//
// The guarantees of IEEE 754 for every precision, with rounding to nearest, are built in. Sums and products
// commute. A sign passes through products, quotients and sums. The rounding error of a sum is the same in
// both orders (two-sum is exact). Larger and smaller accept either order: the bits are the same except for
// the sign of a zero, by which no form divides. Nothing is reassociated, no constants are folded, and
// kernels are treated as unknown functions.
//
// Choices are taken case by case. A recording follows one assumption for each pair of numbers that is
// compared: less, equal or more. All combinations are recorded in turn. In exact arithmetic (Rules::exact)
// sums and products are also associative. The result holds for numbers, not for NaN, and with contraction
// off.
#pragma once

#include <map>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "brdf/geometry.h"
#include "brdf/scalar.h"

namespace brdf::prove {

enum class Rules { bits, exact };

class Graph {
 public:
  explicit Graph(Rules rules = Rules::bits) : rules_(rules) {}
  Rules rules() const { return rules_; }
  // Returns the terms of a sum or the factors of a product; for any other operator, the node itself.
  std::vector<int> parts(std::string_view op, int node) const;

  // Returns the node of this operator and these operands; `constant` distinguishes constants.
  int node(std::string_view op, const std::vector<int>& operands, double constant = 0);
  // Returns the order of a relative to b, -1, 0 or 1, under the current assumption.
  int compare(int a, int b);

  // Begins the next combination of assumptions; returns false after the last one. The nodes are kept.
  bool next_case();
  std::size_t nodes() const { return known_.size(); }

  static Graph& current();

  class Scope {
   public:
    explicit Scope(Graph& graph);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Graph* previous_;
  };

 private:
  struct Key {
    std::string_view op;
    std::vector<int> operands;
    double constant;
    friend bool operator<(const Key& a, const Key& b) {
      return std::tie(a.op, a.operands, a.constant) < std::tie(b.op, b.operands, b.constant);
    }
  };
  Rules rules_;
  std::map<Key, int> known_;
  std::vector<const Key*> keys_;
  std::map<std::pair<int, int>, std::size_t> asked_;  // pairs compared in this case, in order
  std::vector<int> answers_;                          // -1, 0, 1 for each
};

class Recorded {
 public:
  struct Order {
    int sign;  // of the left relative to the right
  };

  Recorded() : Recorded(0.0) {}
  explicit Recorded(double constant);
  static Recorded input(std::string_view name);

  friend bool operator==(const Recorded&, const Recorded&) = default;

  friend Recorded operator-(const Recorded& x) { return {x.id_, !x.negative_}; }
  friend Recorded operator+(const Recorded& a, const Recorded& b) { return sum("+", a, b); }
  friend Recorded operator-(const Recorded& a, const Recorded& b) { return a + -b; }
  friend Recorded operator*(const Recorded& a, const Recorded& b);
  friend Recorded operator/(const Recorded& a, const Recorded& b);
  friend Recorded sum_rest(const Recorded& a, const Recorded& b, const Recorded&) {
    return sum("rest", a, b);
  }
  friend bool operator<(const Recorded& a, const Recorded& b);
  friend Recorded larger(const Recorded& a, const Recorded& b) { return extreme("max", a, b); }
  friend Recorded smaller(const Recorded& a, const Recorded& b) { return extreme("min", a, b); }
  friend Recorded at_least(const Recorded& x, const Recorded& lower) { return larger(x, lower); }
  friend Recorded at_most(const Recorded& x, const Recorded& upper) { return smaller(x, upper); }

  friend Recorded sqrt(const Recorded& x) { return function("sqrt", x); }
  friend Recorded exp(const Recorded& x) { return function("exp", x); }
  friend Recorded log(const Recorded& x) { return function("log", x); }
  friend Recorded erfcx(const Recorded& x) { return function("erfcx", x); }
  friend Recorded log1p(const Recorded& x, const Recorded& rest) { return function("log1p", x, rest); }
  friend Recorded atan2(const Recorded& y, const Recorded& x) { return function("angle", y, x); }
  friend Recorded upper_half(const Recorded& x) {
    return {function("half", {x.id_, false}).id_, x.negative_};
  }

 private:
  Recorded(int id, bool negative) : id_(id), negative_(negative) {}
  int signed_id() const { return negative_ ? -id_ : id_; }
  static Recorded sum(std::string_view op, const Recorded& a, const Recorded& b);
  static Recorded extreme(std::string_view op, const Recorded& a, const Recorded& b);
  static Recorded function(std::string_view name, const Recorded& x);
  static Recorded function(std::string_view name, const Recorded& x, const Recorded& y);

  int id_;
  bool negative_ = false;
};

// Returns the parameters of a form, each as an input with its name.
template <class P>
P recorded_parameters() {
  P p{};
  for (const auto& field : P::fields()) p.*(field.member) = Recorded::input(field.info.name);
  return p;
}

struct RecordedDirections {
  Vec3<Recorded> wi{Recorded::input(".ix"), Recorded::input(".iy"), Recorded::input(".iz")};
  Vec3<Recorded> wo{Recorded::input(".ox"), Recorded::input(".oy"), Recorded::input(".oz")};
};

}  // namespace brdf::prove
