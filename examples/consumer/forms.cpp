// forms: every form of the catalogue at its default parameters, lit from 45 degrees and seen from 30 across.
// Of brdf::core alone: no file is read, and nothing but the standard library is linked.
#include <cstdio>
#include <string>

#include "brdf/directions.h"
#include "brdf/material.h"

int main() {
  const brdf::Vec3<double> wi = direction(brdf::degrees(45), brdf::degrees(0));
  const brdf::Vec3<double> wo = direction(brdf::degrees(30), brdf::degrees(180));
  for (const brdf::Reflectance& form : brdf::catalogue()) {
    double value;
    eval(make_material(form, {"fr"}), wi, wo, {&value, 1});
    std::printf("%s %.17g\n", std::string(info(form).name).c_str(), value);
  }
}
