#pragma once
// The times that are asked for.

namespace gausssim {

template <class S>
struct Grid {
  S start, end;
  long samples;
  S every = 0;  ///< what somebody has said is between two; 0: nobody has

  S at(long k) const {
    if (k + 1 == samples) return end;
    return every > S(0) ? start + every * S(k) : start + (end - start) * S(k) / S(samples - 1);
  }
};

}  // namespace gausssim
