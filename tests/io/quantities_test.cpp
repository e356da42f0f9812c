// Tests that every word of a quantity and every unit is converted, refused by its name, or leads to a
// question. Only the words of f_r become f_r without an announcement.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "brdf/angle.h"
#include "io/columns/quantities.h"
#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "io/samples/degrees.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// Light at 60 degrees, viewer at 45 degrees: the cosines are 1/2 and sqrt(1/2).
const double kCosLight = cos_degrees(60), kCosViewer = cos_degrees(45);
constexpr double kTruth = 0.2;  // f_r

std::string foreign(const std::string& name, double value) {
  return "Incidence (deg),View angle (deg),Relative azimuth,\"" + name + "\"\n60,45,170," + to_text(value) +
         "\n";
}
std::string plain(const std::string& name, double value) {
  return "theta_i,phi_i,theta_o,phi_o,\"" + name + "\"\n60,0,45,170," + to_text(value) + "\n";
}
std::string all_notes(const SampleTable& table) {
  std::string notes;
  for (const std::string& warning : table.warnings) notes += warning + '\n';
  return notes;
}

struct Word {
  const char* name;
  double value;  // represents kTruth in the unit of the name
};

std::ostream& operator<<(std::ostream& out, const Word& word) {
  return out << word.name;
}

const double kBrf = kPi * kTruth, kArs = kTruth * kCosViewer;

const Word kOfFr[] = {{"f_r", kTruth},
                      {"fr", kTruth},
                      {"BRDF", kTruth},
                      {"brdf (sr^-1)", kTruth},
                      {"BRDF [sr⁻¹]", kTruth},
                      {"BRDF_1/sr", kTruth},
                      {"BSDF (1/sr)", kTruth},
                      {"ρ (1/sr)", kTruth},
                      {"rho [sr-1]", kTruth},
                      {"Bidirectional reflectance distribution function", kTruth},
                      {"radiance coefficient", kTruth},
                      {"Radiance coefficient q (cd/m2/lx)", kTruth},
                      {"luminance coefficient (cd m^-2 lx^-1)", kTruth},
                      {"q (cd/(m²·lx))", kTruth},
                      {"1/sr", kTruth},
                      {"BRDF/sr", kTruth},
                      {"fr /sr", kTruth},
                      {"550nm (1/sr)", kTruth}};

const Word kConverted[] = {
    {"mcd/m2/lx", 1000 * kTruth},
    {"luminance coefficient (mcd/m²/lx)", 1000 * kTruth},
    {"BRDF x1000 (1/sr)", 1000 * kTruth},
    {"BRDFx1000", 1000 * kTruth},
    {"1000*BRDF", 1000 * kTruth},
    {"BRDF × 10^4", 1e4 * kTruth},
    {"BRDF (x100)", 100 * kTruth},
    {"BRDF (10^-3 sr^-1)", 1000 * kTruth},
    {"fr [10⁻³ sr⁻¹]", 1000 * kTruth},
    {"BRDF (1e-3/sr)", 1000 * kTruth},
    {"milli BRDF", 1000 * kTruth},
    {"BRDF (milli 1/sr)", 1000 * kTruth},
    {"mBRDF", 1000 * kTruth},
    {"BRDF (%/sr)", 100 * kTruth},
    {"BRF", kBrf},
    {"brf_nadir", kBrf},
    {"HDRF", kBrf},
    {"HCRF", kBrf},
    {"Reflectance factor", kBrf},
    {"ReflectanceFactor", kBrf},
    {"REFLECTANCE_FACTOR", kBrf},
    {"bidirectional reflectance factor R", kBrf},
    {"CIE radiance factor", kBrf},
    {"luminance factor", kBrf},
    {"REFF", kBrf},
    {"reflectance factor (%)", 100 * kBrf},
    {"BRF [percent]", 100 * kBrf},
    {"Reflectance factor / %", 100 * kBrf},
    {"RF", kBrf},
    {"% BRF", 100 * kBrf},
    {"Reflectance factor in percent", 100 * kBrf},
    {"Reflectance factor [1]", kBrf},
    {"Reflectance factor (-)", kBrf},
    {"BRF1", kBrf},
    {"BRF 550 nm", kBrf},
    {"ARS", kArs},
    {"ARS (1/sr)", kArs},
    {"DSC", kArs},
    {"angle-resolved scatter (1/sr)", kArs},
    {"cosine-corrected BRDF", kArs},
    {"cos corrected BRDF (1/sr)", kArs},
    {"ccBRDF", kArs},
    {"BRDF*cos", kArs},
    {"BRDFcos", kArs},
    {"cos-weighted BRDF", kArs},
    {"BRDF cos(theta_o)", kArs},
    {"f_r*cos_o", kArs},
    {"fr·cosθr", kArs},
    {"intensity", kArs},
    {"ARS (ppm/sr)", 1e6 * kArs},
    {"f_r*cos_i", kTruth* kCosLight},
    {"BRDF cos(θ_i) (1/sr)", kTruth* kCosLight},
    {"f_r*cos_i*cos_o", kTruth* kCosLight* kCosViewer},
    {"I/F", kBrf* kCosLight},
    {"RADF", kBrf* kCosLight},
    {"reduced luminance coefficient", 1e4 * kTruth* std::pow(kCosLight, 3)},
    {"reduced luminance coefficient x 10^4", 1e4 * kTruth* std::pow(kCosLight, 3)},
    {"R_A (cd/lx/m2)", kTruth* kCosLight* kCosViewer},
    {"R_A", kTruth* kCosLight* kCosViewer},
    {"R' (cd/lx/m2)", kTruth* kCosLight* kCosViewer},
    {"R_L (mcd/m²/lx)", 1000 * kTruth* kCosLight},
    {"coefficient of retroreflection (mcd/lx/m²)", 1000 * kTruth* kCosLight* kCosViewer},
    {"log10 BRDF", std::log10(kTruth)},
    {"log10(BRDF) (1/sr)", std::log10(kTruth)},
    {"log BRDF", std::log10(kTruth)},
    {"lg(f_r)", std::log10(kTruth)},
    {"log_10 BRF", std::log10(kBrf)},
    {"ln(f_r)", std::log(kTruth)},
    {"ln BRDF [1/sr]", std::log(kTruth)},
    {"log_e BRDF", std::log(kTruth)},
    {"BRDF (dB)", 10 * std::log10(kTruth)},
    {"BRDF [dB sr^-1]", 10 * std::log10(kTruth)},
    {"dB/sr", 10 * std::log10(kTruth)},
    {"BRDF (dB re 1/sr)", 10 * std::log10(kTruth)},
    {"BRF (dB)", 10 * std::log10(kBrf)},
    {"10 log10(BRDF)", 10 * std::log10(kTruth)},
    {"10*log BRDF", 10 * std::log10(kTruth)},
    {"BRDF [ppm/sr]", 1e6 * kTruth},
    {"BRF (‰)", 1e3 * kBrf},
    {"BRF (per mille)", 1e3 * kBrf},
    {"BRF‰", 1e3 * kBrf},
    {"BRF_permille", 1e3 * kBrf},
    {"BRF (ppb)", 1e9 * kBrf},
    {"BRDF [‰/sr]", 1e3 * kTruth},
    {"dB_fr", 10 * std::log10(kTruth)},
    {"dB BRF", 10 * std::log10(kBrf)}};

