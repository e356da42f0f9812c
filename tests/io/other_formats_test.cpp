// Tests that files of other programs are recognised by their content and refused with advice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/columns/foreign_json.h"
#include "io/files/content.h"
#include "io/material/material_file.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

TEST(OtherFormats, AreNamedWithWhatToWriteInstead) {
  using namespace std::string_literals;
  const std::pair<std::string, const char*> cases[] = {
      {"OPTIS - brdf surface file v9.0\n1\n\0\1\2"s,
       "is a binary BRDF file of Speos ('OPTIS - brdf surface file v9.0'), which is not read: save it as "
       "text"},
      {"OPTIS - Simple scattering surface file v1.0\n0\n",
       "is a file of Speos ('OPTIS - Simple scattering surface file v1.0') other than"},
      {"<WindowElement><IncidentDataStructure>TensorTree4</IncidentDataStructure></WindowElement>",
       "is a BSDF of Radiance as a tensor tree, which is not read: export a matrix in a Klems basis"},
      {"<?xml version=\"1.0\"?>\n<!-- x -->\n<plist/>", "is XML (root element 'plist'), not a table"},
      {"<!DOCTYPE html>\n<html>", "is a web page or XML, not a table"},
      {"0.3 3.1 0.2 0.1 0.5\n0.3 3.1 1.2 0.1 0.5\n",
       "write one above the numbers: theta_i (rad) phi_i (rad) theta_o (rad) phi_o (rad) fr (guessed"},
      {"30,180,40,0,550,0.5\n30,180,40,0,650,0.5\n",
       "theta_i,phi_i,theta_o,phi_o,wavelength (nm),fr (guessed"},
      {"30,-40,0.5\n30,40,0.5\n", "write one above the numbers: theta_i,theta_o,fr (guessed"},
      {"30,40,180,0.5\n", "write one above the numbers: theta_i,theta_o,phi_o,fr (guessed"},
      {"VERSION 1.0\nDATA_TYPE BRDF\nCOLOR_MODEL RGB\n", "is SSDD text of libbsdf"},
      {"\x89HDF\r\n", "is an HDF5 file (AxF, NetCDF"},
      {"\x89HDF\r\n....com.xrite.Materials",
       "is an AxF file, which is not read: export the measured samples"},
      {"PK\x03\x04....[Content_Types].xml", "is a spreadsheet or another document of Office (.xlsx): export"},
      {"PK\x03\x04....mimetypeapplication/vnd.oasis.opendocument.spreadsheet",
       "is a spreadsheet (.ods): export the sheet as CSV"},
      {"\x09\x08\x10\0\0\6"s, "is an Excel workbook (.xls): export the sheet as CSV"},
      {"<?xml version=\"1.0\"?>\n<Workbook/>",
       "is a spreadsheet in XML ('Workbook'): export the sheet as CSV"},
      {"<?xml version=\"1.0\"?>\n<o:document xmlns:o=\"opendocument\"/>",
       "is a spreadsheet in XML ('document')"},
      {"\x93NUMPY\1\0"s, "is an array of NumPy"},
      {"PK\x03\x04....Index/Tables.iwa", "is a document of Apple Numbers or Pages: export the sheet as CSV"},
      {"PK\x03\x04....theta_i.npy", "is an archive of NumPy arrays (.npz)"},
      {"PK\x03\x04....zarr.json", "is a Zarr store: write the table as CSV"},
      {"PAR1\x15", "is a Parquet file: write the table as CSV"},
      {"ARROW1\0\0"s, "is an Arrow or Feather file"},
      {"CDF\1\0\0"s, "is a NetCDF file"},
      {"SQLite format 3\0"s, "is a database (SQLite)"},
      {"\x80\x04\x95\0"s, "is a pickle of Python"},
      {"BZh91AY", "is compressed: use `bzcat"},
      {"\xfd"
       "7zXZ\0"s,
       "is compressed: use `xzcat"},
      {"\x28\xb5\x2f\xfd", "is compressed: use `zstdcat"},
      {"7z\xbc\xaf\x27", "is an archive (7-Zip): unpack"},
      {"Rar!\x1a\7\0"s, "is an archive (RAR): unpack"},
      {"II*\0....."s, "is a picture (TIFF)"},
      {"GIF89a", "is a picture (GIF)"},
      {"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "is a picture of Radiance (.hdr, .pic)"},
      {"{\\rtf1 x}", "is a document (RTF)"},
      {"\0\0\0\x5a\0\0\0\x5a\0\0\0\xb4"s, "is a MERL file in big-endian byte order"},
      {"IESNA:LM-63-2002\n[TEST] 7\nTILT=NONE\n",
       "is a photometric file of IES (LM-63), which describes the light"},
      {"A firm\nA lamp\nTILT=NONE\n1 800 1 2 1\n", "is a photometric file of IES (LM-63)"},
      {"A firm\n1\n1\n1\n0\n3\n45\na\nb\nc\nd\ne\n300\n300\n90\n0\n0\n0\n0\n0\n0\n100\n80\n1\n0\n1\n1\nLED\n",
       "is a photometric file in EULUMDAT (.ldt), which describes the light of a luminaire"},
      {"2\n0 90 2\n0 180 3\n.1 .2 .3\n.4 .5 .6\n", "is a data file of Radiance (.dat), which is not read"},
      {"# gloss\n1\n0 90 3\n.1 .2 .3\n", "is a data file of Radiance (.dat)"},
      {"{ a gloss }\nf(x) = .3 * x;\n", "is a function file of Radiance (.cal)"},
      {"TracePro Surface Property Data\nName\tx\n", "is a surface property of TracePro, which is not read"},
      {"Symmetry Asymmetrical\nScatterAzimuth 1\n0\nScatterRadial 1\n0\nDataBegin\nAOI 10\nPOI 0\nSide "
       "Front\n",
       "is a BSDF of LightTools, which is not read"},
      {"<?xml version=\"1.0\"?>\n<c:CxF xmlns:c=\"x\"/>",
       "is CxF (XML of colour instruments), which is not read: export reflectance factors"},
      {R"([{"theta_i": 10, "theta_o": 20, "f": 1}])",
       "is JSON, but not a material: the content looks like a table of samples"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

// Texts that resemble those formats are not refused by their names.
TEST(OtherFormats, AreNotSeenInTables) {
  for (const char* text :
       {"1\n500\n.5 0 .5 3.14 .2\n", "1\n0 90 3\n.1 .2\n", "A firm\n1\n1\n1\n0\n3\n45\na\n"})
    EXPECT_THAT(message(text), testing::Not(AnyOf(HasSubstr("Radiance"), HasSubstr("EULUMDAT")))) << text;
  // Words of another program within a comment, as a note of the laboratory has them.
  for (const char* comment :
       {"converted from ##JCAMP-DX=4.24", "not TILT=NONE", "Side of ScatterRadial at AOI"})
    EXPECT_EQ(read_samples(Content{"t.csv", std::string("# ") + comment +
                                                "\ntheta_i,phi_i,theta_o,phi_o,f\n30,0,40,180,0.3\n"})
                  .theta_i.size(),
              1u)
        << comment;
  EXPECT_FALSE(may_be_material(Content{"f.cal", "{ a gloss }\nf(x) = .3 * x;\n"}));
  EXPECT_TRUE(may_be_material(Content{"m.json", R"({"form": "ward", "a": {}})"}));
}

std::string bytes_of(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

std::string with_side(std::string head, std::uint32_t side, bool is_png) {
  for (const std::uint32_t number :
       is_png ? std::vector{side, side} : std::vector{0u, 0u, side - 1, side - 1})
    for (int k = 0; k < 4; ++k) head += char(number >> (8 * (is_png ? 3 - k : k)));
  return head;
}

TEST(OtherFormats, UtiaIsRecognisedByItsSize) {
  using namespace std::string_literals;
  constexpr std::size_t kNumbers = 3 * 288 * 288;
  EXPECT_THAT(message(bytes_of(std::vector<double>(kNumbers, .25))),
              HasSubstr("has the size of a binary BRDF of UTIA (3 x 288 x 288 numbers), which is not read"));
  const std::string png = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s;
  EXPECT_THAT(message(with_side(png, 288, true)),
              HasSubstr("is a picture (PNG) of 288 x 288 pixels, the size "
                        "of a BRDF of UTIA"));
  const std::string exr = "\x76\x2f\x31\x01\2\0\0\0dataWindow\0box2i\0\x10\0\0\0"s;
  EXPECT_THAT(message(with_side(exr, 288, false)), HasSubstr("is a picture (OpenEXR) of 288 x 288 pixels"));
  // Other sizes, and numbers of another meaning, are not taken for such files.
  for (const std::string& other :
       {bytes_of(std::vector<double>(kNumbers - 1, .25)), bytes_of(std::vector<double>(kNumbers, 1e9)),
        bytes_of(std::vector<double>(kNumbers)), with_side(png, 287, true), with_side(exr, 289, false)})
    EXPECT_THAT(message(other), testing::Not(HasSubstr("UTIA")));
}

TEST(OtherFormats, AbgCoefficientsAreNamed) {
  for (const char* text : {"Name: black\nWave (um),AOI (deg),A,B,g,TIS\n0.6328,0,0.0123,0.00034,1.85,0.03\n",
                           "scatter model\nA = 0.0123\nB = 3.4e-4\ng = 1.85\n",
                           "! angle A B g\n0 0.01 0.001 1.5\n30 0.02 0.001 1.4\n"})
    EXPECT_THAT(message(text),
                HasSubstr("file: holds coefficients of the ABg model of scatter (A, B, g), which "
                          "are not read: export the measured BSDF"))
        << text;
  // A table whose comment holds a fit, and tables of other channels.
  EXPECT_EQ(read("# ABg: A=0.1 B=0.002 g=2\n" + std::string(kHeader) + kRow).rows(), 1u);
  EXPECT_EQ(read("theta_i,phi_i,theta_o,phi_o,A,B,g\n30,180,60,5,1,1,1\n").channels.size(), 3u);
  EXPECT_THAT(message("R,G,B,A\n1,1,1,1\n"), testing::Not(HasSubstr("ABg")));
}

TEST(OtherFormats, ParametersOfModelsAndSpectraAreNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"##TITLE=blue tile\n##JCAMP-DX=5.01\n##XYDATA=(X++(Y..Y))\n400 0.1 0.2\n",
       "is a spectrum in JCAMP-DX"},
      {"PE UV       SUBTECH     SPECTRUM    ASCII       PEDS        4.00\n-1\nblue.asc\n",
       "is a spectrum of PerkinElmer (ASCII), which has no directions"},
      {"netcdf paint {\ndimensions:\n  row = 2 ;\n", "is CDL, the text of a NetCDF file"},
      {"Harvey-Shack\nb0 0.12\nL 0.01\ns -1.6\n", "holds parameters of Harvey and Shack's model"},
      {"wavelength_nm,b0,L,s\n633,0.12,0.01,-1.6\n", "holds parameters of Harvey and Shack's model"},
      {"band,f_iso,f_vol,f_geo\n1,0.2,0.05,0.02\n", "holds weights of the kernels of MODIS"},
      {"---\nmaterial: tile\nvalues:\n  - 0.1\n", "looks like YAML, which is not read"},
      {"material: tile\ntheta: 45\nvalue: 0.1\n", "looks like YAML, which is not read"},
      {"[sample]\nname = \"tile\"\ntheta = 45\n", "looks like TOML, which is not read"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
  // Tables of samples with such words stay tables.
  for (const std::string head : {"# Harvey-Shack fit: b0 0.1 L 0.01 s -1.5\n", "# f_iso 1 f_vol 2 f_geo 3\n",
                                 "# material: tile\n# note: yes\n"})
    EXPECT_EQ(read(head + kHeader + kRow).rows(), 1u) << head;
}

TEST(OtherFormats, ReportsAfterE2387AreNamedIfTheyAreNoTables) {
  EXPECT_THAT(message("ASTM E2387-19 report\nWavelength: 633 nm\n\nScatter angle (deg),BRDF (1/sr)\n6,1\n"),
              AllOf(HasSubstr("file: refers to ASTM E2387, which gives no layout of files: export columns"),
                    HasSubstr("(as a table of columns: ")));
  const char* with_angle =
      "ASTM E2387-19 report\nAngle of incidence: 5 deg\n\nScatter angle (deg),BRDF (1/sr)\n6,1\n";
  EXPECT_THAT(read(with_angle).theta_i, testing::ElementsAre(5));
  EXPECT_EQ(read("# measured after ASTM E 2387\n" + std::string(kHeader) + kRow).rows(), 1u);
  EXPECT_THAT(message("Scatter angle (deg),BRDF (1/sr)\n6,1\n"), testing::Not(HasSubstr("E2387")));
}

// Some verbs read JSON as a material and others as a table. Both messages recognise the file as a table.
TEST(OtherFormats, InJsonAreToldByTheirKeys) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"metadata": {}, "reflectionCoefficient": {"lookupTable": [[5e-7, 0.1, 0.2, 3.1, 0, 0.05, 1]]}})",
       "ratios of amplitudes (*_reflCoeff.xompt), which lacks the solid angles"},
      {R"({"metadata": {"openMaterial3dVersion": "1.0.0"}, "emp": {"lookupTable": [[1, 2]]}})",
       "a file of ASAM OpenMATERIAL without a BRDF look-up table"},
      {R"({"rows": [{"theta_in": 1, "theta_out": 2, "value": 3}]})",
       "the content looks like a table of samples of another program"}};
  for (const auto& [text, expected] : cases) {
    EXPECT_THAT(message(text), HasSubstr(expected)) << text;
    EXPECT_THAT(message_of([&] { read_material(Content{"file", text}); }), HasSubstr(expected)) << text;
  }
  // These are read as samples.
  const std::pair<const char*, const char*> tables[] = {
      {R"({"metadata": {}, "brdf": {"lookupTable": []}})", "a look-up table of ASAM OpenMATERIAL"},
      {R"({"data": {"theta_i": 1, "theta_r": 2, "BRDF": 3}})", "a universal BRDF file (BiRD)"},
      {R"({"data": {"theta_i": [1], "theta_v": [2], "phi_v": [0]}})",
       "a BRDF file of BiRD before version 1.0"}};
  for (const auto& [text, expected] : tables)
    EXPECT_THAT(message_of([&] {
                  read_material(Content{"file", text});
                }),
                AllOf(HasSubstr(expected), HasSubstr("which holds samples: `brdf fit` finds a material")));
  EXPECT_THAT(message(R"({"a": 1})"), HasSubstr("is JSON, not a table of samples"));
  EXPECT_THAT(message_of([] {
                read_material(Content{"file", R"({"a": 1})"});
              }),
              HasSubstr("key \"format\" is missing"));
}

}  // namespace
}  // namespace brdf::io
