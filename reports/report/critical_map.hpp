#pragma once

#include "reports/report/report_content.hpp"

namespace porowave::reports {

/// Adds to every study of two scenes or more a section with the map of their critical Courant
/// numbers, if all maps together take at most options.map_seconds of CPU by a guess; else a note
/// with the command that draws it. A scene is the coarsest case of a group with its first seed;
/// load, end and courant have no part in it, and groups that differ in nothing else are one.
/// Cases of other programs and those that this one cannot read are left out.
void add_critical_maps(ReportContent& content);

}  // namespace porowave::reports
