// Whose an allocation is.
#pragma once

namespace faults {

// Reads FAULTS_FOREIGN, and makes stacks readable without further allocations.
void prepare_stacks();

}  // namespace faults
