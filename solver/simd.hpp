#pragma once

// Loops that the compiler builds for several instruction sets, chosen when the program starts.
//
// The solver is compiled without contraction to fused multiply-adds, which not every set has: the
// same bits come out on every machine.

#include <cstddef>
#include <new>
#include <vector>

namespace porowave::solver {

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define POROWAVE_VECTORISED __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define POROWAVE_VECTORISED
#endif
#define POROWAVE_INLINE inline __attribute__((always_inline))

// Several doubles at once, in as many registers as the set needs.
using Four [[gnu::vector_size(32)]] = double;
using Eight [[gnu::vector_size(64)]] = double;

// From and to any address. A template or `auto` would forget the alignment of these types.
using FourAnywhere [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;
using EightAnywhere [[gnu::vector_size(64), gnu::aligned(8), gnu::may_alias]] = double;

POROWAVE_INLINE void read(const double* from, double& to) {
  to = *from;
}
POROWAVE_INLINE void read(const double* from, Four& to) {
  to = *reinterpret_cast<const FourAnywhere*>(from);
}
POROWAVE_INLINE void read(const double* from, Eight& to) {
  to = *reinterpret_cast<const EightAnywhere*>(from);
}
POROWAVE_INLINE void write(const double& from, double* to) {
  *to = from;
}
POROWAVE_INLINE void write(const Four& from, double* to) {
  *reinterpret_cast<FourAnywhere*>(to) = from;
}
POROWAVE_INLINE void write(const Eight& from, double* to) {
  *reinterpret_cast<EightAnywhere*>(to) = from;
}

// Numbers that begin at a cache line: a register full of them then never lies across two.
template <class T>
struct LineAllocator {
  using value_type = T;
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{64}));
  }
  void deallocate(T* at, std::size_t) { ::operator delete (at, std::align_val_t{64}); }
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};
using LineVector = std::vector<double, LineAllocator<double>>;

}  // namespace porowave::solver
