#include "app/verbs/document_options.h"

#include "io/files/error.h"
#include "io/files/file.h"
#include "io/files/toml_reader.h"

namespace rimpact::app {
namespace {

DocumentWords from_file(const std::string &path) {
  DocumentWords words;
  std::string text;
  try {
    text = read_file(path);
  } catch (const DataError &error) {
    throw InputError(std::string("--document ") + error.what());
  }
  const TomlFile file(text, path);
  TomlReader reader(file, "");
  reader.text({"title"}, words.title);
  reader.text({"client"}, words.client);
  reader.text({"project"}, words.project);
  reader.text({"author"}, words.author);
  reader.finish();
  return words;
}

} // namespace

void add_document_options(CLI::App &verb, DocumentWords &words) {
  verb.add_option("--title", words.title, "of the report's first page");
  verb.add_option("--client", words.client, "for whom it is");
  verb.add_option("--project", words.project, "what it is for");
  verb.add_option("--author", words.author, "who signs it");
  verb.add_option("--document", words.file, "TOML file with title, client, project, author");
}

nlohmann::json document_json(const DocumentWords &words) {
  const DocumentWords kept = words.file.empty() ? DocumentWords{} : from_file(words.file);
  const auto either = [](const std::string &typed, const std::string &filed) {
    const std::string &word = typed.empty() ? filed : typed;
    return word.empty() ? nlohmann::json() : nlohmann::json(word);
  };
  return {{"title", either(words.title, kept.title)},
          {"client", either(words.client, kept.client)},
          {"project", either(words.project, kept.project)},
          {"author", either(words.author, kept.author)}};
}

} // namespace rimpact::app
