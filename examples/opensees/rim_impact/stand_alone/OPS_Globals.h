// Where OpenSees says what is wrong: kept as text.
#pragma once
#include <sstream>
#include <string>

class OPS_Stream {
public:
  template <class T> OPS_Stream &operator<<(const T &value) {
    std::ostringstream text;
    text << value;
    said += text.str();
    return *this;
  }
  std::string said;
};
inline OPS_Stream opserr;
