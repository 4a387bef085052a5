#include "fe_contact/drive/sliding_replan.h"

#include "fe_contact/drive/record_checkpoint.h"
#include <memory>

namespace rimpact::fe {

void run_sliding(const Rung &rung, const scene::Scene &scene, const planning::Plan &plan, const RunOptions &options,
                 RunRecord &record) {
  planning::Plan now = plan;
  std::optional<Checkpoint> kept;
  if (options.resume) kept = kept_checkpoint(options, record);
  if (kept) now.sectors = kept->field("sectors", Limits{-7, 7}); // it may have been replanned
  if (kept && (now.sectors.empty() || now.sectors.size() > 100)) kept->damaged("field sectors names no sectors");
  auto dynamic = std::make_unique<SlidingRun>(rung, scene, now, options, record);
  std::map<std::string, double> before; // of those replanned
  SolverWork work_before;
  const auto times = [&] {
    auto result = before;
    for (const auto &[name, seconds] : dynamic->stack().time_split()) result[name] += seconds;
    return result;
  };
  const auto work = [&] {
    SolverWork result = work_before;
    return result += dynamic->stack().work();
  };
  run_counted(
      record,
      [&] {
        if (kept)
          dynamic->restore(*kept);
        else
          dynamic->start();
        kept.reset();
        while (const auto direction = dynamic->run()) {
          now.sectors.push_back(*direction);
          auto next = std::make_unique<SlidingRun>(rung, scene, now, options, record);
          next->take_over(*dynamic);
          before = times();
          work_before = work();
          dynamic = std::move(next);
        }
      },
      times, work, [&] { return dynamic->steel(); });
}

} // namespace rimpact::fe
