#include "prove/shader/random_program.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace brdf::prove {
namespace {

class Writer {
 public:
  explicit Writer(std::mt19937_64& random) : random_(random) {}

  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  double between(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  static std::string number(double x) {
    std::ostringstream out;
    out.precision(9);
    out << std::scientific << x;
    return out.str();
  }
  std::string between_text(double low, double high) { return number(between(low, high)); }

  // Returns an expression between 0 and about 3.
  std::string positive(int depth) {
    if (depth == 0) return leaf();
    const std::string a = positive(depth - 1), b = positive(depth - 1);
    switch (below(14)) {
      case 0:
        return "(0.5 * (" + a + " + " + b + "))";
      case 1:
        return "(" + a + " * " + b + " / (1.0 + " + b + "))";
      case 2:
        return "(" + a + " / (" + b + " + " + between_text(0.5, 2) + "))";
      case 3:
        return "min(" + a + ", " + b + ")";
      case 4:
        return "max(" + a + ", " + b + ")";
      case 5:
        return "sqrt(" + a + ")";
      case 6:
        return "exp(-" + a + ")";
      case 7:
        return "mix(" + a + ", " + b + ", clamp(" + leaf() + ", 0.0, 1.0))";
      case 8:
        return "pow(" + a + " + " + between_text(0.05, 0.5) + ", " + between_text(0.3, 2) + ")";
      case 9:
        return "smoothstep(0.2, 0.9, " + a + ")";
      case 10:
        return "(" + leaf() + " > " + between_text(0.1, 0.9) + " ? " + a + " : " + b + ")";
      case 11:
        return "abs(sin(" + number(below(5) + 1.0) + " * " + a + "))";
      case 12:
        return "element(clamp(int(2.0 * " + leaf() + "), 0, 3), " + a + ")";
      default:
        return "summed(" + a + ")";
    }
  }

  std::string shader(const std::string& before, const std::string& value) {
    return "//: param p 0.05 1 0.5\n//: param q 0 1 0.5\n"
           "float element(int k, float x) { float t[4] = float[4](0.2, 0.4, 0.6, 0.8); return t[k] + 0.1 * "
           "x; }\n"
           "float summed(float x) { float s = 0.0; for (int k = 0; k < 3; ++k) s += 0.3 * x; return s; }\n"
           "float brdf(vec3 L, vec3 V, vec3 N, float p, float q) {\n"
           "  float nl = dot(N, L), nv = dot(N, V);\n"
           "  vec3 H = normalize(L + V);\n"
           "  float nh = clamp(dot(N, H), 0.0, 1.0), lh = clamp(dot(L, H), 0.0, 1.0);\n"
           "  float value = 0.3 * " +
           value + ";\n" + before + "  return value;\n}\n";
  }

 private:
  std::string leaf() {
    constexpr std::array<const char*, 8> kLeaves{"nl", "nv", "nh",      "lh",
                                                 "p",  "q",  "nl * nv", "(1.0 - 0.5 * nl)"};
    return below(5) == 0 ? between_text(0.05, 1) : kLeaves[below(kLeaves.size())];
  }

  std::mt19937_64& random_;
};

// Returns a condition that holds on a thin set within the domain, and the name of the set.
std::pair<std::string, std::string> thin_set(Writer& w) {
  const double width = std::pow(10, w.between(-7, -2));
  const auto near = [&](const std::string& x, double low, double high) {
    return "abs(" + x + " - " + w.between_text(low, high) + ") < " + Writer::number(width);
  };
  switch (w.below(7)) {
    case 0:
      return {near("nl", 0.05, 0.95), "slab"};
    case 1:
      return {near("nv", 0.05, 0.95) + " && " + near("p", 0.1, 0.9), "ball"};
    case 2:
      return {near("nl", 0.1, 0.9) + " && " + near("nv", 0.1, 0.9), "ball"};
    case 3:
      return {near("nl + " + w.between_text(0.2, 1) + " * nv", 0.2, 1), "line"};
    case 4:
      return {near("L.y", -0.8, 0.8), "azimuth"};
    case 5:
      return {near("V.x", -0.8, 0.8), "azimuth"};
    default:
      return {near("(L.x * V.y - L.y * V.x)", -0.4, 0.4), "azimuth"};
  }
}

struct Operation {
  const char* name;
  const char* code;
};
// Each gives `value` an undefined value if `hit` holds.
constexpr Operation kUndefined[] = {
    {"variable", "float u; if (!(hit)) u = 0.1; value += u;"},
    {"return", "value = other(hit, value);"},
    {"index", "value += element(hit ? 4 + int(3.0 * p) : 1, 0.0);"},
    {"division", "value += 0.01 * float(7 / (hit ? 0 : 2));"},
    {"shift", "value += 0.001 * float((1 << (hit ? 32 : 3)) & 7);"},
    {"pow", "value += pow(hit ? -0.5 : 0.5, 2.0);"},
    {"pow of 0", "value += pow(hit ? 0.0 : 0.5, 0.0);"},
    {"atan", "value += abs(cos(atan(hit ? 0.0 : nl, hit ? 0.0 : nv)));"},
    {"smoothstep", "value += smoothstep(0.4, hit ? 0.4 : 0.9, nl);"},
    {"clamp", "value += clamp(nl, 0.5, hit ? 0.4 : 0.9);"},
    {"max", "value += max(sqrt(hit ? -1.0 : 1.0), 0.0);"},
    {"root", "value += sqrt(hit ? -0.5 : 0.5) > 0.6 ? 0.1 : 0.2;"},
    {"logarithm", "value += log2(hit ? 0.0 : 0.5) > -0.6 ? 0.1 : 0.2;"},
    {"arc", "value += acos(hit ? 1.5 : 0.5) > 1.2 ? 0.1 : 0.2;"},
    {"conversion", "value += 0.001 * float(int(hit ? 3e9 : 3.0) & 7);"},
};

}  // namespace

RandomProgram sound_program(std::mt19937_64& random) {
  Writer w(random);
  return {w.shader("", w.positive(2 + int(w.below(2)))), Planted::nothing, "", false};
}

RandomProgram planted_program(std::mt19937_64& random) {
  Writer w(random);
  const std::string value = w.positive(1 + int(w.below(2)));
  const std::uint64_t kind = w.below(10);
  if (kind == 0) {
    // A quotient by the length of a vector with squares that are subnormal in float.
    const std::string scale = w.between_text(7.6e-23, 7.95e-23);
    return {
        w.shader("  value = 1.02 - normalize(vec3(0.0, 0.0, (1.0 + 0.02 * nl) * " + scale + ")).z;\n", value),
        Planted::negative, "subnormal", true};
  }
  if (kind == 1) {
    // The program is isotropic in real numbers, and nothing overflows where the light has no coordinate L.y.
    const std::string big = "L.y * " + w.between_text(5e21, 9e21) + " * 1e18";
    return {w.shader("  if (!(" + big + " < " + big + " + 1e36)) value = -0.1;\n", value), Planted::negative,
            "overflow", true};
  }
  const auto [condition, hit] = thin_set(w);
  if (kind < 4)
    return {w.shader("  if (" + condition + ") value = -0.1;\n", value), Planted::negative, hit, false};
  if (kind < 6)
    return {w.shader("  if (" + condition + ") value = 1.0 / (q - q);\n", value), Planted::infinite, hit,
            false};
  const Operation& o = kUndefined[w.below(std::size(kUndefined))];
  std::string text = w.shader("  bool hit = " + condition + ";\n  " + o.code + "\n", value);
  text.insert(text.find("float brdf("), "float other(bool w, float x) { if (!w) return x; }\n");
  return {std::move(text), Planted::undefined, std::string(o.name) + " in a " + hit, false};
}

bool contradicts(const RandomProgram& program, Property property, Precision precision) {
  if (program.float_only && precision != Precision::float_type) return false;
  switch (program.planted) {
    case Planted::nothing:
      return false;
    case Planted::negative:
      return property == Property::non_negative;
    case Planted::infinite:
      return property == Property::finite;
    case Planted::undefined:
      return property == Property::finite || property == Property::non_negative;
  }
  return true;
}

}  // namespace brdf::prove
