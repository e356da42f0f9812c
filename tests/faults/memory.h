// Decides which code an allocation belongs to.
#pragma once

namespace faults {

// Reads FAULTS_FOREIGN, and prepares stack traces so that they need no further allocations.
void prepare_stacks();

}  // namespace faults
