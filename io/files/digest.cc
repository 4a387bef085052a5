#include "io/files/digest.h"

#include "io/files/file.h"
#include <array>
#include <openssl/sha.h>

namespace rimpact {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
  SHA256(reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size(), digest.data());
  std::string hex;
  for (const unsigned char byte : digest) hex += "0123456789abcdef"[byte >> 4], hex += "0123456789abcdef"[byte & 15];
  return hex;
}

std::string sha256_of_file(const std::string &path) {
  return sha256(read_file(path));
}

} // namespace rimpact
