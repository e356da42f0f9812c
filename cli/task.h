// What a plan plans: `fit` of a stack or of the refits of one table, `fit` or `study` of tables, with the same options as at
// once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/fit_stack.h"
#include "fit/choice.h"
#include "maps/job.h"

namespace CLI {
class App;
}

namespace brdf::cli {

// A plan keeps these as words.
struct TaskOptions {
  fit::FitChoice choice;
  StackOptions stack;
  bool no_pictures = false;
};

void add_task_options(CLI::App& verb, TaskOptions& options);

// What `brdf plan VERB NAMED...` is to do. The metric of a stack is chosen here, once for all units. Every input is read for
// its fingerprint. Throws InputError.
maps::Plan plan_of(const std::string& verb, const std::vector<std::string>& named,
                   const std::string& unit_size, TaskOptions options);

// A stack that a plan divides, as all its units see it.
struct StackTask {
  texel::Stack stack;
  maps::Settings settings;
  std::optional<maps::Normals> normals;
};

// A job's plan, in the folder where it was planned, and its options. Outputs name the command that does the same at once.
class Task {
 public:
  // The job's folder is looked up from where the program was started, as is every path that goes through absolute().
  explicit Task(const std::string& job);

  const std::string& job() const { return job_; }
  const maps::Plan& plan() const { return plan_; }
  const TaskOptions& options() const { return options_; }

  StackTask stack() const;                   // precondition: it is of a stack
  std::vector<std::string> samples() const;  // precondition: it is of tables
  // Of one table the units are of its refits, folds and bootstrap replicates.
  bool of_refits() const { return plan_.stack.empty() && plan_.inputs.size() == 1; }

 private:
  std::string job_;
  maps::Plan plan_;
  TaskOptions options_;
};

// As it is where the program was started.
std::string absolute(const std::string& path);

}  // namespace brdf::cli
