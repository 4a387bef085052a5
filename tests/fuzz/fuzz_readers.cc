// libFuzzer on the readers of data files: whatever the bytes, they are understood or refused by one of the toolkit's
// own errors, and what is understood is finite. RIMPACT_READER names the reader. See fuzz.sh.
#include "calibration/fit/run_facts.h"
#include "io/files/error.h"
#include "io/files/loose_csv.h"
#include "io/records/record.h"
#include "io/records/record_format.h"
#include "meshes/mesh_kind.h"
#include "responses/kept_run.h"
#include "responses/response_csv.h"
#include "responses/response_hdf5.h"
#include "scene/scene.h"
#include "scene/toml_writer.h"
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace rimpact;

namespace {

void require_finite(const std::vector<double> &values) {
  for (const double value : values)
    if (!std::isfinite(value)) std::abort();
}

void read_record(const SampledSignal &record) {
  require_finite(record.values);
  inspect(record);
}

void read_loose_table(const std::string &text) {
  const LooseTable table(text, "fuzz", {"rsn", "factor"});
  for (const auto &row : table.rows()) require_finite({table.number(row, "factor")});
}

/// A scene that is understood must be understood again as it is written out.
void read_scene(const std::string &text) {
  const auto read = scene::parse_scene(text, "fuzz");
  const std::string written = scene::to_toml(read);
  if (scene::to_toml(scene::parse_scene(written, "written")) != written) std::abort();
}

/// A run folder whose summary.json holds these bytes.
void read_summary(const std::string &text) {
  static const auto folder = std::filesystem::temp_directory_path() / ("rimpact_fuzz_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "summary.json", std::ios::binary) << text;
  rimpact::read_summary(folder.string());
  calibration::run_facts(folder.string());
}

void read(char reader, const std::string &text) {
  switch (reader) {
  case 'a':
    return read_record(parse_at2(text, "fuzz", 9.81));
  case 'c':
    return read_record(parse_record_csv(text, "fuzz", 9.81));
  case 'k':
    return read_record(parse_knet(text, "fuzz", 9.81));
  case 'e':
    return read_record(parse_esm(text, "fuzz", 9.81));
  case 'v':
    return read_record(parse_cosmos_v2(text, "fuzz", 9.81));
  case 'l':
    return read_loose_table(text);
  case 'r':
    return require_finite(parse_csv(text, "fuzz").series("time"));
  case 'h':
    return require_finite(parse_hdf5(text, "fuzz").series("time"));
  case 't':
    return read_scene(text);
  case 'j':
    return read_summary(text);
  case 'm':
    meshes::mesh_kind(text), meshes::call_that_leaves(text);
    return;
  default:
    std::abort();
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static const char reader = *std::getenv("RIMPACT_READER");
  try {
    read(reader, std::string(reinterpret_cast<const char *>(data), size));
  } catch (const Error &) {
  }
  return 0;
}
