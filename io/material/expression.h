// Small formulas of a command line: "roughness*roughness", "kd + ks <= 1".
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

// Numbers, names, + - * / ^, brackets, sqrt, exp, log, abs, min and max of two. ^ binds closest, to the
// right.
class Expression {
 public:
  // `option` is named in messages. Throws InputError.
  Expression(std::string_view text, std::string_view option);
  double value(const std::function<double(std::string_view name)>& of_name) const;
  const std::vector<std::string>& names() const { return names_; }

  struct Node;

 private:
  std::shared_ptr<const Node> root_;
  std::vector<std::string> names_;
};

// One or more of "A <= B", "A < B", "A >= B", "A > B", separated by commas: whether all hold.
class Condition {
 public:
  Condition(std::string_view text, std::string_view option);
  bool holds(const std::function<double(std::string_view name)>& of_name) const;
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
