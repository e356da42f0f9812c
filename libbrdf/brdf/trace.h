// The tracing scalar. Evaluating a form on this type records the formula, which is then written as GLSL.
//
// All shaders are generated in this way from the one formula in the headers. Traced values reject `if`,
// `?:`, mixing with double and std:: functions at compile time; this also checks the style that keeps forms
// vectorisable. Constant arithmetic is folded in float, and equal expressions share one temporary. Every
// float temporary is `precise`; without it Mesa folds (x + magic) - magic, and results differ by up to
// 50 %. The software driver and the float library therefore agree bit for bit. GlslDialect describes the
// dialect for browsers.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "brdf/clones.h"
#include "brdf/form.h"
#include "brdf/reflectance.h"
#include "brdf/sampling.h"

namespace brdf {

// A recorded expression graph. Equal nodes are shared.
class Trace {
 public:
  enum class Type { float_type, uint_type, bool_type };
  struct Node {
    Type type;
    std::string code;  // operator, function, input text or literal
    std::vector<int> operands;
    bool constant = false;
    std::uint32_t bits = 0;  // of a constant, float or uint
    auto key() const { return std::tie(type, code, operands); }
    friend bool operator<(const Node& a, const Node& b) { return a.key() < b.key(); }
  };

  explicit Trace(GlslDialect dialect = GlslDialect::vulkan) : dialect_(dialect) {}

  int add(Node node);
  GlslDialect dialect() const { return dialect_; }
  const Node& operator[](int id) const { return nodes_[std::size_t(id)]; }
  // Returns the statements that compute `roots`, depth first, followed by `result` with %0, %1, ...
  // replaced by the roots.
  std::string statements(const std::vector<int>& roots, std::string_view result, bool precise) const;

  // Returns the graph into which traced values record: one per thread, replaced for the lifetime of a scope.
  static Trace& current();
  class Scope;

 private:
  GlslDialect dialect_;
  std::vector<Node> nodes_;
  std::map<Node, int> known_;
};

class Trace::Scope {
 public:
  explicit Scope(Trace& trace);
  ~Scope();
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

 private:
  Trace* previous_;
};

class TracedBool {
 public:
  explicit TracedBool(int node) : node_(node) {}
  int node() const { return node_; }
  explicit operator bool() const = delete;  // forbids `if` and `?:` on traced values

 private:
  int node_;
};

class TracedBits {
 public:
  explicit TracedBits(int node) : node_(node) {}
  int node() const { return node_; }
  friend TracedBits operator+(TracedBits a, std::uint32_t b);
  friend TracedBits operator-(TracedBits a, std::uint32_t b);
  friend TracedBits operator-(TracedBits a, TracedBits b);
  friend TracedBits operator|(TracedBits a, std::uint32_t b);
  friend TracedBits operator&(TracedBits a, std::uint32_t b);
  friend TracedBits operator<<(TracedBits a, int b);
  friend TracedBits operator>>(TracedBits a, int b);

 private:
  int node_;
};

class Traced {
 public:
  Traced() : Traced(0.0) {}
  explicit Traced(double constant);
  static Traced input(std::string_view glsl);
  static Traced from_node(int node) { return Traced(Node{node}); }
  int node() const { return node_; }

  friend Traced operator+(Traced a, Traced b);
  friend Traced operator-(Traced a, Traced b);
  friend Traced operator*(Traced a, Traced b);
  friend Traced operator/(Traced a, Traced b);
  friend Traced operator-(Traced a);
  friend TracedBool operator<(Traced a, Traced b);
  friend Traced select(TracedBool c, Traced yes, Traced no);
  friend Traced sqrt(Traced x);
  friend TracedBits to_bits(Traced x);
  friend Traced from_bits(TracedBits bits);
  friend kernels::WholePower<Traced> whole_power(Traced x);
  // Kernels, which are traced once into GLSL functions and called here.
  friend Traced exp(Traced x);
  friend Traced log(Traced x);
  friend Traced log1p(Traced x, Traced rest);
  friend Traced erfcx(Traced x);
  friend Traced atan2(Traced y, Traced x);
  // Functions for samplers only. In contrast to values, their results are not proved bit-identical to the
  // library.
  friend Traced sin(Traced x);
  friend Traced cos(Traced x);
  friend Traced pow(Traced x, Traced y);
  friend Traced log1p(Traced x);
  friend Traced expm1(Traced x);
  friend Traced erfc(Traced x);

