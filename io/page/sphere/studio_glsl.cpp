// The studio's functions as GLSL, traced from the templates that the still pictures use.
#include "brdf/trace.h"
#include "io/colour/neutral.h"
#include "io/colour/traced_power.h"
#include "io/material/glsl.h"
#include "io/page/sphere/studio.h"

namespace brdf::io::sphere {
namespace {

// Returns a function; `values` is called while its trace records.
template <class Values>
std::string traced(const std::string& signature, const std::string& result, Values values) {
  Trace trace(GlslDialect::es);
  const Trace::Scope scope(trace);
  return brdf::detail::glsl_function(signature, values(), result, false);
}

Traced in(const char* name) {
  return Traced::input(name);
}

std::vector<Traced> list(const Vec3<Traced>& v) {
  return {v.x, v.y, v.z};
}

std::vector<Traced> list(const std::array<Traced, 3>& v) {
  return {v.begin(), v.end()};
}

}  // namespace

std::string studio_glsl() {
  using brdf::detail::input_vector;
  const std::string vec3 = "return vec3(%0, %1, %2);", number = "return %0;";
  constexpr std::array steps = additive_recurrence_steps<2>();
  return "const vec2 kStudioStep = vec2(" + glsl_number(steps[0]) + ", " + glsl_number(steps[1]) + ");\n" +
         traced("vec3 studio_radiance(vec3 w)", vec3,
                [] { return list(studio::radiance(input_vector("w"))); }) +
         traced("float studio_floor(vec3 p, vec3 w)", number,
                [] { return std::vector{studio::floor_share(input_vector("p"), input_vector("w"))}; }) +
         traced("mat3 studio_boxes(vec2 u)", "return mat3(%0, %1, %2, %3, %4, %5, %6, %7, %8);",
                [] {
                  std::vector<Traced> all;
                  for (const Vec3<Traced>& w : studio::box_directions(in("u.x"), in("u.y")))
                    for (const Traced& x : list(w)) all.push_back(x);
                  return all;
                }) +
         traced("float studio_density(vec3 w)", number,
                [] { return std::vector{studio::box_density(input_vector("w"))}; }) +
         traced("vec3 studio_cosine(vec2 u)", vec3,
                [] { return list(sample_cosine(in("u.x"), in("u.y"))); }) +
         traced("vec3 studio_lobe(float width, vec2 u, vec3 wo)", vec3,
                [] { return list(lobe_direction(in("width"), in("u.x"), in("u.y"), input_vector("wo"))); }) +
         traced(
             "float studio_lobe_density(float width, vec3 wi, vec3 wo)", number,
             [] { return std::vector{lobe_density(in("width"), input_vector("wi"), input_vector("wo"))}; }) +
         traced("vec3 displayed(vec3 x)", vec3, [] {
           return list(neutral_display<Traced>({in("x.r"), in("x.g"), in("x.b")}));
         });
}

}  // namespace brdf::io::sphere
