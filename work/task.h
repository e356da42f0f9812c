// What a plan plans: `fit` of a stack or of the refits of one table, `fit` or `study` of tables, with the
// same options as at once.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "work/job.h"
#include "work/options.h"

namespace brdf::work {

// What `brdf plan VERB NAMED...` is to do. The metric of a stack is chosen here, once for all units. Every
// input is read for its fingerprint. Throws InputError.
Plan plan_of(const std::string& verb, const std::vector<std::string>& named, const std::string& unit_size,
             TaskOptions options);

// A stack that a plan divides, as all its units see it.
struct StackTask {
  texel::Stack stack;
  maps::Settings settings;
  std::optional<maps::Normals> normals;
};

// A job's plan and its options. Its names are looked up in the plan's folder, to which the caller changes.
class Task {
 public:
  // `read` understands the plan's words. The job's folder is looked up from where the program was started, as
  // is every path that goes through absolute().
  Task(const std::string& job, const std::function<TaskOptions(const std::vector<std::string>&)>& read);

  const std::string& job() const { return job_; }
  const Plan& plan() const { return plan_; }
  const TaskOptions& options() const { return options_; }

  StackTask stack() const;                   // precondition: it is of a stack
  std::vector<std::string> samples() const;  // precondition: it is of tables
  // Of one table the units are of its refits, folds and bootstrap replicates.
  bool of_refits() const { return plan_.stack.empty() && plan_.inputs.size() == 1; }

 private:
  std::string job_;
  Plan plan_;
  TaskOptions options_;
};

// As it is where the program was started.
std::string absolute(const std::string& path);

}  // namespace brdf::work
