/// Every key of scene and bearing files with what a reader must know of it: with file_keys.h the source of `list keys`
/// and of docs/reference/keys.md.
#pragma once
#include <string>
#include <vector>

namespace rimpact::app {

struct KeyDescription {
  std::string path;             ///< dotted, as a scene file has it
  std::string kind;             ///< number | limit | integer | flag | text | choice | pair | numbers | switches
  std::string unit;             ///< as the name says it; empty: none
  std::string preset;           ///< its value where the file is silent, as TOML writes it
  std::string range;            ///< in the file's unit, or the words to choose from
  std::string meaning;          ///< never empty
  bool assumption;              ///< of the built-in bearing: no source gives it
  std::string condition;        ///< e.g. "excitation.kind = push"; empty: it always counts
  std::string counts_also = {}; ///< who reads it beside these, to be appended
};

/// Keys of scenes, those of a bearing under "bearing."; a bearing file has them without that word.
std::vector<KeyDescription> scene_keys();

/// The unit a key's name ends in, e.g. "kN/m" for k_i_kN_per_m; empty: none.
std::string unit_in_name(const std::string &name);

} // namespace rimpact::app
