#pragma once
// In place of CUDA's own headers, for a check of emitted text by clang where there is no CUDA: what __host__ and __device__ are, and
// which functions of <cmath> can be called on a device.

#define __CUDACC__ 1
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))

#define GAUSS_DEVICE_FUNCTIONS(T, f)    \
  __device__ T sin##f(T) noexcept;      \
  __device__ T cos##f(T) noexcept;      \
  __device__ T tan##f(T) noexcept;      \
  __device__ T asin##f(T) noexcept;     \
  __device__ T acos##f(T) noexcept;     \
  __device__ T atan##f(T) noexcept;     \
  __device__ T exp##f(T) noexcept;      \
  __device__ T log##f(T) noexcept;      \
  __device__ T sinh##f(T) noexcept;     \
  __device__ T cosh##f(T) noexcept;     \
  __device__ T tanh##f(T) noexcept;     \
  __device__ T sqrt##f(T) noexcept;     \
  __device__ T atan2##f(T, T) noexcept; \
  __device__ T pow##f(T, T) noexcept;   \
  __device__ void sincos##f(T, T*, T*) noexcept;

extern "C" {
GAUSS_DEVICE_FUNCTIONS(double, )
GAUSS_DEVICE_FUNCTIONS(float, f)
}
namespace std {
GAUSS_DEVICE_FUNCTIONS(float, )
}
