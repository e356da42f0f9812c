// Tests columns other than values: wavelengths in every unit, the sample rotation, metadata and text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/columns/wavelengths.h"
#include "io/files/text.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Wave {
  const char *name, *first, *second;  // 850 and 1310 nm
};

std::ostream& operator<<(std::ostream& out, const Wave& wave) {
  return out << wave.name;
}

class WavelengthColumn : public testing::TestWithParam<Wave> {};

TEST_P(WavelengthColumn, BecomesAChannelForEachWavelength) {
  const auto& [name, first, second] = GetParam();
  const std::string one = first, two = second;
  for (const char* header :
       {"theta_i,phi_i,theta_o,phi_o,fr", "Incidence,phi_i,View angle,phi_o,BRDF (1/sr)"}) {
    const SampleTable t = read(std::string(name) + "," + header + "\n" + one + ",10,0,20,180,.1\n" + two +
                               ",10,0,20,180,.2\n" + two + ",10,0,30,180,.4\n" + one + ",10,0,30,180,.3\n");
    EXPECT_THAT(t.channels, ElementsAre("850nm", "1310nm"));
    EXPECT_THAT(t.values, ElementsAre(ElementsAre(.1, .3), ElementsAre(.2, .4)));
    EXPECT_THAT(t.theta_o, ElementsAre(20, 30));
  }
}

const Wave kWaves[] = {{"wavelength", "850", "1310"},
                       {"Wavelength (nm)", "850", "1310"},
                       {"wavelength_nm", "850.000001", "1309.9999992"},
                       {"λ/nm", "850", "1310"},
                       {"lambda", "0.85", "1.31"},
                       {"wl", ".85", "1.31"},
                       {"lambda [um]", "0.85", "1.31"},
                       {"wavelength (µm)", "0.85", "1.31"},
                       {"Wavelength (microns)", "0.85", "1.31"},
                       {"wavelength (m)", "8.5e-7", "1.31e-6"},
                       {"wavelength [m]", "0.00000085", "0.00000131"},
                       {"wavelength (Å)", "8500", "13100"},
                       {"lambda (angstrom)", "8500", "13100"},
                       {"wavelength (mm)", "8.5e-4", "1.31e-3"},
                       {"wavenumber (cm-1)", "11764.705882", "7633.5877863"},
                       {"wavenumber [cm^-1]", "11764.705882", "7633.5877863"},
                       {"Wavenumber", "11764.705882", "7633.5877863"},
                       {"ν (cm⁻¹)", "11764.705882", "7633.5877863"},
                       {"frequency (GHz)", "352697.00941", "228849.20458"},
                       {"f (THz)", "352.69700941", "228.84920458"},
                       {"Frequency [Hz]", "3.5269700941e14", "2.2884920458e14"},
                       {"photon energy (eV)", "1.458637628", "0.9464442626"},
                       {"E (eV)", "1.458637628", "0.9464442626"}};
INSTANTIATE_TEST_SUITE_P(Units, WavelengthColumn, testing::ValuesIn(kWaves));

TEST(Wavelengths, WithoutAUnitBelowAHundredAreMicrometresAndSaidSo) {
  const std::string rows = "theta_i,phi_i,theta_o,phi_o,wavelength,fr\n1,2,3,4,";
  EXPECT_THAT(read(rows + "0.55,1\n").warnings,
              Contains("the wavelengths have no unit and are all below 100: interpreted as micrometres"));
  EXPECT_THAT(read(rows + "550,1\n").warnings, Not(Contains(HasSubstr("micrometres"))));
}

TEST(Wavelengths, WhoseUnitIsUnknownAreRefused) {
  const std::string rows = ",theta_i,phi_i,theta_o,phi_o,fr\n1,2,3,4,5,6\n";
  EXPECT_THAT(message("frequency" + rows), HasSubstr("column 'frequency' has no unit"));
  EXPECT_THAT(message("wavelength (kg)" + rows),
              HasSubstr("'wavelength (kg)' has the unit 'kg', which is not a unit of wavelengths"));
}

