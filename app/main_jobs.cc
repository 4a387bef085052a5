#include "app/main_jobs.h"

#include <fmt/format.h>

namespace rimpact::app {

std::vector<Job> main_jobs(const scene::Bearing &bearing, const std::string &folder) {
  std::vector<Job> jobs;
  const auto add = [&](const std::string &name, const std::string &role, const std::string &scene,
                       const std::string &override) {
    Job job{name, role, scene::load_scene(scene, {override}), folder + "/runs/" + name, false, false, {}};
    job.scene.bearing = bearing;
    job.scene.name = name;
    job.scene.validate();
    jobs.push_back(job);
  };
  for (const double scale : {1.10, 1.05, 1.0})
    for (const char *pulse : {"ricker-0.78g-1.0s", "ricker-0.38g-1.5s"})
      add(fmt::format("{}-x{:.2f}", pulse, scale), scale > 1 ? "fit" : "predict", pulse,
          fmt::format("excitation.scale={:.2f}", scale));
  for (const double speed : {1.0, 0.6, 0.35, 0.2, 0.1, 0.05})
    add(fmt::format("window-{:.2f}", speed), "window", "impact-window",
        fmt::format("excitation.speed_m_per_s={}", speed));
  return jobs;
}

} // namespace rimpact::app
