// Studies one sample: computes all findings and the files that report them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/files/content.h"
#include "io/samples/samples.h"
#include "sheet/data_sheet.h"
#include "study/folder.h"
#include "study/spheres.h"
#include "validate/search/finding.h"
#include "validate/search/subject.h"

namespace brdf::study {

struct SampleOptions {
  std::vector<std::vector<Reflectance>> models;  // empty: --form auto
  fit::FitOptions fit;
  std::string fit_words;  // the options of `fit` in shell syntax, for the commands that the page shows
  bool pictures = true;
  bool alone = true;                // the page is not part of an overview
  std::optional<double> tolerance;  // of the median error (fitted), a fraction
  fit::Progress progress;           // called with each model before it is fitted
  // Called with the sentence on the best fit, before its properties are judged and its pictures are drawn.
  std::function<void(const std::string&)> fitted = {};
};

// The content of the page and of the JSON files.
struct Findings {
  std::string name;  // for readers: the file's name without its folder
  io::SampleTable table;
  sheet::DataSheet sheet;
  fit::FitResult fit;
  std::optional<validate::Subject> subject;  // material of the best fit; std::nullopt if no fit exists
  std::vector<validate::Finding> properties;
  Spheres spheres;
  std::vector<std::string> files;  // files in the page's folder
  std::string no_shader;           // the reason why there is no shader; empty if there is one
};

// The number of steps of a sample (reading, fitting, judging, drawing), and the function that is called
// after each.
inline constexpr int kSteps = 4;
using Step = std::function<void()>;

struct SampleStudy {
  std::vector<File> files;
  io::Json row;  // the row of study.json
  bool interrupted = false;
  std::vector<std::string> assumptions = {};  // made by the reader
};

// Studies one sample. `name` is the name in its row. Throws InputError if the samples cannot be read or
// fitted.
SampleStudy study_sample(io::Content content, const std::string& name, const SampleOptions& options,
                         const Step& step);

}  // namespace brdf::study