class NameOfFr : public testing::TestWithParam<Word> {};
class ConvertedName : public testing::TestWithParam<Word> {};

TEST_P(NameOfFr, StaysAsItIsAndNeedsNoWord) {
  for (const std::string& text :
       {foreign(GetParam().name, GetParam().value), plain(GetParam().name, GetParam().value)}) {
    const SampleTable table = read(text);
    EXPECT_EQ(table.values[0][0], kTruth);
    EXPECT_THAT(all_notes(table), Not(HasSubstr("interpreted as f_r")));
  }
}

TEST_P(ConvertedName, BecomesFrAndIsAnnouncedByItsName) {
  for (const std::string& text :
       {foreign(GetParam().name, GetParam().value), plain(GetParam().name, GetParam().value)}) {
    const SampleTable table = read(text);
    EXPECT_NEAR(table.values[0][0], kTruth, 1e-12);
    EXPECT_THAT(table.warnings,
                Contains(AllOf(HasSubstr("column " + shown(GetParam().name) + " is "), HasSubstr(": "))));
    // The written table holds f_r and is read back as f_r.
    expect_same(read(written(table)), table);
  }
}

INSTANTIATE_TEST_SUITE_P(Quantities, NameOfFr, testing::ValuesIn(kOfFr));
INSTANTIATE_TEST_SUITE_P(Quantities, ConvertedName, testing::ValuesIn(kConverted));

struct RefusedName {
  const char *name, *message;
};

