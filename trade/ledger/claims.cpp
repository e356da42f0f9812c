#include "trade/ledger/claims.h"
#include "brdf/forms.h"

#include <cmath>
#include <map>

#include "brdf/integrals.h"

namespace brdf::trade {
namespace {

constexpr const char* kThesis = "the thesis";
constexpr const char* kLookup = "the lookup-texture article";
constexpr const char* kShading = "the pixel-shader article";

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

double value(const Material& m, double theta_i, double theta_o, double phi) {
  double f = 0;
  eval(m, direction(degrees(theta_i), {}), direction(degrees(theta_o), degrees(phi)), std::span(&f, 1));
  return f;
}

Material lobe_only(const Reflectance& form, const char* parameter, double shape) {
  Material m = make_material(form, {"fr"});
  const int kd = info(form).weight_index("kd"), ks = info(form).weight_index("ks");
  if (kd >= 0) m.terms[0].weights[0][std::size_t(kd)] = 0;
  if (ks >= 0) m.terms[0].weights[0][std::size_t(ks)] = 1;
  if (const int k = info(form).shape_index(parameter); k >= 0) m.terms[0].shape[0][std::size_t(k)] = shape;
  return m;
}

class Judge {
 public:
  explicit Judge(const Ledger& ledger) : ledger_(ledger) {}

  // Adds the claim where the row exists; `say` returns verdict and evidence.
  template <class Say>
  void claim(const char* source, const char* text, const std::string& question, const std::string& choice,
             Say say) {
    const LedgerRow* row = ledger_.find(question, choice);
    if (!row) return;
    const auto [verdict, evidence] = say(*row);
    claims.push_back({source, text, verdict, evidence, question, choice});
  }
  const LedgerRow* find(const char* question, const char* choice) const {
    return ledger_.find(question, choice);
  }
  std::vector<Claim> claims;

