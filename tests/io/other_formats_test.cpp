// Tests that files of other programs are recognised by their content and refused with advice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/content.h"
#include "io/material/material_file.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::AllOf;
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
      {R"([{"theta_i": 10, "theta_o": 20, "f": 1}])",
       "is JSON, but not a material: the content looks like a table of samples"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
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
