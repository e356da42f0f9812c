// Parses small formulas of a command line: "roughness*roughness", "kd + ks <= 1".
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

// An expression of numbers, names, + - * / ^, brackets, sqrt, exp, log, abs, and min and max of two
// arguments. ^ binds most tightly and associates to the right.
class Expression {
 public:
  // Parses `text`. `option` is named in messages. Throws InputError.
  Expression(std::string_view text, std::string_view option);
  // Evaluates the expression. `of_name` returns the value of a name.
  double value(const std::function<double(std::string_view name)>& of_name) const;
  const std::vector<std::string>& names() const { return names_; }

  struct Node;

 private:
  std::shared_ptr<const Node> root_;
  std::vector<std::string> names_;
};

// One or more comparisons "A <= B", "A < B", "A >= B", "A > B", separated by commas. The condition holds if
// all comparisons hold.
class Condition {
 public:
  Condition(std::string_view text, std::string_view option);
  // Returns whether all comparisons hold. The tolerance `rounding`, relative and absolute, applies to <= and
  // >=: numbers that people write, such as 0.7 + 0.2 + 0.1, may exceed a sum by their rounding.
  bool holds(const std::function<double(std::string_view name)>& of_name, double rounding = 1e-12) const;
  const std::vector<std::string>& names() const { return names_; }

 private:
  struct Part {
    Expression less, more;
    bool strict;
  };
  std::vector<Part> parts_;
  std::vector<std::string> names_;
};

}  // namespace brdf::io
