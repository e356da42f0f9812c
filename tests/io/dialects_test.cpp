// Tables as laboratories write them: the same samples in 32 dialects must read to the same table, bit for
// bit. Other dialects are refused with a message that names the text found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/samples/samples.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string utf16(std::string_view ascii, bool is_big) {
  std::string bytes = is_big ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) is_big ? (bytes += '\0') += c : (bytes += c) += '\0';
  return bytes;
}

// Two rows of one channel.
constexpr const char* kPlain = "theta_i,phi_i,theta_o,phi_o,fr\n30,0,40.5,180,1.25\n60,0,20,170,0.5\n";

struct DialectFile {
  const char* name;
  std::string text;
  const char* note;  // part of the announcement; empty: no announcement
};

std::ostream& operator<<(std::ostream& out, const DialectFile& d) {
  return out << d.name;
}

class SameTable : public testing::TestWithParam<DialectFile> {};

TEST_P(SameTable, BitForBit) {
  const SampleTable got = read(GetParam().text);
  SampleTable expected = read(kPlain);
  expected.metadata = got.metadata;  // the comments of the spreadsheet itself
  expect_same(got, expected);
  std::string notes;
  for (const std::string& warning : got.warnings) notes += warning + '\n';
  EXPECT_EQ(notes.empty(), *GetParam().note == '\0') << notes;
  EXPECT_THAT(notes, HasSubstr(GetParam().note));
}

