#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_complex.hpp>
#include <complex>

/// Helpers of fifty_digits.hpp, which share nothing with the reference but the problem itself.
namespace porowave::fixtures::digits {

using Real50 = boost::multiprecision::cpp_bin_float_50;
using Real100 = boost::multiprecision::cpp_bin_float_100;

template <class R>
struct ComplexOver;
template <>
struct ComplexOver<double> {
  using type = std::complex<double>;
};
template <>
struct ComplexOver<Real50> {
  using type = boost::multiprecision::cpp_complex_50;
};
template <>
struct ComplexOver<Real100> {
  using type = boost::multiprecision::cpp_complex_100;
};
/// The complex numbers over R.
template <class R>
using ComplexOf = typename ComplexOver<R>::type;

}  // namespace porowave::fixtures::digits
