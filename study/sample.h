// One sample's study: everything that is found out about it, and the files that say it.
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
  std::vector<std::vector<Reflectance>> models;  // none: --form auto
  fit::FitOptions fit;
  std::string fit_words;  // the same as a shell takes it, for the commands that the page shows
  bool pictures = true;
  bool alone = true;  // its page is no part of an overview
};

// What the page and the JSON are made of.
struct Findings {
  std::string name;  // for people: the file's, without its folder
  io::SampleTable table;
  sheet::DataSheet sheet;
  fit::FitResult fit;
  std::optional<validate::Subject> subject;  // the best fit's material; none where there is no fit
  std::vector<validate::Finding> properties;
  Spheres spheres;
  std::vector<std::string> files;  // beside the page
  std::string no_shader;           // why there is none of them; empty where there is
};

// How far a sample is read, fitted, judged, drawn: called after each of kSteps steps.
inline constexpr int kSteps = 4;
using Step = std::function<void()>;

struct SampleStudy {
  std::vector<File> files;
  io::Json row;  // of study.json
  bool interrupted = false;
  std::vector<std::string> assumptions = {};  // of the reader
};

// `name` is the row's. Throws InputError where the samples cannot be read or fitted.
SampleStudy study_sample(io::Content content, const std::string& name, const SampleOptions& options,
                         const Step& step);

}  // namespace brdf::study
