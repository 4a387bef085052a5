// rimpact version
#include "app/verbs/catalogue.h"
#include "app/verbs/library_versions.h"
#include "io/files/json_text.h"
#include "responses/identity.h"
#include "responses/physics_version.h"
#include <fmt/format.h>

namespace rimpact::app {
namespace {

void add_version(CLI::App &verb, Console &console) {
  console.add_common(verb);
  console.add_json(verb);
  verb.callback([&console] {
    nlohmann::ordered_json table{{"rimpact", RIMPACT_VERSION}, {"physics", physics_version()}};
    const LibraryVersions libraries = library_versions();
    for (const auto &[name, version] : libraries.rows) table[name] = version;
    if (!libraries.warning.empty()) console.warn(libraries.warning);
    if (console.json) return console.data(json_text(table));
    for (const auto &[name, version] : table.items())
      console.data(fmt::format("{:15s} {}\n", name, version.get<std::string>()));
  });
}

} // namespace

const Verb version_verb{{.name = "version",
                         .help = "versions of the libraries in use",
                         .examples = "rimpact version\nrimpact version --json"},
                        add_version};

} // namespace rimpact::app