TEST(Wavelengths, EndTheNamesOfChannels) {
  EXPECT_EQ(wavelength_of("0.55um"), 550);
  EXPECT_EQ(wavelength_of("fr_0.55 µm"), 550);
  EXPECT_EQ(wavelength_of("5500 Å"), 550);
  EXPECT_EQ(wavelength_of("BRDF 5500angstrom"), 550);
  EXPECT_EQ(wavelength_of("20000 cm-1"), 500);
  EXPECT_EQ(wavelength_of("20000cm^-1"), 500);
  EXPECT_NEAR(*wavelength_of("299.792458THz"), 1000, 1e-9);
  EXPECT_EQ(wavelength_of("550 NM"), 550);
  for (const char* name : {"10m", "sample 5", "5 s", "f550um", "run 3 V", "90deg"})
    EXPECT_FALSE(wavelength_of(name)) << name;
}

TEST(SampleRotation, LowersBothAzimuths) {
  for (const char* name : {"sample rotation (deg)", "Rotation", "psi", "ψ (°)", "turn", "sample_azimuth"}) {
    const SampleTable t = read("theta_i,theta_o,phi," + std::string(name) +
                               ",fr (1/sr)\n30,20,170,0,1\n30,20,170,40,2\n30,20,170,90,3\n");
    EXPECT_THAT(t.phi_i, ElementsAre(0, -40, -90)) << name;
    EXPECT_THAT(t.phi_o, ElementsAre(170, 130, 80)) << name;
    EXPECT_THAT(t.channels, ElementsAre("fr"));
  }
  const SampleTable radians = read("theta_i,theta_o,phi,rotation (rad),fr\n30,20,170,0.5235987755982988,1\n");
  EXPECT_EQ(radians.phi_i[0], -30);
  // This holds for two signed angles, too.
  const SampleTable plane = read("theta_i,theta_o,rotation,fr\n30,-20,45,1\n30,30,45,2\n");
  EXPECT_THAT(plane.phi_i, ElementsAre(135, 135));
  EXPECT_THAT(plane.phi_o, ElementsAre(135, -45));
}

TEST(Metadata, IsSetAsideInOneLine) {
  const SampleTable t = read(
      "Temperature (°C),theta_i,phi_i,theta_o,phi_o,humidity (%),time,date,exposure (ms),gain,lamp current "
      "(A),"
      "integration time (s),repeat,point number,x (mm),y,polariser angle (deg),remark,stage (mm),fr\n"
      "21.5,1,2,3,4,40,12:05,2024-05-01,20,3,1.5,2,1,7,0.5,1,90,\"fine, really\",5,0.25\n");
  EXPECT_THAT(t.channels, ElementsAre("fr"));
  EXPECT_THAT(t.values[0], ElementsAre(0.25));
  EXPECT_THAT(t.warnings, ElementsAre(AllOf(HasSubstr("columns 'Temperature (°C)', 'humidity (%)', 'time'"),
                                            HasSubstr("(15) are ignored: not values of f_r"))));
}

// A column is metadata under any name if its unit belongs to another quantity, or if its cells are not
// numbers.
TEST(Metadata, IsToldByItsUnitOrItsCells) {
  for (const char* name : {"a (deg)", "b [rad]", "c (K)", "d (°C)", "e (h)", "g [mm]", "h (ms)", "bias (V)",
                           "i (nA)", "j (hPa)", "k (%)", "delay (s)", "solid angle (sr)", "thickness (um)"})
    for (const char* angles : {"theta_i,phi_i,theta_o,phi_o,", "Incidence,phi_i,View angle,phi_o,"}) {
      const SampleTable t = read(angles + std::string(name) + ",BRDF\n1,2,3,4,5,6\n");
      EXPECT_THAT(t.channels, ElementsAre("BRDF")) << name;
      EXPECT_THAT(t.warnings, Contains("column " + shown(name) + " is ignored: not values of f_r"));
    }
  const SampleTable text = read("theta_i,phi_i,theta_o,phi_o,what,fr\n1,2,3,4,,5\n1,2,3,5,gold,6\n");
  EXPECT_THAT(text.channels, ElementsAre("fr"));
  // A column of f_r with a bad cell is not metadata.
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o,550nm,fr\n1,2,3,4,x,5\n"),
              HasSubstr("(550nm): 'x' is not a number"));
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o,what\n1,2,3,4,x\n"),
              HasSubstr("(what): 'x' is not a number"));
  EXPECT_THAT(
      message("theta_i,phi_i,theta_o,phi_o,time (s)\n1,2,3,4,5\n"),
      HasSubstr(
          "no value column in addition to the four angles; the other columns are not values: 'time (s)'"));
}