const RefusedName kRefused[] = {
    {"BTDF (1/sr)", "of transmitted light, not f_r: only reflected light is read"},
    {"transmittance", "of transmitted light"},
    {"BSDF transmission (1/sr)", "of transmitted light"},
    {"ccBTDF", "of transmitted light"},
    {"counts", "a detector's signal, not f_r: the signal of a white standard, or the irradiance, is missing"},
    {"counts/s", "a detector's signal"},
    {"signal (V)", "a detector's signal"},
    {"signal (mV)", "a detector's signal"},
    {"photocurrent (nA)", "a detector's signal"},
    {"detector (W)", "a detector's signal"},
    {"digital number", "a detector's signal"},
    {"radiance (W/m2/sr)", "a radiance, not f_r: the irradiance of the sample is missing"},
    {"radiance", "a radiance"},
    {"L [W m^-2 sr^-1 nm^-1]", "a radiance"},
    {"luminance (cd/m2)", "a luminance, not f_r: the illuminance of the sample is missing"},
    {"luminance (cd/m²)", "a luminance"},
    {"cd/m2", "a luminance"},
    {"intensity (W/sr)", "an intensity that is not divided by the incident light"},
    {"radiant intensity", "an intensity"},
    {"intensity (counts)", "a detector's signal"},
    {"L*", "a colour coordinate or a gloss, not f_r: the geometry and the spectrum are missing"},
    {"a*", "a colour coordinate"},
    {"gloss (GU)", "a colour coordinate or a gloss"},
    {"R (dB)", "in decibels of a ratio"},
    {"reflectance (dB)", "in decibels of a ratio"},
    {"RCS (dBsm)", "a radar cross section, not f_r: the illuminated area is missing"},
    {"RCS", "a radar cross section"},
    {"phase", "a phase or an amplitude"},
    {"albedo", "of a whole hemisphere"},
    {"TIS", "of a whole hemisphere"},
    {"d/8", "of a whole hemisphere"},
    {"Qd (mcd/m2/lx)", "of a whole hemisphere"},
    {"nBRDF", "without a scale"},
    {"RCS (m2)", "a radar cross section"},
    {"20 log10(BRDF)", "is a multiple of a logarithm"},
    {"BRDF (a.u.)", "without a scale"},
    {"relative BRDF", "without a scale"},
    {"normalised BRDF (1/sr)", "without a scale"},
    // These names are ambiguous, because several quantities have them. The message asks for --quantity.
    {"reflectance (%)", "--quantity BRF"},
    {"Reflectance", "--quantity BRF"},
    {"reflectivity", "--quantity BRF"},
    {"rho", "--quantity BRF"},
    {"550nm (%)", "--quantity 'BRF %'"},
    {"%", "--quantity 'BRF %'"},
    {"scatter [ppm/sr]", "--quantity f_r or --quantity f_r*cos_o (ARS)"},
    {"ppm/sr", "--quantity f_r or"},
    {"scatter (1/sr)", "--quantity f_r or"},
    // In these names the unit and the word contradict each other.
    {"BRDF (%)", "has the unit '%', which does not fit the quantity"},
    {"BRDF (V)", "has the unit 'V'"},
    {"BRF (1/sr)", "has the unit '1/sr'"},
    {"BRDF x10^-3", "has a factor or a unit that is a power of ten below 1"},
    {"-log10 BRDF", "is a negative logarithm"},
    {"log2 BRDF", "is a logarithm with a base other than"},
    {"log10(550nm)", "gives a scale, but no quantity"},
    {"BRDF / cos", "is divided by a cosine"},
    {"BRDF*cos^2", "is multiplied by a power of a cosine"},
    {"BRDF cos²θ", "is multiplied by a power of a cosine"},
    {"fr (‰)", "has the unit '‰', which does not fit the quantity"},
    {"fr (per thousand)", "has the unit 'per thousand'"},
    {"BRDF (ppb)", "has the unit 'ppb'"},
    {"fr (kg)", "has the unit 'kg'"},
    {"550nm [‰]", "is in parts of 1000, of a quantity that the name does not state"},
    {"BRDF_norm", "without a scale"},
    {"log1p(fr)", "is a logarithm with a base other than"},
    // A part of the name that is not understood may change the values.
    {"fr (xyz)", "has the unknown unit 'xyz' in its name, which is not applied: rename the column"},
    {"BRDF 10^3", "has the operator '^' in its name, which is not applied"},
    {"10^3 BRDF", "has the operator '^'"},
    {"1000 BRDF", "has the factor '1000'"},
    {"2 BRDF", "has the factor '2'"},
    {"BRDF 1e3", "has the factor '1e3'"},
    {"BRDF (1000)", "has the factor '1000'"},
    {"BRDF/1000", "has the operator '/'"},
    {"BRDF / 1e-3", "has the operator '/'"},
    {"1/BRDF", "has the operator '/'"},
    {"fr/fr0", "has the operator '/'"},
    {"BRDF^2", "has the operator '^'"},
    {"2*BRDF", "has the operator '*'"},
    {"1-fr", "has the operator '-'"},
    {"-fr", "has the operator '-'"},
    {"|fr|", "has the operator '|'"},
    {"sqrt(BRDF)", "has the function 'sqrt'"},
    {"√BRDF", "has the function 'sqrt'"},
    {"exp(fr)", "has the function 'exp'"},
    {"F(BRDF)", "has the function 'f'"},
    {"delta fr", "has the word 'delta'"},
    {"Δfr", "has the word 'delta'"},
    {"dBRDF", "has the word 'd'"},
    {"fr_ratio", "has the word 'ratio'"},
    {"fr_dark", "has the word 'dark'"},
    {"fr_bg", "has the word 'bg'"},
    {"fr_max", "has the word 'max'"},
    {"550nm_max", "has the word 'max'"},
    {"550nm/1000", "has the operator '/'"},
    {"sqrt(550nm)", "has the function 'sqrt'"},
    {"BRF*cos_o", "is multiplied by a cosine"}};

class NameOfAnother : public testing::TestWithParam<RefusedName> {};

TEST_P(NameOfAnother, IsRefusedByItsNameWithWhatIsMissing) {
  const std::string name = GetParam().name;
  const auto says = AllOf(HasSubstr("column " + shown(name)), HasSubstr(GetParam().message));
  EXPECT_THAT(message(plain(name, 0.5)), says);
  EXPECT_THAT(message(foreign(name, 0.5)), says);
}

INSTANTIATE_TEST_SUITE_P(Quantities, NameOfAnother, testing::ValuesIn(kRefused));

// The names of bands, polarisations, samples and geometries have no part that changes the values.
TEST(Quantities, NamesOfChannelsAreNoOperations) {
  for (const char* name :
       {"550nm",   "r",       "fr_550",    "fr[550nm]", "fr (550 nm)",    "BRDF_633nm",  "BRDF 550",
        "fr_1000", "X",       "fr_s",      "fr_pp",     "fr (s)",         "s-pol",       "red",
        "nir",     "band1",   "ch2",       "sample A",  "sample-A",       "fr sample 3", "fr (red)",
        "fr (r)",  "fr mean", "mean(fr)",  "dark red",  "fr-550",         "0.55um",      "18000cm-1",
        "tile #4", "fr_mean", "R (550nm)", "rgb_r",     "BRDF (in-plane)"}) {
    const SampleTable table = read(plain(name, 0.5));
    EXPECT_EQ(table.values[0][0], 0.5) << name;
    EXPECT_EQ(table.channels[0], std::string(name)) << name;
    EXPECT_THAT(table.warnings, testing::IsEmpty()) << name;
  }
  EXPECT_DOUBLE_EQ(read(plain("BRF 45/0", 0.5)).values[0][0], 0.5 / kPi);
}

