// The results of `brdf prove --all`, and that its certificate is verified and cannot be forged.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/material/settings.h"
#include "prove/check/certificate.h"
#include "prove/report.h"

namespace brdf::prove {
namespace {

// Returns whether docs/proofs.md lists the results for the form. A form that was added later is printed by
// name and may be undecided.
bool is_listed(const Proof& p) {
  static const std::string page = io::read_content(BRDF_SOURCE_DIR "/docs/proofs.md").bytes;
  if (page.find("| `" + p.form + "` |") != std::string::npos) return true;
  std::cout << p.form << " is not in docs/proofs.md: " << name_of(p.verdict) << ", " << p.statement << '\n';
  return false;
}

std::vector<Proof> all(const std::vector<Property>& properties, long leaves = 20000) {
  std::vector<Proof> found;
  Options options;
  options.properties = properties;
  options.search.leaves = leaves;
  for (const Reflectance& form : catalogue())
    for (Proof& p : prove(form, options)) found.push_back(std::move(p));
  return found;
}

bool declared(const Proof& p) {
  return catalogue()[std::size_t(p.claim.form)].info().violates(name_of(p.claim.property));
}

TEST(Proofs, EveryFormIsFiniteInBothPrecisions) {
  for (const Proof& p : all({Property::finite})) {
    EXPECT_NE(p.verdict, Verdict::refuted) << p.form;
    if (is_listed(p)) {
      EXPECT_EQ(p.verdict, Verdict::proved) << p.form << ": " << p.statement;
    }
  }
}

TEST(Proofs, FormsAreNonNegativeUnlessDeclaredOtherwise) {
  for (const Proof& p : all({Property::non_negative})) {
    if (!declared(p)) {
      EXPECT_NE(p.verdict, Verdict::refuted) << p.form;
      if (is_listed(p)) {
        EXPECT_EQ(p.verdict, Verdict::proved) << p.form << ": " << p.statement;
      }
      continue;
    }
    ASSERT_EQ(p.verdict, Verdict::refuted) << p.form;
    EXPECT_LT(p.witness->value, -0.01);
    EXPECT_LT(p.low, p.witness->value);
  }
}

TEST(Proofs, ReciprocityIsOfTheOperationsThemselves) {
  std::map<std::string, int> of;
  for (const Proof& p : all({Property::reciprocity})) {
    if (!is_listed(p)) continue;
    EXPECT_EQ(p.verdict, declared(p) ? Verdict::no_method : Verdict::proved) << p.form;
    ++of[p.arithmetic];
  }
  EXPECT_EQ(of["every IEEE precision, bit for bit"],
            25);  // with five matt bases and one retroreflective lobe
  EXPECT_EQ(of["exact"], 3);
}

TEST(Proofs, EnergyIsProvedWhereAReasonIsKnownAndRefutedWhereDeclared) {
  int proved = 0;
  for (const Proof& p : all({Property::energy})) {
    EXPECT_EQ(p.verdict == Verdict::refuted, declared(p)) << p.form;
    if (p.verdict != Verdict::proved || !is_listed(p)) continue;
    ++proved;
    EXPECT_LE(p.high, 1 + 1e-15) << p.form;
  }
  // Two diffuse forms, two cosine lobes, four families of facets, the bounded Ward and two lobes about the
  // light.
  EXPECT_EQ(proved, 12);
}

TEST(Proofs, AnAlbedoAboveOneIsBoundedCloselyAtAllAngles) {
  int bounded = 0;
  for (const Proof& p : all({Property::energy})) {
    if (!p.witness || !(p.high < 2)) continue;
    ++bounded;
    EXPECT_EQ(p.cover.open, 0);
    EXPECT_NEAR(p.witness->value, 1.0151788, 2e-7);
    EXPECT_LE(p.witness->value, p.high);
    EXPECT_LT(p.high, 1.0151788 + 2e-5);
  }
  EXPECT_EQ(bounded, 1);
}

// A small certificate of proofs that need only a few boxes.
const std::string& certificate() {
  static const std::string text =
      to_certificate(all({Property::finite, Property::non_negative, Property::reciprocity}, 40));
  return text;
}

TEST(Certificate, HoldsAsItIsWritten) {
  const Checked checked = check({"c", certificate()});
  EXPECT_TRUE(checked.faults.empty()) << checked.faults.front();
  EXPECT_GT(checked.results.size(), 100u);
  EXPECT_GT(checked.leaves, long(checked.results.size()) / 2);
}

TEST(Certificate, IsRejectedWithAnyDigitChanged) {
  const std::string& text = certificate();
  long tried = 0;
  for (std::size_t k = 0; k < text.size(); k += 31) {
    const std::size_t at = text.find_first_of("0123456789", k);
    if (at == std::string::npos) break;
    std::string changed = text;
    changed[at] = changed[at] == '9' ? '8' : char(changed[at] + 1);
    ++tried;
    try {
      EXPECT_FALSE(check({"c", changed}).faults.empty()) << "at " << at;
    } catch (const InputError&) {  // no longer a certificate
    }
  }
  EXPECT_GT(tried, 200);
}

// Changes the content as a forger would and seals the certificate again.
std::string forged(const std::function<bool(io::Json&)>& change) {
  io::Json results = io::parse_json(certificate(), "c")["results"];
  for (io::Json& row : results)
    if (change(row)) return sealed(results);
  ADD_FAILURE() << "nothing to change";
  return certificate();
}
bool rejected(const std::string& text) {
  return !check({"c", text}).faults.empty();
}
bool has_cuts(const io::Json& row) {
  return row.contains("cover") && row["cover"].size() > 4;
}

TEST(Certificate, IsRejectedWhenForgedAndSealedAnew) {
  EXPECT_TRUE(rejected(forged([](io::Json& row) {  // another bound
    if (!row.contains("high")) return false;
    row["high"] = row["high"].get<double>() / 2;
    return true;
  })));
  EXPECT_TRUE(rejected(forged([](io::Json& row) {  // a smaller domain
    if (!has_cuts(row)) return false;
    row["domain"].begin().value()[0] = row["domain"].begin().value()[1];
    return true;
  })));
  EXPECT_TRUE(rejected(forged([](io::Json& row) {  // one half left out
    if (!has_cuts(row)) return false;
    row["cover"].erase(row["cover"].size() - 1);
    return true;
  })));
  EXPECT_TRUE(rejected(forged([](io::Json& row) {  // the whole domain as one leaf
    if (!has_cuts(row)) return false;
    row["cover"] = io::Json::array({io::Json::array({row["low"], row["high"]})});
    return true;
  })));
  EXPECT_TRUE(rejected(forged([](io::Json& row) {  // a claim for another precision
    if (!has_cuts(row) || row["scalar"] != "float") return false;
    row["scalar"] = "double";
    return true;
  })));
  EXPECT_TRUE(rejected(forged([](io::Json& row) {  // a form that is not reciprocal
    if (row.contains("cover")) return false;
    for (const Proof& p : all({Property::reciprocity}))
      if (p.verdict != Verdict::proved) row["form"] = p.form;
    return true;
  })));
}

TEST(Certificate, HoldsTheGrowthOfAnAlbedoAndRejectsAnother) {
  Options options;
  options.properties = {Property::energy};
  const auto rows = [&](const std::function<void(io::Json&)>& change) {
    int count = 0;
    io::Json results = io::parse_json(to_certificate(prove(*find_form("ward"), options)), "c")["results"];
    for (io::Json& row : results)
      if (row["property"] == "growth") ++count, change(row);
    EXPECT_EQ(count, 1);
    return sealed(results);
  };
  EXPECT_FALSE(rejected(rows([](io::Json&) {})));
  EXPECT_TRUE(rejected(rows([](io::Json& row) { row["high"] = row["high"].get<double>() * 0.9; })));
  EXPECT_TRUE(rejected(rows([](io::Json& row) { row["low"] = row["low"].get<double>() * 1.1; })));
  EXPECT_TRUE(rejected(rows([](io::Json& row) { row["width"] = row["width"].get<double>() / 2; })));
  EXPECT_TRUE(rejected(rows([](io::Json& row) { row["form"] = "ward_duer"; })));
  EXPECT_TRUE(rejected(rows([](io::Json& row) { row["form"] = "ward_bounded"; })));
}

}  // namespace
}  // namespace brdf::prove
