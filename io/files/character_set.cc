#include "io/files/character_set.h"
#include "io/files/error.h"
#include <array>
#include <cerrno>
#include <fmt/format.h>
#include <iconv.h>

namespace rimpact {
namespace {

/// One conversion of iconv, closed at its end.
class Conversion {
public:
  explicit Conversion(const std::string &from) : handle_(iconv_open("UTF-8", from.c_str())) {}
  Conversion(const Conversion &) = delete;
  Conversion &operator=(const Conversion &) = delete;
  ~Conversion() {
    if (known()) iconv_close(handle_);
  }
  bool known() const { return handle_ != reinterpret_cast<iconv_t>(-1); }
  /// Bytes read until the first that is no character; `out`, where given, takes the text.
  std::size_t read(std::string_view bytes, std::string *out) {
    std::string copy(bytes);
    std::array<char, 4096> buffer;
    char *in = copy.data();
    std::size_t left = copy.size();
    for (bool more = true; more;) {
      char *to = buffer.data();
      std::size_t room = buffer.size();
      more = iconv(handle_, &in, &left, &to, &room) == static_cast<std::size_t>(-1) && errno == E2BIG;
      if (out) out->append(buffer.data(), buffer.size() - room);
    }
    return bytes.size() - left;
  }

private:
  iconv_t handle_;
};

} // namespace

std::optional<std::size_t> not_utf8(std::string_view bytes) {
  const std::size_t read = Conversion("UTF-8").read(bytes, nullptr);
  return read < bytes.size() ? std::optional(read) : std::nullopt;
}

std::optional<std::string> utf8_from(std::string_view bytes, const std::string &name, const std::string &place) {
  Conversion conversion(name);
  if (!conversion.known())
    throw InputError(fmt::format("{}: the character set \"{}\" is not known to this system; others are utf-8, "
                                 "windows-1252 (western), windows-1254 (Turkish), windows-1250 (central European), "
                                 "shift_jis (Japanese); `iconv -l` lists them (Debian 13: libc-gconv-modules-extra)",
                                 place, name));
  std::string text;
  return conversion.read(bytes, &text) == bytes.size() ? std::optional(text) : std::nullopt;
}

} // namespace rimpact