TEST(Quantities, NumbersThatAccompanyValuesAreNoChannels) {
  const SampleTable t =
      read("theta_i,phi_i,theta_o,phi_o,fr,n,fr_min,fr_max,fr_dark\n60,0,45,170,.5,7,.4,.6,.1\n");
  EXPECT_THAT(t.channels, ElementsAre("fr"));
  EXPECT_THAT(t.warnings,
              Contains("columns 'n', 'fr_min', 'fr_max', 'fr_dark' are ignored: not values of f_r"));
  // Alone, such a number is not taken for the quantity, and a table that states f_r keeps every name.
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o,fr_min\n60,0,45,170,.4\n"), HasSubstr("the word 'min'"));
  EXPECT_THAT(read("# quantity: f_r\ntheta_i,phi_i,theta_o,phi_o,fr_min\n60,0,45,170,.4\n").channels,
              ElementsAre("fr_min"));
}

TEST(Quantities, OneChannelInTwoSpellingsIsRefused) {
  const std::string angles = "theta_i,phi_i,theta_o,phi_o,", row = "\n60,0,45,170,.5,.6\n";
  for (const char* names :
       {"550nm,550 nm", "0.55um,550nm", "fr,BRF", "fr_550nm,550nm", "sample A,sample_A", "BRDF,f_r*cos_o"})
    EXPECT_THAT(message(angles + names + row), HasSubstr("are one channel in two spellings or units"))
        << names;
  for (const char* names :
       {"550nm,551nm", "550nm A,550nm B", "fr_s,fr_p", "r,g", "fr,value", "BRF_1,BRF_2", "fr,fr A"})
    EXPECT_EQ(read(angles + names + row).channels.size(), 2u) << names;
}

// The scale in a comment is not applied; and a note follows. Numbers with units are not about the values.
TEST(Quantities, AScaleInACommentIsNoted) {
  const auto notes_of = [](const std::string& comment, const std::string& name = "fr") {
    return all_notes(read("# " + comment + "\n" + plain(name, 0.5)));
  };
  for (const char* comment :
       {"values in percent", "units: degrees, percent", "scale: 0.001", "values multiplied by 1000",
        "values normalised to 1", "units: dB", "data in log10", "BRF (‰)", "unit: W/m2/sr"})
    EXPECT_THAT(notes_of(comment),
                AnyOf(HasSubstr("seems to give the values a scale or a unit, which is not applied"),
                      HasSubstr("is not a statement of the quantity")))
        << comment;
  for (const char* comment :
       {"scale: 1", "units: deg, 1/sr", "humidity: 45 %", "noise: 2 percent of the values",
        "values with 1 % noise", "reference: Spectralon 99 % reflectance", "instrument: A"})
    EXPECT_EQ(notes_of(comment), "") << comment;
  EXPECT_EQ(notes_of("values in percent\n# quantity: f_r"), "");
  EXPECT_THAT(notes_of("values in percent", "BRF (%)"), Not(HasSubstr("not applied")));
}

TEST(Quantities, RowsThatSummariseOthersAreNoted) {
  const std::string angles = "theta_i,phi_i,theta_o,phi_o,fr,kind\n";
  EXPECT_THAT(all_notes(read(angles + "60,0,45,170,.5,single\n60,0,46,170,.5,Mean\n")),
              HasSubstr("1 row with a word such as 'mean' or 'total' counts as measured"));
  EXPECT_THAT(all_notes(read(angles + "60,0,45,170,.5,TOTAL:\n60,0,46,170,.5,a\n60,0,47,170,.5,avg\n")),
              HasSubstr("2 rows with a word such as"));
  // A table of which every row is a mean has no row that summarises others.
  EXPECT_THAT(all_notes(read(angles + "60,0,45,170,.5,mean\n60,0,46,170,.5,mean\n")),
              Not(HasSubstr("a word such as")));
}

TEST(Quantities, ATitleThatIsAFormulaIsRefused) {
  EXPECT_THAT(message("BRDF/1000\nsrc_z src_a view_z view_a 450nm\n60 0 45 180 1\n"),
              HasSubstr("the title 'BRDF/1000' has the operator '/'"));
}

TEST(Quantities, OfASetOfColumnsAreToldTogether) {
  const std::string angles = "Incidence,View angle,Relative azimuth,";
  EXPECT_THAT(message(angles + "X,Y,Z\n1,2,3,4,5,6\n"),
              HasSubstr("column 'X' is, with X, Y and Z, a tristimulus value"));
  const SampleTable stated = read("# quantity: f_r\n" + angles + "X,Y,Z\n1,2,3,4,5,6\n");
  EXPECT_THAT(stated.channels, ElementsAre("X", "Y", "Z"));
  // A column of another quantity next to a column of f_r is not one of the channels.
  const SampleTable beside = read(angles + "counts,BRDF (1/sr),BTDF (1/sr),R (dB)\n1,2,3,4,5,6,7\n");
  EXPECT_THAT(beside.channels, ElementsAre("BRDF"));
  EXPECT_THAT(beside.warnings,
              Contains("columns 'counts', 'BTDF (1/sr)', 'R (dB)' are ignored: not values of f_r"));
  const SampleTable bands = read(angles + "BRF_450nm,BRF_550nm,sigma_BRF_550nm\n10,20,30,1,2,.3\n");
  EXPECT_THAT(bands.channels, ElementsAre("450nm", "550nm"));
  EXPECT_DOUBLE_EQ(bands.sigma[1][0], .3 / kPi);
  EXPECT_THAT(
      bands.warnings,
      Contains("each of the columns 'BRF_450nm', 'BRF_550nm' is a reflectance factor: divided by pi"));
}

TEST(Quantities, OfNeutralNamesAreFrWithALineInAForeignHeader) {
  for (const char* name : {"r", "550nm", "value", "red", "sample A", "f", "data"}) {
    EXPECT_TRUE(read(plain(name, 1)).warnings.empty()) << name;
    EXPECT_THAT(read(foreign(name, 1)).warnings,
                Contains("column " + shown(name) +
                         " is interpreted as f_r in 1/sr, because its name gives no quantity"));
  }
  EXPECT_THAT(read("Incidence,View angle,r,g,b\n10,20,1,2,3\n").warnings,
              Contains("each of the columns 'r', 'g', 'b' is interpreted as f_r in 1/sr, because its name "
                       "gives no quantity"));
}

