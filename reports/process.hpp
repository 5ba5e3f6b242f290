#pragma once

#include "verification/process/process.hpp"

namespace porowave::reports {

using verification::ProcessResult;
using verification::run_process;

}  // namespace porowave::reports
