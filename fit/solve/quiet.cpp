#include "fit/solve/quiet.h"

#include <glog/logging.h>

namespace brdf::fit {

void silence_solver_log() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

}  // namespace brdf::fit
