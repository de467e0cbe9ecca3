#pragma once

struct Counts {
  long steps = 0, rejected = 0, calls = 0;
};
