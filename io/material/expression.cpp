#include "io/material/expression.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {

struct Expression::Node {
  char kind;  // n a number, v a name, u minus, + - * / ^, f a function
  double number = 0;
  std::string name = {};
  std::shared_ptr<const Node> a = {}, b = {};
};

namespace {

using Node = Expression::Node;
using Pointer = std::shared_ptr<const Node>;

constexpr int kDeepest = 60;

class Parser {
 public:
  Parser(std::string_view text, std::string_view option, std::vector<std::string>& names)
      : text_(text), option_(option), names_(names) {}

  Pointer run() {
    Pointer root = sum();
    if (at_ < text_.size()) refuse("'" + std::string(text_.substr(at_)) + "' is not understood");
    return root;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(std::string(option_) + " '" + printable(text_, 200) + "': " + what);
  }
  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(char c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  static Pointer node(char kind, Pointer a, Pointer b = {}) {
    return std::make_shared<const Node>(Node{kind, 0, {}, std::move(a), std::move(b)});
  }

  Pointer sum() {
    Pointer left = product();
    for (;;) {
      if (take('+'))
        left = node('+', left, product());
      else if (take('-'))
        left = node('-', left, product());
      else
        return left;
    }
  }
  Pointer product() {
    Pointer left = power();
    for (;;) {
      if (take('*'))
        left = node('*', left, power());
      else if (take('/'))
        left = node('/', left, power());
      else
        return left;
    }
  }
  Pointer power() {
    if (++depth_ > kDeepest) refuse("is nested too deeply");
    Pointer out = take('-') ? node('u', power()) : atom();
    if (out->kind != 'u' && take('^')) out = node('^', out, power());
    --depth_;
    return out;
  }
  Pointer atom() {
    skip();
    if (take('(')) {
      Pointer inner = sum();
      if (!take(')')) refuse("a bracket is not closed");
      return inner;
    }
    const std::size_t begin = at_;
    const auto is_letter = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    if (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) || text_[at_] == '.')) {
      while (at_ < text_.size() &&
             (is_letter(text_[at_]) || text_[at_] == '.' ||
              ((text_[at_] == '-' || text_[at_] == '+') && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E'))))
        ++at_;
      double value;
      if (!parse_number(text_.substr(begin, at_ - begin), value))
        refuse("'" + std::string(text_.substr(begin, at_ - begin)) + "' is not a number");
      return std::make_shared<const Node>(Node{'n', value});
    }
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    const std::string name(text_.substr(begin, at_ - begin));
    if (name.empty())
      refuse(at_ < text_.size() ? "'" + std::string(text_.substr(at_)) + "' is not understood"
                                : "ends early");
    if (!take('(')) {
      if (std::ranges::find(names_, name) == names_.end()) names_.push_back(name);
      return std::make_shared<const Node>(Node{'v', 0, name});
    }
    return call(name);
  }
  Pointer call(const std::string& name) {
    const bool two = name == "min" || name == "max";
    if (!two && name != "sqrt" && name != "exp" && name != "log" && name != "abs")
      refuse("'" + name + "' is not a function (known: sqrt, exp, log, abs, min, max)");
    Pointer a = sum(), b;
    if (two && !take(',')) refuse(name + " has two arguments");
    if (two) b = sum();
    if (!take(')')) refuse("a bracket is not closed");
    return std::make_shared<const Node>(Node{'f', 0, name, a, b});
  }

  std::string_view text_, option_;
  std::vector<std::string>& names_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

double value_of(const Node& n, const std::function<double(std::string_view)>& of_name) {
  const double a = n.a ? value_of(*n.a, of_name) : 0, b = n.b ? value_of(*n.b, of_name) : 0;
  switch (n.kind) {
    case 'n':
      return n.number;
    case 'v':
      return of_name(n.name);
    case 'u':
      return -a;
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    case '/':
      return a / b;
    case '^':
      return std::pow(a, b);
    default:
      return n.name == "min"    ? std::min(a, b)
             : n.name == "max"  ? std::max(a, b)
             : n.name == "sqrt" ? std::sqrt(a)
             : n.name == "exp"  ? std::exp(a)
             : n.name == "log"  ? std::log(a)
                                : std::abs(a);
  }
}

// Splits the text at commas outside brackets.
std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> out;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= text.size(); ++k) {
    const char c = k < text.size() ? text[k] : ',';
    depth += (c == '(') - (c == ')');
    if ((c != ',' || depth > 0) && k < text.size()) continue;
    out.push_back(text.substr(begin, k - begin));
    begin = k + 1;
  }
  return out;
}

}  // namespace

Expression::Expression(std::string_view text, std::string_view option) {
  constexpr std::size_t kLongest = 1000;
  if (text.size() > kLongest)
    throw InputError(std::string(option) + ": is longer than " + std::to_string(kLongest) + " characters");
  root_ = Parser(text, option, names_).run();
}

double Expression::value(const std::function<double(std::string_view)>& of_name) const {
  return value_of(*root_, of_name);
}

Condition::Condition(std::string_view text, std::string_view option) {
  for (const std::string_view part : parts_of(text)) {
    const std::size_t at = part.find_first_of("<>");
    if (at == part.npos)
      throw InputError(std::string(option) + " '" + printable(part, 200) + "': must be A <= B or A >= B");
    const bool equal = at + 1 < part.size() && part[at + 1] == '=';
    Expression left(part.substr(0, at), option), right(part.substr(at + (equal ? 2 : 1)), option);
    for (const Expression* e : {&left, &right})
      names_.insert(names_.end(), e->names().begin(), e->names().end());
    if (part[at] == '<')
      parts_.push_back({std::move(left), std::move(right), !equal});
    else
      parts_.push_back({std::move(right), std::move(left), !equal});
  }
}

bool Condition::holds(const std::function<double(std::string_view)>& of_name, double rounding) const {
  return std::ranges::all_of(parts_, [&](const Part& part) {
    const double less = part.less.value(of_name), more = part.more.value(of_name);
    return part.strict ? less < more : less <= more + rounding * (1 + std::abs(more));
  });
}

}  // namespace brdf::io
