// A channel that keeps what was sent: it gives it back to who receives.
#pragma once
#include "Vector.h"

class Channel {
public:
  int sendVector(int, int, const Vector &data) { return kept_ = data, 0; }
  int recvVector(int, int, Vector &data) { return data = kept_, 0; }

private:
  Vector kept_{0};
};
