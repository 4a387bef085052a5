/// What a report's first page says of whom it is for: title, client, project, author.
#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace rimpact::app {

struct DocumentWords {
  std::string title, client, project, author;
  std::string file; ///< TOML with these keys; a word on the command line counts more
};
void add_document_options(CLI::App &verb, DocumentWords &words);
/// {title, client, project, author}, null where nobody said. Throws InputError for an unknown key or one that is no
/// text.
nlohmann::json document_json(const DocumentWords &words);

} // namespace rimpact::app
