/// What the keys' own descriptions leave to their names.
#pragma once
#include <string>

namespace rimpact::app {

/// In full, for a key whose comment in the file is empty or too short to stand alone; empty: the comment does.
std::string meaning_of(const std::string &path);
/// Of a default that follows from other keys, in words; empty: it is a plain value.
std::string preset_by_hand(const std::string &path);
/// When a key counts, where no choice says it.
std::string conditions_by_hand(const std::string &path);
/// What is to be added to a key's condition: who reads it beside the choices that say so.
std::string further_condition(const std::string &path);

} // namespace rimpact::app