const DialectFile kDialects[] = {
    {"semicolons", "theta_i;phi_i;theta_o;phi_o;fr\n30;0;40.5;180;1.25\n60;0;20;170;0.5\n",
     "separated by ';'"},
    {"decimal_commas", "theta_i;phi_i;theta_o;phi_o;fr\n30;0;40,5;180;1,25\n60;0;20;170;0,5\n",
     "separated by ';', decimal commas"},
    {"tabs", "theta_i\tphi_i\ttheta_o\tphi_o\tfr\n30\t0\t40.5\t180\t1.25\n60\t0\t20\t170\t.5\n",
     "separated by a tab"},
    {"tabs_decimal_commas",
     "theta_i\tphi_i\ttheta_o\tphi_o\tfr\n30\t0\t40,5\t180\t1,25\n60\t0\t20\t170\t0,5\n", "decimal commas"},
    {"blanks", "  theta_i  phi_i theta_o   phi_o fr\n  30   0 40.5 180 1.25\n 60 0  20 170  0.5\n",
     "separated by blanks"},
    {"blanks_and_tabs", "theta_i \tphi_i theta_o phi_o fr\n30 0\t40.5 180 1.25\n60 0 20 170 5e-1\n",
     "blanks"},
    {"quoted_names",
     "\"theta_i\",\"phi_i\",\"theta_o\",\"phi_o\",\"fr\"\n30,0,40.5,180,1.25\n60,0,20,170,0.5\n", ""},
    {"quoted_fields",
     "theta_i,phi_i,theta_o,phi_o,fr\n\"30\",\"0\",\"40.5\",180,\"1.25\"\n60,0,20,170,\"0.5\"\n", ""},
    {"quoted_decimal_commas",
     "theta_i,phi_i,theta_o,phi_o,fr\n30,0,\"40,5\",180,\"1,25\"\n60,0,20,170,\"0,5\"\n", "decimal commas"},
    {"utf16_little_endian", utf16(kPlain, false), "UTF-16"},
    {"utf16_big_endian", utf16(kPlain, true), "UTF-16"},
    {"quoted_between_tabs",
     "\"theta_i\"\t\"phi_i\"\t\"theta_o\"\t\"phi_o\" \t \"fr\"\n30\t0 \t\"40.5\" \t180\t1.25\n"
     "60\t0\t20\t170\t\"0.5\"\n",
     "a tab"},
    {"sep_line", "sep=;\r\ntheta_i;phi_i;theta_o;phi_o;fr\r\n30;0;40,5;180;1,25\r\n60;0;20;170;0,5\r\n",
     "';'"},
    {"sep_line_of_bars", "sep=|\ntheta_i|phi_i|theta_o|phi_o|fr\n30|0|40.5|180|1.25\n60|0|20|170|0.5\n",
     "'|'"},
    {"units_in_brackets",
     "theta_i (deg),phi_i [deg],theta_o (°),phi_o [degrees],fr (1/sr)\n30,0,40.5,180,1.25\n60,0,20,170,0.5\n",
     "'theta_i (deg)' theta_i"},
    {"units_behind",
     "theta_i_deg,phi_i/deg,theta_o deg,phi_o_degrees,fr [sr^-1]\n30,0,40.5,180,1.25\n60,0,20,170,0.5\n",
     "'fr [sr^-1]' fr"},
    {"radians",
     "theta_i (rad),phi_i (deg),theta_o (rad),phi_o (rad),fr\n0.5235987755982988,0,0.7068583470577035,"
     "3.141592653589793,1.25\n1.0471975511965976,0,0.3490658503988659,2.9670597283903604,0.5\n",
     "theta_o in radians"},
    {"units_between_blanks",
     "theta_i (deg) phi_i (deg) theta_o (deg) phi_o (deg) fr (1/sr)\n30 0 40.5 180 1.25\n"
     "60 0 20 170 0.5\n",
     "blanks"},
    {"aliases_without_underscores", "thetai,phii,thetar,phir,fr\n30,0,40.5,180,1.25\n60,0,20,170,0.5\n",
     "'thetar' theta_o"},
    {"aliases_in_words",
     "Angle of Incidence,Incident Azimuth,Viewing Angle,View "
     "Azimuth,fr\n30,0,40.5,180,1.25\n60,0,20,170,0.5\n",
     "'Angle of Incidence' theta_i"},
    {"greek", "θ_i;φ_i;θ_r;φ_r;fr\n30;0;40,5;180;1,25\n60;0;20;170;0,5\n", "'θ_r' theta_o"},
    {"scattered", "theta_i,phi_i,theta_s,phi_s,fr\n30,0,40.5,180,1.25\n60,0,20,170,0.5\n",
     "'theta_s' theta_o"},
    {"source", "theta_s,phi_s,theta_r,phi_r,fr\n30,0,40.5,180,1.25\n60,0,20,170,0.5\n", "'theta_s' theta_i"},
    {"one_azimuth", "incidence,theta_r,azimuth,fr\n30,40.5,180,1.25\n60,20,170,0.5\n",
     "only one azimuth, 'azimuth': interpreted as phi_o with phi_i 0"},
    {"elevation", "elevation_i,phi_i,elevation_o,phi_o,fr\n60,0,49.5,180,1.25\n30,0,70,170,0.5\n",
     "90 - elevation"},
    {"empty_last_column", "theta_i;phi_i;theta_o;phi_o;fr;\n30;0;40,5;180;1,25;\n60;0;20;170;0,5;\n", "';'"},
    {"lines_end_in_cr", "theta_i,phi_i,theta_o,phi_o,fr\r30,0,40.5,180,1.25\r60,0,20,170,0.5\r", "CR only"},
    {"units_in_a_second_row",
     "theta_i;phi_i;theta_o;phi_o;fr\n[rad];deg;[deg];;(1/sr)\n0,5235987755982988;0;40,5;180;1,25\n"
     "1,0471975511965976;0;20;170;0,5\n",
     "'theta_i [rad]' theta_i in radians"},
    {"header_in_the_last_comment",
     "# made by hand\n# theta_i phi_i theta_o phi_o fr\n30 0 40.5 180 1.25\n60 0 20 170 .5\n",
     "the header row is the comment above the numbers"},
    {"utf16_without_its_mark", utf16(kPlain, false).substr(2), "UTF-16"},
    {"utf16_big_endian_without_its_mark", utf16(kPlain, true).substr(2), "UTF-16"},
    {"a_sheet_of_everything",
     "\xFF\xFE" +
         utf16(
             "sep=;\r\n# sample: x\r\n\"Theta incident (rad)\";\"Viewing angle [deg]\";\"Relative azimuth\";"
             "\"fr (1/sr)\"\r\n\"0,5235987755982988\";40,5;180;1,25\r\n\"1,0471975511965976\";20;170;0,5\r\n",
             false)
             .substr(2),
     "UTF-16"},
};

