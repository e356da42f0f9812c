// Control of the messages that the solver writes to the terminal.
#pragma once

namespace brdf::fit {

// Suppresses the messages that Ceres writes to the terminal through glog, except messages that end the
// process. The summaries of fits contain the same information. A program calls this once, before it fits.
// The setting is global to the process, so no library calls this function.
void silence_solver_log();

}  // namespace brdf::fit
