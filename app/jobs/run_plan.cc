#include "app/jobs/run_plan.h"

#include "app/jobs/time_to_go.h"
#include "io/files/json_text.h"
#include "responses/build_version.h"
#include <fmt/format.h>

namespace rimpact::app {

void print_plan(const GivenCase &given, const RunPlan &plan, const Console &console) {
  std::vector<RunTime> times;
  nlohmann::json rows = nlohmann::json::array();
  std::string text = given.head() + fmt::format("{:{}s} expected\n", plan.what, plan.width);
  for (const auto &run : plan.runs) {
    times.push_back({.expected = run.expected});
    rows.push_back({{"name", run.name}, {"expected_seconds", run.expected}});
    text += fmt::format("{:{}s} {}\n", run.name, plan.width, about(run.expected));
  }
  const double proof = plan.proof.value_or(0), in_all = time_to_go(times, plan.at_once) + proof;
  if (proof > 0) text += fmt::format("{:{}s} {}\n", "the answer's rim, solid", plan.width, about(proof));
  text += fmt::format("{} {}, {} at a time: {} in all\n", plan.runs.size(), plan.several, plan.at_once, about(in_all));
  nlohmann::json table{{"made_by", build_version()}, {"bearing", given.bearing_json()},
                       {"load", given.load_json()},  {"runs", rows},
                       {"at_once", plan.at_once},    {"expected_seconds", in_all}};
  if (plan.proof) table["proof_seconds"] = proof;
  console.data(console.json ? json_text(table) : text);
}

} // namespace rimpact::app
