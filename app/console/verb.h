/// A verb of the command line as a value: what its help says, and what it does. One file verb_NAME.cc, and its name in
/// catalogue.h.
#pragma once
#include "app/console/console.h"

namespace rimpact::app {

/// Examples: one a line. `next`: a command to go on with, {} the folder that was made, `usual` where none is named;
/// empty: nothing follows. `next_of_sweep`: the same after --sweep.
struct VerbText {
  const char *name, *help, *examples = "", *next = "", *usual = "", *next_of_sweep = "";
};

struct Verb {
  VerbText text;
  /// Adds the verb's options and the callback that does its work; errors leave as rimpact::Error. Null: the
  /// finite-element program carries the verb out.
  void (*add)(CLI::App &verb, Console &console) = nullptr;
};

} // namespace rimpact::app