// Standard deviations are converted by the same factor as their values.
TEST(Quantities, StandardDeviationsTakeTheSameFactor) {
  struct Deviation {
    const char *name, *sigma_name;
    double value, sigma, expected;
  };
  for (const Deviation& d : std::initializer_list<Deviation>{
           {"BRF", "sigma_BRF", kBrf, .01 * kBrf, .01 * kTruth},
           {"BRF (%)", "std", 100 * kBrf, kBrf, .01 * kTruth},
           {"ARS (1/sr)", "ARS std", kArs, .02 * kArs, .02 * kTruth},
           {"log10 BRDF", "sigma_log10 BRDF", std::log10(kTruth), .01, .01 * std::log(10) * kTruth},
           {"ln(f_r)", "uncertainty", std::log(kTruth), .01, .01 * kTruth},
           {"BRDF (dB)", "standard deviation", 10 * std::log10(kTruth), .1, .01 * std::log(10) * kTruth}}) {
    const SampleTable t =
        read("Incidence,View angle,Relative azimuth," + std::string(d.name) + "," + d.sigma_name +
             "\n60,45,170," + to_text(d.value) + "," + to_text(d.sigma) + "\n");
    ASSERT_TRUE(t.has_sigma(0)) << d.name;
    EXPECT_NEAR(t.sigma[0][0], d.expected, 1e-12) << d.name;
  }
  // A standard deviation under another name belongs to the only channel. With several channels its channel
  // is unknown, and the column is ignored.
  EXPECT_TRUE(read("Incidence,View angle,fr,u(BRDF)\n60,45,1,2\n").has_sigma(0));
  EXPECT_THAT(all_notes(read("Incidence,View angle,r,g,std dev\n60,45,1,2,3\n")),
              HasSubstr("'std dev' is ignored"));
  EXPECT_TRUE(read("Incidence,View angle,fr,uncertainty (k=1)\n60,45,1,2\n").has_sigma(0));
  EXPECT_THAT(message("Incidence,View angle,fr,sigma,std\n60,45,1,2,3\n"),
              HasSubstr("'sigma' and 'std' are both standard deviations of 'fr'"));
  EXPECT_THAT(
      message("Incidence,View angle,uncertainty\n60,45,1\n"),
      HasSubstr(
          "no value column in addition to the four angles; the other columns are not values: 'uncertainty'"));
  // A relative standard deviation is ignored, too.
  const SampleTable relative = read("Incidence,View angle,BRDF (1/sr),uncertainty (%)\n60,45,1,2\n");
  EXPECT_FALSE(relative.has_sigma(0));
  EXPECT_THAT(all_notes(relative), HasSubstr("'uncertainty (%)' is ignored"));
}

TEST(Quantities, ExpandedUncertaintiesAreDividedByTheirFactor) {
  const std::string angles = "Incidence,View angle,BRDF (1/sr),", row = "\n60,45,1,.4\n";
  for (const char* name :
       {"Expanded uncertainty (k=2)", "uncertainty (k = 2)", "U (k=2)", "BRDF unc. k=2.0"}) {
    const SampleTable t = read(angles + name + row);
    ASSERT_TRUE(t.has_sigma(0)) << name;
    EXPECT_DOUBLE_EQ(t.sigma[0][0], .2) << name;
    EXPECT_THAT(all_notes(t), HasSubstr("is an expanded uncertainty: divided by 2"));
  }
  const SampleTable one = read(angles + "uncertainty (k=1)" + row);
  EXPECT_DOUBLE_EQ(one.sigma[0][0], .4);
  EXPECT_THAT(all_notes(one), Not(HasSubstr("expanded")));
  // These do not give a standard deviation in 1/sr, and are never channels.
  const std::pair<const char*, const char*> ignored[] = {
      {"relative uncertainty", "is ignored: a relative uncertainty is read with a layout"},
      {"rel. unc", "is ignored: a relative uncertainty"},
      {"expanded uncertainty", "is ignored: an expanded uncertainty without its factor k"}};
  for (const auto& [name, note] : ignored) {
    const SampleTable t = read(angles + name + row);
    EXPECT_EQ(t.channels.size(), 1u) << name;
    EXPECT_FALSE(t.has_sigma(0)) << name;
    EXPECT_THAT(all_notes(t), HasSubstr(note));
  }
}

TEST(Quantities, AFactorOfPiMakesAReflectanceFactor) {
  const std::string angles = "theta_i,phi_i,theta_o,phi_o,", row = "\n30,180,40,0,.6\n";
  for (const char* name : {"pi*BRDF", "BRDF * pi", "pi BRDF", "π·BRDF", "pi f_r"}) {
    const SampleTable t = read(angles + name + row);
    EXPECT_NEAR(t.values[0][0], .6 / 3.14159265358979, 1e-12) << name;
    EXPECT_THAT(all_notes(t), HasSubstr("is a reflectance factor: divided by pi"));
  }
  EXPECT_THAT(message(angles + "BRDF/pi" + row), HasSubstr("has a factor of pi"));
  EXPECT_DOUBLE_EQ(read(angles + "BRDF" + row).values[0][0], .6);
}