TEST(Metadata, IncludesOtherAnglesAndCosines) {
  const SampleTable t = read(
      "Unnamed: 0,theta_i,phi_i,theta_o,phi_o,theta_h,phi_d,tilt angle,cos_i,cos(theta_o),solid angle,fr\n"
      "0,1,2,3,4,5,6,7,.8,.9,.01,.25\n");
  EXPECT_THAT(t.channels, ElementsAre("fr"));
  EXPECT_THAT(t.values[0], ElementsAre(.25));
}

TEST(Metadata, OfOneLetterIsAChannelWhereNothingElseIs) {
  EXPECT_THAT(read("theta_i,phi_i,theta_o,phi_o,x\n1,2,3,4,5\n").channels, ElementsAre("x"));
  EXPECT_THAT(read("theta_i,phi_i,theta_o,phi_o,Y\n1,2,3,4,5\n").channels, ElementsAre("Y"));
}

TEST(Polarisations, OfSAndPAreNoSeconds) {
  const SampleTable t = read("Incidence,View angle,fr (s),fr (p)\n1,2,3,4\n");
  EXPECT_THAT(t.channels, ElementsAre("fr (s)", "fr (p)"));
}

TEST(Mueller, TablesGiveFrOfUnpolarisedLight) {
  std::string names = "lambda,thetai,phi,thetar,phir", more = names;
  std::string row = "0.6,-40,0,35,170,0.3";
  for (int i = 1; i <= 4; ++i)
    for (int k = 1; k <= 4; ++k) {
      const std::string place = std::to_string(i) + std::to_string(k);
      names += place == "11" ? ",f_r11" : ",f_r" + place + "/f_r11";
      more += place == "11" ? ",M11" : ",M" + place;
      row += place == "11" ? "" : ",0.05";
    }
  for (const std::string& header : {names, more}) {
    const SampleTable t = read(header + "\n" + row + "\n");
    EXPECT_THAT(t.channels, ElementsAre("600nm"));
    EXPECT_THAT(t.values[0], ElementsAre(0.3));
    EXPECT_THAT(t.phi_i, ElementsAre(180));
    EXPECT_THAT(t.warnings, AllOf(Contains(HasSubstr("16 elements of a Mueller matrix")),
                                  Contains(HasSubstr("ignored"))));
  }
}

TEST(AngleNames, OfOtherLaboratoriesAreUnderstood) {
  struct Names {
    const char *light, *viewer;
  };
  for (const Names& names : std::initializer_list<Names>{{"measure", ""},
                                                         {"", "measurement"},
                                                         {"", "Measurement angle (deg)"},
                                                         {"", "detection angle"},
                                                         {"", "receiver"},
                                                         {"", "receiver angle"},
                                                         {"", "exit (deg)"},
                                                         {"", "Exit angle"},
                                                         {"", "emission"},
                                                         {"", "emission angle"},
                                                         {"", "reflected angle"},
                                                         {"", "reflected"},
                                                         {"", "thr"},
                                                         {"", "thv"},
                                                         {"", "theta_v"},
                                                         {"", "view_z"},
                                                         {"illumination", ""},
                                                         {"illumination angle", ""},
                                                         {"source (deg)", ""},
                                                         {"source angle", ""},
                                                         {"light angle", ""},
                                                         {"thi", ""},
                                                         {"src_z", ""},
                                                         {"th_in", ""},
                                                         {"AOI", ""},
                                                         {"Angle of illumination", ""},
                                                         {"", "angle of view"},
                                                         {"", "Scattering angle"},
                                                         {"i", "e"},
                                                         {"angle_in", "angle_out"},
                                                         {"Angle_i", "Angle_r"},
                                                         {"incident polar angle", "polar angle of detection"},
                                                         {"AOI", "AOS"},
                                                         {"θᵢ", "θᵣ"},
                                                         {"theta_in", "theta_out"},
                                                         {"sza", "vza"}}) {
    const std::string light = *names.light && std::string(names.light) != "measure" ? names.light : "theta_i";
    const std::string viewer = *names.viewer ? names.viewer : "theta_o";
    const SampleTable t = read(light + "," + viewer + ",phi_o - phi_i,BRDF\n10,20,30,1\n");
    EXPECT_THAT(t.theta_i, ElementsAre(10)) << light << viewer;
    EXPECT_THAT(t.theta_o, ElementsAre(20)) << light << viewer;
    EXPECT_THAT(t.channels, ElementsAre("BRDF"));
  }
  const SampleTable lab = read("src_z src_a view_z view_a 450nm\n10 20 30 40 1\n");
  EXPECT_THAT(lab.phi_i, ElementsAre(20));
  EXPECT_THAT(lab.phi_o, ElementsAre(40));
}

