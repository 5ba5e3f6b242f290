#include "solver/apic.hpp"

namespace porowave::solver {

namespace {

constexpr double smallest_moment = 1e-8;  // of D_p, in h²

}  // namespace

template <int Dim>
std::array<std::vector<double>, Dim> make_affine(std::span<const Vector<Dim>> points,
                                                 const Grid<Dim>& grid, LinearRows<Dim>& rows) {
  std::array<std::vector<double>, Dim> moments;
  const SparseRows& shape = rows.values;
  for (std::size_t a = 0; a < Dim; ++a) {
    const auto axis = static_cast<int>(a);
    moments[a].resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto offset = [&](std::size_t k) {
        return grid.node_position(shape.columns[k])[axis] - points[p][axis];
      };
      double& moment = moments[a][p];
      for (std::size_t k = shape.row_offsets[p]; k < shape.row_offsets[p + 1]; ++k) {
        moment += shape.values[k] * offset(k) * offset(k);
      }
      if (moment < smallest_moment * grid.spacing * grid.spacing) continue;
      for (std::size_t k = shape.row_offsets[p]; k < shape.row_offsets[p + 1]; ++k) {
        rows.gradients[a].values[k] = shape.values[k] * offset(k) / moment;
      }
    }
  }
  return moments;
}

template std::array<std::vector<double>, 1> make_affine<1>(std::span<const Vector<1>>,
                                                           const Grid<1>&, LinearRows<1>&);
template std::array<std::vector<double>, 2> make_affine<2>(std::span<const Vector<2>>,
                                                           const Grid<2>&, LinearRows<2>&);
template std::array<std::vector<double>, 3> make_affine<3>(std::span<const Vector<3>>,
                                                           const Grid<3>&, LinearRows<3>&);

}  // namespace porowave::solver