TEST(Quantities, WithoutAnglesAreNamedIfTheyAreNotFr) {
  EXPECT_THAT(message("theta_i,theta_t,BTDF\n30,20,.5\n"),
              AllOf(HasSubstr("'theta_o' is missing"), HasSubstr("column 'BTDF' is of transmitted light")));
  EXPECT_THAT(message("theta_i,DHR,fr\n30,20,.5\n"),
              HasSubstr("column 'DHR' is a reflectance of a whole hemisphere"));
  EXPECT_THAT(message("theta_i,fr\n30,.5\n"), HasSubstr("no column has the viewing angle"));
}

TEST(Quantities, ColourCoordinatesAreRefusedWithoutAsterisks) {
  const std::string angles = "theta_i,phi_i,theta_o,phi_o,", row = "\n30,180,40,0,52,3,7\n";
  EXPECT_THAT(message(angles + "L,a,b" + row),
              HasSubstr("'L' is, with L, a and b, a colour coordinate (CIELAB)"));
  EXPECT_THAT(message(angles + "L,C,h" + row), HasSubstr("'L' is, with L, C and h, a colour coordinate"));
  EXPECT_EQ(read("# quantity: f_r\n" + angles + "L,a,b" + row).channels.size(), 3u);
  EXPECT_EQ(read(angles + "a,b,c" + row).channels.size(), 3u);
}

TEST(Quantities, NumbersForMissingMeasurementsAreRefused) {
  const std::string angles = "theta_i,phi_i,theta_o,phi_o,";
  for (const char* fill : {"-999", "-9999.0", "-99999", "-32768", "9.96921e36", "-3.40282347e38"})
    EXPECT_THAT(
        message(angles + "fr\n30,180,40,0,.5\n30,180,50,0," + fill + "\n"),
        AllOf(HasSubstr("file, line 3: "), HasSubstr("(fr) usually means 'not measured': omit such rows")))
        << fill;
  // The number counts as the file states it, not after its conversion.
  EXPECT_THAT(message(angles + "BRF\n30,180,40,0,-999\n"), HasSubstr("line 2: -999 (fr)"));
  EXPECT_THAT(message("VARS theta_i,phi_i,theta_s,phi_s,Y\n30,180,40,0,-999\n"), HasSubstr("'not measured'"));
  EXPECT_EQ(read(angles + "fr\n30,180,40,0,-998\n30,180,50,0,-0.1\n").rows(), 2u) << "noise may be negative";
}

// One small file of each format that states f_r, with a place for a number.
TEST(Quantities, NumbersForMissingMeasurementsAreRefusedInEveryFormat) {
  const std::string bird =
      R"({"data": {"theta_i": {"unit": "deg", "values": [30]}, "phi_i": {"unit": "deg", "values": [180]},
      "theta_r": {"unit": "deg", "values": [60]}, "phi_r": {"unit": "deg", "values": [0]},
      "BRDF": {"unit": "1/sr", "values": [@]}}})";
  const std::pair<const char*, std::string> files[] = {
      {"bird", bird},
      {"openmaterial", R"({"brdf": {"lookupTable": [[9.05e-07, 0.523599, 0.523599, 3.141593, @]]}})"},
      {"zemax", replaced(kLens, "1 2", "1 @")},
      {"fred", "type bsdf_data\nformat angles=deg bsdf=value scale=2\n20 0\n20 0 @\n"},
      {"alta",
       "#DIM 3 1\n#PARAM_IN ISOTROPIC_TV_TL_DPHI\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n.3 .4 0 @\n"},
      {"cornell", "1\n500\n.5 0 .5 3.14 .2\n.5 0 .6 3.14 @\n"},
      {"speos",
       "OPTIS - brdf surface file v8.0\n0\nx\n0\n\n1 0\n1\n1 1\n20\n550\n50\n2 2\n0 180\n0 .1 .1\n80 .1 @\n"},
      {"aspecular", "geometry,500nm\n45as15,.4\n45as25,@\n"}};
  for (const auto& [format, text] : files) {
    EXPECT_EQ(read(replaced(text, "@", "0.25")).format, format) << text;
    for (const char* fill : {"-999", "9.96921e36"})
      EXPECT_THAT(message(replaced(text, "@", fill)), HasSubstr("usually means 'not measured'"))
          << format << text;
  }
  EXPECT_THAT(
      message("theta_o \\ theta_i,30,60\n-30,.1,-999\n30,.6,.2\n"),
      HasSubstr(
          "line 2: column 3 (): '-999' usually means 'not measured': leave such cells of a matrix empty"));
}

TEST(StatedQuantity, CountsInAnySpelling) {
  const std::string rows = "theta_i,phi_i,theta_o,phi_o,fr\n0,0,60,0,1\n";
  for (const char* line :
       {"# quantity: f_r*cos_o", "# Quantity: f_r*cos_o", "# QUANTITY : f_r * cos_o", "#quantity=f_r*cos_o",
        "## quantity: ARS", "# quantity f_r*cos_o", "# # Quantity = f_r cos(theta_o)"})
    EXPECT_NEAR(read(line + ("\n" + rows)).values[0][0], 2, 1e-12) << line;
  for (const char* words : {"f_r", "BRDF", "BRDF [1/sr]", "bsdf values", "radiance coefficient"})
    EXPECT_EQ(read("# quantity: " + std::string(words) + "\n" + rows).values[0][0], 1) << words;
  for (const char* words : {"BRF", "reflectance factor", "Reflectance factor R", "HDRF"})
    EXPECT_DOUBLE_EQ(read("# quantity: " + std::string(words) + "\n" + rows).values[0][0], 1 / kPi) << words;
  for (const char* words : {"1/BRDF", "-fr", "BRDF^2", "BRDF/1000", "sqrt(BRDF)", "BRDF*cos^2"})
    EXPECT_THAT(message("# quantity: " + std::string(words) + "\n" + rows), HasSubstr("is unknown")) << words;
  for (const char* words : {"BRF %", "percent BRF", "reflectance factor (%)", "BRF in percent"})
    EXPECT_DOUBLE_EQ(read("# quantity: " + std::string(words) + "\n" + rows).values[0][0], .01 / kPi)
        << words;
  EXPECT_DOUBLE_EQ(read("# quantity: log10 BRDF\n" + rows).values[0][0], 10);
  EXPECT_DOUBLE_EQ(read("# quantity: r\n" + rows).values[0][0], 1e-4);
}

