/// JMA's tables: a header of lines KEY = VALUE, then a column for each of NS, EW and UD.
#pragma once
#include <string_view>

namespace rimpact {

/// Whether a text's beginning is such a table's.
bool is_jma_table(std::string_view text);

} // namespace rimpact