 private:
  const Ledger& ledger_;
};

using Said = std::pair<std::string, std::string>;

void judge_lobes(Judge& judge) {
  judge.claim(kThesis, "the half vector is cheaper than the mirror direction",
              "mirror direction or half vector", "half vector, equal n", [](const LedgerRow& row) {
                return Said{row.cost_ratio < 0.95   ? "holds"
                            : row.cost_ratio > 1.05 ? "does not hold"
                                                    : "no difference",
                            "costs " + number(row.cost_ratio) +
                                " times the mirror direction: the half vector must be "
                                "normalised, the mirror direction's cosine needs no root"};
              });
  judge.claim(kThesis, "Blinn-Phong's highlight is dimmer than Phong's at equal n",
              "mirror direction or half vector", "half vector, equal n", [](const LedgerRow&) {
                const double phong_peak = value(lobe_only(phong{}, "exponent", 20), 0, 0, 180);
                const double blinn_peak = value(lobe_only(blinn_phong{}, "exponent", 20), 0, 0, 180);
                return Said{
                    blinn_peak < phong_peak ? "holds for normalised lobes" : "does not hold",
                    "peaks at n = 20: " + number(blinn_peak) + " against " + number(phong_peak) +
                        " 1/sr; as printed, without normalisation, both peaks are 1 and Blinn-Phong's "
                        "highlight is wider, so brighter in all"};
              });
}

// Width of the listing's lobe at 90 % of its value in the
// mirror direction, across over along the plane of incidence.
double ward_aspect() {
  Material m = make_material(ward_as_coded{}, {"fr"});
  if (const int k = info(ward_as_coded{}).shape_index("metallic"); k >= 0)
    m.terms[0].shape[0][std::size_t(k)] = 1;
  const Vec3<double> wi = direction(degrees(60), {}), mirror{-wi.x, -wi.y, wi.z};
  const Vec3<double> along{-wi.z, 0, -wi.x}, across{0, 1, 0};
  const auto f = [&](const Vec3<double>& wo) {
    double value = 0;
    eval(m, wi, wo, std::span(&value, 1));
    return value;
  };
  const auto width = [&](const Vec3<double>& axis) {
    double t = 0;
    while (t < 1.5 && f(mirror * std::cos(t) + axis * std::sin(t)) > 0.9 * f(mirror)) t += 1e-3;
    return t;
  };
  return width(across) / std::min(width(along), width(along * -1.0));
}

void judge_families(Judge& judge, const Ledger& ledger) {
  judge.claim(kThesis, "Ward's highlight looks elliptical even with both constants 1",
              "families for a material of ward", "ward", [](const LedgerRow&) {
                const double aspect = ward_aspect();
                return Said{std::abs(aspect - 1) > 0.1 ? "holds" : "does not hold",
                            "the listing's lobe at 60 degrees is " + number(aspect) +
                                " times as wide across the plane of incidence as along it"};
              });
  judge.claim(kThesis, "Oren-Nayar conserves energy", "families for a material of oren_nayar", "oren_nayar",
              [](const LedgerRow&) {
                Material m = make_material(oren_nayar{}, {"fr"});
                m.terms[0].weights[0] = {1};
                m.terms[0].shape[0] = {0.198533};
                const double e = directional_albedo(m.terms[0], 0, degrees(90), {}).value;
                return Said{e > 1 + 1e-6 ? "does not hold" : "holds",
                            "albedo " + number(e) + " at rho 1, sigma 0.1985 rad, grazing light"};
              });
  judge.claim(kThesis, "Oren-Nayar brightens towards the limb", "families for a material of oren_nayar",
              "oren_nayar", [](const LedgerRow&) {
                Material m = make_material(oren_nayar{}, {"fr"});
                m.terms[0].shape[0] = {0.5};
                const double ratio = value(m, 80, 80, 0) / value(m, 0, 0, 0);
                return Said{ratio > 1.05 ? "holds" : "does not hold",
                            "light from the viewer, sigma 0.5: f at 80 degrees is " + number(ratio) +
                                " times f at normal incidence"};
              });
  judge.claim(kThesis, "Lambert or Oren-Nayar suffice where physics matters less",
              "families for a material of cook_torrance", "lambert", [](const LedgerRow& row) {
                return Said{"a matter of tolerance", "Lambert fitted to cook_torrance: image error " +
                                                         number(row.image_error.value_or(0)) + " at " +
                                                         number(row.cost_ratio) + " of the cost"};
              });
  // The family that fits the others' materials best.
  std::map<std::string, double> sums;
  for (const LedgerRow& row : ledger.rows)
    if (row.question.rfind("families for a material of ", 0) == 0 && row.choice != row.exact &&
        row.image_error)
      if (const auto form = find_form(row.choice); form && info(*form).canonical)
        sums[row.choice] += *row.image_error / 5;
  judge.claim(kThesis, "Cook-Torrance is the most realistic", "families for a material of ward",
              "cook_torrance", [&](const LedgerRow&) {
                std::string best = "cook_torrance";
                for (const auto& [name, error] : sums)
                  if (error < sums[best]) best = name;
                return Said{best == "cook_torrance" ? "holds among the six" : "does not hold",
                            "mean image error on the other five families' materials: cook_torrance " +
                                number(sums["cook_torrance"]) + ", the best is " + best + " with " +
                                number(sums[best]) + "; real materials are another question"};
              });
  judge.claim(kThesis, "parameters are fitted from goniometer samples by optimisation", "samples for a fit",
              "1e3 samples", [](const LedgerRow& row) {
                return Said{row.error.mean < 0.02 ? "holds" : "does not hold",
                            "1000 samples with 5 % noise give f within " + number(row.error.mean) +
                                " on average in " + number(row.cost.seconds * 1e3) + " ms"};
              });
}

void judge_frames(Judge& judge) {
  judge.claim(kThesis, "deferred rendering allows many more lights", "forward or deferred, 64 lights",
              "deferred, 16 bits", [&](const LedgerRow& row) {
                const LedgerRow* one = judge.find("forward or deferred, 1 light", "deferred, 16 bits");
                return Said{row.cost_ratio < 0.95 ? "holds" : "does not hold",
                            "a frame costs " + number(row.cost_ratio) + " of forward's at 64 lights" +
                                (one ? ", " + number(one->cost_ratio) + " at one" : std::string())};
              });
  judge.claim(kThesis, "16-bit targets are needed for vectors", "bits of the G-buffer, alpha 0.05", "8 bits",
              [&](const LedgerRow& row) {
                const LedgerRow* wide = judge.find("bits of the G-buffer, alpha 0.3", "8 bits");
                return Said{row.error.max > 0.05 ? "holds for narrow highlights" : "does not hold",
                            "8 bits: image error " + number(row.image_error.value_or(0)) + ", largest " +
                                number(row.error.max) + " at alpha 0.05" +
                                (wide ? "; " + number(wide->image_error.value_or(0)) + " at alpha 0.3"
                                      : std::string())};
              });
  for (const char* triangles : {"5120", "320"})
    judge.claim(kShading, "Phong and Gouraud shading look alike", "where to shade: diffuse",
                std::string(triangles) + " triangles, Phong as coded", [&](const LedgerRow& row) {
                  const LedgerRow* gouraud = judge.find(
                      "where to shade: diffuse", (std::string(triangles) + " triangles, Gouraud").c_str());
                  const LedgerRow* phong = judge.find("where to shade: diffuse",
                                                      (std::string(triangles) + " triangles, Phong").c_str());
                  return Said{"holds because the normal is not renormalised",
                              "as coded: " + row.note + (gouraud ? "; Gouraud: " + gouraud->note : "") +
                                  (phong ? "; with unit normals: " + phong->note : "")};
                });
  judge.claim(kShading, "the half vector of the code is a half vector", "where to shade: highlight",
              "5120 triangles, highlight as coded", [](const LedgerRow& row) {
                return Said{"does not hold",
                            "the light vector has length sqrt(3), so h is 7.9 degrees off: largest "
                            "error " +
                                number(row.error.max) + " of a highlight of 0.75"};
              });
}

void judge_lookup(Judge& judge) {
  judge.claim(kLookup, "H = N is adequate because the lobe is strong there", "lookup texture, alpha 0.3",
              "H = N, evaluated", [](const LedgerRow& row) {
                const double image = row.image_error.value_or(0);
                return Said{image < 0.02 ? "holds in the picture, not towards grazing" : "does not hold",
                            "image error " + number(image) + "; largest error " + number(row.error.max) +
                                " 1/sr at " + row.error.where};
              });
  judge.claim(kLookup, "the lookup texture is fast", "lookup texture, alpha 0.3", "512^2, 8 bit, nearest",
              [](const LedgerRow& row) {
                return Said{row.cost_ratio < 0.95 ? "holds" : "does not hold on a CPU",
                            "costs " + number(row.cost_ratio) + " times the exact evaluation in batches"};
              });
  judge.claim(
      kLookup, "G is cancelled by D and meaningless", "masking for GGX, by the albedo it gives", "G dropped",
      [&](const LedgerRow& row) {
        const LedgerRow* picture = judge.find("masking for GGX", "G dropped");
        return Said{
            "does not hold towards grazing",
            "without G the albedo is up to " + number(row.error.max) + " too large (" + row.error.where +
                ")" +
                (picture ? "; image error on the ball " + number(picture->image_error.value_or(0)) : "")};
      });
  judge.claim(kLookup, "the reflection is weaker where the light is frontal", "lookup texture, alpha 0.3",
              "exact", [](const LedgerRow&) {
                const Material m = lobe_only(cook_torrance_vcavity{}, "eta", 1.5);
                const double ratio = value(m, 60, 60, 180) * 0.5 / value(m, 0, 0, 180);
                return Said{ratio > 1 ? "holds" : "does not hold",
                            "mirror direction at 60 degrees against normal incidence: f cos_i is " +
                                number(ratio) + " times as large"};
              });
  judge.claim(kLookup, "its Fresnel term, as coded", "Fresnel of glass", "the article's slip",
              [](const LedgerRow& row) {
                return Said{"wrong", "up to " + number(row.error.max) + " too large, image error " +
                                         number(row.image_error.value_or(0))};
              });
}

}  // namespace

std::vector<Claim> judge_claims(const Ledger& ledger) {
  Judge judge(ledger);
  judge_lobes(judge);
  judge_families(judge, ledger);
  judge_frames(judge);
  judge_lookup(judge);
  return judge.claims;
}

}  // namespace brdf::trade
