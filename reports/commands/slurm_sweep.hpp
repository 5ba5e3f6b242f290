#pragma once

#include <string>

#include "verification/cluster/slurm.hpp"

namespace porowave::reports {

/// `porowave sweep --slurm`: submits the cases that neither the store nor a shard has, unless jobs
/// of this store are still in the queue. With `dry_run` prints scripts and commands, and leaves
/// nothing behind. Returns the exit code. Throws InputError, EnvironmentError.
int sweep_by_slurm(const std::string& study, const std::string& store,
                   const verification::SlurmOptions& options, bool dry_run);

}  // namespace porowave::reports