TEST(AngleNames, PhiBesideTheOtherAzimuthIsTheMissingOne) {
  const SampleTable light = read("thetai,phi,thetar,phir,fr\n10,20,30,40,1\n");
  EXPECT_THAT(light.phi_i, ElementsAre(20));
  EXPECT_THAT(light.phi_o, ElementsAre(40));
  EXPECT_THAT(light.warnings, Contains(HasSubstr("'phi' phi_i")));
  const SampleTable viewer = read("thetai,phii,thetar,phi,fr\n10,20,30,40,1\n");
  EXPECT_THAT(viewer.phi_o, ElementsAre(40));
}

TEST(AngleNames, TheOnlyAzimuthOfTheScatteredDirectionIsRead) {
  const SampleTable t = read("theta_i,theta_s,phi_s,BRDF\n10,20,40,1\n");
  EXPECT_THAT(t.theta_o, ElementsAre(20));
  EXPECT_THAT(t.phi_i, ElementsAre(0));
  EXPECT_THAT(t.phi_o, ElementsAre(40));
  EXPECT_THAT(t.warnings, Contains(HasSubstr("only one azimuth, 'phi_s'")));
  const SampleTable source = read("theta_s,phi_s,theta_v,BRDF\n10,40,20,1\n");
  EXPECT_THAT(source.phi_i, ElementsAre(40));
  EXPECT_THAT(message("theta_s,phi_s,BRDF\n10,40,1\n"), HasSubstr("may belong to the incident or"));
}

// Without the column, directions outside the plane of incidence would be read as directions in the plane.
TEST(AngleNames, AnAzimuthThatIsNotUnderstoodIsNotIgnored) {
  for (const char* name : {"Phi_x", "detector-arm azimuth", "Azimut Messkopf", "phi 2 (deg)"}) {
    const std::string both = "theta_i,theta_o," + std::string(name) + ",BRDF\n10,20,40,1\n";
    EXPECT_THAT(message(both),
                AllOf(HasSubstr(name), HasSubstr("seems to be an azimuth, but its name does not")))
        << name;
    EXPECT_THAT(message("theta_i,phi_i,theta_o," + std::string(name) + ",BRDF\n10,0,20,40,1\n"),
                HasSubstr("seems to be an azimuth"))
        << name;
    EXPECT_EQ(
        read("theta_i,phi_i,theta_r,phi_r," + std::string(name) + ",BRDF\n10,0,20,40,5,1\n").channels.size(),
        1u)
        << "both azimuths are given";
  }
  EXPECT_EQ(read("theta_i,theta_o,sample azimuth,BRDF\n10,20,0,1\n").rows(), 1u);
}

TEST(AngleNames, OfReflectionAndInGermanAreRead) {
  for (const char* names : {"theta_inc,phi_inc,theta_ref,phi_ref",
                            "Einfallswinkel,Azimut Einfall,Ausfallswinkel,Azimut "
                            "Ausfall"}) {
    const SampleTable t = read(std::string(names) + ",BRDF\n10,20,30,40,1\n");
    EXPECT_THAT(t.theta_i, ElementsAre(10)) << names;
    EXPECT_THAT(t.phi_i, ElementsAre(20));
    EXPECT_THAT(t.theta_o, ElementsAre(30));
    EXPECT_THAT(t.phi_o, ElementsAre(40));
  }
  EXPECT_THAT(read("Theta_in,Theta_out,Phi_diff,BRDF\n10,20,40,1\n").phi_o, ElementsAre(40));
}

}  // namespace
}  // namespace brdf::io
