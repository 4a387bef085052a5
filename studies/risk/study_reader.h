/// Study files.
#pragma once
#include "studies/risk/study.h"

namespace rimpact::risk {

/// Names that a limit's quantity may have; "collapsed" has no values: a run collapsed or left its dish.
const std::vector<std::string> &quantities();
/// Throws InputError "file:line:column: ..." for what is not in the form above.
Study parse_study(const std::string &text, const std::string &origin);
Study read_study(const std::string &path);

} // namespace rimpact::risk