 private:
  struct Node {
    int id;
  };
  explicit Traced(Node node) : node_(node.id) {}
  int node_;
};

// Argument-dependent lookup finds this function only if it is declared here too.
Traced from_bits(TracedBits bits);

// Returns the GLSL functions of the elementary kernels. A shader needs them once, before any form.
// Example:
//     const brdf::Reflectance form = *brdf::find_form("ward");
//     const std::string functions = brdf::glsl_kernels() + form->glsl();
std::string glsl_kernels(const GlslOptions& options = {});

namespace detail {

// Returns the number as a GLSL literal that reads back to the same float.
std::string float_literal(float x);

// Returns a function with this signature: the statements that compute the values, followed by `result` with
// %0, %1, ... replaced.
std::string glsl_function(std::string_view signature, const std::vector<Traced>& values,
                          std::string_view result, bool precise);

// Returns the parameter struct with the arguments of the shader as members. `component` is "" or ".r",
// ".g", ".b".
template <class P>
P inputs(const std::string& component) {
  P p{};
  for (const auto& field : P::fields())
    p.*(field.member) = Traced::input(std::string(field.info.name) + component);
  return p;
}

inline Vec3<Traced> input_vector(const std::string& v) {
  return {Traced::input(v + ".x"), Traced::input(v + ".y"), Traced::input(v + ".z")};
}

// Returns the parameters of the shape as arguments that follow other arguments.
template <class Shape>
std::string glsl_shape() {
  std::string text;
  for (const auto& field : Shape::fields()) text += ", float " + std::string(field.info.name);
  return text;
}

template <Form F>
BRDF_SMALL std::string glsl_of(F form, bool cosine, const GlslOptions& options) {
  using Weights = typename F::template Weights<Traced>;
  using Shape = typename F::template Shape<Traced>;
  Trace trace(options.dialect);
  const Trace::Scope scope(trace);
  const Geometry<Traced> g = geometry(input_vector("wi"), input_vector("wo"));
  const Shape shape = inputs<Shape>("");
  const Weights first = inputs<Weights>(".r");
  std::vector<Traced> values;
  for (const char* component : {".r", ".g", ".b"}) {
    const Weights w = inputs<Weights>(component);
    values.push_back(cosine ? eval_cos(form, w, first, shape, g) : eval(form, w, first, shape, g));
  }
  std::string signature = std::string("vec3 brdf_eval_") + (cosine ? "cos_" : "") + std::string(F::name) +
                          "(vec3 wi, vec3 wo" + glsl_shape<Shape>();
  for (const auto& field : Weights::fields()) signature += ", vec3 " + std::string(field.info.name);
  return glsl_function(signature + ")", values, "return vec3(%0, %1, %2);", options.marks_precise());
}

}  // namespace detail

// Returns the two functions of a form; see ReflectanceModel::glsl.
template <Form F>
std::string glsl_functions(F form, const GlslOptions& options = {}) {
  return detail::glsl_of(form, false, options) + detail::glsl_of(form, true, options);
}

// Returns the sampler of a form and its density; see ReflectanceModel::glsl_sampler.
template <Form F>
std::string glsl_sampler_functions(F form, const GlslOptions& options = {}) {
  using Shape = typename F::template Shape<Traced>;
  const std::string name(F::name), arguments = detail::glsl_shape<Shape>();
  std::string text;
  {
    Trace trace(options.dialect);
    const Trace::Scope scope(trace);
    const Vec3<Traced> u = detail::input_vector("u");
    const Vec3<Traced> wi =
        sample(form, detail::inputs<Shape>(""), u.x, u.y, u.z, detail::input_vector("wo"), Traced(0.5));
    text += detail::glsl_function("vec3 brdf_sample_" + name + "(vec3 u, vec3 wo" + arguments + ")",
                                  {wi.x, wi.y, wi.z}, "return vec3(%0, %1, %2);", options.marks_precise());
  }
  Trace trace(options.dialect);
  const Trace::Scope scope(trace);
  const Traced density = pdf(form, detail::inputs<Shape>(""), detail::input_vector("wi"),
                             detail::input_vector("wo"), Traced(0.5));
  return text + detail::glsl_function("float brdf_pdf_" + name + "(vec3 wi, vec3 wo" + arguments + ")",
                                      {density}, "return %0;", options.marks_precise());
}

// Returns a function that selects the reflectance by its number in a shader:
//   vec3 <function>(int form, vec3 wi, vec3 wo, vec4 shape, vec3 w0, vec3 w1, vec3 w2)
// calls <function>_<name> of the reflectance with that number. `function` is brdf_eval or brdf_eval_cos.
struct NumberedReflectance {
  int number;
  Reflectance reflectance;
};
std::string glsl_dispatch(std::string_view function, std::span<const NumberedReflectance> reflectances);
// Returns the same for samplers. A reflectance without a sampler in GLSL uses the sampler of the cosine:
//   vec3 brdf_sample(int form, vec3 u, vec3 wo, vec4 shape)
//   float brdf_pdf(int form, vec3 wi, vec3 wo, vec4 shape)
std::string glsl_sampler_dispatch(std::span<const NumberedReflectance> reflectances);

}  // namespace brdf
