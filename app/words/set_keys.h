/// Keys given by --set to a verb that reads only some of a scene.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace rimpact::app {

/// Dotted paths of the values that KEY=VALUE words give; a table gives those of all its keys. Throws InputError.
std::vector<std::string> keys_set(const std::vector<std::string> &assignments);

/// Why a verb does not read a key, and what to do instead; empty: it does.
using WhyUnread = std::function<std::string(const std::string &key)>;
/// Whether the key is `table` or stands in it.
bool is_in(const std::string &key, const std::string &table);
/// Throws InputError for the first key that `verb` does not read: "--set load.mass_kg=1: rimpact mesh BEARING does not
/// read load.mass_kg: ...". Whether the keys are known at all is the scene's matter.
void refuse_unread(const std::vector<std::string> &assignments, const std::string &verb, const WhyUnread &why_unread);

} // namespace rimpact::app
