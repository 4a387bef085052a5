// rimpact version
#include "app/library_versions.h"
#include "app/verb.h"
#include "files/json_text.h"
#include "responses/identity.h"
#include <fmt/format.h>

namespace rimpact::app {

void add_version(CLI::App &app, Console &console) {
  auto *verb = app.add_subcommand("version", "versions of the libraries in use");
  console.add_common(*verb);
  console.add_json(*verb);
  verb->callback([&console] {
    nlohmann::ordered_json table{{"rimpact", RIMPACT_VERSION}, {"physics", physics_version()}};
    const LibraryVersions libraries = library_versions();
    for (const auto &[name, version] : libraries.rows) table[name] = version;
    if (!libraries.warning.empty()) console.warn(libraries.warning);
    if (console.json) return console.data(json_text(table));
    for (const auto &[name, version] : table.items())
      console.data(fmt::format("{:15s} {}\n", name, version.get<std::string>()));
  });
}

} // namespace rimpact::app
