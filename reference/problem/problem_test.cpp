#include "reference/problem/problem.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "reference/problem/errors.hpp"
#include "reference/problem/problem_fixtures.hpp"
#include "reference/problem/toml_document.hpp"

BOOST_AUTO_TEST_SUITE(problem)

using namespace porowave;
namespace tt = boost::test_tools;

namespace {

const std::string valid = R"([material]
porosity = 0.4
grain_density = 2650.0
fluid_density = 1000
constrained_modulus = 5.0e9
fluid_bulk_modulus = 2.2e9
intrinsic_permeability = 1.0e-11
fluid_viscosity = 1.0e-3

[column]
length = 0.1
near = "drained_traction"
far  = "rigid_sealed"

[load]
shape = "smooth_ramp"
magnitude = 2.0
duration = 1.0e-5
)";

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = valid;
  const auto at = text.find(from);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string message_for(const std::string& text) {
  try {
    read_problem(TomlDocument::parse(text, "p.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_valid_problem_is_read) {
  const Problem problem = read_problem(TomlDocument::parse(valid, "p.toml"));
  BOOST_TEST(problem.material.porosity == 0.4);
  BOOST_TEST(problem.material.fluid_density == 1000.0);
  BOOST_TEST(problem.column.length.value() == 0.1);
  BOOST_TEST(name(problem.column.far) == "rigid_sealed");
  BOOST_TEST(name(problem.load.shape()) == "smooth_ramp");
  BOOST_TEST(problem.load.value(1.0) == 2.0);
}

BOOST_AUTO_TEST_CASE(values_outside_of_physics_are_refused) {
  BOOST_TEST(message_for(replaced("porosity = 0.4", "porosity = 1.2")) ==
             "p.toml:2: [material] porosity = 1.2: expected a number > 0 and < 1");
  BOOST_TEST(message_for(replaced("5.0e9", "-5.0e9")) ==
             "p.toml:5: [material] constrained_modulus = -5000000000: expected a number > 0");
  BOOST_TEST(message_for(replaced("length = 0.1", "")) ==
             "p.toml: [column] length is missing: expected a number > 0");
  BOOST_TEST(message_for(replaced("rigid_sealed", "half_space")) ==
             "p.toml:11: [column] length = 0.1: expected no length with far = \"half_space\"");
  BOOST_TEST(message_for(replaced("smooth_ramp", "step")) ==
             "p.toml:18: [load] duration = 1e-05: expected no duration with shape = \"step\"");
  BOOST_TEST(message_for(replaced("duration = 1.0e-5", "")) ==
             "p.toml: [load] duration is missing: expected a number > 0");
  BOOST_TEST(message_for(replaced("magnitude = 2.0", "magnitude = 0.0")) ==
             "p.toml:17: [load] magnitude = 0: expected a number other than 0");
}

BOOST_AUTO_TEST_CASE(speeds_of_the_papers_column) {
  const Material material = fixtures::paper_material();
  BOOST_TEST(wave_speeds(material).p1 == 2297.73, tt::tolerance(3e-6));
  BOOST_TEST(wave_speeds(material).p2 == 1144.72, tt::tolerance(3e-6));
  BOOST_TEST(material.undrained_speed() == 2297.04, tt::tolerance(3e-6));
}

BOOST_AUTO_TEST_CASE(speeds_solve_the_characteristic_equation) {
  Material m = fixtures::paper_material();
  for (const double modulus : {1e3, 1e6, 5e9, 1e13}) {
    m.constrained_modulus = modulus;
    const double ns = m.solid_fraction();
    const double K = m.storage_modulus();
    for (const double c : {wave_speeds(m).p1, wave_speeds(m).p2}) {
      const double solid = (modulus + K * ns * ns) / (c * c) - m.solid_partial_density();
      const double fluid = K * m.porosity * m.porosity / (c * c) - m.fluid_partial_density();
      const double coupling = K * ns * m.porosity / (c * c);
      BOOST_TEST(solid * fluid == coupling * coupling, tt::tolerance(1e-8));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_table_load_is_read_relative_to_its_problem_file) {
  const auto folder = std::filesystem::temp_directory_path() / "porowave_table_load";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "load.csv") << "t,value\n0,0\n1e-5,2\n";
  std::string text = replaced("shape = \"smooth_ramp\"", "shape = \"table\"\nfile = \"load.csv\"");
  text.erase(text.find("duration"));
  std::ofstream(folder / "p.toml") << text;
  BOOST_TEST(load_problem((folder / "p.toml").string()).load.value(0.5e-5) == 2.0);

  const auto refused = [&](const std::string& csv) {
    std::ofstream(folder / "load.csv") << csv;
    BOOST_CHECK_THROW(load_problem((folder / "p.toml").string()), InputError);
  };
  refused("time,value\n0,0\n");
  refused("t,value\n0,zero\n");
  refused("t,value\n0\n");
  refused("t,value\n1,0\n0,1\n");
  refused("t,value\n-1,0\n0,1\n");
  refused("t,value\n");
  refused("");
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_SUITE_END()
