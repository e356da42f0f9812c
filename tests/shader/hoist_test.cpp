// The steps that a run for many directions computes once: the results have the bits of the whole program.
#include <gtest/gtest.h>

#include <cstring>

#include "brdf/random.h"
#include "shader/function.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

// A lobe; a variable with two values; an array and a loop of parameters; a branch that only some lanes take.
constexpr const char* kTexts[] = {
    "float brdf(vec3 L, vec3 V, float a, float b) {\n"
    "  vec3 h = normalize(L + V); float a2 = a * a, norm = a2 / (3.14159 * (1.0 + b)); float t = h.z * h.z * "
    "(a2 - 1.0) + 1.0;\n"
    "  return b + norm / (t * t); }",
    "float brdf(vec3 L, vec3 V, float a, float b) {\n"
    "  float x = a; if (L.z > 0.5) { float y = sqrt(b + 1.0) * a; x = y * y + V.z; } if (a > 0.5) x += "
    "exp(b); return x; }",
    "float brdf(vec3 L, vec3 V, float a, float b) {\n"
    "  float w[3]; w[0] = a * b; w[1] = a + b; w[2] = V.z; float sum = 0.0;\n"
    "  for (int k = 0; k < 3; ++k) { float s = sqrt(a) + 0.25; sum += w[k] * s * pow(L.z, b); }\n"
    "  int j = int(3.0 * L.z); return sum + w[j]; }",
    "float brdf(vec3 L, vec3 V, float a, float b) {\n"
    "  if (V.z < 0.3) return a / (b + 1.0); float c = log(a + 2.0); if (L.z < 0.4) c = c * L.z; return c + a "
    "/ (b + 1.0); }"};

template <class T, int W>
void expect_same_bits(const Function& f) {
  Runner<T, W> whole(f);
  const std::unique_ptr<Runner<T, W>> hoisted = Runner<T, W>::hoisted(f);
  Random random(5);
  std::vector<T> values(f.values);
  for (int k = 0; k < 200; ++k) {
    if (k % 3 == 0)  // two more runs keep the values
      for (T& v : values) v = T(random.uniform());
    typename Runner<T, W>::Lanes wi, wo;
    for (std::size_t l = 0; l < W; ++l) {
      const Vec3<double> i = direction(degrees(89 * random.uniform()), degrees(360 * random.uniform())),
                         o = direction(degrees(89 * random.uniform()), degrees(360 * random.uniform()));
      wi[0][l] = T(i.x), wi[1][l] = T(i.y), wi[2][l] = T(i.z);
      wo[0][l] = T(o.x), wo[1][l] = T(o.y), wo[2][l] = T(o.z);
    }
    for (Runner<T, W>* runner : {&whole, hoisted.get()}) {
      runner->set_values(f, values);
      runner->set_directions(f, wi, wo);
      runner->run(W, values, wi, wo);
    }
    for (int l = 0; l < W; ++l) {
      const T a = whole.result(l, 0), b = hoisted->result(l, 0);
      ASSERT_EQ(std::memcmp(&a, &b, sizeof(T)), 0) << f.source.text << a << " " << b;
    }
  }
}

SlotSet directions_of(const Function& f) {
  SlotSet inputs(f.as_meant);
  for (const Binding& b : f.bindings_as_meant) inputs.of(b.integer)[b.slot] = b.from != Binding::From::value;
  return inputs;
}

TEST(Hoist, GivesTheBitsOfTheWholeProgram) {
  for (const char* text : kTexts) {
    const Function f = make_function(parse_source("test.glsl", text));
    EXPECT_FALSE(hoist(f.as_meant, directions_of(f)).once.empty()) << text;
    expect_same_bits<double, 1>(f);
    expect_same_bits<double, kLanes>(f);
    expect_same_bits<float, kLanes>(f);
  }
}

// A step with two values, or with a value that a direction decides, stays where it is.
TEST(Hoist, LeavesWhatMayChange) {
  const Function lobe = make_function(parse_source("test.glsl", kTexts[0]));
  const Hoisted parts = hoist(lobe.as_meant, directions_of(lobe));
  EXPECT_EQ(parts.once.size() + parts.rest.size(), lobe.as_meant.size());
  EXPECT_LE(parts.once.size(), 5u);  // a2, norm with three steps, a2 - 1
  EXPECT_GE(parts.once.size(), 4u);

  // Slot 2 is written in a branch alone, and read after the branch.
  const Step add{.op = Op::add, .r = 2, .a = 0, .b = 0}, less{.op = Op::less, .r = 0, .a = 1, .b = 0};
  Program p{.stretches = {{.steps = {less}, .end = End::branch, .condition = 0, .next = {1, 2}},
                          {.steps = {add}, .end = End::jump, .next = {2, 0}},
                          {.steps = {}, .end = End::stop}},
            .numbers = 3,
            .integers = 1,
            .inputs = {{"a", "float", {0}}, {"b", "float", {1}}},
            .results = {2}};
  SlotSet changes(p);
  changes.numbers[1] = true;
  EXPECT_TRUE(hoist(p, changes).once.empty());
  p.stretches[0].steps.push_back(add);  // two steps write it
  EXPECT_TRUE(hoist(p, changes).once.empty());
  p.stretches[1].steps.clear();
  EXPECT_EQ(hoist(p, changes).once.size(), 1u);
  changes.numbers[0] = true;
  EXPECT_TRUE(hoist(p, changes).once.empty());
}

}  // namespace
}  // namespace brdf::shader
