// Small texts of every format, and helpers that return the table or the message from reading them.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "io/csv/csv.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/formats/read.h"
#include "io/samples/samples.h"

namespace brdf::io {

inline constexpr const char* kHeader = "theta_i,phi_i,theta_o,phi_o,f\n";
inline constexpr const char* kRow = "30,180,60,5,1\n";
inline constexpr const char* kAstm = "VARS theta_i,phi_i,theta_s,phi_s,Y\n30,180,60,5,1\n";
inline constexpr const char* kLens =
    "Source Measured\nSymmetry PlaneSymmetrical\nSpectralContent Monochrome\nScatterType BRDF\n"
    "SampleRotation 1\n0\nAngleOfIncidence 1\n30\nScatterAzimuth 1\n0\nScatterRadial 2\n0 10\nMonochrome\n"
    "DataBegin\nTIS 0.5\n1 2\nDataEnd\n";

inline std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  for (std::size_t k = 0; k < count; ++k) all += text;
  return all;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

inline SampleTable read(const std::string& bytes) {
  return read_samples(Content{"file", bytes});
}

template <class Read>
inline std::string message_of(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

inline std::string message(const std::string& bytes) {
  return message_of([&] { read(bytes); });
}

inline std::string json_message(const std::string& text) {
  return message_of([&] { parse_json(text, "m.json"); });
}

inline std::string written(const SampleTable& table) {
  std::ostringstream out;
  write_samples(out, table);
  return out.str();
}

inline void expect_same(const SampleTable& a, const SampleTable& b) {
  EXPECT_EQ(a.channels, b.channels);
  EXPECT_EQ(a.metadata, b.metadata);
  EXPECT_EQ(a.theta_i, b.theta_i);
  EXPECT_EQ(a.phi_i, b.phi_i);
  EXPECT_EQ(a.theta_o, b.theta_o);
  EXPECT_EQ(a.phi_o, b.phi_o);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.sigma, b.sigma);
}

}  // namespace brdf::io
