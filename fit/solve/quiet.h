#pragma once

namespace brdf::fit {

// For a program, before it fits: what Ceres writes to the terminal through glog is left out, except for what
// ends the process. The summaries of fits say the same. It changes glog for the whole process, so no library
// calls it.
void silence_solver_log();

}  // namespace brdf::fit
