#pragma once

#include <functional>
#include <string>

#include "verification/gate/observation.hpp"
#include "verification/sweep/case_runner.hpp"

namespace porowave::verification {

/// What makes a floor, an error that refinement no longer lowers, in words. By experiment: some
/// cases of the finest level are run again with half the time step, with twice the points in a
/// cell, and with twice the elements (each unless it is what the study refines); what lowers the
/// error by a fifth or more has a part in it. If nothing does, what is left is named: strains,
/// where they are not small against the error, or what none of the three changes.
///
/// Cases that the scheme cannot run so are left out. `group` must have errors in its finest level.
std::string cause_of_floor(const Study& study, const Group& group, std::size_t measure,
                           CaseRunner& runner);

}  // namespace porowave::verification
