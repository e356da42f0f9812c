#include "io/formats/exr_table.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/samples/table_rules.h"

namespace brdf::io {
namespace {

// Names that a comment's attribute must not take. They are the attributes by which OpenEXR distinguishes
// kinds of files, and its standard attributes of types other than string. Under such a name a comment would
// be mistaken for the standard attribute, and other programs would skip the comment or report an error.
// Source: IMF_STD_ATTRIBUTE_DEF of OpenEXR 3.1.5, and additions of later versions.
constexpr std::array kReserved{
    "type", "name", "version", "chunkCount", "tiles", "view", "multiView", "preview", "envmap",
    "chromaticities", "deepImageState", "idManifest", "maxSamplesPerPixel",
    // float
    "whiteLuminance", "xDensity", "utcOffset", "longitude", "latitude", "altitude", "focus", "expTime",
    "aperture", "isoSpeed", "dwaCompressionLevel", "cameraCCTSetting", "cameraTintSetting", "shutterAngle",
    "nominalFocalLength", "pinholeFocalLength", "effectiveFocalLength", "entrancePupilOffset", "tStop",
    "sensorPhotositePitch",
    // int, rational, two numbers, boxes, matrices, codes
    "imageCounter", "acesImageContainerFlag", "framesPerSecond", "captureRate", "adoptedNeutral",
    "cameraColorBalance", "sensorCenterOffset", "sensorOverallDimensions", "originalDataWindow",
    "sensorAcquisitionRectangle", "worldToCamera", "worldToNDC", "keyCode", "timeCode"};
constexpr std::size_t kLongestKey = 255;

struct ExrColumn {
  std::string name;
  const std::vector<double>* values;
  bool is_sigma = false;
};

// Converts to float. A positive standard deviation stays above 0.
float as_float(double value, bool is_sigma) {
  const auto rounded = static_cast<float>(value);
  return is_sigma && rounded == 0 ? std::numeric_limits<float>::denorm_min() : rounded;
}

std::vector<ExrColumn> columns_of(const SampleTable& table) {
  std::vector<ExrColumn> columns = {{"theta_i", &table.theta_i},
                                    {"phi_i", &table.phi_i},
                                    {"theta_o", &table.theta_o},
                                    {"phi_o", &table.phi_o}};
  for (std::size_t c = 0; c < table.channels.size(); ++c) {
    columns.push_back({table.channels[c], &table.values[c]});
    if (table.has_sigma(c)) columns.push_back({"sigma_" + table.channels[c], &table.sigma[c], true});
  }
  return columns;
}

std::string to_exr(const SampleTable& table) {
  const std::size_t width = std::min(kExrTableWidth, table.rows()),
                    height = (table.rows() + width - 1) / width;
  Imf::Header header(static_cast<int>(width), static_cast<int>(height));
  Imf::FrameBuffer frame;
  const std::vector<ExrColumn> columns = columns_of(table);
  std::vector<std::string> names;
  std::vector<std::vector<float>> planes;
  planes.reserve(columns.size());
  for (const ExrColumn& column : columns) {
    names.push_back(column.name);
    std::vector<float>& plane = planes.emplace_back(width * height, std::numeric_limits<float>::quiet_NaN());
    std::transform(column.values->begin(), column.values->end(), plane.begin(),
                   [&](double value) { return as_float(value, column.is_sigma); });
    header.channels().insert(column.name, Imf::Channel(Imf::FLOAT));
    frame.insert(column.name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(plane.data()), sizeof(float),
                                         sizeof(float) * width));
  }
  header.insert(std::string(kExrColumns), Imf::StringAttribute(joined(names, ",")));
  std::string comments;
  for (const Comment& comment : table.metadata)
    (comments += comments.empty() ? "" : "\n") += comment_text(comment);
  if (!table.metadata.empty()) header.insert(std::string(kExrComments), Imf::StringAttribute(comments));
  for (const auto& [key, value] : table.metadata) {
    if (key.empty() || key.size() + kExrPrefix.size() > kLongestKey) continue;
    const bool is_reserved =
        std::ranges::find(kReserved, key) != kReserved.end() || header.find(key.c_str()) != header.end();
    header.insert(is_reserved ? std::string(kExrPrefix) + key : key, Imf::StringAttribute(value));
  }
  Imf::StdOSStream bytes;
  {
    Imf::OutputFile file(bytes, header);
    file.setFrameBuffer(frame);
    file.writePixels(static_cast<int>(height));
  }
  return bytes.str();
}

}  // namespace

std::vector<std::string> write_exr_table(const std::filesystem::path& path, const SampleTable& table) {
  if (table.rows() == 0) throw InputError(table.name() + ": holds no rows");
  check_table(table);
  write_file_atomically(path, to_exr(table));
  std::vector<std::string> lost{"digits beyond 32-bit float (7 significant ones)"};
  std::size_t infinite = 0;
  for (const ExrColumn& column : columns_of(table))
    infinite += static_cast<std::size_t>(
        std::count_if(column.values->begin(), column.values->end(),
                      [](double value) { return std::abs(value) > std::numeric_limits<float>::max(); }));
  if (infinite > 0)
    lost.push_back(std::to_string(infinite) + " numbers above 3.4e38, which become infinite in 32-bit float");
  return lost;
}

}  // namespace brdf::io
