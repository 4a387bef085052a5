#include "app/words/run_words.h"

namespace rimpact::app {

void add_run_words(CLI::App &verb, RunWords &words, Console &console) {
  verb.add_option("SCENE", words.scene, "a TOML file or a built-in scene")->required();
  verb.add_option("-o,--output", words.folder, "run folder (default results/<scene>)");
  verb.add_flag("--resume", words.resume, "go on from the folder's checkpoint; a run that has ended stays as it is");
  verb.add_flag("--dry-run", words.dry_run, "print the plan and stop");
  verb.add_flag("--no-fields", words.no_fields, "no VTU files");
  verb.add_option("--fields-every", words.fields_every_ms,
                  "also VTU files at so many ms of an impact, for a film (some 5 MB each on mesh 1)")
      ->check(CLI::Range(0.01, 1e6));
  console.add_common(verb);
  console.add_json(verb);
  console.add_overrides(verb);
  console.add_force(verb);
  console.add_model(verb);
}

} // namespace rimpact::app
