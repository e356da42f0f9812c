#include "fit/solve/quiet.h"

#include <glog/logging.h>

namespace brdf::fit {

void silence_solver_log() {
// Ceres' own small replacement of glog, which a build for browsers uses, is silenced when it is compiled.
#ifndef CERCES_INTERNAL_MINIGLOG_GLOG_LOGGING_H_
  FLAGS_minloglevel = google::GLOG_FATAL;
#endif
}

}  // namespace brdf::fit
