// rimpact version
#include "app/verb.h"
#include "fe_contact/drive/run.h"
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
    for (const auto &[name, version] : fe::component_versions()) table[name] = version;
    if (const std::string warning = fe::blas_warning(); !warning.empty()) console.warn(warning);
    if (console.json) return console.data(json_text(table));
    for (const auto &[name, version] : table.items())
      console.data(fmt::format("{:15s} {}\n", name, version.get<std::string>()));
  });
}

} // namespace rimpact::app
