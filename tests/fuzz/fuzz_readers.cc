// libFuzzer on the readers of data files: whatever the bytes, they are understood or refused by one of the toolkit's
// own errors, and what is understood is finite. The first byte chooses the reader. See fuzz.sh.
#include "scene/error.h"
#include "scene/record.h"
#include "scene/response_files.h"
#include <cmath>
#include <cstdint>
#include <cstdlib>

using namespace rimpact;

namespace {

void require_finite(const std::vector<double> &values) {
  for (const double value : values)
    if (!std::isfinite(value)) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char *>(data) + 1, size - 1);
  try {
    if (data[0] == 'a' || data[0] == 'c') {
      const auto record = (data[0] == 'a' ? scene::parse_at2 : scene::parse_record_csv)(text, "fuzz", 9.81);
      require_finite(record.values);
      scene::inspect(record);
    } else {
      require_finite(scene::parse_csv(text, "fuzz").series("time"));
    }
  } catch (const Error &) {
  }
  return 0;
}
