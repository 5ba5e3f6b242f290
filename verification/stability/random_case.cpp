#include "verification/stability/random_case.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string_view>

#include "reference/problem/problem.hpp"
#include "verification/stability/dice.hpp"

namespace porowave::verification {

namespace {

using Words = std::span<const std::string_view>;

constexpr double courant_of_length = 0.5;

/// Writes a case file line by line; every choice is a draw.
struct CaseWriter {
  Dice dice;
  std::string text = {};

  bool given() { return dice.chance(2.0 / 3.0); }
  std::string_view one_of(Words words) {
    return words[static_cast<std::size_t>(dice.integer(0, static_cast<int>(words.size()) - 1))];
  }

  void section(std::string_view name) { text += fmt::format("\n[{}]\n", name); }
  void number(std::string_view key, double value) {
    text += fmt::format("{} = {:e}\n", key, value);
  }
  void whole(std::string_view key, std::uint64_t value) {
    text += fmt::format("{} = {}\n", key, value);
  }
  void word(std::string_view key, std::string_view value) {
    text += fmt::format("{} = \"{}\"\n", key, value);
  }
  void line(const std::string& words) { text += words + "\n"; }
};

constexpr std::array<std::string_view, 6> kernels = {"bspline1",    "bspline2",    "bspline3",
                                                     "wendland_c2", "wendland_c4", "wendland_c6"};
constexpr std::array<std::string_view, 5> shapes = {"bspline1", "bspline2", "bspline3", "gimp",
                                                    "cpgimp"};
constexpr std::array<std::string_view, 4> placements = {"uniform", "jittered", "stratified",
                                                        "random"};

struct Size {
  double length;  // of the column, m
  int elements;
  double end;  // s
  bool half_space;
  double spacing() const { return length / elements; }
};

Material write_material(CaseWriter& file) {
  Material m{file.dice.between(0.2, 0.6), 2650.0, 1000.0, 0.0, 2.2e9, 0.0, 1e-3};
  m.constrained_modulus = m.fluid_bulk_modulus * file.dice.log_between(1e-4, 1e4);
  m.intrinsic_permeability = file.dice.log_between(1e-16, 1e-6);
  file.section("material");
  file.number("porosity", m.porosity);
  file.number("grain_density", m.grain_density);
  file.number("fluid_density", m.fluid_density);
  file.number("constrained_modulus", m.constrained_modulus);
  file.number("fluid_bulk_modulus", m.fluid_bulk_modulus);
  file.number("intrinsic_permeability", m.intrinsic_permeability);
  file.number("fluid_viscosity", m.fluid_viscosity);
  return m;
}

Size choose_size(CaseWriter& file, const Material& m) {
  Size size{file.dice.log_between(0.01, 10.0), file.dice.integer(12, 32), 0.0,
            file.dice.chance(0.1)};
  const double crossing = size.spacing() / wave_speeds(m).p1;
  size.end = file.dice.log_between(200.0, 3000.0) * courant_of_length * crossing;
  if (size.half_space) size.length = 1.05 * wave_speeds(m).p1 * size.end;
  return size;
}

void write_column_and_load(CaseWriter& file, const Material& m, const Size& size) {
  file.section("column");
  const auto near = static_cast<NearEnd>(file.dice.integer(0, 3));
  const auto far =
      size.half_space ? FarEnd::half_space : static_cast<FarEnd>(file.dice.integer(0, 2));
  file.word("near", name(near));
  file.word("far", name(far));
  if (!size.half_space) file.number("length", size.length);
  file.section("load");
  const auto shape = static_cast<LoadShape>(file.dice.integer(0, 4));
  const double strain = file.dice.log_between(1e-14, 1e-6);
  const double speed = m.undrained_speed();
  file.word("shape", name(shape));
  file.number("magnitude",
              strain * speed * (near == NearEnd::velocity ? 1.0 : m.mixture_density() * speed));
  if (has_duration(shape)) {
    file.number("duration", file.dice.log_between(1.0, 40.0) * size.spacing() / wave_speeds(m).p1);
  }
}

void write_mls(CaseWriter& file) {
  if (file.given()) file.word("transfer", "mls");
  double natural = 1.5;
  if (file.given()) {
    const int kernel = file.dice.integer(0, 5);
    file.word("kernel", kernels[static_cast<std::size_t>(kernel)]);
    natural = kernel < 3 ? 0.5 * (kernel + 2) : 2.0;
  }
  if (!file.given()) {
    file.number("support_radius", file.dice.between(natural, 5.0));
  } else if (file.dice.chance(0.3)) {
    file.word("support_radius", "adaptive");
  }
  if (!file.given()) file.whole("basis_order", static_cast<std::uint64_t>(file.dice.integer(0, 2)));
  if (file.given()) file.word("strain", file.dice.chance(0.5) ? "recovered" : "cell");
}

void write_shape(CaseWriter& file) {
  file.word("transfer", "shape");
  std::string_view shape = shapes[0];
  if (file.given()) {
    shape = file.one_of(shapes);
    file.word("kernel", shape);
  }
  if (shape == shapes[0] && file.given()) {
    file.word("strain", file.dice.chance(0.5) ? "recovered" : "cell");
  }
}

void write_apic(CaseWriter& file) {
  file.word("transfer", "apic");
  if (file.given()) file.word("kernel", file.one_of(Words(shapes).first(3)));
}

void write_staggered(CaseWriter& file) {
  file.word("scheme", "staggered4");
  if (file.given()) file.word("kernel", file.one_of(kernels));
  if (file.given()) file.whole("basis_order", static_cast<std::uint64_t>(file.dice.integer(2, 3)));
  if (file.dice.chance(0.3)) file.number("support_radius", file.dice.between(1.5, 5.0));
}

void write_points(CaseWriter& file, const Size& size) {
  if (file.dice.chance(0.9)) {
    file.whole("points_per_element", static_cast<std::uint64_t>(file.dice.integer(1, 8)));
  }
  if (file.dice.chance(0.8)) {
    const auto placement = file.one_of(placements);
    file.word("placement", placement);
    if (placement == "jittered" && file.given()) file.number("jitter", file.dice.between(0.0, 1.0));
  }
  if (!file.dice.chance(0.25)) return;
  const int width = file.dice.integer(1, 3);
  const int first = file.dice.integer(2, size.elements - 3 - width);
  std::string places;
  for (int k = 0; k < width; ++k) {
    places += fmt::format("{}{:e}", k == 0 ? "" : ", ", (first + k + 0.5) * size.spacing());
  }
  file.line(fmt::format("empty_elements = [{}]", places));
}

enum class Family { mls, shape, apic, staggered };

Family family_of(double draw) {
  if (draw < 0.55) return Family::mls;
  if (draw < 0.75) return Family::shape;
  return draw < 0.85 ? Family::apic : Family::staggered;
}

void write_time(CaseWriter& file, Family family, double end) {
  file.section("time");
  file.number("end", end);
  file.word("courant", "auto");
  const double draw = file.dice.between(0.0, 1.0);
  if (family == Family::staggered) {
    if (draw < 0.5) file.whole("time_order", 4);
  } else if (family != Family::apic && draw < 0.2) {
    if (draw < 0.1) {
      file.whole("xpic_order", static_cast<std::uint64_t>(file.dice.integer(1, 5)));
    } else {
      file.number("flip", file.dice.between(0.0, 1.0));
    }
  }
  if (family != Family::staggered && file.dice.chance(0.1)) file.word("path", "points");
}

}  // namespace

std::string random_case(std::uint64_t number) {
  CaseWriter file{Dice(number)};
  const Material material = write_material(file);
  const Size size = choose_size(file, material);
  write_column_and_load(file, material, size);
  file.section("discretization");
  file.whole("elements", static_cast<std::uint64_t>(size.elements));
  const Family family = family_of(file.dice.between(0.0, 1.0));
  switch (family) {
    case Family::mls:
      write_mls(file);
      break;
    case Family::shape:
      write_shape(file);
      break;
    case Family::apic:
      write_apic(file);
      break;
    case Family::staggered:
      write_staggered(file);
      break;
  }
  write_points(file, size);
  file.whole("seed", number);
  write_time(file, family, size.end);
  return file.text;
}

}  // namespace porowave::verification
