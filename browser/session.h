// The program as a browser's page calls it: requests and answers are JSON, files are bytes in memory. No file
// is read or written.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "io/files/json.h"
#include "study/folder.h"

namespace brdf::browser {

class Session {
 public:
  // Called during a study.
  struct Listener {
    std::function<void(const std::string&, double)> progress;  // a step, and the finished share, 0 to 1
    std::function<void(const std::string&)> fitted;  // the sentence on the best fit; the report comes later
  };

  explicit Session(Listener listener) : listener_(std::move(listener)) {}

  // Creates an input file of this name (without a folder) and size. The caller writes its bytes to the
  // returned address before the next request. An older file of this name is replaced.
  char* put(const std::string& name, std::size_t size);
  void clear() { inputs_.clear(); }

  // Returns the answer to a request, which has the key "do":
  //   about     version, forms with their parameters, metrics
  //   study     "table", "form", "metric" ("": automatic), "tolerance" (a fraction or null): the row of
  //             study.json, the same command for a terminal, and the names of the files of the study
  //   material  "form" and "parameters" (name to a list of values), or "material" (a material's JSON):
  //             albedo and lobes, the same command for a terminal, and the names of the material's files
  //   export    a material as glTF: the sentence on the loss, and the name of the file
  // A request that is refused, and a failure, give {"error": SENTENCE}.
  io::Json answer(const std::string& request);

  // The files of the last answer, in the order of its "files".
  const std::vector<study::File>& files() const { return files_; }

 private:
  io::Json study(const io::JsonPlace& request);
  io::Json material(const io::JsonPlace& request);
  io::Json exported(const io::JsonPlace& request);

  Listener listener_;
  std::map<std::string, std::string> inputs_;
  std::vector<study::File> files_;
};

}  // namespace brdf::browser
