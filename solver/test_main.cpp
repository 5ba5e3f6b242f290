#define BOOST_TEST_MODULE porowave_solver
#include <boost/test/unit_test.hpp>
