#pragma once

#include <string>

namespace porowave::reports {

/// The text of reports/plots/<name>.gp, compiled into the program. Throws std::invalid_argument for
/// a name that is not there.
std::string plot_template(const std::string& name);

}  // namespace porowave::reports
