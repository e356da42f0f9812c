// The subject of a plan: `fit` of a stack or of the refits of one table, `fit` or `study` of tables. The
// options are the same as for a run without a plan.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "work/job.h"
#include "work/options.h"

namespace brdf::work {

// Returns the plan of `brdf plan VERB NAMED...`. The metric of a stack is chosen here, once for all units.
// Every input is read to compute its fingerprint. Throws InputError.
Plan plan_of(const std::string& verb, const std::vector<std::string>& named, const std::string& unit_size,
             TaskOptions options);

// A stack that a plan divides, identical for all its units.
struct StackTask {
  texel::Stack stack;
  maps::Settings settings;
  std::optional<maps::Normals> normals;
};

// A job's plan and its options. File names are relative to the plan's folder; the caller must change to this
// folder.
class Task {
 public:
  // `read` parses the plan's words. The job's folder is resolved relative to the folder in which the program
  // was started, and so is every path that is passed through absolute().
  Task(const std::string& job, const std::function<TaskOptions(const std::vector<std::string>&)>& read);

  const std::string& job() const { return job_; }
  const Plan& plan() const { return plan_; }
  const TaskOptions& options() const { return options_; }

  StackTask stack() const;                   // precondition: the task is a stack
  std::vector<std::string> samples() const;  // precondition: the task has tables
  // Returns true for a single table: its units are refits, folds and bootstrap replicates.
  bool of_refits() const { return plan_.stack.empty() && plan_.inputs.size() == 1; }

 private:
  std::string job_;
  Plan plan_;
  TaskOptions options_;
};

// Returns the absolute path, resolved relative to the current folder; call before changing folders. An empty
// path stays empty.
std::string absolute(const std::string& path);

}  // namespace brdf::work
