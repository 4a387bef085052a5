#include "fe_contact/drive/record_checkpoint.h"

#include "fe_contact/drive/sample_row.h"
#include "fe_contact/drive/solver_counts.h"
#include "fe_contact/drive/state_fields.h"
#include "fe_contact/solver/ranks.h"
#include "io/files/error.h"
#include "io/files/json_text.h"
#include "responses/identity.h"
#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace rimpact::fe {
namespace {

constexpr Limits seconds{0, 1e12};

/// Texts without line breaks, a line each.
void visit_lines(StateVisitor &v, const std::string &name, std::vector<std::string> &lines) {
  std::string text;
  for (const std::string &line : lines) text += line + "\n";
  v.text(name, text);
  lines.clear();
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) lines.push_back(line);
}

/// Numbers by names, in lines of `name`_names.
void visit_named(StateVisitor &v, const std::string &name, std::vector<std::pair<std::string, double>> &entries,
                 Limits limits) {
  std::vector<std::string> names;
  std::vector<double> values;
  for (const auto &[word, value] : entries) names.push_back(word), values.push_back(value);
  visit_lines(v, name + "_names", names);
  values.resize(names.size());
  v.numbers(name, values, limits);
  entries.clear();
  for (std::size_t k = 0; k < names.size(); ++k) entries.emplace_back(names[k], values[k]);
}

/// Every signal of a finite-element run is as long as the time.
void visit(StateVisitor &v, Response &response) {
  std::vector<std::string> signals;
  for (const auto &[name, values] : response.all()) signals.push_back(name);
  visit_lines(v, "signals", signals);
  if (signals.empty()) return; // no instant was stored yet
  const auto &known = known_signals();
  RunRecord example;
  append(example, {});
  for (const auto &[name, unused] : example.response.all())
    if (std::ranges::find(signals, name) == signals.end()) v.damaged(name, "is missing");
  std::vector<double> &time = response.series("time");
  v.numbers("time", time, {-1e-9, 1e6}, true);
  if (!std::ranges::is_sorted(time)) v.damaged("time", "runs back");
  for (const std::string &name : signals) {
    if (name == "time") continue;
    if (std::ranges::none_of(known, [&](const auto &info) { return info.name == name; }))
      v.damaged(name, "is not known");
    std::vector<double> &series = response.series(name);
    series.resize(time.size());
    v.numbers(name, series);
  }
}

void visit(StateVisitor &v, SolverWork &work) {
  for (const auto &count : solver_counts) v.integer(count.sum, work.*count.of, 0, 1e15);
}

/// What a process before this one has taken: the writer keeps what all have taken so far.
void visit_costs(StateVisitor &v, RunRecord &record) {
  SolverWork work = record.work_so_far();
  double wall = record.wall_so_far(), processor = record.processor_so_far() * ranks().size; // ranks wait busily: alike
  std::vector<std::pair<std::string, double>> split;
  for (const auto &[name, time] : record.split_so_far()) split.emplace_back(name, time);
  v.part("work", [&] { visit(v, work); });
  v.part("rows_work", [&] { visit(v, record.rows_work); });
  v.number("seconds_wall", wall, seconds);
  v.number("seconds_processor", processor, seconds);
  visit_named(v, "seconds_split", split, seconds);
  if (!v.reads()) return;
  record.earlier_work = work;
  record.earlier_wall = wall;
  record.earlier_processor = processor / ranks().size;
  record.time_split = {split.begin(), split.end()};
}

} // namespace

void begin_checkpoint(const RunOptions &options, const RunRecord &record) {
  if (!options.keeps_files()) return;
  Checkpoint file;
  file.texts["identity"] = json_text(record.identity);
  write_checkpoint(file, checkpoint_of(options));
}

Checkpoint kept_checkpoint(const RunOptions &options, const RunRecord &record) {
  Checkpoint file = read_checkpoint(checkpoint_of(options));
  const auto kept = identity_from(nlohmann::json::parse(file.text("identity"), nullptr, false)),
             now = identity_from(record.identity);
  if (!kept || !now) file.damaged("it does not say what it is of");
  if (*kept != *now) {
    const std::string what = changes(*kept, *now);
    throw DataError(fmt::format("{} belongs to another run: {} since; run without --resume to start afresh", file.path,
                                what.empty() ? "the files it reads changed" : what));
  }
  return file;
}

bool has_only_begun(const Checkpoint &file) {
  return file.numbers.empty();
}

void visit(StateVisitor &v, RunRecord &record) {
  std::string identity = json_text(record.identity); // kept_checkpoint has read it
  v.text("identity", identity);
  visit_lines(v, "warnings", record.warnings);
  v.flag("ended", record.ended);
  v.part("ledger", [&] { visit(v, record.ledger); });
  v.part("impacts", [&] { visit(v, record.impacts); });
  v.integer("steps", record.n_steps, 0, 1e15);
  v.integer("cuts", record.n_cuts, 0, 1e15);
  v.integer("augmentation_caps", record.augmentation_caps, 0, 1e15);
  v.part("response", [&] { visit(v, record.response); });
  visit_costs(v, record);
  std::vector<std::pair<std::string, double>> fields;
  for (const auto &[time, file] : record.fields) fields.emplace_back(file, time);
  visit_named(v, "fields", fields, {});
  record.fields.clear();
  for (const auto &[file, time] : fields) record.fields.emplace_back(time, file);
}

} // namespace rimpact::fe