TEST(StatedQuantity, ThatContradictsAnotherIsRefusedWithBothLines) {
  const std::string rows = "theta_i,phi_i,theta_o,phi_o,fr\n0,0,60,0,1\n";
  EXPECT_EQ(message("# quantity: f_r\n# note: x\n# Quantity = f_r*cos_o\n" + rows),
            "file, line 3: quantity 'f_r*cos_o' contradicts line 1, 'f_r'");
  EXPECT_EQ(message("# quantity: f_r*cos_o\n# quantity: f_r\n" + rows),
            "file, line 2: quantity 'f_r' contradicts line 1, 'f_r*cos_o'");
  EXPECT_EQ(message("# quantity: BRDF\n# quantity: f_r\n" + rows), "accepted");
  EXPECT_THAT(message("# quantity: transmittance\n" + rows),
              HasSubstr("quantity 'transmittance' is of transmitted light"));
}

TEST(StatedQuantity, InACommentOutranksNames) {
  const std::string brf = "Incidence,View angle,BRF\n60,45,1\n";
  const SampleTable f_r = read("# quantity: f_r\n" + brf);
  EXPECT_EQ(f_r.values[0][0], 1);
  EXPECT_THAT(all_notes(f_r), HasSubstr("quantity 'f_r' (line 1) takes precedence over the name 'BRF'"));
  const SampleTable cos = read("# quantity: ARS\nIncidence,View angle,BRDF (1/sr)\n60,45,1\n");
  EXPECT_DOUBLE_EQ(cos.values[0][0], 1 / kCosViewer);
  EXPECT_THAT(all_notes(cos), HasSubstr("takes precedence over the name 'BRDF (1/sr)'"));
  // A scale that only the name states is applied nevertheless.
  EXPECT_DOUBLE_EQ(read("# quantity: BRF\nIncidence,View angle,Reflectance (%)\n60,45,100\n").values[0][0],
                   1 / kPi);
  EXPECT_DOUBLE_EQ(read("# quantity: BRDF\nIncidence,View angle,log10\n60,45,2\n").values[0][0], 100);
}

TEST(StatedQuantity, ByTheCallerFillsWhatTheFileDoesNotSay) {
  const auto with = [](const std::string& text, const std::string& quantity) {
    return read_samples(Content{"file", text}, {quantity, MirrorSide::automatic});
  };
  const std::string neutral = "theta_i,phi_i,theta_o,phi_o,550nm\n60,0,45,180,1\n";
  EXPECT_DOUBLE_EQ(with(neutral, "BRF").values[0][0], 1 / kPi);
  EXPECT_DOUBLE_EQ(with(replaced(neutral, "550nm", "fr"), "BRF").values[0][0], 1 / kPi);
  EXPECT_DOUBLE_EQ(with(replaced(neutral, "550nm", "Reflectance (%)"), "BRF").values[0][0], .01 / kPi);
  EXPECT_DOUBLE_EQ(with(replaced(neutral, "550nm", "scatter [ppm/sr]"), "f_r*cos_o").values[0][0],
                   1e-6 / kCosViewer);
  EXPECT_DOUBLE_EQ(with(replaced(neutral, "550nm", "550nm (‰)"), "BRF").values[0][0], 1e-3 / kPi);
  EXPECT_DOUBLE_EQ(with(replaced(neutral, "550nm", "BRF"), "reflectance factor").values[0][0], 1 / kPi);
  EXPECT_DOUBLE_EQ(with("# quantity: BRF\n" + neutral, "BRF").values[0][0], 1 / kPi);
  EXPECT_DOUBLE_EQ(with(kAstm, "BRF").values[0][0], 1 / kPi);
  const auto refusal = [&](const std::string& text, const std::string& quantity) {
    return message_of([&] { with(text, quantity); });
  };
  EXPECT_EQ(refusal("# quantity: f_r\n" + neutral, "BRF"),
            "file, line 1: quantity 'f_r' contradicts --quantity 'BRF'");
  EXPECT_EQ(refusal(replaced(neutral, "550nm", "BRF"), "f_r"),
            "file, line 1: column 'BRF' is a reflectance factor, but --quantity gives 'f_r': if the name is "
            "wrong, write "
            "'# quantity: f_r' above the header row");
  EXPECT_THAT(refusal(replaced(neutral, "550nm", "550nm (‰)"), "BRF %"),
              HasSubstr("but --quantity gives 'BRF %'"));
  EXPECT_THAT(refusal(replaced(neutral, "550nm", "BTDF"), "f_r"), HasSubstr("but --quantity gives 'f_r'"));
  EXPECT_EQ(refusal(kLens, "BRF"), "file: --quantity BRF: values of this format are f_r");
  EXPECT_EQ(refusal(neutral, "BTDF"),
            "--quantity 'BTDF' is of transmitted light, not f_r: only reflected light is read: export the "
            "reflection");
  EXPECT_THAT(refusal(neutral, "what"),
              HasSubstr("--quantity 'what' is unknown (known: f_r, BRF, f_r*cos_o, "));
}