INSTANTIATE_TEST_SUITE_P(Dialects, SameTable, testing::ValuesIn(kDialects),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(LongFormat, IsTheWideTable) {
  const SampleTable wide = read(
      "theta_i,phi_i,theta_o,phi_o,465nm,525nm,630nm,sigma_465nm,sigma_525nm,sigma_630nm\n"
      "10,0,20,180,1,2,3,.1,.2,.3\n30,0,30,180,4,5,6,.4,.5,.6\n");
  const SampleTable got = read(
      "theta_i;phi_i;theta_o;phi_o;Wavelength (nm);BRDF;sigma\n10;0;20;180;630;3;,3\n10;0;20;180;465;1;,1\n"
      "30;0;30;180;465;4;,4\n10;0;20;180;525;2;,2\n30;0;30;180;525;5;,5\n30;0;30;180;630;6;,6\n");
  expect_same(got, wide);
  EXPECT_THAT(got.lines, ElementsAre(2u, 4u));
  EXPECT_THAT(got.warnings.back(), HasSubstr("long format: 6 rows of 3 wavelengths, 465 to 630 nm"));
}

// Every pair has a wavelength of its own. The reader must not allocate memory for pairs times wavelengths.
TEST(LongFormat, OfPairsThatShareNoWavelengthIsRefused) {
  std::string text = "theta_i,phi_i,theta_o,phi_o,wavelength,fr\n";
  for (int k = 0; k < 4000; ++k)
    text += "1,2,3," + std::to_string(k) + "," + std::to_string(400 + k) + ",1\n";
  EXPECT_THAT(message(text), HasSubstr("line 2: these directions have no value at 401 nm"));
}

// Text in quotes is stored in separate memory. A former version joined such a name with its unit by the
// distance between the two in memory.
TEST(Quotes, BeforeAUnitBetweenBlanks) {
  const SampleTable got = read("\"theta_i\" (deg) \"phi_i\" theta_o (deg) phi_o \"a b\" (1/sr)\n1 2 3 4 5\n");
  EXPECT_THAT(got.channels, ElementsAre("a b"));
  EXPECT_EQ(got.theta_i[0], 1);
}

TEST(Bands, MayBeNamedByTheirNumbers) {
  const SampleTable got = read("theta_i,phi_i,theta_o,phi_o,400,410.5,sigma_400\n1,2,3,4,.5,.6,.1\n");
  EXPECT_THAT(got.channels, ElementsAre("400nm", "410.5nm"));
  EXPECT_EQ(got.sigma[0], std::vector<double>{.1});
  const SampleTable astm = read("VARS theta_i,phi_i,theta_s,phi_s,400,410\n30,180,60,5,1,2\n");
  EXPECT_THAT(astm.channels, ElementsAre("400nm", "410nm"));
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o,5\n1,2,3,4,5\n"),
              HasSubstr("is the number '5', not a name"));
}

TEST(LongFormat, WavelengthsMayBeInMicrometres) {
  const SampleTable got =
      read("theta_i,phi_i,theta_o,phi_o,lambda (um),fr\n1,2,3,4,0.6328,1\n1,2,3,4,1.064,2\n");
  EXPECT_THAT(got.channels, ElementsAre("632.8nm", "1064nm"));
}

TEST(LongFormat, MeasuredAgainKeepsEveryRow) {
  const SampleTable got = read(
      "theta_i,phi_i,theta_o,phi_o,wavelength,fr\n1,2,3,4,500,1\n1,2,3,4,600,2\n5,6,7,8,600,3\n5,6,7,8,500,"
      "4\n"
      "1,2,3,4,600,5\n1,2,3,4,500,6\n");
  expect_same(got, read("theta_i,phi_i,theta_o,phi_o,500nm,600nm\n1,2,3,4,1,2\n1,2,3,4,6,5\n5,6,7,8,4,3\n"));
  EXPECT_THAT(got.lines, ElementsAre(2u, 7u, 4u));
}

TEST(LongFormat, HasAChannelForEachPolarisation) {
  const SampleTable got = read(
      "theta_i,phi_i,theta_o,phi_o,Polarization,fr\n1,2,3,4,p,1\n1,2,3,4,S-pol,2\n5,6,7,8,te,3\n5,6,7,8,TM,"
      "4\n");
  expect_same(got, read("theta_i,phi_i,theta_o,phi_o,fr_s,fr_p\n1,2,3,4,2,1\n5,6,7,8,3,4\n"));
  EXPECT_THAT(got.warnings.back(), HasSubstr("long format: 4 rows of 2 bands, s to p"));
  const SampleTable both = read(
      "theta_i,phi_i,theta_o,phi_o,wavelength,polarisation,fr\n1,2,3,4,500,s,1\n1,2,3,4,500,p,2\n1,2,3,4,600,"
      "s,3\n"
      "1,2,3,4,600,p,4\n");
  EXPECT_THAT(both.channels, ElementsAre("s_500nm", "p_500nm", "s_600nm", "p_600nm"));
  EXPECT_EQ(both.values[2][0], 3);
}

