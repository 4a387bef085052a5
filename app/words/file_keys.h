/// Keys of the files beside scenes and bearings: sweeps, studies, buildings, mappings.
#pragma once
#include "app/words/key_catalogue.h"

namespace rimpact::app {

struct FileKeys {
  std::string name;  ///< of the list in JSON, e.g. "sweep_keys"
  std::string title; ///< e.g. "Sweep files"
  std::string note;  ///< what a reader must know before the table; may be empty
  std::vector<KeyDescription> keys;
};

/// Every kind of file, KEY standing for any scene key.
std::vector<FileKeys> file_keys();

} // namespace rimpact::app