// Channel names of our own tables are kept, whatever they are. A table that was written in any format is
// read back unchanged.
TEST(StatedQuantity, OfOurOwnTablesKeepsEveryName) {
  const SampleTable table = read(
      "# quantity: f_r\ntheta_i,phi_i,theta_o,phi_o,BRF,reflectance (%),temperature "
      "(°C),x,sigma_BRF\n1,2,3,4,5,6,7,8,9\n");
  EXPECT_THAT(table.channels, ElementsAre("BRF", "reflectance (%)", "temperature (°C)", "x"));
  EXPECT_EQ(table.values[0][0], 5);
  EXPECT_THAT(all_notes(table),
              HasSubstr("takes precedence over the names 'BRF', 'reflectance (%)', 'temperature (°C)'"));
  expect_same(read(written(table)), table);
  // A standard deviation belongs to the channel with exactly that name.
  const SampleTable alike =
      read("SZA,VZA,RAA,ln BRDF red (1/sr),BRF green (%),f_r cos_o,sigma_BRF green\n20,50,0,0,30,.1,3\n");
  EXPECT_THAT(alike.channels, ElementsAre("red", "green", "fr"));
  ASSERT_TRUE(alike.has_sigma(1));
  expect_same(read(written(alike)), alike);
}

TEST(StatedQuantity, MayBeInATitle) {
  const std::string rows = "src_z src_a view_z view_a 450nm\n60 0 45 180 1\n";
  const SampleTable titled = read("BRF Values\nTile 7, polished\nOperator: N. N.\n" + rows);
  EXPECT_DOUBLE_EQ(titled.values[0][0], 1 / kPi);
  EXPECT_THAT(all_notes(titled), AllOf(HasSubstr("column '450nm' is a reflectance factor: divided by pi"),
                                       HasSubstr("3 lines above the header row interpreted as titles")));
  EXPECT_EQ(titled.find_metadata("Operator"), "N. N.");
  EXPECT_EQ(read("A table of BRDF values\n" + rows).values[0][0], 1);
  EXPECT_DOUBLE_EQ(read("Instrument 5\nMeasured reflectance factors (%)\n" + rows).values[0][0], .01 / kPi);
  EXPECT_THAT(message("BTDF\n" + rows), HasSubstr("line 1: the title 'BTDF' is of transmitted light"));
  EXPECT_THAT(message("Reflectance of paint\n" + rows),
              HasSubstr("the title 'Reflectance of paint' is a reflectance"));
  EXPECT_EQ(read("Reflectance of paint\n" + replaced(rows, "450nm", "BRDF")).values[0][0], 1);
  EXPECT_EQ(read("Measured with a laser of high intensity\n" + rows).values[0][0], 1);
  EXPECT_THAT(message("# quantity: f_r\nBRF values\n" + rows),
              HasSubstr("line 2: the title 'BRF values' contradicts line 1, 'f_r'"));
  EXPECT_THAT(message("BRF values\n" + replaced(rows, "450nm", "ARS")),
              HasSubstr("but the title in line 1 gives 'BRF values'"));
  EXPECT_EQ(read("quantity: f_r\n" + rows).values[0][0], 1);
}

// A free-text comment does not state a quantity. If it mentions another quantity, a warning reports it.
TEST(StatedQuantity, OfFreeTextIsAHint) {
  const std::string rows = "theta_i,phi_i,theta_o,phi_o,450nm\n60,0,45,180,1\n";
  const SampleTable t = read("# BRF values\n" + rows);
  EXPECT_EQ(t.values[0][0], 1);
  EXPECT_THAT(t.warnings,
              ElementsAre("the comment in line 1 names a reflectance factor, but is not a statement of the "
                          "quantity: if the values are not f_r, write '# quantity: ...'"));
  EXPECT_TRUE(read("# BRF values\n# quantity: f_r\n" + rows).warnings.empty());
  EXPECT_TRUE(read("# BRDF values\n# sample: BRF tile\n" + rows).warnings.empty());
}

TEST(Quantities, OfAstmAndOpenExrColumnsAreReadAlike) {
  const SampleTable astm = read("VARS theta_i,phi_i,theta_s,phi_s,BRF\n30,180,60,5,1\n");
  EXPECT_DOUBLE_EQ(astm.values[0][0], 1 / kPi);
  EXPECT_THAT(all_notes(astm), HasSubstr("column 'BRF' is a reflectance factor"));
  EXPECT_THAT(message("VARS theta_i,phi_i,theta_s,phi_s,BTDF\n30,180,60,5,1\n"),
              HasSubstr("of transmitted light"));
  EXPECT_EQ(read("QUANTITY f_r\nVARS theta_i,phi_i,theta_s,phi_s,BRF\n30,180,60,5,1\n").values[0][0], 1);
}

// Returns the row of a kind in the documentation's table.
std::string documented(const QuantityKind& kind) {
  std::string words(kind.words);
  if (!kind.forms.empty()) (words += words.empty() ? "" : "; ") += kind.forms;
  for (std::size_t at = 0; (at = words.find("; ", at)) != words.npos;) words.replace(at, 2, ", ");
  const std::string use = kind.use == QuantityKind::Use::converted ? Quantity{&kind}.operation()
                          : kind.use == QuantityKind::Use::asked   ? "ambiguous: " + std::string(kind.advice)
                                                                   : "refused: " + std::string(kind.advice);
  return "| " + words + " | " + use + " |\n";
}

// The table in the documentation must equal the table in the code.
TEST(Quantities, OfTheDocumentationAreThese) {
  const std::string document = read_content(BRDF_SOURCE_DIR "/docs/formats.md").bytes;
  for (const QuantityKind& kind : quantity_kinds())
    EXPECT_NE(document.find(documented(kind)), std::string::npos) << "docs/formats.md lacks the row\n"
                                                                  << documented(kind);
}

}  // namespace
}  // namespace brdf::io