TEST(UnreadableDialect, IsRefusedWithWhatWasFoundAndWhere) {
  const std::string names = "theta_i;phi_i;theta_o;phi_o;fr\n",
                    wave = "theta_i,phi_i,theta_o,phi_o,wavelength,fr\n";
  const std::pair<std::string, const char*> cases[] = {
      {names + "30;0;40.5;180;1,25\n", "line 2: column 5 (fr): '1,25' has a different decimal mark"},
      {names + "30;0;40;180;1.234,5\n", "line 2: column 5 (fr): '1.234,5' is not a number"},
      {names + "30,0,40,180,1.25\n", "line 2: 1 columns, but the header has 5, separated by ';'"},
      {"theta_i,phi_i,theta_o,phi_o,fr\n30,0,40,5,180,1,25\n", "line 2: 7 columns, but the header has 5"},
      {"theta_i,phi_i,theta_o,phi_o,fr\n30,0,\"40,180,1\n",
       "line 2: a quotation mark is not closed in its line, or text follows it"},
      {"theta_i,phi_i,theta_o,phi_o,fr\n30,0,\"40\"5,180,1\n",
       "line 2: a quotation mark is not closed in its line, or text follows it"},
      {"\"theta_i,phi_i,theta_o,phi_o,fr\n30,0,40,180,1\n",
       "line 1: a quotation mark is not closed in its line, or text follows it"},
      {"theta_h,phi_h,theta_d,phi_d,fr\n1,2,3,4,5\n",
       "line 1: column 'theta_i' is missing (theta_i,phi_i,theta_o,phi_o,<channel>...); found, separated by "
       "',': "
       "'theta_h', 'phi_h', 'theta_d', 'phi_d', 'fr'"},
      {"theta_s,phi_s,fr\n1,2,3\n", "'theta_s' may belong to the incident or to the scattering direction"},
      {"theta_i,thetain,theta_o,phi_o,fr\n1,2,3,4,5\n", "columns 'theta_i' and 'thetain' are both theta_i"},
      {"theta_i,phi_i,azimuth,theta_o,fr\n1,2,3,4,5\n",
       "'azimuth' does not name the direction of its azimuth"},
      {"thetai,phii,thetao,phio,550nm (%)\n1,2,3,4,5\n", "'550nm (%)' is in percent, of a quantity"},
      {wave + "1,2,3,4,500,1\n1,2,3,4,500,2\n1,2,3,4,600,2\n",
       "line 4: rows of these directions at 600 nm: 1, at 500 nm: 2"},
      {"theta_i,phi_i,theta_o,phi_o,polarisation,fr\n1,2,3,4,x,1\n",
       "line 2: column 5 (polarisation): 'x' is not a polarisation"},
      {"theta_i,phi_i,theta_o,phi_o,polarisation,polarization,fr\n1,2,3,4,s,p,1\n",
       "two columns of polarisations"},
      {"theta_i,phi_i,theta_o,phi_o,lambda (um),fr\n1,2,3,4,1e304,1\n",
       "line 2: column 5 (lambda (um)): '1e304' is not finite"},
      {wave + "1,2,3,4,500,1\n1,2,3,4,600,2\n5,6,7,8,500,2\n",
       "line 4: these directions have no value at 600 nm"},
      {"theta_i,phi_i,theta_o,phi_o,wavelength,r,g\n",
       "a column of wavelengths needs one column of values, not 2"},
      {std::string("\xFF\xFEt\0h\0\0\xD8", 8), "begins like UTF-16 text, but is not valid UTF-16"},
      {std::string("th\0e\0i", 6), "line 1: contains a NUL byte"},
  };
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

// The message must contain a suggestion of readable text.
TEST(UnreadableDialect, IsRefusedWithWhatWouldBeRead) {
  const std::string names = "theta_i,phi_i,theta_o,phi_o,fr\n", bars = "theta_i;phi_i;theta_o;phi_o;fr\n";
  const std::pair<std::string, const char*> cases[] = {
      {names + "30,0,40,180,\n",
       "line 2: column 5 (fr): '' is not a number; omit the rows of directions that were not measured"},
      {names + "30,0,40,180,#NUM!\n", "'#NUM!' is not a number; omit the rows"},
      {names + "30,0,40,180,n/a\n", "'n/a' is not a number; omit the rows"},
      {names + "30,0,40,180,NaN\n", "'NaN' is not finite; omit the rows"},
      {names + "30,0,40,180,-inf\n", "'-inf' is not finite; omit the rows"},
      {names + "30,0,40,180,1e400\n", "'1e400' is not a number; the value exceeds the largest number"},
      {names + "30,0,40,180,1e-400\n",
       "'1e-400' is not a number; the value is below the smallest number above 0"},
      {names + "30,0,40,180,1.25D-01\n", "write the exponent with e"},
      {names + "30°,0,40,180,1\n", "'30°' is not a number; write the unit in the column's name"},
      {names + "30,0,40,180,25%\n", "'25%' is not a number; values are f_r in 1/sr, not percent"},
      {names + "30,0,\u221240,180,1\n", "use '-' as the minus sign"},
      {names + "30,0,40,180,1 # outlier\n", "write a comment as a separate line"},
      {bars + "30;0;40;180;1\u00a0250\n", "do not group thousands"},
      {bars + "30;0;40;180;1'250.5\n", "do not group thousands"},
      {bars + "30;0;40;180;1.250,5\n", "do not group thousands"},
      {bars + "30,0,40,180,1\n",
       "1 columns, but the header has 5, separated by ';'; this line is separated by ','"},
      {"My data on paper\nangle signal\n30 1\n", "lines above the header row begin with '#'"},
      {"30,0,40,180,1\n", "write one above the numbers: theta_i,phi_i,theta_o,phi_o"},
      {",theta_i,phi_i,theta_o,phi_o,fr\n0,1,2,3,4,5\n",
       "column 1 has no name; remove a column of row numbers"},
      {",0,30,60\n0,100,100,100\n",
       "column 1 has no name; in a matrix of two angles the first cell names both"},
      {"theta_i,phi_i,theta_o,phi_o,fr,fr\n1,2,3,4,5,6\n", "write repeat measurements as separate rows"},
      {"theta_i,phi_i,theta_o,phi_o,\"fr\n(1/sr)\"\n", "line 1: a quotation mark is not closed in its line"},
      {std::string("\xff\xfe\0\0t\0\0\0", 8), "is UTF-32 text: save it as UTF-8"},
      {std::string("\0\0\xfe\xff\0\0\0t", 8), "is UTF-32 text: save it as UTF-8"},
      {"PK\x03\x04 ...", "is a ZIP archive: unpack the archive"},
      {"\xd0\xcf\x11\xe0 ...", "is an Excel workbook (.xls): export the sheet as CSV"},
      {"\x1f\x8b ...", "is compressed: use `zcat FILE | brdf fit -`"},
      {"%PDF-1.4", "is a PDF"},
      {"<html>", "is a web page or XML"},
  };
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
  EXPECT_THAT(message("theta_i (mm),phi_i,theta_o,phi_o,fr\n1,2,3,4,5\n"),
              testing::Not(HasSubstr("lines above")));
}

TEST(Dialects, CommentsMayBeginWithOtherSigns) {
  const std::string rows = "30,180,40,0,.5\n30,180,50,0,.25\n", names = "theta_i,phi_i,theta_r,phi_r,BRDF\n";
  for (const char* sign : {"% ", "%", "// ", "! "}) {
    const std::string comment = sign + std::string("a goniometer\n");
    const SampleTable t = read(comment + sign + names + "30,180,40,0,.5\n" + comment + "30,180,50,0,.25\n");
    EXPECT_THAT(t.values[0], ElementsAre(.5, .25)) << sign;
    EXPECT_THAT(t.channels, ElementsAre("BRDF"));
    EXPECT_THAT(read(comment + names + rows).values[0], ElementsAre(.5, .25)) << sign;
  }
  EXPECT_THAT(message(names + "/30,180,40,0,.5\n"), HasSubstr("'/30' is not a number"))
      << "one slash is no sign";
}

TEST(Dialects, RowsMayEndInASeparator) {
  const std::string names = "theta_i;phi_i;theta_r;phi_r;BRDF\n";
  EXPECT_THAT(read(names + "30;180;40;0;.5;\n30;180;50;0;.25;\n").values[0], ElementsAre(.5, .25));
  EXPECT_THAT(message(names + "30;180;40;0;;\n"), HasSubstr("'' is not a number"));
  EXPECT_THAT(message(names + "30;180;40;0;.5;;\n"), HasSubstr("7 columns, but the header has 5"));
}

// A table that we write must be read back unchanged, whatever other formats call their channels.
TEST(PlainFormat, KeepsTheNamesOfItsChannels) {
  const SampleTable t =
      read("# quantity: f_r\ntheta_i,phi_i,theta_o,phi_o,azimuth,fr (1/sr),sigma,thetar\n1,2,3,4,5,6,7,8\n");
  EXPECT_THAT(t.channels, ElementsAre("azimuth", "fr (1/sr)", "sigma", "thetar"));
  EXPECT_TRUE(t.warnings.empty());
}

}  // namespace
}  // namespace brdf::io
