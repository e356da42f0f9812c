// Tests that reading any content ends in a table or in an InputError.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include "io/csv/csv.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "io/formats/read.h"
#include "io/material/material_file.h"
#include "io/samples/samples.h"
#include "tests/io/data_folder.h"

namespace brdf::io {
namespace {

constexpr const char* kCsv =
    "# sample: x\n# quantity: "
    "f_r*cos_o\ntheta_i,phi_i,theta_o,phi_o,r,sigma_r\n30,180,30,0,1.5,.1\n10,0,20,90,2,.2\n";
constexpr const char* kAstmToDamage =
    "LAB_NAME x\nVARS theta_i,phi_i,theta_s,phi_s,Y\n.1,.2,.3,.4,5\n.2,.3,.4,.5,6\n";
constexpr const char* kLensToDamage =
    "# Sample: "
    "test\nSource\tMeasured\nSymmetry\tPlaneSymmetrical\nSpectralContent\tMonochrome\nScatterType\tBRDF\n"
    "SampleRotation\t1\n0\nAngleOfIncidence\t1\n30\nScatterAzimuth\t2\n0\t180\nScatterRadial\t3\n0\t10\t70\n"
    "\nMonochrome\n"
    "DataBegin\nTIS\t0.5\n1\t2\t3\n1\t2\t3\nDataEnd\n";
constexpr const char* kMaterial =
    R"({"format": "brdf-material", "version": 1, "form": "ward", "channels": ["r"], "weights": {"kd": [0.1],
        "ks": [0.3]}, "shape": {"alpha_x": 0.1, "alpha_y": 0.25}, "tangent_phi": 20, "fit": {"a": [1, {}]}})";

class Damaged : public testing::Test {
 protected:
  // Overwrites, deletes, repeats or cuts at random places, with bytes that are significant in the formats.
  std::string damaged(std::string content) {
    constexpr std::string_view kBytes = "0189.,-+eE#:\n\r\t \"{}[]nai\0\xff\x7f";
    for (int changes = 1 + static_cast<int>(random_() % 4); changes > 0 && !content.empty(); --changes) {
      const std::size_t where = random_() % content.size();
      switch (random_() % 5) {
        case 0:
        case 1:
          content[where] = kBytes[random_() % kBytes.size()];
          break;
        case 2:
          content.erase(where, 1 + random_() % 8);
          break;
        case 3:
          content.insert(where, content.substr(random_() % content.size(), random_() % 20));
          break;
        default:
          if (random_() % 4 == 0) content.resize(where);
      }
    }
    return content;
  }

  template <class Read>
  void expect_table_or_input_error(const std::string& content, int trials, Read read) {
    const auto path = folder_.path() / "file";
    int accepted = 0, refused = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::ofstream(path, std::ios::binary) << damaged(content);
      try {
        read(path);
        ++accepted;
      } catch (const InputError&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, trials / 20);
    EXPECT_EQ(accepted + refused, trials);
  }

  static void read_table(const std::filesystem::path& path) {
    const SampleTable table = read_samples(path);
    EXPECT_GT(table.rows(), 0u);
    EXPECT_EQ(table.values.size(), table.channels.size());
    for (const auto& column : table.values) EXPECT_EQ(column.size(), table.rows());
    for (std::size_t k = 0; k < table.rows(); ++k) {
      EXPECT_TRUE(table.theta_i[k] >= 0 && table.theta_i[k] <= 90);
      EXPECT_TRUE(table.theta_o[k] >= 0 && table.theta_o[k] <= 90);
    }
    // A table that was read can be written, and reading it back gives the same text again.
    const auto written = [](const SampleTable& t) {
      std::ostringstream out;
      write_samples(out, t);
      return out.str();
    };
    const std::string once = written(table);
    const SampleTable back = read_samples(Content{"written", once});
    EXPECT_EQ(back.values, table.values);
    EXPECT_EQ(back.metadata, table.metadata);
    EXPECT_EQ(written(back), once);
  }

  std::mt19937_64 random_{5};
  io::TemporaryFolder folder_;
};

TEST_F(Damaged, CsvIsReadOrRefused) {
  expect_table_or_input_error(kCsv, 300, read_table);
}
TEST_F(Damaged, AstmIsReadOrRefused) {
  expect_table_or_input_error(kAstmToDamage, 300, read_table);
}
TEST_F(Damaged, LensDesignTextIsReadOrRefused) {
  expect_table_or_input_error(kLensToDamage, 300, read_table);
}
TEST_F(Damaged, MaterialsAreReadOrRefused) {
  expect_table_or_input_error(kMaterial, 300, [](const auto& path) { read_material(path); });
}

TEST_F(Damaged, TensorFilesAreReadOrRefused) {
  const auto folder = measured_data();
  if (!folder) GTEST_SKIP() << "BRDF_DATA_DIR is unset";
  std::ifstream in(*folder / "paper_white_rgb.bsdf", std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  // Only the table of fields is damaged, because the arrays contain nothing but numbers.
  for (int trial = 0; trial < 50; ++trial) {
    std::ofstream(folder_.path() / "file", std::ios::binary)
        << damaged(content.substr(0, 416)) << content.substr(416);
    try {
      read_table(folder_.path() / "file");
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace brdf::io
