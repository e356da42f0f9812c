// Tests `brdf albedo`, as a user calls it, against independent albedos: closed forms, published tables, and
// the known violations that can be expressed as albedos.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "brdf/scalar.h"
#include "io/files/json.h"
#include "io/files/text.h"
#include "run_brdf.h"

namespace brdf {
namespace {

constexpr double kDigits = 1e-10;  // or half a unit of the last digit printed

struct Row {
  std::string form, parameters;  // in the form of --set
  std::vector<double> theta, albedo;
  double error = kDigits;
  std::string fixed = "i";
};

double phong_at_grazing(double n) {
  return (n + 2) * std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2 + 2)) / (4 * std::sqrt(kPi));
}
double oren_nayar_closed(double sigma, double degrees) {
  const double s2 = sigma * sigma, a = 1 - 0.5 * s2 / (s2 + 0.33), b = 0.45 * s2 / (s2 + 0.09);
  const double t = degrees * kPi / 180, s = std::sin(t);
  if (degrees == 90) return a + b / 2;
  return a + b / kPi * (s * (t - s * std::cos(t)) + 2.0 / 3 * std::tan(t) * (1 - s * s * s));
}
Row oren_nayar_row(const std::string& sigma) {
  Row row{"oren_nayar", "rho=1 sigma=" + sigma, {0, 30, 70, 90}, {}};
  for (const double theta : row.theta) row.albedo.push_back(oren_nayar_closed(std::stod(sigma), theta));
  return row;
}
Row ggx_row(const std::string& alpha, std::vector<double> theta, std::vector<double> albedo) {
  return {"cook_torrance", "kd=0 ks=1 f0=1 " + alpha, std::move(theta), std::move(albedo)};
}
Row table_cell(double x, double y, double albedo) {
  Row row = ggx_row("alpha=" + io::to_text(square(x / 31)), {std::acos(y / 31) * 180 / kPi}, {albedo});
  row.error = 1e-6;
  return row;
}

std::vector<Row> rows() {
  const std::string lobe = "kd=0 ks=1 ";
  const double e = std::exp(1.0);
  std::vector<Row> r{
      {"lambert", "rho=0.7", {0, 45, 80, 90}, {.7, .7, .7, .7}},
      {"phong", "kd=0 ks=0.8 exponent=10", {0}, {.8}},
      {"phong", lobe + "exponent=10", {30, 60, 90}, {.86602853, .50473595, .12304688}, 5e-9},
      {"phong", lobe + "exponent=10", {90}, {phong_at_grazing(10)}},
      {"phong", lobe + "exponent=200", {0, 90}, {1, phong_at_grazing(200)}},
      {"phong", lobe + "exponent=0", {60, 90}, {.75, .5}},
      {"phong", lobe + "exponent=1e6", {60}, {.5}, 1e-6},
      {"phong_classic", lobe + "exponent=10", {0, 90}, {1, .5}, kDigits, "o"},
      {"phong_classic", lobe + "exponent=10", {0}, {11.0 / 12}},
      {"phong_unnormalised", lobe + "exponent=1", {0}, {2 * kPi / 3}},
      {"blinn_phong", lobe + "exponent=10", {0, 30, 60}, {1, .804640070110, .400323695483}},
      {"blinn_phong", lobe + "exponent=50", {0, 30, 60}, {1, .760003008300, .280649183625}},
      {"blinn_phong", lobe + "exponent=1e6", {60}, {.25}, 1e-5},
      {"blinn_phong_n8", lobe + "exponent=8.764", {0}, {1.075201}, 5e-7},
      {"blinn_phong_unnormalised", "kd=1 ks=0 exponent=20", {0, 50}, {kPi, kPi}},
      ggx_row("alpha=1", {0, 60}, {1 - std::log(2.0), .45069385566595}),
      ggx_row("alpha=0.1", {0, 30, 60, 85},
              {.988304056520612, .98608694349477, .96920498441169, .88638129863219}),
      ggx_row("alpha=0.25", {0}, {.915812430249750}),
      ggx_row("alpha=0.5", {0, 60}, {.687848515110236, .69825069692755}),
      ggx_row("alpha=0.01", {60, 89}, {.99974212259913, .90483783976559}),
      ggx_row("alpha_x=0.1 alpha_y=0.3", {0}, {.929819878192003}),
      ggx_row("alpha_x=0.05 alpha_y=0.5", {0}, {.821825242883966}),
      table_cell(16, 8, .834154),
      table_cell(22, 16, .693982),
      table_cell(31, 1, .888202),
      table_cell(31, 31, .306853),
      {"cook_torrance_beckmann", lobe + "f0=1 alpha=0.25", {0}, {.999991012221851}},
      {"cook_torrance_beckmann", lobe + "f0=1 alpha=0.5", {0}, {.942998374631463}},
      {"cook_torrance_beckmann", lobe + "f0=1 alpha=1", {0}, {.461588090570296}},
      {"cook_torrance_1982", lobe + "f0=1 alpha=1e-4", {0}, {4 / kPi}, 1e-6},
      {"ward", lobe + "alpha=0.1", {0}, {.971051675567060}},
      {"ward", lobe + "alpha=0.5", {0}, {.585490376444347}},
      {"ward", lobe + "alpha=1", {0}, {.256445212511538}},
      {"ward_duer", lobe + "alpha=0.1", {0}, {.980577132669816}},
      {"ward_duer", lobe + "alpha=0.5", {0}, {.694741897039630}},
      {"ward_duer", lobe + "alpha=1", {0}, {.352638286751174}},
      {"ward_duer", lobe + "alpha=0.617", {89.5}, {10.138}, 5e-4},
      {"ward_bounded", lobe + "alpha=0.1", {0}, {.99}},
      {"ward_bounded", lobe + "alpha=0.5", {0}, {.754578909722184}},
      {"ward_bounded", lobe + "alpha=1", {0}, {1 / e}},
      oren_nayar_row("0.2"),
      oren_nayar_row("1.2"),
      {"oren_nayar", "rho=1 sigma=0.198533", {90}, {1.015179}, 5e-7},
      {"oren_nayar_energy", "rho=1 roughness=0.05", {0, 60, 89.5, 90}, {1, 1, 1, 1}},
      {"oren_nayar_energy", "rho=1 roughness=1", {0, 60, 89.5, 90}, {1, 1, 1, 1}},
      {"oren_nayar_as_coded", "albedo=1 roughness=0.5", {89}, {1.2155}, 5e-5},
  };
  return r;
}

TEST(AlbedoVerb, ReproducesTheIndependentValues) {
  const io::TemporaryFolder folder;
  for (const Row& row : rows()) {
    std::string arguments = "albedo --json --tolerance 1e-12 --form " + row.form + " --fixed " + row.fixed;
    std::istringstream sets(row.parameters);
    for (std::string set; sets >> set;) arguments += " --set " + set;
    std::ostringstream angles;
    angles.precision(17);
    for (const double theta : row.theta) angles << (angles.tellp() > 0 ? "," : "") << theta;
    const Outcome outcome = run_brdf(arguments + " --theta " + angles.str(), folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << arguments << outcome.err;
    const io::Json results = io::parse_json(outcome.out, "stdout")["results"];
    ASSERT_EQ(results.size(), row.albedo.size());
    for (std::size_t k = 0; k < row.albedo.size(); ++k)
      EXPECT_NEAR(results[k]["value"].get<double>(), row.albedo[k], row.error)
          << arguments << " at " << row.theta[k];
  }
}

}  // namespace
}  // namespace brdf
