// No value that the library computes lies outside the enclosure of a box that contains the inputs.
#include <sstream>

#include <gtest/gtest.h>

#include "prove/scalar/lemmas.h"
#include "tests/prove/boxes.h"
#include "tests/thorough.h"

namespace brdf::prove {
namespace {

const int kBoxes = thorough() ? 20000 : 200;
const int kBoxPoints = thorough() ? 500 : 20;

template <class T>
struct Outside {
  long points = 0, beyond = 0, finite_boxes = 0;
  std::string first;
};

template <class T>
Outside<T> sample(int form, Precision precision, int boxes, int points, unsigned seed) {
  const Reflectance& reflectance = catalogue()[std::size_t(form)];
  const Domain domain = value_domain_of(form);
  const Parts parts = parts_of(reflectance.info(), domain);
  Engine e(seed + unsigned(form));
  Outside<T> found;
  for (int b = 0; b < boxes; ++b) {
    const Box box = random_box(e, domain);
    const Bounds bounds = enclose_value(form, precision, box);
    found.finite_boxes += std::isfinite(bounds.lo);
    if (!std::isfinite(bounds.lo)) continue;
    for (int k = 0; k < points; ++k) {
      std::vector<double> at;
      std::vector<T> values;
      bool inside = true;
      for (std::size_t j = 0; j < box.size(); ++j) {
        at.push_back(anywhere(e, domain.variables[j], box[j]));
        values.push_back(T(at.back()));
        if (j < parts.directions)
          inside = inside && box[j].lo <= double(values.back()) && double(values.back()) <= box[j].hi;
      }
      if (!inside) continue;  // rounded to T, the point is no longer in the box
      const std::size_t d = parts.directions;
      const auto [wi, wo] = pair_in<T>(e, reflectance.info(), std::span(at).subspan(d));
      const std::span<const T> all(values);
      const auto info = reflectance.info();
      const ParameterValues<T> p{all.subspan(parts.weights, info.weights.size()),
                                 all.subspan(parts.first, info.weights.size()),
                                 all.subspan(0, info.shape.size())};
      const Directions<T> directions{&wi.x, &wi.y, &wi.z, &wo.x, &wo.y, &wo.z, 1};
      T f = 0, f_cos = 0;
      reflectance->eval(p, directions, &f);
      reflectance->eval_cos(p, directions, &f_cos);
      for (const bool times_cosine : {false, true}) {
        const T value = times_cosine ? f_cos : f;
        ++found.points;
        // The bounds of a basis are those of f; f cos_i lies between them and 0.
        const double low = info.basis && times_cosine ? std::min(bounds.lo, 0.0) : bounds.lo;
        if (low <= double(value) && double(value) <= bounds.hi) continue;
        if (found.beyond++ == 0) {
          std::ostringstream text;
          text.precision(17);
          text << info.name << ": " << value << " outside " << bounds.lo << " .. " << bounds.hi << " in";
          for (std::size_t j = 0; j < box.size(); ++j)
            text << "\n  " << domain.variables[j].name << " " << box[j].lo << " .. " << box[j].hi << " at "
                 << at[j];
          found.first = text.str();
        }
      }
    }
  }
  return found;
}

class Enclosures : public testing::TestWithParam<int> {};

TEST_P(Enclosures, HoldEveryValueInDouble) {
  const auto found = sample<double>(GetParam(), Precision::double_type, kBoxes, kBoxPoints, 1);
  EXPECT_EQ(found.beyond, 0) << found.beyond << " of " << found.points << "\n" << found.first;
  EXPECT_GT(found.finite_boxes, kBoxes / 2);
}
TEST_P(Enclosures, HoldEveryValueInFloat) {
  const auto found = sample<float>(GetParam(), Precision::float_type, kBoxes, kBoxPoints, 2);
  EXPECT_EQ(found.beyond, 0) << found.beyond << " of " << found.points << "\n" << found.first;
  EXPECT_GT(found.finite_boxes, kBoxes / 3);
}

// A form that chooses by the sign of the product is enclosed case by case. A product that the same thread
// encloses afterwards belongs to no case and has both signs.
TEST(Cases, OfOneFormDoNotCutALaterProduct) {
  using I = Interval<double>;
  const Vec3<I> w{I::of(-0.5, 0.5), I::of(-0.5, 0.5), I::of(0.5, 1)};
  const I before = tangential_product(geometry(w, w));
  ASSERT_LT(before.lo, 0);
  ASSERT_GT(before.hi, 0);
  int form = 0;
  while (catalogue()[std::size_t(form)].info().name != "oren_nayar_energy") ++form;
  Box box;
  for (const Variable& v : domain_of(form).variables) box.push_back({v.low, v.high});
  enclose_value(form, Precision::double_type, box);
  const I after = tangential_product(geometry(w, w));
  EXPECT_EQ(after.lo, before.lo);
  EXPECT_EQ(after.hi, before.hi);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Enclosures, testing::Range(0, int(catalogue().size())),
                         [](const auto& each) {
                           return std::string(catalogue()[std::size_t(each.param)].info().name);
                         });

}  // namespace
}  // namespace brdf::prove
